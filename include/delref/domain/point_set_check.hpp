// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether a surface can be reconstructed from a set of points at all, and which of its points are different.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <delref/core/point.hpp>
#include <delref/domain/bounding_box_3.hpp>
#include <delref/domain/describe.hpp>
#include <delref/domain/invalid_input.hpp>
#include <delref/domain/point_set.hpp>

namespace delref::detail {

/// "point 12 at (1, 2, 3)", numbered from 0 as readers do.
inline std::string describe_sample(std::size_t number, Point3 p) { return "point " + std::to_string(number) + " at " + describe(p); }

/// Throws `InvalidInput` naming coordinates and normals that are not finite, or when there are not as many normals as points.
inline void check_numbers(const PointSet& set) {
  if (!set.normals.empty() && set.normals.size() != set.points.size())
    throw InvalidInput("the point set has " + count_of(set.points.size(), "point", "points") + " and " + count_of(set.normals.size(), "normal", "normals") +
                       "; give one normal per point, or none");
  DefectList defects;
  for (std::size_t i = 0; i != set.points.size(); ++i) {
    if (!is_finite(set.points[i])) defects.add(defects.full() ? "" : describe_sample(i, set.points[i]) + " has a coordinate that is not a finite number");
    if (set.normals.empty()) continue;
    if (const Point3 end = Point3{} + set.normals[i]; !is_finite(end))
      defects.add(defects.full() ? "" : "the normal " + describe(end) + " of " + describe_sample(i, set.points[i]) + " is not finite");
  }
  if (!defects.empty()) throw InvalidInput(defects.take());
}

/// The numbers of the points that differ from all before them, in increasing order.
inline std::vector<std::size_t> different_points(std::span<const Point3> points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto key = [&](std::size_t i) { return std::tuple(points[i].x, points[i].y, points[i].z, i); };
  std::ranges::sort(order, {}, key);
  const auto repeated = std::ranges::unique(order, {}, [&](std::size_t i) { return std::tuple(points[i].x, points[i].y, points[i].z); });
  order.erase(repeated.begin(), repeated.end());
  std::ranges::sort(order);
  return order;
}

/// Throws `InvalidInput` for fewer than four different points, for points on a line or plane (to a billionth of their extent), and for an
/// extent that no size can be put to.
inline void check_extent(std::span<const Point3> points) {
  if (points.size() < 4)
    throw InvalidInput("the point set has " + count_of(points.size(), "different point", "different points") +
                       "; the least that has an inside is 4, and a surface that is worth reconstructing needs hundreds");
  const double extent = bounding_box_3(points).extent();
  if (!(extent > 1e-60 && extent < 1e60))
    throw InvalidInput("the points are in a box whose longest side is " + describe(extent) + "; it must be between 1e-60 and 1e60");
  const Point3 a = points[0];
  const auto unit = [&](Point3 p) { return 1 / extent * (p - a); };
  const auto farthest = [&](auto squared) { return unit(std::ranges::max(points, {}, [&](Point3 p) { return squared(unit(p)); })); };
  const Vector3 along = farthest([](Vector3 v) { return squared_length(v); });
  const Vector3 across = farthest([&](Vector3 v) { return squared_length(cross(along, v)); });
  const Vector3 normal = cross(along, across);
  const Vector3 off = farthest([&](Vector3 v) { return dot(normal, v) * dot(normal, v); });
  constexpr double thin = 1e-9;
  if (!(squared_length(normal) > thin * thin)) throw InvalidInput("all points are on one line; they bound no volume");
  if (!(std::abs(dot(normal, off)) > thin * std::sqrt(squared_length(normal)))) throw InvalidInput("all points are in one plane; they bound no volume");
}

}  // namespace delref::detail
