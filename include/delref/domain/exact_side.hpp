// SPDX-License-Identifier: GPL-3.0-or-later
//
// The exact orientation of three points of the input, by CGAL's filtered predicates.
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <delref/core/point.hpp>

namespace delref {

/// 1 when `c` is to the left of the line from `a` to `b`, -1 to its right, 0 on it: exactly, whatever the magnitudes.
/// Requires finite coordinates.
inline int exact_side(Point2 a, Point2 b, Point2 c) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Point = Kernel::Point_2;
  return static_cast<int>(CGAL::orientation(Point(a.x, a.y), Point(b.x, b.y), Point(c.x, c.y)));
}

}  // namespace delref
