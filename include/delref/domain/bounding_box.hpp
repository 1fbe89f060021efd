// SPDX-License-Identifier: GPL-3.0-or-later
//
// The smallest upright rectangle around points.
#pragma once

#include <algorithm>
#include <limits>
#include <ranges>

#include <delref/core/point.hpp>

namespace delref {

/// An upright rectangle. As made it is empty: every point extends it.
struct BoundingBox2 {
  Point2 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Point2 high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  void extend(Point2 p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  bool empty() const { return !(low.x <= high.x); }
  double width() const { return empty() ? 0 : high.x - low.x; }
  double height() const { return empty() ? 0 : high.y - low.y; }
  /// The longer side; 0 when empty.
  double extent() const { return std::max(width(), height()); }
};

/// The box of all points of a range.
template <std::ranges::input_range Points>
BoundingBox2 bounding_box(Points&& points) {
  BoundingBox2 box;
  for (const Point2 p : points) box.extend(p);
  return box;
}

}  // namespace delref
