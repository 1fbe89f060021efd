// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which points count as lying on a segment: no rounded point lies on a line exactly, and vertices within a few units in the last
// place of a segment are taken to be on it when something is added to a mesh.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <delref/core/point.hpp>

namespace delref {

/// The segment from `a` to `b`, two different points, and its points in their order.
class ChainLine {
 public:
  ChainLine(Point2 a, Point2 b) : a_(a), b_(b), by_x_(std::abs(b.x - a.x) >= std::abs(b.y - a.y)) {
    const double largest = std::max({std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y)});
    ulp_ = std::ldexp(std::numeric_limits<double>::epsilon(), std::ilogb(largest));
  }

  /// A unit in the last place of the segment's largest coordinate.
  double ulp() const { return ulp_; }
  /// Points at most so far away are on the segment.
  double tolerance() const { return 2 * ulp_; }

  /// How far `p` is from the line, to a small part of `ulp()` if it is near.
  double distance(Point2 p) const {
    const long double dx = static_cast<long double>(b_.x) - a_.x, dy = static_cast<long double>(b_.y) - a_.y;
    const long double doubled_area = dx * (static_cast<long double>(p.y) - a_.y) - dy * (static_cast<long double>(p.x) - a_.x);
    return static_cast<double>(std::abs(doubled_area) / std::sqrt(dx * dx + dy * dy));
  }

  /// Grows from `a` to `b`, without rounding: the greater coordinate of the direction.
  double order(Point2 p) const { return by_x_ ? (a_.x < b_.x ? p.x : -p.x) : (a_.y < b_.y ? p.y : -p.y); }
  /// Strictly between the ends, by `order`.
  bool is_between(Point2 p) const { return order(a_) < order(p) && order(p) < order(b_); }
  bool holds(Point2 p) const { return is_between(p) && distance(p) <= tolerance(); }

 private:
  Point2 a_, b_;
  bool by_x_;
  double ulp_;
};

}  // namespace delref
