// SPDX-License-Identifier: GPL-3.0-or-later
//
// A sizing field from sizes at points: the greatest function that is at most the given size at each point and grows no faster
// than the gradation away from it (the infimal convolution with a cone; Persson 2006, "Mesh size functions for implicit
// geometries and PDE-based gradient limiting"). Evaluated exactly by branch and bound over a kd-tree; nothing is sampled.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <delref/core/point.hpp>
#include <delref/domain/bounding_box.hpp>
#include <delref/domain/bounding_box_3.hpp>
#include <delref/domain/describe.hpp>
#include <delref/domain/invalid_input.hpp>

namespace delref {

namespace point_sizing_detail {

/// From a box to a point outside of it; no coordinate is rounded beyond the least one that a point of the box has.
inline Vector2 outside(const BoundingBox2& box, Point2 p) {
  return {std::max({box.low.x - p.x, p.x - box.high.x, 0.0}), std::max({box.low.y - p.y, p.y - box.high.y, 0.0})};
}
inline Vector3 outside(const BoundingBox3& box, Point3 p) {
  return {std::max({box.low.x - p.x, p.x - box.high.x, 0.0}), std::max({box.low.y - p.y, p.y - box.high.y, 0.0}),
          std::max({box.low.z - p.z, p.z - box.high.z, 0.0})};
}

/// The coordinate along which a box is longest.
inline double Point2::* longest_axis(const BoundingBox2& box) { return box.width() >= box.height() ? &Point2::x : &Point2::y; }
inline double Point3::* longest_axis(const BoundingBox3& box) {
  const Vector3 sides = box.high - box.low;
  return sides.x >= std::max(sides.y, sides.z) ? &Point3::x : sides.y >= sides.z ? &Point3::y : &Point3::z;
}

inline bool is_placed(Point2 p, double largest) { return std::abs(p.x) <= largest && std::abs(p.y) <= largest; }
inline bool is_placed(Point3 p, double largest) { return is_placed(Point2{p.x, p.y}, largest) && std::abs(p.z) <= largest; }

/// The places of a defect lie in the plane.
inline std::vector<Point2> places(Point2 p) { return {p}; }
inline std::vector<Point2> places(Point3) { return {}; }

}  // namespace point_sizing_detail

/// The sizing field h(p) = min over i of (size_i + gradation * |p - point_i|), in the plane (`PointSizing2`, which models
/// `SizingField2`) or in space (`PointSizing3`, `SizingField3`).
///
/// The number is exactly what evaluating that formula in doubles for every i, and taking the least, would give. Copies are
/// independent; concurrent calls are safe. A call allocates nothing and visits O(log n) nodes for sizes of a moderate gradient;
/// building costs O(n log n).
template <class Point>
class PointSizing {
 public:
  /// `sizes[i]` is the size at `points[i]`: positive, infinity for none. `gradation` is how much the size may grow over a unit of
  /// length: finite and not negative; 0 gives the smallest size everywhere, 0.2 is gentle, 1 abrupt.
  /// Throws `InvalidInput`, naming the points by their place in the span counted from `first_index`, when a size is NaN, zero or
  /// negative, a coordinate is not finite or beyond 1e150, the spans differ in length or are empty, or the gradation is refused.
  PointSizing(std::span<const Point> points, std::span<const double> sizes, double gradation, std::size_t first_index = 0)
      : gradation_(gradation) {
    check(points, sizes, gradation, first_index);
    samples_.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) samples_.push_back({points[i], sizes[i]});
    nodes_.reserve(2 * (points.size() / (leaf_size / 2) + 1));
    build(0, static_cast<std::uint32_t>(samples_.size()));
  }

