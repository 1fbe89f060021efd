// SPDX-License-Identifier: GPL-3.0-or-later
//
// Vertices that no facet and no segment names, but that lie in a facet: they become vertices of it, as if it had listed them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <CGAL/box_intersection_d.h>

#include <delref/core/budget.hpp>
#include <delref/domain/describe.hpp>
#include <delref/domain/plc_cuts.hpp>
#include <delref/domain/plc_names.hpp>
#include <delref/domain/triangulated_plc.hpp>

namespace delref {

namespace loose_vertices {

using Index = Plc::Index;

/// A vertex in a facet.
using Found = std::array<Index, 2>;

/// True when a vertex is in a triangle within rounding. It is on no segment: those were cut at such vertices.
inline bool lies_in(const TriangulatedPlc& plc, std::size_t facet, const TriangulatedPlc::Triangle& t, Point3 p,
                    double rounding) {
  const PlaneFrame& frame = plc.frames[facet];
  const Point3 a = plc.points[t[0]];
  if (std::abs(dot(frame.normal, p - a)) > rounding) return false;
  const Point2 q = frame.project(p);
  for (std::size_t i = 0; i < 3; ++i) {
    const Point2 from = frame.project(plc.points[t[i]]), to = frame.project(plc.points[t[(i + 1) % 3]]);
    if (cross(to - from, q - from) < 0) return false;
  }
  return true;
}

inline std::vector<Found> find(const TriangulatedPlc& plc, const Control& control) {
  std::vector<bool> named(plc.points.size(), false);
  for (const auto& [a, b] : plc.segments.all()) named[a] = named[b] = true;
  for (const Index v : plc.outlines.all_loose) named[v] = true;
  std::vector<plc_cuts::Box> vertices, triangles;
  for (Index v = 0; v < named.size(); ++v)
    if (!named[v]) vertices.push_back(plc_cuts::box_of(plc.points[v], plc.points[v], 0, v));
  std::vector<Found> found;
  if (vertices.empty()) return found;
  const double rounding = rounding_of(plc.points);
  std::vector<Index> facet_of(plc.triangles.size());
  for (Index f = 0; f < plc.size(); ++f)
    for (std::size_t t = plc.first_triangle[f]; t < plc.first_triangle[f + 1]; ++t) {
      facet_of[t] = f;
      BoundingBox3 box;
      for (const Index v : plc.triangles[t]) box.extend(plc.points[v]);
      triangles.push_back(plc_cuts::box_of(box.low, box.high, rounding, static_cast<Index>(t)));
    }
  std::size_t steps = 0;
  const auto compare = [&](const plc_cuts::Box& vertex, const plc_cuts::Box& box) {
    if (++steps % 4096 == 0) throw_if_stopped(control);
    const Index t = box.info(), f = facet_of[t];
    if (lies_in(plc, f, plc.triangles[t], plc.points[vertex.info()], rounding)) found.push_back({f, vertex.info()});
  };
  CGAL::box_intersection_d(vertices.begin(), vertices.end(), triangles.begin(), triangles.end(), compare);
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

/// The outlines with more loose vertices. `found` is sorted.
inline FacetOutlines with_loose(const FacetOutlines& outlines, const std::vector<Found>& found) {
  FacetOutlines result = outlines;
  result.all_loose.clear();
  auto next = found.begin();
  for (std::size_t f = 0; f < outlines.size(); ++f) {
    result.facets[f].first_loose = result.all_loose.size();
    result.all_loose.insert(result.all_loose.end(), outlines.loose(f).begin(), outlines.loose(f).end());
    for (; next != found.end() && (*next)[0] == f; ++next) result.all_loose.push_back((*next)[1]);
  }
  return result;
}

}  // namespace loose_vertices

/// Adds vertices that nothing names to the facets in which they lie, and tells it; true when there were any: these facets are to
/// be triangulated again.
inline bool adopt_loose_vertices(TriangulatedPlc& plc, const PlcNames& names, const Control& control,
                                 std::vector<std::string>& notes) {
  const std::vector<loose_vertices::Found> found = loose_vertices::find(plc, control);
  if (found.empty()) return false;
  ExampleList examples;
  for (const auto& [facet, vertex] : found) {
    if (examples.full())
      examples.add();
    else
      examples.add(names.placed_vertex(vertex) + " in " + names.facet(plc.outlines.facets[facet].original));
  }
  notes.push_back(count_of(found.size(), "vertex lies in a facet that does not list it, and was",
                           "vertices lie in facets that do not list them, and were") +
                  " made vertices there: " + examples.text());
  plc.outlines = loose_vertices::with_loose(plc.outlines, found);
  return true;
}

}  // namespace delref
