// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a subsegment is split: in the middle, or, on a segment with a sharp corner, where all segments of that corner are split
// too. After Ruppert's concentric shells at powers of two (1995, section 6), here at every distance from the corner.
#pragma once

#include <algorithm>
#include <cmath>

#include <delref/core/point.hpp>

namespace delref {

/// The multiple of the greatest power of two between `low` and `high`, where 0 <= low < high: of all numbers there the one with the
/// fewest binary digits. Segments that share a corner and choose their split points so choose the same ones.
inline double simplest_between(double low, double high) {
  double step = std::exp2(std::floor(std::log2(high - low)));
  double best = std::ceil(low / step) * step;
  for (double coarser = 2 * step; std::ceil(low / coarser) * coarser <= high; coarser *= 2) best = std::ceil(low / coarser) * coarser;
  return best;
}

/// The point of the line through `p` and `q` whose greater coordinate, by the line's direction, is that of `m`. Off the line by half
/// a unit in the last place of the other coordinate, where `long double` is longer than `double`, and a few units elsewhere.
inline Point2 onto_line(Point2 m, Point2 p, Point2 q) {
  const long double dx = static_cast<long double>(q.x) - p.x, dy = static_cast<long double>(q.y) - p.y;
  if (std::abs(dx) >= std::abs(dy)) return {m.x, static_cast<double>(p.y + (m.x - static_cast<long double>(p.x)) * (dy / dx))};
  return {static_cast<double>(p.x + (m.y - static_cast<long double>(p.y)) * (dx / dy)), m.y};
}

/// Whether `m` is strictly between `a` and `b` by the greater coordinate of the line's direction.
inline bool is_between(Point2 m, Point2 a, Point2 b, Vector2 along) {
  return std::abs(along.x) >= std::abs(along.y) ? std::min(a.x, b.x) < m.x && m.x < std::max(a.x, b.x)
                                                : std::min(a.y, b.y) < m.y && m.y < std::max(a.y, b.y);
}

/// The split point of the subsegment from `a` to `b` of the segment from `p` to `q`: its middle. `a` when no double is between.
inline Point2 split_point(Point2 a, Point2 b, Point2 p, Point2 q) {
  const Point2 m = onto_line(midpoint(a, b), p, q);
  return is_between(m, a, b, q - p) ? m : a;
}

/// The same for a segment with a sharp corner at `p`: the simplest distance from `p` in the middle third.
inline Point2 split_point_near_corner(Point2 a, Point2 b, Point2 p, Point2 q) {
  const auto distance = [&](Point2 x) { return std::hypot(x.x - p.x, x.y - p.y); };
  const double from = std::min(distance(a), distance(b)), to = std::max(distance(a), distance(b));
  const double at = simplest_between(from + (to - from) / 3, to - (to - from) / 3);
  const Point2 m = onto_line(p + (at / distance(q)) * (q - p), p, q);
  return is_between(m, a, b, q - p) ? m : split_point(a, b, p, q);
}

}  // namespace delref
