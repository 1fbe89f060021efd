// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a subsegment in space is split: as in the plane (`split_point.hpp`), in the middle or, next to a sharp corner, at a distance
// from it that all segments of the corner share.
#pragma once

#include <algorithm>
#include <cmath>

#include <delref/core/point.hpp>
#include <delref/levels/split_point.hpp>

namespace delref {

/// The coordinate in whose direction a vector is longest.
inline double Point3::* main_coordinate(Vector3 v) {
  const double x = std::abs(v.x), y = std::abs(v.y), z = std::abs(v.z);
  return x >= y && x >= z ? &Point3::x : (y >= z ? &Point3::y : &Point3::z);
}

/// The point of the line through `p` and `q` whose main coordinate is that of `m`. Off the line by half a unit in the last place of
/// the other coordinates, where `long double` is longer than `double`, and a few units elsewhere.
inline Point3 onto_line(Point3 m, Point3 p, Point3 q) {
  const auto k = main_coordinate(q - p);
  const long double t = (m.*k - static_cast<long double>(p.*k)) / (q.*k - static_cast<long double>(p.*k));
  const auto at = [t](double from, double to) { return static_cast<double>(from + t * (static_cast<long double>(to) - from)); };
  Point3 r{at(p.x, q.x), at(p.y, q.y), at(p.z, q.z)};
  r.*k = m.*k;
  return r;
}

/// Whether `m` is strictly between `a` and `b` by the main coordinate of `along`.
inline bool is_between(Point3 m, Point3 a, Point3 b, Vector3 along) {
  const auto k = main_coordinate(along);
  return std::min(a.*k, b.*k) < m.*k && m.*k < std::max(a.*k, b.*k);
}

/// The split point of the subsegment from `a` to `b` of the segment from `p` to `q`: its middle. `a` when no double is between.
inline Point3 split_point(Point3 a, Point3 b, Point3 p, Point3 q) {
  const Point3 m = onto_line(midpoint(a, b), p, q);
  return is_between(m, a, b, q - p) ? m : a;
}

/// The same for a segment with a sharp corner at `p`: the simplest distance from `p` in the middle third, times `stretch`, which is
/// near 1.
inline Point3 split_point_near_corner(Point3 a, Point3 b, Point3 p, Point3 q, double stretch = 1) {
  const auto distance = [&](Point3 x) { return std::sqrt(squared_distance(x, p)); };
  const double from = std::min(distance(a), distance(b)), to = std::max(distance(a), distance(b));
  const double at = stretch * simplest_between(from + (to - from) / 3, to - (to - from) / 3);
  const Point3 m = onto_line(p + (at / distance(q)) * (q - p), p, q);
  return is_between(m, a, b, q - p) ? m : split_point(a, b, p, q);
}

}  // namespace delref
