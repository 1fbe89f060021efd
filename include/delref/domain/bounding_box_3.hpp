// SPDX-License-Identifier: GPL-3.0-or-later
//
// The smallest upright box around points of space.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <ranges>

#include <delref/core/point.hpp>

namespace delref {

/// An upright box. As made it is empty: every point extends it.
struct BoundingBox3 {
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  Point3 low{infinity, infinity, infinity};
  Point3 high{-infinity, -infinity, -infinity};

  void extend(Point3 p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  bool empty() const { return !(low.x <= high.x); }
  /// The longest side; 0 when empty.
  double extent() const { return empty() ? 0 : std::max({high.x - low.x, high.y - low.y, high.z - low.z}); }
  /// The length of the diagonal, between once and 1.74 times the diameter of what is inside; 0 when empty.
  double diagonal() const { return empty() ? 0 : std::hypot(high.x - low.x, high.y - low.y, high.z - low.z); }
};

/// The box of all points of a range.
template <std::ranges::input_range Points>
BoundingBox3 bounding_box_3(Points&& points) {
  BoundingBox3 box;
  for (const Point3 p : points) box.extend(p);
  return box;
}

}  // namespace delref
