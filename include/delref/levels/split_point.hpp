// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a subsegment is split, in the plane and in space: in the middle, or, on a segment with a sharp corner, where all segments of
// that corner are split too. After Ruppert's concentric shells at powers of two (1995, section 6), here at every distance from the
// corner.
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

/// The coordinate in whose direction a vector is longest.
inline double Point2::* main_coordinate(Vector2 v) { return std::abs(v.x) >= std::abs(v.y) ? &Point2::x : &Point2::y; }
inline double Point3::* main_coordinate(Vector3 v) {
  const double x = std::abs(v.x), y = std::abs(v.y), z = std::abs(v.z);
  return x >= y && x >= z ? &Point3::x : (y >= z ? &Point3::y : &Point3::z);
}

namespace detail {

inline double part_of_way(double from, double to, long double t) {
  return static_cast<double>(from + t * (static_cast<long double>(to) - from));
}
inline Point2 part_of_way(Point2 p, Point2 q, long double t) { return {part_of_way(p.x, q.x, t), part_of_way(p.y, q.y, t)}; }
inline Point3 part_of_way(Point3 p, Point3 q, long double t) {
  return {part_of_way(p.x, q.x, t), part_of_way(p.y, q.y, t), part_of_way(p.z, q.z, t)};
}
inline double length(Vector2 v) { return std::hypot(v.x, v.y); }
inline double length(Vector3 v) { return std::sqrt(squared_length(v)); }

}  // namespace detail

/// The point of the line through `p` and `q` whose main coordinate, by the line's direction, is that of `m`. Off the line by half a unit
/// in the last place of each other coordinate, where `long double` is longer than `double`, and a few units elsewhere.
template <class Point>
Point onto_line(Point m, Point p, Point q) {
  const auto k = main_coordinate(q - p);
  Point r = detail::part_of_way(p, q, (m.*k - static_cast<long double>(p.*k)) / (q.*k - static_cast<long double>(p.*k)));
  r.*k = m.*k;
  return r;
}

/// Whether `m` is strictly between `a` and `b` by the main coordinate of `along`.
template <class Point, class Vector>
bool is_between(Point m, Point a, Point b, Vector along) {
  const auto k = main_coordinate(along);
  return std::min(a.*k, b.*k) < m.*k && m.*k < std::max(a.*k, b.*k);
}

/// The split point of the subsegment from `a` to `b` of the segment from `p` to `q`: its middle. `a` when no double is between.
template <class Point>
Point split_point(Point a, Point b, Point p, Point q) {
  const Point m = onto_line(midpoint(a, b), p, q);
  return is_between(m, a, b, q - p) ? m : a;
}

/// The same for a segment with a sharp corner at `p`: the simplest distance from `p` in the middle third, times `stretch`, which is
/// near 1.
template <class Point>
Point split_point_near_corner(Point a, Point b, Point p, Point q, double stretch = 1) {
  const auto distance = [&](Point x) { return detail::length(x - p); };
  const double from = std::min(distance(a), distance(b)), to = std::max(distance(a), distance(b));
  const double at = stretch * simplest_between(from + (to - from) / 3, to - (to - from) / 3);
  const Point m = onto_line(p + (at / distance(q)) * (q - p), p, q);
  return is_between(m, a, b, q - p) ? m : split_point(a, b, p, q);
}

}  // namespace delref
