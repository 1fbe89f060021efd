// SPDX-License-Identifier: GPL-3.0-or-later
//
// The distance from a place to the nearest of some points, by a balanced tree split in x and y by turns (Bentley 1975).
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <delref/core/point.hpp>

namespace delref::verification {

class NearestPoint {
 public:
  explicit NearestPoint(std::vector<Point2> points) : points_(std::move(points)) { build(points_, false); }

  /// Infinity when there are no points. Expected time logarithmic in their number.
  double squared_distance_from(Point2 place) const {
    double best = std::numeric_limits<double>::infinity();
    search(points_, false, place, best);
    return best;
  }

 private:
  static double along(Point2 p, bool vertical) { return vertical ? p.y : p.x; }

  static void build(std::span<Point2> part, bool vertical) {
    if (part.size() < 2) return;
    const std::size_t middle = part.size() / 2;
    std::nth_element(part.begin(), part.begin() + static_cast<std::ptrdiff_t>(middle), part.end(),
                     [&](Point2 a, Point2 b) { return along(a, vertical) < along(b, vertical); });
    build(part.first(middle), !vertical);
    build(part.subspan(middle + 1), !vertical);
  }

  static void search(std::span<const Point2> part, bool vertical, Point2 place, double& best) {
    if (part.empty()) return;
    const std::size_t middle = part.size() / 2;
    best = std::min(best, squared_distance(part[middle], place));
    const double offset = along(place, vertical) - along(part[middle], vertical);
    const auto low = part.first(middle), high = part.subspan(middle + 1);
    search(offset < 0 ? low : high, !vertical, place, best);
    if (offset * offset < best) search(offset < 0 ? high : low, !vertical, place, best);
  }

  std::vector<Point2> points_;
};

}  // namespace delref::verification
