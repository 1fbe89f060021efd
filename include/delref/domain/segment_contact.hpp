// SPDX-License-Identifier: GPL-3.0-or-later
//
// How two segments of a planar straight line graph meet, decided exactly, and where, rounded once. Segments that touch (a shared
// vertex, an end on the other's inside) are valid: the triangulation splits the touched one at that vertex.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include <CGAL/Exact_rational.h>

#include <delref/core/point.hpp>
#include <delref/domain/exact_side.hpp>

namespace delref {

/// What two segments have in common that a valid graph does not allow.
enum class SegmentContact : std::uint8_t {
  valid,     ///< nothing, or one point that is an end of at least one of them
  crossing,  ///< one point inside both
  overlap    ///< more than one point
};

/// The ends of a segment.
using Ends2 = std::array<Point2, 2>;

/// True when `a` comes before `b` by x, then y.
inline bool lexicographically_less(Point2 a, Point2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

/// The ends in lexicographic order.
inline Ends2 ordered(Ends2 s) { return lexicographically_less(s[1], s[0]) ? Ends2{s[1], s[0]} : s; }

/// What two collinear segments share, from its lexicographically lower end; reversed or a point when they do not overlap.
inline Ends2 common_part(Ends2 a, Ends2 b) {
  a = ordered(a);
  b = ordered(b);
  return {std::max(a[0], b[0], lexicographically_less), std::min(a[1], b[1], lexicographically_less)};
}

/// How two segments of positive length meet. Exact.
inline SegmentContact contact(Ends2 a, Ends2 b) {
  const int first = exact_side(a[0], a[1], b[0]);
  const int second = exact_side(a[0], a[1], b[1]);
  if (first == 0 && second == 0) {
    const Ends2 common = common_part(a, b);
    return lexicographically_less(common[0], common[1]) ? SegmentContact::overlap : SegmentContact::valid;
  }
  if (first * second >= 0) return SegmentContact::valid;
  return exact_side(b[0], b[1], a[0]) * exact_side(b[0], b[1], a[1]) < 0 ? SegmentContact::crossing : SegmentContact::valid;
}

/// The point in which two segments cross, exactly. Requires `contact(a, b) == SegmentContact::crossing`.
inline std::array<CGAL::Exact_rational, 2> exact_crossing(Ends2 a, Ends2 b) {
  using Exact = CGAL::Exact_rational;
  const Exact ax = a[0].x, ay = a[0].y, bx = b[0].x, by = b[0].y;
  const Exact ux = Exact(a[1].x) - ax, uy = Exact(a[1].y) - ay, vx = Exact(b[1].x) - bx, vy = Exact(b[1].y) - by;
  const Exact t = ((bx - ax) * vy - (by - ay) * vx) / (ux * vy - uy * vx);
  return {Exact(ax + t * ux), Exact(ay + t * uy)};
}

/// That point with each coordinate rounded to a double, monotonically: along a segment, rounded points keep their order and stay
/// within the box of its ends.
inline Point2 rounded_crossing(Ends2 a, Ends2 b) {
  const auto [x, y] = exact_crossing(a, b);
  return {CGAL::to_double(x), CGAL::to_double(y)};
}

}  // namespace delref
