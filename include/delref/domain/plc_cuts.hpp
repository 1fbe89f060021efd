// SPDX-License-Identifier: GPL-3.0-or-later
//
// Segments that pass through input vertices are cut there: a segment of the domain has no vertex inside. A vertex counts as on a
// segment when it is so within the rounding of coordinates, since a point on a slanted line has no exact coordinates as a rule.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>

#include <delref/core/budget.hpp>
#include <delref/core/point.hpp>
#include <delref/domain/describe.hpp>
#include <delref/domain/plc_names.hpp>
#include <delref/domain/plc_outlines.hpp>
#include <delref/domain/segment_table.hpp>

namespace delref {

/// Vertex `vertex` is inside segment `segment`.
struct SegmentCut {
  SegmentTable::Index segment = 0, vertex = 0;
};

/// What coordinates of this size lose by rounding, and by a few operations on them.
inline double rounding_of(std::span<const Point3> points) {
  double largest = 0;
  for (const Point3 p : points) largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return 4 * std::numeric_limits<double>::epsilon() * largest;
}

/// True when `p` is between `a` and `b`, not farther off their line than `tolerance`, and not so near to either.
inline bool lies_inside_segment(Point3 a, Point3 b, Point3 p, double tolerance) {
  const Vector3 along = b - a, to_p = p - a;
  const double length = std::sqrt(squared_length(along));
  const double position = dot(along, to_p) / length;
  if (!(position > tolerance && position < length - tolerance)) return false;
  return squared_length(cross(along, to_p)) <= tolerance * tolerance * length * length;
}

namespace plc_cuts {

using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, SegmentTable::Index>;

inline Box box_of(Point3 a, Point3 b, double margin, SegmentTable::Index info) {
  std::array low{std::min(a.x, b.x) - margin, std::min(a.y, b.y) - margin, std::min(a.z, b.z) - margin};
  std::array high{std::max(a.x, b.x) + margin, std::max(a.y, b.y) + margin, std::max(a.z, b.z) + margin};
  return {low.data(), high.data(), info};
}

}  // namespace plc_cuts

/// All cuts, sorted by segment, then from its first end to its second. O(n log^2 n).
inline std::vector<SegmentCut> find_cuts(std::span<const Point3> points, const SegmentTable& segments, const Control& control) {
  using plc_cuts::Box;
  const double tolerance = rounding_of(points);
  std::vector<Box> segment_boxes, point_boxes;
  segment_boxes.reserve(segments.size());
  point_boxes.reserve(points.size());
  for (SegmentTable::Index s = 0; s < segments.size(); ++s)
    segment_boxes.push_back(plc_cuts::box_of(points[segments[s][0]], points[segments[s][1]], tolerance, s));
  for (SegmentTable::Index v = 0; v < points.size(); ++v) point_boxes.push_back(plc_cuts::box_of(points[v], points[v], 0, v));
  std::vector<SegmentCut> cuts;
  std::size_t steps = 0;
  const auto compare = [&](const Box& segment, const Box& point) {
    if (++steps % 4096 == 0) throw_if_stopped(control);
    const auto [a, b] = segments[segment.info()];
    const SegmentTable::Index v = point.info();
    if (v != a && v != b && lies_inside_segment(points[a], points[b], points[v], tolerance)) cuts.push_back({segment.info(), v});
  };
  throw_if_stopped(control);
  CGAL::box_intersection_d(segment_boxes.begin(), segment_boxes.end(), point_boxes.begin(), point_boxes.end(), compare);
  const auto position = [&](const SegmentCut& cut) {
    return squared_distance(points[segments[cut.segment][0]], points[cut.vertex]);
  };
  std::ranges::sort(cuts, [&](const SegmentCut& a, const SegmentCut& b) {
    if (a.segment != b.segment) return a.segment < b.segment;
    const double p = position(a), q = position(b);
    return p != q ? p < q : a.vertex < b.vertex;
  });
  return cuts;
}

/// Replaces pairs of ends by the chains that cuts make of them.
class SegmentChains {
 public:
  using Ends = SegmentTable::Ends;

  SegmentChains(const SegmentTable& segments, const std::vector<SegmentCut>& cuts) : segments_(segments), cuts_(cuts) {}

  /// Appends the pieces of the segment from `ends[0]` to `ends[1]` to `pieces`. Requires that it is in the table.
  void append(Ends ends, std::vector<Ends>& pieces) const {
    const auto s = segments_.find(ends[0], ends[1]);
    const auto found = std::ranges::equal_range(cuts_, s, {}, &SegmentCut::segment);
    const std::span<const SegmentCut> inside(found.begin(), found.end());
    const bool forward = segments_[s][0] == ends[0];
    for (std::size_t k = 0; k < inside.size(); ++k) {
      const SegmentTable::Index v = inside[forward ? k : inside.size() - 1 - k].vertex;
      pieces.push_back({ends[0], v});
      ends[0] = v;
    }
    pieces.push_back(ends);
  }

 private:
  const SegmentTable& segments_;
  const std::vector<SegmentCut>& cuts_;
};

/// The outlines with every side replaced by its pieces.
inline FacetOutlines cut_outlines(const FacetOutlines& outlines, const SegmentChains& chains) {
  FacetOutlines result;
  result.facets.reserve(outlines.size());
  result.all_sides.reserve(outlines.all_sides.size());
  for (std::size_t f = 0; f < outlines.size(); ++f) {
    result.start(outlines.facets[f].original, outlines.facets[f].marker);
    for (const auto& side : outlines.curves(f)) chains.append(side, result.all_sides);
    result.end_curves();
    for (const auto& side : outlines.slits(f)) chains.append(side, result.all_sides);
    result.all_loose.insert(result.all_loose.end(), outlines.loose(f).begin(), outlines.loose(f).end());
  }
  return result;
}

/// A note on what was cut; nothing when nothing was.
inline void tell_cuts(const SegmentTable& segments, const std::vector<SegmentCut>& cuts, const PlcNames& names,
                      std::vector<std::string>& notes) {
  if (cuts.empty()) return;
  ExampleList examples;
  for (const SegmentCut& cut : cuts) {
    if (examples.full())
      examples.add();
    else
      examples.add(names.placed_segment(segments[cut.segment][0], segments[cut.segment][1]) + " at " + names.vertex(cut.vertex));
  }
  notes.push_back("segments that pass through input vertices were cut there, in " + count_of(cuts.size(), "place", "places") +
                  ": " + examples.text());
}

}  // namespace delref
