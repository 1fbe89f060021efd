// SPDX-License-Identifier: GPL-3.0-or-later
//
// A few of many points, spread as widely as can be: each is the farthest from those before it. After Gonzalez, "Clustering to minimize
// the maximum intercluster distance" (1985).
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include <delref/core/point.hpp>

namespace delref {

/// At most `most` different points of `points`, the farthest from the first one before all others. Of many points some thousand,
/// evenly taken, are candidates. Ties go to the one that comes first. O(points + most * candidates).
inline std::vector<Point3> spread_points(std::span<const Point3> points, std::size_t most) {
  std::vector<Point3> chosen;
  if (points.empty() || most == 0) return chosen;
  constexpr std::size_t enough = 4096;
  const std::size_t step = points.size() / enough + 1;
  std::vector<double> distance((points.size() + step - 1) / step, std::numeric_limits<double>::infinity());
  const auto farthest_from = [&](Point3 p) {
    std::size_t best = 0;
    for (std::size_t i = 0; i != distance.size(); ++i) {
      distance[i] = std::min(distance[i], squared_distance(points[i * step], p));
      if (distance[i] > distance[best]) best = i;
    }
    return best;
  };
  std::size_t next = farthest_from(points[0]);
  std::ranges::fill(distance, std::numeric_limits<double>::infinity());
  chosen.push_back(points[next * step]);
  while (chosen.size() != most) {
    next = farthest_from(chosen.back());
    if (!(distance[next] > 0)) break;
    chosen.push_back(points[next * step]);
  }
  return chosen;
}

}  // namespace delref
