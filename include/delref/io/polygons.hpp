// SPDX-License-Identifier: GPL-3.0-or-later
//
// Labelled polygons as a planar straight line graph: every vertex once, every border between neighbours once, a region seed in
// each polygon, and a hole seed in every bounded face that no polygon covers. Such a face is the inside of an inner ring that no
// other polygon fills, or a lake that several neighbours enclose.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <delref/core/budget.hpp>
#include <delref/domain/pslg.hpp>
#include <delref/io/polygon_faces.hpp>
#include <delref/io/polygon_rows.hpp>

namespace delref {

/// A polygon: the first ring is its outside, the others cut holes into it. A ring's last vertex is joined to its first; which way
/// it goes around does not matter.
struct LabelledPolygon {
  int label = 0;
  double max_area = 0;  ///< bound on the area of a triangle; 0 for none
  std::vector<std::vector<Point2>> rings;
};

/// A planar straight line graph with what a person should know of how it was made.
struct PslgFile {
  Pslg pslg;
  std::vector<std::string> notes;
};

namespace detail {

/// Gathers polygons into a Pslg.
class PolygonGatherer {
 public:
  using Index = std::uint32_t;

  explicit PolygonGatherer(const std::vector<LabelledPolygon>& polygons) : polygons_(polygons) {
    for (Index p = 0; p != polygons.size(); ++p) {
      for (std::size_t r = 0; r != polygons[p].rings.size(); ++r) add_ring(p, polygons[p].rings[r], r == 0);
    }
    std::ranges::sort(sides_);
  }

  PslgFile gather(const Control& control) && {
    PolygonRows rows(out_.pslg.points, out_.pslg.segments, sides_, polygons_.size());
    add_holes(rows, control);
    add_regions(rows, control);
    return std::move(out_);
  }

 private:
  struct Hash {
    std::size_t operator()(const std::pair<std::uint64_t, std::uint64_t>& key) const {
      const std::uint64_t mixed = (key.first * 0x9E3779B97F4A7C15U) ^ std::rotl(key.second * 0xC2B2AE3D27D4EB4FU, 31);
      return static_cast<std::size_t>(mixed ^ mixed >> 29);
    }
  };

  Index point(Point2 p) {
    const auto key = std::pair{std::bit_cast<std::uint64_t>(p.x + 0.0), std::bit_cast<std::uint64_t>(p.y + 0.0)};
    const auto [place, added] = point_of_.try_emplace(key, static_cast<Index>(out_.pslg.points.size()));
    if (added) out_.pslg.points.push_back(p);
    return place->second;
  }
  void add_ring(Index polygon, const std::vector<Point2>& ring, bool outer) {
    double doubled_area = 0;
    for (std::size_t i = 0; i != ring.size(); ++i) doubled_area += cross(ring[i] - ring[0], ring[(i + 1) % ring.size()] - ring[0]);
    const bool filled_on_left = (doubled_area > 0) == outer;
    for (std::size_t i = 0; i != ring.size(); ++i) {
      const Index a = point(ring[i]), b = point(ring[(i + 1) % ring.size()]);
      if (a == b) continue;
      const auto [place, added] = segment_of_.try_emplace(std::minmax(a, b), static_cast<Index>(out_.pslg.segments.size()));
      const Index s = place->second;
      if (added) {
        out_.pslg.segments.push_back({a, b});
        out_.pslg.segment_markers.push_back(polygons_[polygon].label);
        filled_.resize(filled_.size() + 2, false);
      }
      filled_[2 * s + ((out_.pslg.segments[s][0] == a) == filled_on_left ? 0 : 1)] = true;
      sides_.emplace_back(s, polygon);
    }
  }
  void add_holes(PolygonRows& rows, const Control& control) {
    const PolygonFaces faces(out_.pslg.points, out_.pslg.segments);
    std::size_t missed = 0;
    for (Index w = 0; w != faces.walks().size(); ++w) {
      throw_if_stopped(control);
      const auto& walk = faces.walks()[w];
      if (!(faces.doubled_area(walk) > 0) || std::ranges::any_of(walk, [&](Index h) { return filled_[h]; })) continue;
      std::vector<double> ys;
      for (const Index h : walk) ys.push_back(out_.pslg.points[faces.origin(h)].y);
      bool covered = false;
      const auto seed = rows.seed(std::move(ys), [&](const PolygonRows::Interval& i, const auto&) {
        if (faces.walk_of(i.left_half_edge) != w && faces.walk_of(i.right_half_edge) != w) return false;
        covered = covered || i.cover != 0;
        return i.cover == 0;
      });
      if (seed) out_.pslg.holes.push_back(*seed);
      else if (!covered) ++missed;
    }
    if (missed != 0) out_.notes.push_back(fmt::format("{} holes are too thin for a point inside them, and are meshed", missed));
  }
  void add_regions(PolygonRows& rows, const Control& control) {
    std::size_t missed = 0;
    for (Index p = 0; p != polygons_.size(); ++p) {
      throw_if_stopped(control);
      std::vector<double> ys;
      for (const Point2& q : polygons_[p].rings.front()) ys.push_back(q.y);
      auto seed = rows.seed(ys, [&](const PolygonRows::Interval& i, const auto& inside) { return i.cover == 1 && inside(p); });
      if (!seed) seed = rows.seed(std::move(ys), [&](const PolygonRows::Interval&, const auto& inside) { return inside(p); });
      if (seed) out_.pslg.regions.push_back({*seed, polygons_[p].label, polygons_[p].max_area});
      else ++missed;
    }
    if (missed != 0) out_.notes.push_back(fmt::format("{} polygons are too thin for a point inside them, and get no label", missed));
  }

  const std::vector<LabelledPolygon>& polygons_;
  PslgFile out_;
  std::unordered_map<std::pair<std::uint64_t, std::uint64_t>, Index, Hash> point_of_, segment_of_;
  /// Per half-edge: a polygon fills what is on its left.
  std::vector<bool> filled_;
  std::vector<std::pair<Index, Index>> sides_;
};

}  // namespace detail

/// The polygons as one domain. Vertices with the same coordinates are one; a segment has the label of the first polygon that has
/// it as its marker. Each polygon becomes a region; where polygons overlap, the labels of the common part are undefined.
///
/// Requires polygons with at least one ring, of at least one vertex, and finite coordinates. Polygons that cross are kept as they
/// are, for `check_pslg` to judge. Throws `Interrupted` when the control says stop. O(n sqrt n) for n vertices.
inline PslgFile polygons_to_pslg(const std::vector<LabelledPolygon>& polygons, const Control& control = Control{}) {
  return detail::PolygonGatherer(polygons).gather(control);
}

}  // namespace delref
