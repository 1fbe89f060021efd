// SPDX-License-Identifier: GPL-3.0-or-later
//
// Facets that are there twice: with the same sides, vertices and holes. They are one facet if their markers allow it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/domain/describe.hpp>
#include <delref/domain/pair_table.hpp>
#include <delref/domain/plc.hpp>
#include <delref/domain/plc_names.hpp>
#include <delref/domain/plc_outlines.hpp>

namespace delref {

namespace plc_duplicates {

inline std::uint64_t mixed(std::uint64_t h) {
  h = (h ^ (h >> 31)) * 0x7fb5d329728ea185u;
  h = (h ^ (h >> 27)) * 0x81dadef4bc2dd44du;
  return h ^ (h >> 33);
}

/// Equal for facets with equal sides and vertices, whatever their order.
inline PairTable::Key signature(const FacetOutlines& outlines, std::size_t f) {
  PairTable::Key key{0, 0};
  const auto add = [&key](std::uint64_t a, std::uint64_t b) {
    const std::uint64_t word = mixed(a << 32 | b);
    key.first += word;
    key.second += mixed(word ^ 0x5851f42d4c957f2du);
  };
  for (const auto& [a, b] : outlines.sides(f)) add(std::min(a, b), std::max(a, b));
  for (const Plc::Index v : outlines.loose(f)) add(v, v);
  return key;
}

/// Sides and vertices, sorted.
inline std::vector<FacetOutlines::Side> elements(const FacetOutlines& outlines, std::size_t f) {
  std::vector<FacetOutlines::Side> found;
  for (const auto& [a, b] : outlines.sides(f)) found.push_back({std::min(a, b), std::max(a, b)});
  for (const Plc::Index v : outlines.loose(f)) found.push_back({v, v});
  std::ranges::sort(found);
  return found;
}

inline bool same(const Plc& plc, const FacetOutlines& outlines, std::size_t f, std::size_t g) {
  return plc.facets[outlines.facets[f].original].holes == plc.facets[outlines.facets[g].original].holes &&
         elements(outlines, f) == elements(outlines, g);
}

/// The outlines with the facets that are marked.
inline FacetOutlines kept_only(const FacetOutlines& outlines, const std::vector<bool>& kept) {
  FacetOutlines result;
  for (std::size_t f = 0; f < outlines.size(); ++f) {
    if (!kept[f]) continue;
    result.start(outlines.facets[f].original, outlines.facets[f].marker);
    result.all_sides.insert(result.all_sides.end(), outlines.curves(f).begin(), outlines.curves(f).end());
    result.end_curves();
    result.all_sides.insert(result.all_sides.end(), outlines.slits(f).begin(), outlines.slits(f).end());
    result.all_loose.insert(result.all_loose.end(), outlines.loose(f).begin(), outlines.loose(f).end());
  }
  return result;
}

}  // namespace plc_duplicates

/// Drops each facet that repeats an earlier one and tells it; the marker is the first that is not 0. Two different markers,
/// neither of them 0, are a defect: one label would be lost.
inline void drop_duplicate_facets(const Plc& plc, FacetOutlines& outlines, const PlcNames& names, const Control& control,
                                  DefectList& defects, std::vector<std::string>& notes) {
  PairTable first(outlines.size());
  std::vector<bool> kept(outlines.size(), true);
  ExampleList repeated;
  for (std::uint32_t f = 0; f < outlines.size(); ++f) {
    if (f % 4096 == 0) throw_if_stopped(control);
    std::uint32_t& place = first[plc_duplicates::signature(outlines, f)];
    if (place == PairTable::none) place = f;
    if (place == f || !plc_duplicates::same(plc, outlines, place, f)) continue;
    kept[f] = false;
    FacetOutlines::Facet& one = outlines.facets[place];
    const FacetOutlines::Facet& other = outlines.facets[f];
    const std::string what = names.facet(other.original, outlines.vertices(f)) + " repeats " + names.facet(one.original);
    if (one.marker != other.marker && one.marker != 0 && other.marker != 0)
      defects.add(what + " with marker " + std::to_string(other.marker) + " instead of " + std::to_string(one.marker) +
                  ": give it once, or with the same marker");
    if (one.marker == 0) one.marker = other.marker;
    repeated.add(what);
  }
  if (repeated.count() == 0) return;
  outlines = plc_duplicates::kept_only(outlines, kept);
  notes.push_back(count_of(repeated.count(), "repeated facet was", "repeated facets were") + " dropped: " + repeated.text());
}

}  // namespace delref
