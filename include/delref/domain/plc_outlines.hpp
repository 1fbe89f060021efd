// SPDX-License-Identifier: GPL-3.0-or-later
//
// What bounds each facet: the sides of its polygons and the segments and vertices in it, in flat arrays, since surface files have
// a million facets. Made from the polygons of the input with merged vertices; what collapsed is left out and told.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/domain/describe.hpp>
#include <delref/domain/plc.hpp>
#include <delref/domain/plc_names.hpp>

namespace delref {

/// Facets as sets of sides and vertices.
struct FacetOutlines {
  using Index = Plc::Index;
  using Side = std::array<Index, 2>;

  struct Facet {
    /// Its sides are `sides[first_side]` up to the next facet's first: closed curves one after the other, each side starting
    /// where the one before ends, then from `first_slit` on segments in the facet.
    std::size_t first_side = 0, first_slit = 0;
    std::size_t first_loose = 0;
    Index original = 0;
    int marker = 0;
  };

  std::vector<Side> all_sides;
  std::vector<Index> all_loose;
  std::vector<Facet> facets;

  std::size_t size() const { return facets.size(); }
  std::span<const Side> sides(std::size_t f) const { return part(all_sides, facets[f].first_side, next(f, &Facet::first_side)); }
  std::span<const Side> curves(std::size_t f) const { return part(all_sides, facets[f].first_side, facets[f].first_slit); }
  std::span<const Side> slits(std::size_t f) const { return part(all_sides, facets[f].first_slit, next(f, &Facet::first_side)); }
  /// Vertices in the facet that are on no side of it.
  std::span<const Index> loose(std::size_t f) const {
    return part(all_loose, facets[f].first_loose, next(f, &Facet::first_loose));
  }
  /// True for one triangle and nothing in it.
  bool is_triangle(std::size_t f) const { return curves(f).size() == 3 && sides(f).size() == 3 && loose(f).empty(); }
  /// The vertices of the facet, ascending.
  std::vector<Index> vertices(std::size_t f) const {
    std::vector<Index> found(loose(f).begin(), loose(f).end());
    for (const Side& side : sides(f)) found.insert(found.end(), side.begin(), side.end());
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

  /// Starts a facet; its curves, then its slits and loose vertices are to be appended.
  void start(Index original, int marker) {
    facets.push_back({all_sides.size(), all_sides.size(), all_loose.size(), original, marker});
  }
  /// The curves of the facet that was started last are complete.
  void end_curves() { facets.back().first_slit = all_sides.size(); }
  /// Takes the facet that was started last away.
  void abandon() {
    all_sides.resize(facets.back().first_side);
    all_loose.resize(facets.back().first_loose);
    facets.pop_back();
  }

 private:
  template <class T>
  static std::span<const T> part(const std::vector<T>& all, std::size_t first, std::size_t last) {
    return std::span(all).subspan(first, last - first);
  }
  std::size_t next(std::size_t f, std::size_t Facet::*first) const {
    if (f + 1 < facets.size()) return facets[f + 1].*first;
    return first == &Facet::first_side ? all_sides.size() : all_loose.size();
  }
};

namespace plc_outlines {

/// Turns polygons into sides.
class OutlineBuilder {
 public:
  using Index = Plc::Index;

  OutlineBuilder(const Plc& plc, const std::vector<Index>& renumbered, const PlcNames& names)
      : plc_(plc), renumbered_(renumbered), names_(names), depth_(names.points.size(), none) {}

  FacetOutlines build(const Control& control) {
    outlines_.facets.reserve(plc_.facets.size());
    for (Index f = 0; f < plc_.facets.size(); ++f) {
      if (f % 4096 == 0) throw_if_stopped(control);
      add(f);
    }
    return std::move(outlines_);
  }

  void tell(std::vector<std::string>& notes) const {
    if (collapsed_.count() > 0)
      notes.push_back(count_of(collapsed_.count(), "polygon has", "polygons have") +
                      " fewer corners than listed, or none left, since some are the same vertex: " + collapsed_.text());
  }

 private:
  static constexpr Index none = static_cast<Index>(-1);

  void add(Index f) {
    const Plc::Facet& facet = plc_.facets[f];
    outlines_.start(f, facet.marker);
    bool lost = false;
    for (const auto& polygon : facet.polygons)
      if (polygon.size() > 2) lost |= !add_curve(polygon);
    outlines_.end_curves();
    for (const auto& polygon : facet.polygons) {
      if (polygon.size() > 2) continue;
      const Index a = renumbered_[polygon.front()], b = renumbered_[polygon.back()];
      if (a == b)
        outlines_.all_loose.push_back(a);
      else
        outlines_.all_sides.push_back({a, b});
    }
    if (lost) note(f);
    if (outlines_.sides(outlines_.size() - 1).empty()) outlines_.abandon();  // merged away, or vertices only
  }

  /// Adds the sides of a polygon. Where merging makes it pass twice through a vertex it is cut into several closed curves, and
  /// what is then no curve is left out. False when corners were lost.
  bool add_curve(const std::vector<Index>& polygon) {
    path_.clear();
    std::size_t kept = 0;
    for (const Index input : polygon) {
      const Index v = renumbered_[input];
      if (depth_[v] != none) close(depth_[v], kept);
      depth_[v] = static_cast<Index>(path_.size());
      path_.push_back(v);
    }
    if (!path_.empty()) close(0, kept);
    return kept == polygon.size();
  }

  /// Cuts the end of the path, from this depth on, off as a closed curve.
  void close(Index depth, std::size_t& kept) {
    const std::size_t count = path_.size() - depth;
    for (std::size_t k = depth; k < path_.size(); ++k) {
      depth_[path_[k]] = none;
      if (count > 2) outlines_.all_sides.push_back({path_[k], path_[k + 1 < path_.size() ? k + 1 : depth]});
    }
    if (count > 2) kept += count;
    path_.resize(depth);
  }

  void note(Index f) {
    if (collapsed_.full())
      collapsed_.add();
    else
      collapsed_.add("one of " + names_.facet(f) + " near " + names_.place(plc_.points[plc_.facets[f].polygons.front().front()]));
  }

  const Plc& plc_;
  const std::vector<Index>& renumbered_;
  const PlcNames& names_;
  FacetOutlines outlines_;
  std::vector<Index> path_, depth_;
  ExampleList collapsed_;
};

}  // namespace plc_outlines

/// The outlines of the facets of a complex whose vertices were merged. Facets without any side are left out; notes say what
/// merging destroyed. Requires what `find_plain_defects` checks.
inline FacetOutlines outlines_of(const Plc& plc, const std::vector<Plc::Index>& renumbered, const PlcNames& names,
                                 const Control& control, std::vector<std::string>& notes) {
  plc_outlines::OutlineBuilder builder(plc, renumbered, names);
  FacetOutlines outlines = builder.build(control);
  builder.tell(notes);
  return outlines;
}

}  // namespace delref
