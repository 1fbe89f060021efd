// SPDX-License-Identifier: GPL-3.0-or-later
//
// The distance from a place to the nearest of some points, by a balanced tree split along each axis by turns (Bentley 1975).
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <delref/core/point.hpp>

namespace delref::verification {

/// `Point` is `Point2` or `Point3`.
template <class Point>
class NearestPoint {
 public:
  explicit NearestPoint(std::vector<Point> points) : points_(std::move(points)) { build(points_, 0); }

  /// Infinity when there are no points. Expected time logarithmic in their number.
  double squared_distance_from(Point place) const {
    const Point* nearest = nullptr;
    double best = std::numeric_limits<double>::infinity();
    search(points_, 0, place, best, nearest);
    return best;
  }
  /// The nearest point, if it is closer than that; null otherwise.
  const Point* closer_than(Point place, double squared_distance_from_it) const {
    const Point* nearest = nullptr;
    search(points_, 0, place, squared_distance_from_it, nearest);
    return nearest;
  }

 private:
  static constexpr int dimension = sizeof(Point) / sizeof(double);
  static int next(int axis) { return (axis + 1) % dimension; }
  static double along(Point p, int axis) {
    if constexpr (dimension == 3)
      if (axis == 2) return p.z;
    return axis == 0 ? p.x : p.y;
  }

  static void build(std::span<Point> part, int axis) {
    if (part.size() < 2) return;
    const std::size_t middle = part.size() / 2;
    std::nth_element(part.begin(), part.begin() + static_cast<std::ptrdiff_t>(middle), part.end(),
                     [&](Point a, Point b) { return along(a, axis) < along(b, axis); });
    build(part.first(middle), next(axis));
    build(part.subspan(middle + 1), next(axis));
  }

  static void search(std::span<const Point> part, int axis, Point place, double& best, const Point*& nearest) {
    if (part.empty()) return;
    const std::size_t middle = part.size() / 2;
    if (const double distance = squared_distance(part[middle], place); distance < best) {
      best = distance;
      nearest = &part[middle];
    }
    const double offset = along(place, axis) - along(part[middle], axis);
    const auto low = part.first(middle), high = part.subspan(middle + 1);
    search(offset < 0 ? low : high, next(axis), place, best, nearest);
    if (offset * offset < best) search(offset < 0 ? high : low, next(axis), place, best, nearest);
  }

  std::vector<Point> points_;
};

}  // namespace delref::verification
