// SPDX-License-Identifier: GPL-3.0-or-later
//
// The checks of the vertices: those of triangles are on the surface, and all say what they lie on and who inserted them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <delref/mesh/verify/report.hpp>
#include <delref/mesh/verify_smooth/excuses.hpp>
#include <delref/mesh/verify_smooth/subject.hpp>
#include <delref/mesh/verify_smooth/surface_graph.hpp>
#include <delref/mesh/verify_smooth/surface_probe.hpp>

namespace delref::verification_smooth {

/// A vertex is on the surface when the region changes within so many tolerances of it, each a part of the shortest edge at it. More
/// than one, because edges get shorter after a vertex is made.
inline constexpr double most_tolerances = 16;

template <Oracle O>
void check_vertices_on_surface(const Subject& s, Questions<O>& questions, const SurfaceGraph& graph, const std::vector<double>& shortest_edges,
                               Excuses& excuses, Finding& finding) {
  SurfaceProbe<O> probe(questions);
  std::size_t left = 0;
  for (Index v = 0; v < s.points.size(); ++v) {
    s.breathe(16 * std::size_t{v});
    if (!graph.is_on_surface(v)) continue;
    ++finding.examined;
    Vector3 normal;
    for (const Index t : graph.triangles_at(v)) {
      const auto [a, b, c] = s.corners(t);
      normal = normal + cross(b - a, c - a);
    }
    const double length = std::sqrt(squared_length(normal));
    normal = length > 0 ? (1 / length) * normal : Vector3{1, 0, 0};
    const Point3 p = s.points[v];
    const double rounding = 16 * std::numeric_limits<double>::epsilon() * std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    const double tolerance = most_tolerances * s.options.surface_tolerance * shortest_edges[v] + rounding;
    if (probe.finds_change(p, normal, tolerance)) continue;
    const auto its = graph.triangles_at(v);
    if (!s.expected.strict && std::ranges::any_of(its, [&](Index t) { return excuses.is_listed(t); })) ++left;
    else if (!excuses.settle_unfinished())
      finding.fail([&] {
        double distance = tolerance;
        while (distance < shortest_edges[v] && !probe.finds_change(p, normal, distance)) distance *= 2;
        return fmt::format("{} is about {} from the surface ({} would do)", s.vertex(v), s.scaling.original_length(distance),
                           s.scaling.original_length(tolerance));
      });
  }
  if (left != 0) finding.note = fmt::format("{} more are at facets that are left as they are", left);
}

/// The shortest edge of tetrahedra and triangles at each vertex, scaled; infinity at those without any.
inline std::vector<double> shortest_edges_at_vertices(const Subject& s) {
  std::vector<double> shortest(s.points.size(), std::numeric_limits<double>::infinity());
  const auto edge = [&](Index v, Index w) {
    const double squared = squared_distance(s.points[v], s.points[w]);
    shortest[v] = std::min(shortest[v], squared);
    shortest[w] = std::min(shortest[w], squared);
  };
  const auto edges = [&](const auto& element) {
    for (std::size_t i = 0; i < element.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) edge(element[i], element[j]);
  };
  for (const auto& t : s.mesh.triangles) edges(t);
  for (const auto& t : s.mesh.tetrahedra) edges(t);
  for (double& length : shortest) length = std::sqrt(length);
  return shortest;
}

/// Vertices of triangles lie on the surface, others inside a region. (A vertex may be on the surface without being one of its
/// triangles': a seed where refinement has come to an end by its floor.)
inline void check_carriers(const Subject& s, const SurfaceGraph& graph, Excuses& excuses, Finding& finding) {
  std::size_t others = 0;
  for (Index v = 0; v < s.points.size(); ++v) {
    ++finding.examined;
    const int dimension = s.mesh.carriers[v].dimension;
    if (dimension == 2 && !graph.is_on_surface(v)) ++others;
    if (dimension == (graph.is_on_surface(v) ? 2 : 3) || dimension == 2) continue;
    const auto its = graph.triangles_at(v);
    if (!s.expected.strict && std::ranges::any_of(its, [&](Index t) { return excuses.is_listed(t); })) continue;
    if (graph.is_on_surface(v) && excuses.settle_unfinished()) continue;
    finding.fail([&] {
      return fmt::format("{} says that it lies on something of dimension {}, and {}", s.vertex(v), dimension,
                         graph.is_on_surface(v) ? "triangles of the surface have it" : "lies inside a region");
    });
  }
  if (others != 0) finding.note = fmt::format("{} say that they are on the surface and are no corners of its triangles", others);
}

/// Every vertex names a level, or is one of the seeds, of which the surface is made.
inline void check_provenance(const Subject& s, Finding& finding) {
  finding.examined = s.points.size();
  for (Index v = 0; v < s.points.size(); ++v) {
    const LevelIndex level = s.mesh.provenance[v];
    if (level == input_level ? s.mesh.carriers.empty() || s.mesh.carriers[v].dimension == 2 : level < s.mesh.level_names.size()) continue;
    finding.fail([&] {
      return s.vertex(v) + (level == input_level ? " says that it is a seed, and is not on the surface" : " names no level that inserted it");
    });
  }
}

}  // namespace delref::verification_smooth
