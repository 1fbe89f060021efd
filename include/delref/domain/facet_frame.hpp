// SPDX-License-Identifier: GPL-3.0-or-later
//
// The plane of a facet. Its normal is Newell's (Sutherland, Sproull, Schumacker 1974), the average over a closed curve that need
// not be quite planar; of slim triangles, where rounding would decide, it is computed exactly and rounded.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <CGAL/Exact_rational.h>

#include <delref/core/point.hpp>
#include <delref/domain/bounding_box_3.hpp>
#include <delref/domain/exact_side_3.hpp>
#include <delref/domain/plc_outlines.hpp>
#include <delref/domain/polyhedral_domain.hpp>

namespace delref {

/// The vector of length 1 in this direction, however long or short it is. Requires that it is finite and not 0.
inline Vector3 unit(Vector3 a) {
  double largest = std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)});
  if (largest < 1e-100 || largest > 1e100) {
    const int exponent = -std::ilogb(largest);
    a = {std::ldexp(a.x, exponent), std::ldexp(a.y, exponent), std::ldexp(a.z, exponent)};
  }
  return (1 / std::sqrt(squared_length(a))) * a;
}

/// The part of `direction` at a right angle to the normal; some such vector where there is none, as in facets far from planar.
inline Vector3 across(Vector3 normal, Vector3 direction) {
  const Vector3 part = direction - dot(direction, normal) * normal;
  if (squared_length(part) > 1e-12 * squared_length(direction)) return part;
  return std::abs(normal.x) < 0.6 ? cross(normal, {1, 0, 0}) : cross(normal, {0, 1, 0});
}

/// The frame with this normal of length 1 through a point. Axes of the normal's kind where it is along an axis, so that upright
/// planes are handled without rounding; else `u` goes along `direction`.
inline PlaneFrame plane_frame(Point3 origin, Vector3 normal, Vector3 direction) {
  PlaneFrame frame{origin, {}, {}, normal};
  if (normal.x == 0 && normal.y == 0)
    frame.u = {1, 0, 0};
  else if (normal.y == 0 && normal.z == 0)
    frame.u = {0, 1, 0};
  else if (normal.z == 0 && normal.x == 0)
    frame.u = {0, 0, 1};
  else
    frame.u = unit(across(normal, direction));
  frame.v = cross(normal, frame.u);
  return frame;
}

namespace facet_frames {

/// The direction of (b - a) x (c - a), exactly computed.
inline Vector3 exact_cross(Point3 a, Point3 b, Point3 c) {
  using Exact = CGAL::Exact_rational;
  const auto difference = [](Point3 p, Point3 q) {
    return std::array<Exact, 3>{Exact(p.x) - Exact(q.x), Exact(p.y) - Exact(q.y), Exact(p.z) - Exact(q.z)};
  };
  const auto u = difference(b, a), v = difference(c, a);
  std::array<Exact, 3> n{Exact(u[1] * v[2] - u[2] * v[1]), Exact(u[2] * v[0] - u[0] * v[2]), Exact(u[0] * v[1] - u[1] * v[0])};
  const Exact largest = std::max({CGAL::abs(n[0]), CGAL::abs(n[1]), CGAL::abs(n[2])});
  for (Exact& x : n) x /= largest;
  return {CGAL::to_double(n[0]), CGAL::to_double(n[1]), CGAL::to_double(n[2])};
}

}  // namespace facet_frames

/// A vector of length 1 normal to a triangle, which it sees counterclockwise. Requires that the triangle is not degenerate.
inline Vector3 triangle_normal(Point3 a, Point3 b, Point3 c) {
  const Vector3 u = b - a, v = c - a;
  const Vector3 n = cross(u, v);
  const double size = squared_length(u) * squared_length(v);
  if (squared_length(n) > 1e-16 * size && size > 1e-200) return unit(n);
  return unit(facet_frames::exact_cross(a, b, c));
}

