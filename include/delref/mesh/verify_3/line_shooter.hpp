// SPDX-License-Identifier: GPL-3.0-or-later
//
// The triangles that a straight line crosses, in order. The line is turned until it passes well inside every triangle that it
// meets, so that nothing depends on rounding. Triangles are found by a tree of boxes that halves them along the longest extent.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/core/point.hpp>
#include <delref/mesh/verify_3/subject.hpp>

namespace delref::verification_3 {

struct Crossing {
  double along;  ///< from the place that the line goes through; positive: ahead
  Index triangle;
  bool from_front;  ///< the line comes from the side that sees the triangle counterclockwise
};

class LineShooter {
 public:
  /// `place(v)` gives the scaled point of a vertex.
  template <class Place>
  LineShooter(std::span<const std::array<Index, 3>> triangles, Place&& place, const Control& control) : control_(control) {
    triangles_.reserve(triangles.size());
    for (Index t = 0; t < triangles.size(); ++t)
      triangles_.push_back({place(triangles[t][0]), place(triangles[t][1]), place(triangles[t][2]), t});
    if (!triangles_.empty()) build(0, triangles_.size());
  }

  /// All crossings of a line through a place, in order along it; `start` is a triangle that the place lies in, at `along` 0.
  /// Nothing when no line was found that avoids all edges, as for a place on a facet.
  std::optional<std::vector<Crossing>> line(Point3 place, Index start = none) const {
    throw_if_stopped(control_);
    for (int turn = 0; turn < 24; ++turn) {
      const double azimuth = 2.39996 * turn + 0.7321, height = std::sin(1.3 * turn + 0.4142);
      const double radius = std::sqrt(1 - height * height);
      Line l{place, {radius * std::cos(azimuth), radius * std::sin(azimuth), height}, start, {}, true};
      if (!boxes_.empty()) cross_box(l, 0, 0, triangles_.size());
      std::ranges::sort(l.found, {}, &Crossing::along);
      if (l.clear && std::ranges::adjacent_find(l.found, {}, &Crossing::along) == l.found.end()) return std::move(l.found);
    }
    return std::nullopt;
  }

 private:
  static constexpr std::size_t leaf_size = 8;

  struct Triangle {
    Point3 a, b, c;
    Index number;
  };
  struct Box {
    std::array<double, 3> low, high;
  };
  struct Line {
    Point3 place;
    Vector3 direction;
    Index start;
    std::vector<Crossing> found;
    bool clear;  ///< of all edges, so far
  };

  static std::array<double, 3> numbers(Point3 p) { return {p.x, p.y, p.z}; }

  /// The box of the lower half of [from, to) follows its own; `skip_` names that of the upper half.
  std::size_t build(std::size_t from, std::size_t to) {
    const std::size_t number = boxes_.size();
    Box box{};
    box.low.fill(std::numeric_limits<double>::infinity());
    box.high.fill(-std::numeric_limits<double>::infinity());
    for (std::size_t i = from; i < to; ++i)
      for (const Point3 p : {triangles_[i].a, triangles_[i].b, triangles_[i].c})
        for (std::size_t k = 0; k < 3; ++k) {
          box.low[k] = std::min(box.low[k], numbers(p)[k]);
          box.high[k] = std::max(box.high[k], numbers(p)[k]);
        }
    std::size_t axis = 0;
    double size = 0;
    for (std::size_t k = 0; k < 3; ++k)
      if (box.high[k] - box.low[k] > size) size = box.high[k] - box.low[k], axis = k;
    for (std::size_t k = 0; k < 3; ++k) box.low[k] -= 1e-6 * size, box.high[k] += 1e-6 * size;
    boxes_.push_back(box);
    skip_.push_back(0);
    if (to - from > leaf_size) {
      const std::size_t middle = from + (to - from) / 2;
      const auto at = [&](std::size_t i) { return triangles_.begin() + static_cast<std::ptrdiff_t>(i); };
      std::nth_element(at(from), at(middle), at(to), [&](const Triangle& t, const Triangle& u) {
        return numbers(t.a)[axis] + numbers(t.b)[axis] + numbers(t.c)[axis] <
               numbers(u.a)[axis] + numbers(u.b)[axis] + numbers(u.c)[axis];
      });
      build(from, middle);
      skip_[number] = build(middle, to);
    }
    return number;
  }

  void cross_box(Line& l, std::size_t box, std::size_t from, std::size_t to) const {
    if (!l.clear || !meets(l, boxes_[box])) return;
    if (to - from <= leaf_size) {
      for (std::size_t i = from; i < to && l.clear; ++i) cross_triangle(l, triangles_[i]);
      return;
    }
    const std::size_t middle = from + (to - from) / 2;
    cross_box(l, box + 1, from, middle);
    cross_box(l, skip_[box], middle, to);
  }

  static bool meets(const Line& l, const Box& box) {
    double first = -std::numeric_limits<double>::infinity(), last = -first;
    const std::array d{l.direction.x, l.direction.y, l.direction.z};
    for (std::size_t k = 0; k < 3; ++k) {
      const double p = numbers(l.place)[k], t = (box.low[k] - p) / d[k], u = (box.high[k] - p) / d[k];
      first = std::max(first, std::min(t, u)), last = std::min(last, std::max(t, u));
    }
    return first <= last;
  }

  /// By barycentric coordinates (Moeller and Trumbore 1997).
  static void cross_triangle(Line& l, const Triangle& t) {
    constexpr double margin = 1e-7;
    const Vector3 u = t.b - t.a, v = t.c - t.a, w = l.place - t.a, across = cross(l.direction, v), other = cross(w, u);
    const double determinant = dot(u, across), size = std::abs(determinant), sign = determinant < 0 ? -1 : 1;
    const double x = sign * dot(w, across), y = sign * dot(l.direction, other);
    if (x < -margin * size || y < -margin * size || x + y > (1 + margin) * size) return;
    const double along = t.number == l.start ? 0 : dot(v, other) / determinant;
    const bool inside = x > margin * size && y > margin * size && x + y < (1 - margin) * size;
    const bool steep = size > 1e-6 * std::sqrt(squared_length(u) * squared_length(v));
    l.clear = inside && steep && (t.number == l.start || std::abs(along) > 1e-12);
    l.found.push_back({along, t.number, determinant > 0});
  }

  std::vector<Triangle> triangles_;
  std::vector<Box> boxes_;
  std::vector<std::size_t> skip_;  ///< the box of the upper half
  const Control& control_;
};

}  // namespace delref::verification_3
