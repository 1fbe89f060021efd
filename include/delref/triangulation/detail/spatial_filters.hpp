// SPDX-License-Identifier: GPL-3.0-or-later
//
// The sign of the in-sphere predicate in floating-point arithmetic, where a bound on the rounding error proves it: some fifty times a
// vertex, so that it is inline here; what it leaves open goes to CGAL's exact predicate. The bound after Shewchuk, "Adaptive precision
// floating-point arithmetic and fast robust geometric predicates" (1997), section 4.4.
#pragma once

#include <algorithm>
#include <cmath>

#include <delref/core/point.hpp>
#include <delref/triangulation/detail/planar_filters.hpp>

namespace delref::detail {

/// 1 when `p` is inside the sphere through `a`, `b`, `c`, `d`, of which the fourth sees the first three counterclockwise, -1 when it is
/// outside, 0 when arithmetic does not tell. Of the determinant's 24 products of a squared length and three coordinates none is
/// greater than that of the greatest ones, which is quicker to have than their sum, and enough for all but some; Shewchuk's factor is
/// 16 (1 + small) times the unit roundoff of the sum.
inline int filtered_side_of_sphere(Point3 a, Point3 b, Point3 c, Point3 d, Point3 p) {
  const Vector3 s = a - p, t = b - p, u = c - p, v = d - p;
  const double st = s.x * t.y - t.x * s.y, tu = t.x * u.y - u.x * t.y, uv = u.x * v.y - v.x * u.y;
  const double vs = v.x * s.y - s.x * v.y, su = s.x * u.y - u.x * s.y, tv = t.x * v.y - v.x * t.y;
  const double stu = s.z * tu - t.z * su + u.z * st, tuv = t.z * uv - u.z * tv + v.z * tu;
  const double uvs = u.z * vs + v.z * su + s.z * uv, vst = v.z * st + s.z * tv + t.z * vs;
  const double ss = squared_length(s), tt = squared_length(t), uu = squared_length(u), vv = squared_length(v);
  const double value = (ss * tuv - tt * uvs) + (uu * vst - vv * stu);
  const auto greatest = [](double i, double j, double k, double l) {
    return std::max(std::max(std::abs(i), std::abs(j)), std::max(std::abs(k), std::abs(l)));
  };
  const double x = greatest(s.x, t.x, u.x, v.x), y = greatest(s.y, t.y, u.y, v.y), z = greatest(s.z, t.z, u.z, v.z);
  const double most = std::max(std::max(ss, tt), std::max(uu, vv));
  return proven_sign(value, 4.3e-14 * x * y * z * most + underflow_loss(most));
}

}  // namespace delref::detail
