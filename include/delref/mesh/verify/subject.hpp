// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is being verified, with scaled coordinates and the words for its elements. Elements are numbered as in the files, that
// is, from the first index of the input.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <delref/core/budget.hpp>
#include <delref/core/point.hpp>
#include <delref/domain/pslg.hpp>
#include <delref/mesh/planar_mesh.hpp>
#include <delref/mesh/scaling.hpp>
#include <delref/mesh/triangle_measures.hpp>
#include <delref/mesh/verify/criteria.hpp>
#include <delref/mesh/verify/topology.hpp>
#include <delref/mesh/verify/ulp.hpp>

namespace delref::verification {

struct Subject {
  const Pslg& input;
  const PlanarMesh& mesh;
  const PlanarCriteria& criteria;
  const Control& control;
  PowerOfTwoScaling scaling{std::max(largest_absolute_coordinate(input.points), largest_absolute_coordinate(mesh.points))};
  std::vector<Point2> input_points = scaling(input.points);
  std::vector<Point2> points = scaling(mesh.points);

  void breathe(std::size_t step) const {
    if (step % 4096 == 0) throw_if_stopped(control);
  }
  TriangleMeasures shape(std::size_t t) const {
    const auto& [a, b, c] = mesh.triangles[t];
    return {points[a], points[b], points[c]};
  }
  Point2 barycentre(std::size_t t) const {
    const Point2 p = shape(t).barycentre();
    return {scaling.original_length(p.x), scaling.original_length(p.y)};
  }

  /// By which index the mesh names an input vertex or segment.
  Index point_name(Index v) const { return criteria.point_names.empty() ? v : criteria.point_names[v]; }
  Index segment_name(Index i) const { return criteria.segment_names.empty() ? i : criteria.segment_names[i]; }
  /// Whether one of some input segments has that name.
  bool is_named(std::span<const Index> segments, Index name) const {
    return std::ranges::any_of(segments, [&](Index i) { return segment_name(i) == name; });
  }

  std::size_t number(std::size_t index) const { return index + input.first_index; }
  std::string vertex(Index v) const {
    return fmt::format("vertex {} at ({}, {})", number(v), mesh.points[v].x, mesh.points[v].y);
  }
  std::string edge(Index v, Index w) const {
    return fmt::format("edge {} - {} from ({}, {}) to ({}, {})", number(v), number(w), mesh.points[v].x, mesh.points[v].y,
                       mesh.points[w].x, mesh.points[w].y);
  }
  std::string triangle(std::size_t t) const {
    const auto& [a, b, c] = mesh.triangles[t];
    const Point2 p = barycentre(t);
    return fmt::format("triangle {} (vertices {}, {}, {}) around ({}, {})", number(t), number(a), number(b), number(c), p.x, p.y);
  }
  std::string segment(std::size_t s) const {
    const auto& [a, b] = input.segments[s];
    return fmt::format("segment {} from ({}, {}) to ({}, {})", number(s), input.points[a].x, input.points[a].y, input.points[b].x,
                       input.points[b].y);
  }
};

}  // namespace delref::verification
