// SPDX-License-Identifier: GPL-3.0-or-later
//
// What messages call the elements of a piecewise linear complex: by their number in the file and their place in its unit.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <delref/core/point.hpp>
#include <delref/domain/describe.hpp>
#include <delref/domain/enumerated.hpp>
#include <delref/domain/plc.hpp>
#include <delref/domain/plc_scale.hpp>

namespace delref {

/// Names for the elements of a complex that is being checked. `points` may be scaled by 2^`scale`, and `original_point[i]` is the
/// number that vertex i had before doubles were merged; an empty span means the same. Holds references only.
struct PlcNames {
  using Index = Plc::Index;

  std::span<const Point3> points;
  std::span<const Index> original_point = {};
  Index first_index = 0;
  int scale = 0;

  /// The number of a vertex in the file.
  std::string number(std::size_t i) const {
    return std::to_string((original_point.empty() ? i : std::size_t{original_point[i]}) + first_index);
  }
  /// A point and a length in the unit of the file.
  std::string place(Point3 p) const { return describe(scaled(p, -scale)); }
  std::string length(double x) const { return describe(std::ldexp(x, -scale)); }

  /// "vertex 4".
  std::string vertex(std::size_t i) const { return "vertex " + number(i); }
  /// "vertex 4 at (0, 0, 1)".
  std::string placed_vertex(std::size_t i) const { return vertex(i) + " at " + place(points[i]); }
  /// "the segment of vertices 4 and 5, (0, 0, 0) to (0, 0, 1)".
  std::string placed_segment(std::size_t a, std::size_t b) const {
    return "the segment of vertices " + number(a) + " and " + number(b) + ", " + place(points[a]) + " to " + place(points[b]);
  }
  /// "facet 4", by its index in the input.
  std::string facet(std::size_t original) const { return "facet " + std::to_string(original + first_index); }
  /// "facet 4 (vertices 1, 2 and 3)".
  std::string facet(std::size_t original, std::span<const Index> vertices) const {
    return facet(original) + " (vertices " + numbers(vertices) + ")";
  }
  /// "1, 2 and 3".
  std::string numbers(std::span<const Index> vertices) const {
    std::vector<std::string> words;
    for (const Index v : vertices) words.push_back(number(v));
    return enumerated(words);
  }
};

}  // namespace delref
