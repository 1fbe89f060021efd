// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a function of points changes sign along a segment.
#pragma once

#include <cmath>
#include <utility>

#include <delref/core/point.hpp>
#include <delref/domain/bounding_box_3.hpp>
#include <delref/domain/bracketed_root.hpp>
#include <delref/domain/box_questions.hpp>

namespace delref {

/// The point of the segment at the fraction `t` of the way from `a` to `b`; the ends exactly.
inline Point3 point_between(Point3 a, Point3 b, double t) { return t >= 1 ? b : a + t * (b - a); }

/// A point of the segment from `a` to `b` no further than `tolerance` from a change of sign of `f` along it, where points outside
/// the box count as positive, and `f` is not asked about them. One of the points should be inside (`f` negative) and the other
/// not; if not, the end where `f` is closer to 0.
template <class F>
Point3 sign_change(F&& f, const BoundingBox3& box, Point3 a, Point3 b, double tolerance) {
  if (!contains(box, a)) std::swap(a, b);
  if (!contains(box, b)) {
    const Point3 end = last_point_in(box, a, b);
    if (is_inside(f(end)) || !is_inside(f(a))) return end;
    b = end;
  }
  const double length = std::sqrt(squared_distance(a, b));
  if (!(length > 0)) return a;
  const double t = bracketed_root([&](double s) { return f(point_between(a, b, s)); }, 0, f(a), 1, f(b), tolerance / length);
  return point_between(a, b, t);
}

}  // namespace delref
