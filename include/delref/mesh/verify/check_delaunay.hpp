// SPDX-License-Identifier: GPL-3.0-or-later
//
// The Delaunay property of the edges, by exact predicates, and encroachment of the subsegments.
#pragma once

#include <cmath>
#include <string>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <delref/mesh/twofold.hpp>
#include <delref/mesh/verify/chains.hpp>
#include <delref/mesh/verify/report.hpp>
#include <delref/mesh/verify/shortfall.hpp>
#include <delref/mesh/verify/small_angles.hpp>

namespace delref::verification {

/// Whether the corner beyond an edge lies strictly inside the circle of the triangle on its other side. False on the boundary.
inline bool locally_not_delaunay(const Subject& s, const MeshTopology& topology, const MeshTopology::Edge& e) {
  if (e.boundary()) return false;
  const auto& [a, b, c] = s.mesh.triangles[e.forward / 3];
  return CGAL::side_of_oriented_circle(exact(s.points[a]), exact(s.points[b]), exact(s.points[c]),
                                       exact(s.points[topology.apex(e.back)])) == CGAL::ON_POSITIVE_SIDE;
}

/// Every edge that is no subsegment is locally Delaunay.
inline void check_constrained_delaunay(const Subject& s, const MeshTopology& topology, const Chains& chains, Finding& finding) {
  for (Index i = 0; i < topology.edges().size(); ++i) {
    s.breathe(i);
    const MeshTopology::Edge& e = topology.edges()[i];
    if (chains.piece_of_edge(i) != none) continue;
    ++finding.examined;
    if (locally_not_delaunay(s, topology, e)) finding.fail([&] { return s.edge(e.a, e.b) + " is not Delaunay"; });
  }
}

/// Subsegments are locally Delaunay too, but where only rounding at a tiny input angle is in the way.
inline void check_conforming_delaunay(const Subject& s, const MeshTopology& topology, const Chains& chains,
                                      const SmallAngles& small_angles, Shortfalls<Point2>& shortfalls, Finding& finding) {
  for (Index i = 0; i < topology.edges().size(); ++i) {
    const MeshTopology::Edge& e = topology.edges()[i];
    if (chains.piece_of_edge(i) == none) continue;
    ++finding.examined;
    if (!locally_not_delaunay(s, topology, e)) continue;
    if (small_angles.excuse_encroachment(e.a, e.b, topology.apex(e.forward)) ||
        small_angles.excuse_encroachment(e.a, e.b, topology.apex(e.back)))
      continue;
    const Point2 a = s.points[e.a], b = s.points[e.b];
    if (!shortfalls.settle(midpoint(a, b), std::sqrt(squared_distance(a, b))))
      finding.fail([&] { return "subsegment " + s.edge(e.a, e.b) + " is not Delaunay"; });
  }
}

/// No corner lies strictly inside the diametral circle of the subsegment that it faces, that is, sees it under an obtuse angle.
/// The slack is 1e-12 in the cosine, and tiny input angles are excused. (In a constrained Delaunay triangulation no other visible vertex need be looked at.)
inline void check_encroachment(const Subject& s, const MeshTopology& topology, const Chains& chains,
                               const SmallAngles& small_angles, Shortfalls<Point2>& shortfalls, Finding& finding) {
  const auto inside = [&](const MeshTopology::Edge& e, Index half_edge) {
    if (half_edge == none) return false;
    const Point2 p = s.points[topology.apex(half_edge)], a = s.points[e.a], b = s.points[e.b];
    return precise_dot(p, a, b) < -1e-12 * std::sqrt(squared_distance(p, a)) * std::sqrt(squared_distance(p, b)) &&
           !small_angles.excuse_encroachment(e.a, e.b, topology.apex(half_edge));
  };
  for (Index i = 0; i < topology.edges().size(); ++i) {
    const MeshTopology::Edge& e = topology.edges()[i];
    if (chains.piece_of_edge(i) == none) continue;
    ++finding.examined;
    const bool by_forward = inside(e, e.forward);
    if (!by_forward && !inside(e, e.back)) continue;
    const Point2 a = s.points[e.a], b = s.points[e.b];
    if (!shortfalls.settle(midpoint(a, b), std::sqrt(squared_distance(a, b))))
      finding.fail([&] {
        return "subsegment " + s.edge(e.a, e.b) + " is encroached by " + s.vertex(topology.apex(by_forward ? e.forward : e.back));
      });
  }
}

}  // namespace delref::verification
