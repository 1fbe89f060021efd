// SPDX-License-Identifier: GPL-3.0-or-later
//
// The defects of a planar straight line graph that one look at each element shows: lengths, indices, numbers.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

#include <delref/core/budget.hpp>
#include <delref/domain/describe.hpp>
#include <delref/domain/pslg.hpp>
#include <delref/domain/pslg_names.hpp>

namespace delref {

/// Coordinates beyond this are refused: widths and distances would overflow.
inline constexpr double largest_coordinate = 1e300;
/// More vertices or segments than this are refused.
inline constexpr std::size_t largest_element_count = std::numeric_limits<Pslg::Index>::max() / 2;

namespace pslg_defects {

/// Why a point cannot be used; empty when it can.
inline std::string why_unusable(Point2 p) {
  if (std::isnan(p.x) || std::isnan(p.y)) return "a coordinate is not a number";
  if (std::isinf(p.x) || std::isinf(p.y)) return "a coordinate is infinite";
  if (std::abs(p.x) > largest_coordinate || std::abs(p.y) > largest_coordinate)
    return "a coordinate is greater than 1e300; change the unit of length";
  return {};
}

inline void check_counts(const Pslg& pslg, DefectList& defects) {
  const auto length = [&defects](const char* name, std::size_t actual, std::size_t expected, const char* what) {
    if (actual != expected)
      defects.add(std::string("there are ") + std::to_string(actual) + ' ' + name + " for " + std::to_string(expected) + ' ' +
                  what);
  };
  const auto limit = [&defects](std::size_t actual, const char* what) {
    if (actual > largest_element_count)
      defects.add("there are " + std::to_string(actual) + ' ' + what + ": at most " + std::to_string(largest_element_count) +
                  " are handled");
  };
  limit(pslg.points.size(), "vertices");
  limit(pslg.segments.size(), "segments");
  if (!pslg.point_markers.empty()) length("vertex markers", pslg.point_markers.size(), pslg.points.size(), "vertices");
  if (!pslg.segment_markers.empty()) length("segment markers", pslg.segment_markers.size(), pslg.segments.size(), "segments");
  length("attribute values", pslg.attributes.size(), pslg.attribute_count * pslg.points.size(),
         "(vertices times attributes of each)");
  if (pslg.points.empty())
    defects.add("the input has no vertices: there is nothing to mesh");
  else if (pslg.segments.empty())
    defects.add("the input has " + count_of(pslg.points.size(), "vertex", "vertices") +
                " but no segments: nothing bounds a domain; give the segments of its boundary");
}

inline void check_points(const Pslg& pslg, const Control& control, DefectList& defects) {
  const PslgNames names{pslg};
  for (std::size_t i = 0; i < pslg.points.size(); ++i) {
    if (i % 8192 == 0) throw_if_stopped(control);
    const Point2 p = pslg.points[i];
    if (std::abs(p.x) <= largest_coordinate && std::abs(p.y) <= largest_coordinate) continue;
    defects.add(names.placed_vertex(i) + ": " + why_unusable(p));
  }
}

inline void check_segments(const Pslg& pslg, const Control& control, DefectList& defects) {
  const std::size_t count = pslg.points.size();
  if (count == 0) return;
  for (std::size_t s = 0; s < pslg.segments.size(); ++s) {
    if (s % 8192 == 0) throw_if_stopped(control);
    for (const Pslg::Index v : pslg.segments[s]) {
      if (v < count) continue;
      // A number below the first one wraps around when the first is taken from it.
      const auto number = static_cast<long long>(static_cast<std::int32_t>(v)) + pslg.first_index;
      const auto shown =
          number < static_cast<long long>(pslg.first_index) ? number : static_cast<long long>(v) + pslg.first_index;
      defects.add("segment " + std::to_string(s + pslg.first_index) + " refers to vertex " + std::to_string(shown) +
                  ", which does not exist: vertices are numbered from " + std::to_string(pslg.first_index) + " to " +
                  std::to_string(count - 1 + pslg.first_index));
    }
  }
}

inline void check_seeds(const Pslg& pslg, DefectList& defects) {
  for (std::size_t h = 0; h < pslg.holes.size(); ++h)
    if (const std::string why = why_unusable(pslg.holes[h]); !why.empty())
      defects.add("the seed of hole " + std::to_string(h + pslg.first_index) + " at " + describe(pslg.holes[h]) + ": " + why);
  for (std::size_t r = 0; r < pslg.regions.size(); ++r) {
    const Pslg::Region& region = pslg.regions[r];
    std::string name = "region ";
    name.append(std::to_string(r + pslg.first_index)).append(" (label ").append(std::to_string(region.label)).append(")");
    if (const std::string why = why_unusable(region.seed); !why.empty())
      defects.add("the seed of " + name + " at " + describe(region.seed) + ": " + why);
    if (!(region.max_area >= 0))
      defects.add(
          "the greatest area in " + name + " is " + describe(region.max_area) + ": give a positive area, or 0 for no bound",
          {region.seed});
  }
}

}  // namespace pslg_defects

/// Every defect of the numbers of a graph; empty when it has none.
inline DefectList find_plain_defects(const Pslg& pslg, const Control& control) {
  DefectList defects;
  pslg_defects::check_counts(pslg, defects);
  pslg_defects::check_points(pslg, control, defects);
  pslg_defects::check_segments(pslg, control, defects);
  pslg_defects::check_seeds(pslg, defects);
  return defects;
}

}  // namespace delref
