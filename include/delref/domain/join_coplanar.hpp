// SPDX-License-Identifier: GPL-3.0-or-later
//
// Coplanar neighbours become one facet, so that a box given by twelve triangles is meshed as a box. Which ones do is decided by
// `coplanar_growth.hpp`; here they are triangulated in their common plane and take the place of the first.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/domain/bounding_box_3.hpp>
#include <delref/domain/coplanar_growth.hpp>
#include <delref/domain/describe.hpp>
#include <delref/domain/facet_triangulation.hpp>
#include <delref/domain/plc_names.hpp>
#include <delref/domain/plc_options.hpp>
#include <delref/domain/segment_wedges.hpp>
#include <delref/domain/triangulated_plc.hpp>

namespace delref {

namespace join_coplanar_steps {

using Index = Plc::Index;
using Ends = SegmentTable::Ends;

/// The sides, inner segments and inner vertices of a group.
struct JoinedOutline {
  std::vector<Ends> sides, slits;  ///< the group lies to the left of its sides
  std::vector<Index> loose;

  JoinedOutline(const TriangulatedPlc& plc, const SegmentWedges& wedges, const std::vector<bool>& listed,
                const CoplanarGrowth& growth, const CoplanarGrowth::Group& group) {
    const Index name = growth.group_of(group.facets.front());
    std::vector<Index> all, on_side, seen;
    for (const Index f : group.facets)
      for (const auto& [a, b] : plc.outlines.sides(f)) seen.push_back(plc.segments.find(a, b));
    std::ranges::sort(seen);
    seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
    for (const Index s : seen) add(plc.segments[s], wedges[s], listed[s], growth, name);
    for (const Index f : group.facets)
      for (const auto& triangle : plc.triangles_of(f)) all.insert(all.end(), triangle.begin(), triangle.end());
    for (const auto* ends : {&sides, &slits})
      for (const auto& [a, b] : *ends) on_side.insert(on_side.end(), {a, b});
    for (auto* vertices : {&all, &on_side}) {
      std::ranges::sort(*vertices);
      vertices->erase(std::unique(vertices->begin(), vertices->end()), vertices->end());
    }
    std::ranges::set_difference(all, on_side, std::back_inserter(loose));
  }