  double operator()(Point p) const {
    double least = std::numeric_limits<double>::infinity();
    // Each step leaves at most one node behind, and the tree is at most 32 deep.
    std::array<Pending, 64> stack;
    std::size_t depth = 0;
    stack[depth++] = {0, lower_bound(nodes_[0], p)};
    while (depth > 0) {
      const Pending pending = stack[--depth];
      if (pending.bound >= least) continue;
      const Node& node = nodes_[pending.node];
      if (node.far_child == 0) {
        for (std::uint32_t i = node.begin; i < node.end; ++i)
          least = std::min(least, cone(samples_[i].size, samples_[i].point - p));
        continue;
      }
      Pending near{pending.node + 1, lower_bound(nodes_[pending.node + 1], p)};
      Pending far{node.far_child, lower_bound(nodes_[node.far_child], p)};
      if (far.bound < near.bound) std::swap(near, far);
      stack[depth++] = far;
      stack[depth++] = near;
    }
    return least;
  }

  double gradation() const { return gradation_; }
  /// The number of points given.
  std::size_t size() const { return samples_.size(); }

 private:
  static constexpr std::uint32_t leaf_size = 8;

  using Box = std::conditional_t<std::is_same_v<Point, Point2>, BoundingBox2, BoundingBox3>;

  struct Sample {
    Point point;
    double size;
  };
  /// The first child of an inner node is the next node; `far_child` is 0 in a leaf.
  struct Node {
    Box box;
    double least_size;
    std::uint32_t begin, end, far_child;
  };
  struct Pending {
    std::uint32_t node;
    double bound;
  };

  template <class Vector>
  double cone(double size, Vector away) const {
    return size + gradation_ * std::sqrt(squared_length(away));
  }

  /// Not above the computed value of any sample below the node: each operation, the subtraction included, is rounded
  /// monotonically, and so the pruning is exact.
  double lower_bound(const Node& node, Point p) const {
    return cone(node.least_size, point_sizing_detail::outside(node.box, p));
  }

  void build(std::uint32_t begin, std::uint32_t end) {
    Node node{{}, std::numeric_limits<double>::infinity(), begin, end, 0};
    for (std::uint32_t i = begin; i < end; ++i) {
      node.box.extend(samples_[i].point);
      node.least_size = std::min(node.least_size, samples_[i].size);
    }
    const std::size_t self = nodes_.size();
    nodes_.push_back(node);
    if (end - begin <= leaf_size) return;
    const std::uint32_t middle = begin + (end - begin) / 2;
    const auto axis = point_sizing_detail::longest_axis(node.box);
    std::nth_element(samples_.begin() + begin, samples_.begin() + middle, samples_.begin() + end,
                     [axis](const Sample& a, const Sample& b) { return a.point.*axis < b.point.*axis; });
    build(begin, middle);
    nodes_[self].far_child = static_cast<std::uint32_t>(nodes_.size());
    build(middle, end);
  }

  static void check(std::span<const Point> points, std::span<const double> sizes, double gradation, std::size_t first_index) {
    constexpr double largest_size_coordinate = 1e150;
    if (points.size() != sizes.size())
      throw InvalidInput("there are " + std::to_string(points.size()) + " size points but " + std::to_string(sizes.size()) +
                         " sizes: give one size for each point");
    if (points.empty()) throw InvalidInput("there are no size points: give at least one point with its size");
    if (points.size() > std::numeric_limits<std::uint32_t>::max() / 2)
      throw InvalidInput("there are " + std::to_string(points.size()) + " size points: at most 2147483647 are handled");
    if (!(gradation >= 0 && std::isfinite(gradation)))
      throw InvalidInput("the gradation is " + describe(gradation) +
                         ": give a finite number that is not negative, such as 0.2 (0 takes the smallest size everywhere)");
    DefectList defects;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Point p = points[i];
      const bool placed = point_sizing_detail::is_placed(p, largest_size_coordinate);
      if (placed && sizes[i] > 0) continue;
      const std::string name = "size point " + std::to_string(i + first_index) + " at " + describe(p);
      if (!placed)
        defects.add(name + ": its coordinates must be numbers of absolute value at most 1e150");
      else
        defects.add(name + ": its size is " + describe(sizes[i]) + "; a size must be positive (infinity for none)", point_sizing_detail::places(p));
    }
    if (!defects.empty()) throw InvalidInput(defects.take());
  }

  double gradation_;
  std::vector<Sample> samples_;
  std::vector<Node> nodes_;
};

using PointSizing2 = PointSizing<Point2>;
using PointSizing3 = PointSizing<Point3>;

}  // namespace delref
