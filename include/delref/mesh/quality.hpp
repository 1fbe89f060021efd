// SPDX-License-Identifier: GPL-3.0-or-later
//
// The figures by which a triangle mesh is judged: angles, edge lengths, areas, and the worst ratio of circumradius to shortest
// edge (Miller, Talmor, Teng, Walkington 1995), which in the plane is 1 / (2 sin of the smallest angle).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <delref/core/point.hpp>
#include <delref/mesh/planar_mesh.hpp>
#include <delref/mesh/scaling.hpp>
#include <delref/mesh/triangle_measures.hpp>

namespace delref {

/// What `planar_quality` measures. Angles in degrees, lengths and areas in the unit of the mesh. For a mesh without triangles
/// every figure is 0.
struct PlanarQuality {
  static constexpr double degrees_per_bin = 5;

  std::size_t vertex_count = 0;
  std::size_t triangle_count = 0;
  double smallest_angle = 0, largest_angle = 0;
  /// The mean over the triangles of their smallest angle.
  double mean_smallest_angle = 0;
  /// How many triangles have their smallest angle in [5 i, 5 i + 5) degrees; the last bin includes 60.
  std::array<std::size_t, 12> smallest_angles{};
  /// How many angles (three per triangle) lie in [5 i, 5 i + 5) degrees; the last bin includes 180.
  std::array<std::size_t, 36> all_angles{};
  double smallest_area = 0, largest_area = 0, total_area = 0;
  double shortest_edge = 0, longest_edge = 0;
  /// The largest circumradius divided by shortest edge; infinite for a flat triangle.
  double worst_radius_edge = 0;
};

/// Measures a mesh. Linear time; coordinates up to 1e150, with areas up to the largest double.
///
/// Requires the indices of the triangles to be valid. Areas are signed: a clockwise triangle has a negative one.
inline PlanarQuality planar_quality(const PlanarMesh& mesh) {
  PlanarQuality q;
  q.vertex_count = mesh.points.size();
  q.triangle_count = mesh.triangles.size();
  if (mesh.triangles.empty()) return q;
  const PowerOfTwoScaling scaling(largest_absolute_coordinate(mesh.points));
  const auto count = [](auto& bins, double angle) {
    const auto bin = static_cast<std::size_t>(angle / PlanarQuality::degrees_per_bin);
    ++bins[std::min(bin, bins.size() - 1)];
  };
  q.smallest_angle = 180;
  q.smallest_area = q.shortest_edge = std::numeric_limits<double>::infinity();
  q.largest_area = -q.smallest_area;
  PreciseSum total, angles;
  for (const auto& [a, b, c] : mesh.triangles) {
    const TriangleMeasures shape(scaling(mesh.points[a]), scaling(mesh.points[b]), scaling(mesh.points[c]));
    const std::array<double, 3> all = shape.angles();
    for (const double angle : all) count(q.all_angles, angle);
    q.largest_angle = std::max(q.largest_angle, std::ranges::max(all));
    const double smallest = std::ranges::min(all);
    count(q.smallest_angles, smallest);
    angles += smallest;
    q.smallest_angle = std::min(q.smallest_angle, smallest);
    total += shape.area();
    q.smallest_area = std::min(q.smallest_area, shape.area());
    q.largest_area = std::max(q.largest_area, shape.area());
    q.shortest_edge = std::min(q.shortest_edge, shape.shortest_edge());
    q.longest_edge = std::max(q.longest_edge, shape.longest_edge());
  }
  q.mean_smallest_angle = angles.value() / static_cast<double>(q.triangle_count);
  q.worst_radius_edge = 0.5 / std::sin(q.smallest_angle / degrees_per_radian);
  for (double* area : {&q.smallest_area, &q.largest_area}) *area = scaling.original_area(*area);
  q.total_area = scaling.original_area(total.value());
  for (double* edge : {&q.shortest_edge, &q.longest_edge}) *edge = scaling.original_length(*edge);
  return q;
}

}  // namespace delref
