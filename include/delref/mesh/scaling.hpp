// SPDX-License-Identifier: GPL-3.0-or-later
//
// Coordinates brought near 1 by a power of two, so that products of a few of them neither overflow nor underflow. A power of two
// changes no digit: exact predicates answer the same for the scaled points, and equal points stay equal.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include <delref/core/point.hpp>

namespace delref {

/// Multiplies by a power of two and back.
///
/// Exact as long as no coordinate is 2^-1000 times smaller than the largest one.
class PowerOfTwoScaling {
 public:
  PowerOfTwoScaling() = default;
  /// The scaling that brings the largest absolute coordinate into [0.5, 1) (or near it, for coordinates beyond 1e300). Values
  /// that are not finite are passed over.
  explicit PowerOfTwoScaling(double largest) {
    if (std::isfinite(largest) && largest > 0)
      exponent_ = std::clamp(std::ilogb(largest) + 1, -1000, 1000);
    factor_ = std::ldexp(1.0, -exponent_);
  }

  double factor() const { return factor_; }
  double length(double original) const { return original * factor_; }
  double area(double original) const { return original * factor_ * factor_; }
  double volume(double original) const { return original * factor_ * factor_ * factor_; }
  double original_length(double scaled) const { return std::ldexp(scaled, exponent_); }
  double original_area(double scaled) const { return std::ldexp(scaled, 2 * exponent_); }
  double original_volume(double scaled) const { return std::ldexp(scaled, 3 * exponent_); }
  Point2 operator()(Point2 p) const { return {p.x * factor_, p.y * factor_}; }
  Point3 operator()(Point3 p) const { return {p.x * factor_, p.y * factor_, p.z * factor_}; }
  std::vector<Point2> operator()(std::span<const Point2> points) const { return each(points); }
  std::vector<Point3> operator()(std::span<const Point3> points) const { return each(points); }

 private:
  template <class Point>
  std::vector<Point> each(std::span<const Point> points) const {
    std::vector<Point> scaled;
    scaled.reserve(points.size());
    for (const Point p : points) scaled.push_back((*this)(p));
    return scaled;
  }

  int exponent_ = 0;
  double factor_ = 1;
};

/// The largest absolute coordinate; 0 for no points. Coordinates that are not finite are passed over.
inline double largest_absolute_coordinate(std::span<const Point2> points) {
  double largest = 0;
  for (const Point2 p : points)
    for (const double c : {std::abs(p.x), std::abs(p.y)})
      if (std::isfinite(c)) largest = std::max(largest, c);
  return largest;
}
inline double largest_absolute_coordinate(std::span<const Point3> points) {
  double largest = 0;
  for (const Point3 p : points)
    for (const double c : {std::abs(p.x), std::abs(p.y), std::abs(p.z)})
      if (std::isfinite(c)) largest = std::max(largest, c);
  return largest;
}

}  // namespace delref
