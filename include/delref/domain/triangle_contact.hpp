// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether two triangles, or a segment and a triangle, of a complex meet elsewhere than in the vertices and edges that they share.
// Exact; the signs of a few orientations settle nearly every pair (Guigue, Devillers 2003).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include <delref/core/point.hpp>
#include <delref/domain/exact_side_3.hpp>

namespace delref {

namespace triangle_contact {

using Index = std::uint32_t;
using Corners = std::array<Index, 3>;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

inline Kernel::Point_3 cgal(Point3 p) { return {p.x, p.y, p.z}; }
inline Kernel::Triangle_3 triangle(std::span<const Point3> points, const Corners& t) {
  return {cgal(points[t[0]]), cgal(points[t[1]]), cgal(points[t[2]])};
}

/// Moves what two lists share to their fronts, in the same order; gives how many.
template <std::size_t M, std::size_t N>
std::size_t bring_shared_forward(std::array<Index, M>& s, std::array<Index, N>& t) {
  std::size_t shared = 0;
  for (std::size_t i = 0; i < M; ++i)
    for (std::size_t j = shared; j < N; ++j)
      if (s[i] == t[j]) {
        std::swap(s[shared], s[i]);
        std::swap(t[shared], t[j]);
        ++shared;
        break;
      }
  return shared;
}

/// The sides of three coplanar points in a view in which the plane is not on edge.
class PlaneView {
 public:
  PlaneView(Point3 a, Point3 b, Point3 c) : axis_(view_axis(a, b, c)) {}
  /// False when the three points are collinear.
  bool is_plane() const { return axis_ >= 0; }
  int side(Point3 a, Point3 b, Point3 c) const {
    return exact_side(dropped_coordinate(a, axis_), dropped_coordinate(b, axis_), dropped_coordinate(c, axis_));
  }
  /// True when the ray from `apex` through `p` lies between those through `a` and `b`, or along one of them. Requires that these
  /// three are not collinear.
  bool in_sector(Point3 apex, Point3 a, Point3 b, Point3 p) const {
    const int turn = side(apex, a, b);
    return turn * side(apex, a, p) >= 0 && turn * side(apex, p, b) >= 0;
  }

 private:
  int axis_;
};

/// Triangles a, b, c and a, b, d: true when they are coplanar and on the same side of a b.
inline bool meet_beyond_edge(Point3 a, Point3 b, Point3 c, Point3 d) {
  if (exact_side(a, b, c, d) != 0) return false;
  const PlaneView view(a, b, c);
  return view.is_plane() && view.side(a, b, c) == view.side(a, b, d);
}

/// Triangles v, a, b and v, c, d: true when they have more in common than v.
inline bool meet_beyond_vertex(Point3 v, Point3 a, Point3 b, Point3 c, Point3 d) {
  const int sc = exact_side(v, a, b, c), sd = exact_side(v, a, b, d);
  if (sc * sd > 0) return false;
  const int sa = exact_side(v, c, d, a), sb = exact_side(v, c, d, b);
  if (sa * sb > 0) return false;
  // Every vertex that is in the other's plane decides by its place in the other's sector.
  if (sc == 0 || sd == 0) {
    const PlaneView view(v, a, b);
    if (!view.is_plane()) return false;
    if (sc == 0 && view.in_sector(v, a, b, c)) return true;
    if (sd == 0 && view.in_sector(v, a, b, d)) return true;
  }
  if (sa == 0 || sb == 0) {
    const PlaneView view(v, c, d);
    if (!view.is_plane()) return false;
    if (sa == 0 && view.in_sector(v, c, d, a)) return true;
    if (sb == 0 && view.in_sector(v, c, d, b)) return true;
  }
  if (sc == 0 || sd == 0 || sa == 0 || sb == 0) return false;
  // Both sectors reach across the line in which the planes meet: on the same side of v if a b passes inside c d, or c d inside a
  // b.
  const int s = exact_side(a, b, c, d);
  return s == 0 || sc == s || sa == s;
}

/// True when the three are strictly on one side.
inline bool one_side(int a, int b, int c) { return a != 0 && a == b && b == c; }

inline bool meet_anywhere(std::span<const Point3> points, const Corners& s, const Corners& t) {
  const auto apart = [&](const Corners& plane, const Corners& others) {
    const Point3 a = points[plane[0]], b = points[plane[1]], c = points[plane[2]];
    const int first = exact_side(a, b, c, points[others[0]]);
    if (first == 0) return false;
    return first == exact_side(a, b, c, points[others[1]]) && first == exact_side(a, b, c, points[others[2]]);
  };
  if (apart(s, t) || apart(t, s)) return false;
  return CGAL::do_intersect(triangle(points, s), triangle(points, t));
}

}  // namespace triangle_contact

/// True when two triangles have more in common than vertices and an edge. Requires that neither is degenerate.
inline bool triangles_meet(std::span<const Point3> points, std::array<std::uint32_t, 3> s, std::array<std::uint32_t, 3> t) {
  using namespace triangle_contact;
  switch (bring_shared_forward(s, t)) {
    case 0:
      return meet_anywhere(points, s, t);
    case 1:
      return meet_beyond_vertex(points[s[0]], points[s[1]], points[s[2]], points[t[1]], points[t[2]]);
    case 2:
      return meet_beyond_edge(points[s[0]], points[s[1]], points[s[2]], points[t[2]]);
    default:
      return true;
  }
}

/// True when a segment and a triangle have more in common than one vertex.
inline bool segment_meets_triangle(std::span<const Point3> points, std::array<std::uint32_t, 2> s,
                                   std::array<std::uint32_t, 3> t) {
  using namespace triangle_contact;
  const std::size_t shared = bring_shared_forward(s, t);
  if (shared == 2) return true;
  const Point3 a = points[t[0]], b = points[t[1]], c = points[t[2]];
  const int first = shared == 1 ? 0 : exact_side(a, b, c, points[s[0]]), second = exact_side(a, b, c, points[s[1]]);
  if (shared == 1) {
    if (second != 0) return false;
    const PlaneView view(a, b, c);
    return view.is_plane() && view.in_sector(a, b, c, points[s[1]]);
  }
  if (first * second > 0) return false;
  return CGAL::do_intersect(Kernel::Segment_3(cgal(points[s[0]]), cgal(points[s[1]])), triangle(points, t));
}

/// True when two segments have more in common than one vertex.
inline bool segments_meet(std::span<const Point3> points, std::array<std::uint32_t, 2> s, std::array<std::uint32_t, 2> t) {
  using namespace triangle_contact;
  const std::size_t shared = bring_shared_forward(s, t);
  if (shared == 2) return true;
  if (shared == 1) {
    const Point3 v = points[s[0]], a = points[s[1]], b = points[t[1]];
    return exactly_collinear(v, a, b) && dot(a - v, b - v) > 0;
  }
  return CGAL::do_intersect(Kernel::Segment_3(cgal(points[s[0]]), cgal(points[s[1]])),
                            Kernel::Segment_3(cgal(points[t[0]]), cgal(points[t[1]])));
}

}  // namespace delref
