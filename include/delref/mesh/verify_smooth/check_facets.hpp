// SPDX-License-Identifier: GPL-3.0-or-later
//
// The checks of the facets of the surface against the oracle and the criteria, by their surface balls.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <delref/mesh/tetrahedron_measures.hpp>
#include <delref/mesh/verify/report.hpp>
#include <delref/mesh/verify_smooth/excuses.hpp>
#include <delref/mesh/verify_smooth/subject.hpp>
#include <delref/mesh/verify_smooth/surface_balls.hpp>
#include <delref/mesh/verify_smooth/surface_graph.hpp>

namespace delref::verification_smooth {

/// What rounding, and the tolerance of the surface, may do to a length.
inline double slack(const Subject& s) { return 1 + 1e-9 + s.options.surface_tolerance; }

inline double shortest_edge(const std::array<Point3, 3>& c) {
  return std::sqrt(std::min({squared_distance(c[0], c[1]), squared_distance(c[0], c[2]), squared_distance(c[1], c[2])}));
}

/// Where there are more than two regions the crossing nearest to a triangle may be another one than that between the regions of the cells
/// on its two sides: those at the ends of the dual edge.
template <Oracle O>
void sides_at_ends(const Subject& s, SurfaceBallFinder<O>& ball_of, std::vector<Sides>& sides, std::vector<SurfaceBall>& balls) {
  for (std::size_t t = 0; t < sides.size(); ++t) {
    s.breathe(64 * t);
    const auto corners = s.corners(t);
    const Sides ends = ball_of.at_ends(corners);
    if (ends.behind <= ends.front) continue;
    sides[t] = ends;
    if (const SurfaceBall ball = ball_of(corners, shortest_edge(corners), ends); ball.is_known()) balls[t] = ball;
  }
}

/// The surface meets the dual edge of every triangle: there is a ball with the corners on its sphere, its centre on the surface between
/// the two regions of the triangle, and no vertex inside. Writes down the balls, and, where the sides of a triangle are not known, these.
template <Oracle O>
void check_balls(const Subject& s, SurfaceBallFinder<O>& ball_of, std::vector<Sides>& sides, std::vector<SurfaceBall>& balls, Finding& finding) {
  finding.examined = s.mesh.triangles.size();
  sides.resize(s.mesh.triangles.size());
  std::size_t flat = 0, touching = 0;
  for (std::size_t t = 0; t < s.mesh.triangles.size(); ++t) {
    s.breathe(16 * t);
    const auto corners = s.corners(t);
    const SurfaceBall ball = ball_of(corners, shortest_edge(corners), sides[t]);
    balls.push_back(ball);
    if (sides[t].behind == unknown_region && ball.kind == SurfaceBall::Kind::found) sides[t] = ball.sides;
    using Kind = SurfaceBall::Kind;
    if (ball.kind == Kind::flat) ++flat;
    else if (ball.kind == Kind::touching) ++touching;
    else if (ball.kind == Kind::not_empty) finding.fail([&] { return s.triangle(t) + " has a vertex in every ball through its corners"; });
    else if (ball.kind == Kind::no_crossing) finding.fail([&] { return s.triangle(t) + " has a dual edge that does not meet the surface"; });
    else if (ball.kind == Kind::turned) finding.fail([&] { return s.triangle(t) + " is turned the wrong way"; });
  }
  if (s.mesh.tetrahedra.empty() && std::ranges::adjacent_find(sides, std::ranges::not_equal_to{}) != sides.end())
    sides_at_ends(s, ball_of, sides, balls);
  if (touching != 0) finding.note = fmt::format("{} have a dual edge that is on the surface and does not go through it", touching);
  if (flat != 0) finding.note += (finding.note.empty() ? "" : ", ") + fmt::format("{} more are so flat that they have no axis", flat);
}

inline void check_facet_angles(const Subject& s, Excuses& excuses, VerifyReport& report, Finding& finding) {
  finding.examined = s.mesh.triangles.size();
  const double bound = s.options.facet_angle.degrees();
  for (std::size_t t = 0; t < s.mesh.triangles.size(); ++t) {
    s.breathe(t);
    const auto [a, b, c] = s.corners(t);
    const double angle = std::min({angle_degrees(b - a, c - a), angle_degrees(c - b, a - b), angle_degrees(a - c, b - c)});
    report.smallest_angle = std::min(report.smallest_angle, angle);
    if (angle < bound - 1e-6) {
      if (excuses.settle_facet(t)) continue;
      finding.fail([&] { return fmt::format("{} has an angle of {} degrees", s.triangle(t), angle); });
    }
    report.smallest_angle_in_force = std::min(report.smallest_angle_in_force, angle);
  }
  finding.note = excuses.floor_note();
}

/// No ball is larger than the bound, and than the field says at its centre. A size that is not positive is met by nothing.
inline void check_facet_sizes(const Subject& s, std::span<const SurfaceBall> balls, Excuses& excuses, Finding& finding) {
  for (std::size_t t = 0; t < balls.size(); ++t) {
    s.breathe(t);
    if (!balls[t].is_known()) continue;
    ++finding.examined;
    double size = s.options.facet_size;
    if (s.options.facet_size_field) size = std::min(size, s.options.facet_size_field(s.original(balls[t].centre)));
    if (balls[t].radius <= s.scaling.length(size) * slack(s) || excuses.settle_facet(t)) continue;
    finding.fail([&] {
      return fmt::format("{} has a surface ball of radius {}, the size is {}", s.triangle(t), s.scaling.original_length(balls[t].radius), size);
    });
  }
  finding.note = excuses.floor_note();
}

/// The same for the distance between circumcentre and surface, which is known as exactly as the surface is.
inline void check_facet_distances(const Subject& s, std::span<const SurfaceBall> balls, Excuses& excuses, Finding& finding) {
  for (std::size_t t = 0; t < balls.size(); ++t) {
    s.breathe(t);
    if (!balls[t].is_known()) continue;
    ++finding.examined;
    double bound = s.options.facet_distance;
    if (s.options.facet_distance_field) bound = std::min(bound, s.options.facet_distance_field(s.original(balls[t].centre)));
    const double tolerance = 4 * s.options.surface_tolerance * balls[t].radius;
    if (balls[t].distance <= s.scaling.length(bound) * slack(s) + tolerance || excuses.settle_facet(t)) continue;
    finding.fail([&] {
      return fmt::format("{} is {} from the surface, the bound is {}", s.triangle(t), s.scaling.original_length(balls[t].distance), bound);
    });
  }
  finding.note = excuses.floor_note();
}

/// Every component of the surface that the domain finds has a point in the mesh: one of its seeds is within a surface ball's radius of
/// the vertex nearest to it. A component is not told from another one that is nearer to it than the facets are large.
template <FindsComponents O>
void check_coverage(const Subject& s, const SurfaceGraph& graph, std::span<const SurfaceBall> balls, const SurfaceComponents& components,
                    Finding& finding) {
  std::vector<Point3> on_surface;
  std::vector<std::pair<Point3, double>> radii;
  const auto less = [](Point3 p, Point3 q) { return std::array{p.x, p.y, p.z} < std::array{q.x, q.y, q.z}; };
  for (Index v = 0; v < s.points.size(); ++v) {
    if (!graph.is_on_surface(v)) continue;
    double radius = 0;
    for (const Index t : graph.triangles_at(v))
      if (balls[t].is_known()) radius = std::max(radius, balls[t].radius);
    on_surface.push_back(s.points[v]);
    radii.push_back({s.points[v], radius});
  }
  std::ranges::sort(radii, less, &std::pair<Point3, double>::first);
  const verification::NearestPoint<Point3> nearest(std::move(on_surface));
  finding.examined = components.components.size();
  finding.note = components.method;
  std::size_t missed = 0;
  for (const auto& component : components.components) {
    const bool is_covered = std::ranges::any_of(component, [&](Point3 seed) {
      const Point3 p = s.scaling(seed);
      const Point3* v = nearest.closer_than(p, std::numeric_limits<double>::infinity());
      if (v == nullptr) return false;
      const double radius = std::ranges::lower_bound(radii, *v, less, &std::pair<Point3, double>::first)->second;
      return squared_distance(p, *v) <= radius * radius * slack(s);
    });
    if (is_covered) continue;
    if (++missed > s.expected.missed_components || s.expected.strict)
      finding.fail([&] { return "no facet is at the component of the surface at " + s.place(component.front()); });
  }
}

}  // namespace delref::verification_smooth
