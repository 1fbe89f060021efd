// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a planar criterion sees of a triangle: measured once, without a square root.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include <delref/core/point.hpp>

namespace delref {

/// A triangle with its measures. Coordinates in the unit of the input.
struct TriangleShape {
  std::array<Point2, 3> corners;
  int region = 0;                            ///< the region number of the domain, not its label
  std::array<double, 3> squared_lengths{};   ///< of the edge opposite to each corner
  double doubled_area = 0;                   ///< positive
  std::size_t shortest = 0, longest = 0;     ///< the corners opposite to the shortest and the longest edge

  TriangleShape(Point2 a, Point2 b, Point2 c, int region_number = 0) : corners{a, b, c}, region(region_number) {
    const Vector2 ab = b - a, ac = c - a;
    squared_lengths = {squared_distance(b, c), squared_length(ac), squared_length(ab)};
    doubled_area = cross(ab, ac);
    const auto [bc2, ac2, ab2] = squared_lengths;
    shortest = ab2 < std::min(bc2, ac2) ? 2 : ac2 < bc2 ? 1 : 0;
    longest = ab2 >= std::max(bc2, ac2) ? 2 : ac2 >= bc2 ? 1 : 0;
  }

  double shortest_squared() const { return squared_lengths[shortest]; }
  double longest_squared() const { return squared_lengths[longest]; }
  Point2 centroid() const {
    return {(corners[0].x + corners[1].x + corners[2].x) / 3, (corners[0].y + corners[1].y + corners[2].y) / 3};
  }
};

}  // namespace delref
