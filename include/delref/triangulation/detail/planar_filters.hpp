// SPDX-License-Identifier: GPL-3.0-or-later
//
// Signs of the planar predicates in floating-point arithmetic, where a bound on the rounding error proves them: some hundred
// times a vertex, so that they are inline here; what they leave open goes to CGAL's exact predicates. Bounds after Shewchuk,
// "Adaptive precision floating-point arithmetic and fast robust geometric predicates" (1997), with a term for underflow.
#pragma once

#include <cmath>

#include <delref/core/point.hpp>

namespace delref::detail {

/// The sign of a value that is off by at most `error`; 0 when that leaves it open, or when it is not a number.
inline int proven_sign(double value, double error) { return value > error ? 1 : value < -error ? -1 : 0; }

/// More than what products that underflow can lose, beside factors of the size of `scale`.
inline double underflow_loss(double scale) { return 1e-300 * (1 + scale); }

/// 1 when `p` is to the left of the line from `a` to `b`, -1 when to its right, 0 when arithmetic does not tell.
inline int filtered_orientation(Point2 a, Point2 b, Point2 p) {
  const double l = (a.x - p.x) * (b.y - p.y), r = (a.y - p.y) * (b.x - p.x);
  return proven_sign(l - r, 3.4e-16 * (std::abs(l) + std::abs(r)) + underflow_loss(0));
}

/// 1 when `p` is inside the circle through `a`, `b`, `c`, which are in counterclockwise order, -1 when outside, 0 when arithmetic
/// does not tell. The three products of a squared distance and a double area add up to a third of the squared sum of the
/// distances at most, which is quicker to have than each of them, and enough for all but some.
inline int filtered_side_of_circle(Point2 a, Point2 b, Point2 c, Point2 p) {
  const Vector2 u = a - p, v = b - p, w = c - p;
  const double uu = squared_length(u), vv = squared_length(v), ww = squared_length(w), sum = uu + vv + ww;
  return proven_sign(uu * cross(v, w) + vv * cross(w, u) + ww * cross(u, v), 4.1e-16 * sum * sum + underflow_loss(sum));
}

}  // namespace delref::detail
