// SPDX-License-Identifier: GPL-3.0-or-later
//
// The exact orientation of points of space, by CGAL's filtered predicates.
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <delref/core/point.hpp>
#include <delref/domain/exact_side.hpp>

namespace delref {

/// 1 when `d` is on the side of the plane of `a`, `b`, `c` from which these run counterclockwise, -1 on the other, 0 on it:
/// exactly. Requires finite coordinates.
inline int exact_side(Point3 a, Point3 b, Point3 c, Point3 d) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Point = Kernel::Point_3;
  return static_cast<int>(
      CGAL::orientation(Point(a.x, a.y, a.z), Point(b.x, b.y, b.z), Point(c.x, c.y, c.z), Point(d.x, d.y, d.z)));
}

/// A coordinate plane: 0 looks along x, 1 along y, 2 along z.
inline Point2 dropped_coordinate(Point3 p, int axis) {
  return axis == 0 ? Point2{p.y, p.z} : axis == 1 ? Point2{p.z, p.x} : Point2{p.x, p.y};
}

/// True when one straight line holds the three points, exactly.
inline bool exactly_collinear(Point3 a, Point3 b, Point3 c) {
  for (int axis = 2; axis >= 0; --axis)
    if (exact_side(dropped_coordinate(a, axis), dropped_coordinate(b, axis), dropped_coordinate(c, axis)) != 0) return false;
  return true;
}

/// A coordinate plane in which the three points are not collinear; -1 when they are collinear in space.
inline int view_axis(Point3 a, Point3 b, Point3 c) {
  for (int axis = 2; axis >= 0; --axis)
    if (exact_side(dropped_coordinate(a, axis), dropped_coordinate(b, axis), dropped_coordinate(c, axis)) != 0) return axis;
  return -1;
}

}  // namespace delref