namespace facet_frames {

/// The frame of a triangle, from its corner opposite to the longest edge: the product of the shorter edges is the most precise.
inline PlaneFrame triangle_frame(std::array<Point3, 3> p) {
  std::size_t apex = 0;
  const auto opposite = [&](std::size_t i) { return squared_distance(p[(i + 1) % 3], p[(i + 2) % 3]); };
  for (std::size_t i = 1; i < 3; ++i)
    if (opposite(i) > opposite(apex)) apex = i;
  const Point3 a = p[apex], b = p[(apex + 1) % 3], c = p[(apex + 2) % 3];
  return plane_frame(a, triangle_normal(a, b, c), c - b);
}

/// Twice the area vector of a closed curve.
inline Vector3 newell(std::span<const Point3> points, std::span<const FacetOutlines::Side> curve) {
  const Point3 origin = points[curve.front()[0]];
  Vector3 sum{0, 0, 0};
  for (const auto& [a, b] : curve) sum = sum + cross(points[a] - origin, points[b] - origin);
  return sum;
}

/// The area vector of the curve with the largest.
inline Vector3 largest_newell(std::span<const Point3> points, std::span<const FacetOutlines::Side> curves) {
  Vector3 largest{0, 0, 0};
  for (std::size_t first = 0; first < curves.size();) {
    std::size_t last = first;
    while (last < curves.size() && curves[last][1] != curves[first][0]) ++last;
    last = std::min(last + 1, curves.size());
    const Vector3 candidate = newell(points, curves.subspan(first, last - first));
    if (squared_length(candidate) > squared_length(largest)) largest = candidate;
    first = last;
  }
  return largest;
}

/// Three of the vertices far apart and not collinear, if there are.
inline std::optional<std::array<Point3, 3>> wide_triangle(std::span<const Point3> points, std::span<const Plc::Index> vertices) {
  const Point3 a = points[vertices[0]];
  Point3 b = a, c = a;
  for (const Plc::Index v : vertices)
    if (squared_distance(points[v], a) > squared_distance(b, a)) b = points[v];
  double widest = 0;
  bool found = false;
  for (const Plc::Index v : vertices) {
    const double width = squared_length(cross(b - a, points[v] - a));
    if (found && width <= widest) continue;
    if (exactly_collinear(a, b, points[v])) continue;
    found = true;
    widest = width;
    c = points[v];
  }
  if (!found) return std::nullopt;
  return std::array{a, b, c};
}

/// Moves the origin along the normal to the middle of the heights of the vertices.
inline void centre(PlaneFrame& frame, std::span<const Point3> points, std::span<const Plc::Index> vertices) {
  double low = 0, high = 0;
  for (const Plc::Index v : vertices) {
    low = std::min(low, frame.height(points[v]));
    high = std::max(high, frame.height(points[v]));
  }
  if (low + high != 0) frame.origin = frame.origin + 0.5 * (low + high) * frame.normal;
}

}  // namespace facet_frames

/// A frame in the plane of a facet: right-handed, its curve of largest area counterclockwise. Nothing when one line holds all
/// vertices. `vertices` are those of the facet.
inline std::optional<PlaneFrame> facet_frame(std::span<const Point3> points, const FacetOutlines& outlines, std::size_t f,
                                             std::span<const Plc::Index> vertices) {
  using namespace facet_frames;
  const auto curves = outlines.curves(f);
  if (outlines.is_triangle(f)) {
    const std::array corners{points[curves[0][0]], points[curves[1][0]], points[curves[2][0]]};
    if (exactly_collinear(corners[0], corners[1], corners[2])) return std::nullopt;
    return triangle_frame(corners);
  }
  const auto wide = wide_triangle(points, vertices);
  if (!wide) return std::nullopt;
  const Vector3 area = largest_newell(points, curves);
  const double reach = squared_distance((*wide)[0], (*wide)[1]);
  PlaneFrame frame;
  if (squared_length(area) > 1e-16 * reach * reach && reach > 1e-100) {
    frame = plane_frame(points[vertices[0]], unit(area), (*wide)[1] - (*wide)[0]);
  } else {
    frame = triangle_frame(*wide);
    if (dot(frame.normal, area) < 0) frame = {frame.origin, frame.u, -1.0 * frame.v, -1.0 * frame.normal};
  }
  centre(frame, points, vertices);
  return frame;
}

/// The vertex that is farthest off the plane.
inline Plc::Index farthest_off(const PlaneFrame& frame, std::span<const Point3> points, std::span<const Plc::Index> vertices) {
  return *std::ranges::max_element(vertices, {}, [&](Plc::Index v) { return std::abs(frame.height(points[v])); });
}

}  // namespace delref
