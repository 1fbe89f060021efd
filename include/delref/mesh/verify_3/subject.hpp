// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is being verified, with scaled coordinates and the words for its elements. Elements are numbered as in the files, that
// is, from the first index of the input.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <fmt/format.h>

#include <delref/core/budget.hpp>
#include <delref/core/point.hpp>
#include <delref/domain/plc.hpp>
#include <delref/mesh/scaling.hpp>
#include <delref/mesh/tetrahedral_mesh.hpp>
#include <delref/mesh/tetrahedron_measures.hpp>
#include <delref/mesh/verify_3/criteria.hpp>

namespace delref::verification_3 {

using Index = std::uint32_t;
inline constexpr Index none = std::numeric_limits<Index>::max();
using ExactKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
inline ExactKernel::Point_3 exact(Point3 p) { return {p.x, p.y, p.z}; }

struct Subject {
  const Plc& input;
  const TetrahedralMesh& mesh;
  const PolyhedralCriteria& criteria;
  const Control& control;
  PowerOfTwoScaling scaling{std::max(largest_absolute_coordinate(input.points), largest_absolute_coordinate(mesh.points))};
  std::vector<Point3> input_points = scaling(input.points);
  std::vector<Point3> points = scaling(mesh.points);

  void breathe(std::size_t step) const {
    if (step % 4096 == 0) throw_if_stopped(control);
  }
  TetrahedronMeasures shape(std::size_t t) const {
    const auto& [a, b, c, d] = mesh.tetrahedra[t];
    return {points[a], points[b], points[c], points[d]};
  }
  CGAL::Orientation orientation(Index a, Index b, Index c, Index d) const {
    return CGAL::orientation(exact(points[a]), exact(points[b]), exact(points[c]), exact(points[d]));
  }
  Point3 original(Point3 scaled) const {
    return {scaling.original_length(scaled.x), scaling.original_length(scaled.y), scaling.original_length(scaled.z)};
  }

  std::size_t number(std::size_t index) const { return index + input.first_index; }
  static std::string place(Point3 p) { return fmt::format("({}, {}, {})", p.x, p.y, p.z); }
  std::string vertex(Index v) const { return fmt::format("vertex {} at {}", number(v), place(mesh.points[v])); }
  std::string edge(Index v, Index w) const {
    return fmt::format("edge {} - {} from {} to {}", number(v), number(w), place(mesh.points[v]), place(mesh.points[w]));
  }
  std::string triangle(const std::array<Index, 3>& corners) const {
    const auto [a, b, c] = corners;
    const Point3 middle = points[a] + (1.0 / 3) * ((points[b] - points[a]) + (points[c] - points[a]));
    return fmt::format("the triangle of vertices {}, {}, {} around {}", number(a), number(b), number(c), place(original(middle)));
  }
  std::string tetrahedron(std::size_t t) const {
    const auto& [a, b, c, d] = mesh.tetrahedra[t];
    return fmt::format("tetrahedron {} (vertices {}, {}, {}, {}) around {}", number(t), number(a), number(b), number(c),
                       number(d), place(original(shape(t).barycentre())));
  }
  std::string input_vertex(Index v) const { return fmt::format("input vertex {} at {}", number(v), place(input.points[v])); }
  std::string facet(std::size_t f) const { return fmt::format("facet {}", number(f)); }
  /// A straight line between two input vertices.
  std::string segment(Index a, Index b) const {
    return fmt::format("the segment of input vertices {} - {} from {} to {}", number(a), number(b), place(input.points[a]),
                       place(input.points[b]));
  }
};

}  // namespace delref::verification_3
