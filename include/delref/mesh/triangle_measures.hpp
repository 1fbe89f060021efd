// SPDX-License-Identifier: GPL-3.0-or-later
//
// The measures of one triangle that quality tables and verification need.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <delref/core/point.hpp>
#include <delref/mesh/twofold.hpp>

namespace delref {

inline constexpr double degrees_per_radian = 180 / std::numbers::pi;

/// The angle between two vectors in degrees, from 0 to 180; good to about 1e-14 degrees, tiny angles too. 0 when one is zero.
inline double angle_degrees(Vector2 a, Vector2 b) {
  return std::atan2(std::abs(cross(a, b)), dot(a, b)) * degrees_per_radian;
}

/// Edge lengths, area and angles of a triangle. Coordinates should be near 1 (`PowerOfTwoScaling`).
class TriangleMeasures {
 public:
  TriangleMeasures(Point2 a, Point2 b, Point2 c) : corner_{a, b, c}, area_(0.5 * precise_cross(a, b, c)) {
    for (std::size_t i = 0; i < 3; ++i) squared_edge_[i] = squared_distance(corner_[(i + 1) % 3], corner_[(i + 2) % 3]);
  }

  /// Signed: positive when the corners are counterclockwise.
  double area() const { return area_; }
  /// The length of the edge opposite to corner i.
  double edge(std::size_t i) const { return std::sqrt(squared_edge_[i]); }
  /// The corner opposite to the shortest edge (the first, on a tie).
  std::size_t shortest() const {
    return static_cast<std::size_t>(std::ranges::min_element(squared_edge_) - squared_edge_.begin());
  }
  double shortest_edge() const { return std::sqrt(std::ranges::min(squared_edge_)); }
  double longest_edge() const { return std::sqrt(std::ranges::max(squared_edge_)); }
  /// The angle at corner i, in degrees.
  double angle(std::size_t i) const {
    return angle_degrees(corner_[(i + 1) % 3] - corner_[i], corner_[(i + 2) % 3] - corner_[i]);
  }
  /// The angles in degrees, by corner. The largest is what the others leave of 180: two arc tangents are computed, not three.
  std::array<double, 3> angles() const {
    const auto largest = static_cast<std::size_t>(std::ranges::max_element(squared_edge_) - squared_edge_.begin());
    const std::size_t second = (largest + 1) % 3, third = (largest + 2) % 3;
    std::array<double, 3> result{};
    result[second] = angle(second);
    result[third] = angle(third);
    result[largest] = 180 - result[second] - result[third];
    return result;
  }
  /// The smallest angle in degrees: the one opposite to the shortest edge.
  double smallest_angle() const { return angle(shortest()); }
  Point2 barycentre() const { return corner_[0] + (1.0 / 3) * ((corner_[1] - corner_[0]) + (corner_[2] - corner_[0])); }

 private:
  std::array<Point2, 3> corner_;
  std::array<double, 3> squared_edge_{};
  double area_;
};

}  // namespace delref
