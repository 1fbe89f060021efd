// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a subsegment is split: in the middle, or at a power of two from a sharp corner, so that all segments of the corner are
// split on the same circles (Ruppert 1995, section 6: concentric shells).
#pragma once

#include <algorithm>
#include <cmath>

#include <delref/core/point.hpp>

namespace delref {

/// An end of an edge.
enum class End : unsigned char { none, source, target };

/// The share of a length at which it is split so that the first part is a power of two: between a third and two thirds.
inline double shell_ratio(double length) {
  int exponent = 0;
  const double ratio = 0.5 / std::frexp(length, &exponent);  // the power of two in (length / 2, length]
  return ratio > 2.0 / 3 ? ratio / 2 : ratio;
}

/// The point of the line through `p` and `q` whose greater coordinate, by the line's direction, is that of `m`. Off the line by half
/// a unit in the last place of the other coordinate, where `long double` is longer than `double`, and a few units elsewhere.
inline Point2 onto_line(Point2 m, Point2 p, Point2 q) {
  const long double dx = static_cast<long double>(q.x) - p.x, dy = static_cast<long double>(q.y) - p.y;
  if (std::abs(dx) >= std::abs(dy)) return {m.x, static_cast<double>(p.y + (m.x - static_cast<long double>(p.x)) * (dy / dx))};
  return {static_cast<double>(p.x + (m.y - static_cast<long double>(p.y)) * (dx / dy)), m.y};
}

/// The split point of the subsegment from `source` to `target` on the segment from `p` to `q`.
inline Point2 split_point(Point2 source, Point2 target, Point2 p, Point2 q, End corner) {
  if (corner == End::none) return onto_line(midpoint(source, target), p, q);
  if (corner == End::target) std::swap(source, target);
  const Vector2 along = target - source;
  return onto_line(source + shell_ratio(std::hypot(along.x, along.y)) * along, p, q);
}

}  // namespace delref