 private:
  void add(Ends ends, std::span<const SegmentWedges::Wedge> wedges, bool is_listed, const CoplanarGrowth& growth, Index name) {
    std::size_t inside = 0;
    bool left = false;
    for (const auto& wedge : wedges) {
      if (growth.group_of(wedge.facet) != name) continue;
      ++inside;
      left = wedge.left != growth.is_reversed(wedge.facet);
    }
    if (inside == 1)
      sides.push_back(left ? ends : Ends{ends[1], ends[0]});
    else if (is_listed || wedges.size() > inside)
      slits.push_back(ends);
  }
};

/// A frame in the mean plane of a group.
inline PlaneFrame mean_frame(const TriangulatedPlc& plc, const CoplanarGrowth& growth, const CoplanarGrowth::Group& group,
                             double tolerance) {
  Vector3 sum{0, 0, 0};
  std::vector<Index> vertices;
  for (const Index f : group.facets) {
    sum = sum + (growth.is_reversed(f) ? -1.0 : 1.0) * twice_area(plc, f);
    for (const auto& triangle : plc.triangles_of(f)) vertices.insert(vertices.end(), triangle.begin(), triangle.end());
  }
  PlaneFrame frame = plane_frame(group.frame.origin, unit(sum), group.frame.u);
  facet_frames::centre(frame, plc.points, vertices);
  const double off = std::abs(frame.height(plc.points[farthest_off(frame, plc.points, vertices)]));
  return off <= tolerance ? frame : group.frame;
}

/// Twice the area of triangles in the projection of a frame.
inline double projected_area(std::span<const Point3> points, const PlaneFrame& frame,
                             std::span<const TriangulatedPlc::Triangle> triangles) {
  double area = 0;
  for (const auto& [a, b, c] : triangles) {
    const Point2 p = frame.project(points[a]);
    area += cross(frame.project(points[b]) - p, frame.project(points[c]) - p);
  }
  return area;
}

/// A facet made of several.
struct JoinedFacet {
  JoinedOutline outline;
  PlaneFrame frame;
  std::vector<TriangulatedPlc::Triangle> triangles;
};

/// Triangulates a group; false when that is not possible, since it folds back over itself in its plane.
inline bool triangulate(const TriangulatedPlc& plc, const CoplanarGrowth& growth, const CoplanarGrowth::Group& group,
                        double tolerance, FacetTriangulator& triangulator, JoinedFacet& joined) {
  BoundingBox3 box;
  for (const Index f : group.facets)
    for (const auto& triangle : plc.triangles_of(f))
      for (const Index v : triangle) box.extend(plc.points[v]);
  joined.frame = mean_frame(plc, growth, group, tolerance * box.diagonal());
  const JoinedOutline& outline = joined.outline;
  if (!triangulator.triangulate_left_of(joined.frame, outline.sides, outline.slits, outline.loose, joined.triangles).empty())
    return false;
  double area = 0;
  for (const Index f : group.facets)
    area += (growth.is_reversed(f) ? -1 : 1) * projected_area(plc.points, joined.frame, plc.triangles_of(f));
  return std::abs(projected_area(plc.points, joined.frame, joined.triangles) - area) <= 1e-6 * std::abs(area);
}

/// Puts joined facets in the place of their first, and leaves the others out: `joined_at[f]` is the joined facet that takes the
/// place of f, `joined.size()` where there is none.
inline void replace_facets(TriangulatedPlc& plc, const std::vector<bool>& kept, const std::vector<JoinedFacet>& joined,
                           const std::vector<std::size_t>& joined_at) {
  FacetOutlines outlines;
  std::vector<PlaneFrame> frames;
  std::vector<TriangulatedPlc::Triangle> triangles;
  std::vector<std::size_t> first_triangle{0};
  const auto add = [&](const auto& sides, const auto& slits, const auto& loose, const auto& more_triangles,
                       const PlaneFrame& frame) {
    outlines.all_sides.insert(outlines.all_sides.end(), sides.begin(), sides.end());
    outlines.end_curves();
    outlines.all_sides.insert(outlines.all_sides.end(), slits.begin(), slits.end());
    outlines.all_loose.insert(outlines.all_loose.end(), loose.begin(), loose.end());
    triangles.insert(triangles.end(), more_triangles.begin(), more_triangles.end());
    first_triangle.push_back(triangles.size());
    frames.push_back(frame);
  };
  for (std::size_t f = 0; f < plc.size(); ++f) {
    if (!kept[f]) continue;
    outlines.start(plc.outlines.facets[f].original, plc.outlines.facets[f].marker);
    if (joined_at[f] == joined.size()) {
      add(plc.outlines.curves(f), plc.outlines.slits(f), plc.outlines.loose(f), plc.triangles_of(f), plc.frames[f]);
    } else {
      const JoinedFacet& facet = joined[joined_at[f]];
      add(facet.outline.sides, facet.outline.slits, facet.outline.loose, facet.triangles, facet.frame);
    }
  }
  plc.outlines = std::move(outlines);
  plc.frames = std::move(frames);
  plc.triangles = std::move(triangles);
  plc.first_triangle = std::move(first_triangle);
  plc.find_segments();
}

}  // namespace join_coplanar_steps

/// Joins neighbours that meet in a segment where no other facet is, have one marker, and whose planes differ by at most
/// `options.join_coplanar_degrees`; nothing when that is negative. Segments between them vanish unless they are listed; vertices
/// that are on no side any more stay as vertices in the facet. A note tells how many.
inline void join_coplanar(TriangulatedPlc& plc, const PlcOptions& options, const PlcNames& names, const Control& control,
                          std::vector<std::string>& notes) {
  using namespace join_coplanar_steps;
  if (!(options.join_coplanar_degrees >= 0)) return;
  const SegmentWedges wedges(plc);
  const std::vector<bool> listed = listed_segments(plc);
  CoplanarGrowth growth(plc, wedges, options);
  FacetTriangulator triangulator(names);
  std::vector<JoinedFacet> joined;
  std::vector<bool> kept(plc.size(), true);
  std::vector<Index> places;  // of the first facet of each that is joined
  std::size_t count = 0;
  ExampleList failures;
  for (const CoplanarGrowth::Group& group : growth.run(control)) {
    throw_if_stopped(control);
    JoinedFacet facet{JoinedOutline(plc, wedges, listed, growth, group), {}, {}};
    if (!triangulate(plc, growth, group, options.planarity_tolerance, triangulator, facet)) {
      failures.add(names.facet(plc.outlines.facets[group.facets.front()].original));
      continue;
    }
    for (const Index f : group.facets) kept[f] = f == group.facets.front();
    places.push_back(group.facets.front());
    joined.push_back(std::move(facet));
    count += group.facets.size();
  }
  if (failures.count() > 0)
    notes.push_back("coplanar neighbours of " + count_of(failures.count(), "facet", "facets") +
                    " were not joined, since they overlap in the plane: " + failures.text());
  if (joined.empty()) return;
  std::vector<std::size_t> joined_at(plc.size(), joined.size());
  for (std::size_t j = 0; j < places.size(); ++j) joined_at[places[j]] = j;
  replace_facets(plc, kept, joined, joined_at);
  notes.push_back(count_of(count, "facet was", "facets were") + " joined with coplanar neighbours into " +
                  std::to_string(joined.size()));
}

}  // namespace delref
