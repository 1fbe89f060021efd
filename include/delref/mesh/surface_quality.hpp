// SPDX-License-Identifier: GPL-3.0-or-later
//
// The figures by which a triangulated surface is judged, one without tetrahedra or the boundary of some: angles, edge lengths, areas,
// and whether it is closed.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <delref/core/budget.hpp>
#include <delref/core/point.hpp>
#include <delref/domain/disjoint_sets.hpp>
#include <delref/mesh/quality_table.hpp>
#include <delref/mesh/scaling.hpp>
#include <delref/mesh/tetrahedral_mesh.hpp>
#include <delref/mesh/tetrahedron_measures.hpp>
#include <delref/mesh/twofold.hpp>

namespace delref {

/// What `surface_quality` measures. Angles in degrees, lengths and areas in the unit of the mesh. For a mesh without triangles every
/// figure is 0.
struct SurfaceQuality {
  static constexpr double degrees_per_bin = 5;

  /// Corners of triangles only.
  std::size_t vertex_count = 0, edge_count = 0, triangle_count = 0;
  /// Pieces that hang together by edges.
  std::size_t component_count = 0;
  /// Edges of one triangle, where the surface ends, and those of more than two.
  std::size_t border_edges = 0, crowded_edges = 0;
  double smallest_angle = 0, largest_angle = 0;
  /// The mean over the triangles of their smallest angle.
  double mean_smallest_angle = 0;
  /// How many triangles have their smallest angle in [5 i, 5 i + 5) degrees; the last bin includes 60.
  std::array<std::size_t, 12> smallest_angles{};
  /// How many angles (three per triangle) lie in [5 i, 5 i + 5) degrees; the last bin includes 180.
  std::array<std::size_t, 36> all_angles{};
  double smallest_area = 0, largest_area = 0, total_area = 0;
  double shortest_edge = 0, longest_edge = 0;
  /// By marker; all 0 when the mesh carries none.
  std::map<int, double> areas;

  /// Vertices less edges plus triangles.
  long euler_characteristic() const {
    return static_cast<long>(vertex_count) - static_cast<long>(edge_count) + static_cast<long>(triangle_count);
  }
};

namespace quality_detail {

/// Counts vertices, edges and pieces.
inline void count_elements(const TetrahedralMesh& mesh, SurfaceQuality& q, const Control& control) {
  struct Side {
    TetrahedralMesh::Index low, high, triangle;
    auto operator<=>(const Side&) const = default;
  };
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  std::vector<bool> used(mesh.points.size(), false);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(mesh.triangles[t][i], mesh.triangles[t][(i + 1) % 3]);
      sides.push_back({low, high, static_cast<TetrahedralMesh::Index>(t)});
      used[mesh.triangles[t][i]] = true;
    }
  throw_if_stopped(control);
  std::ranges::sort(sides);
  throw_if_stopped(control);
  q.vertex_count = static_cast<std::size_t>(std::ranges::count(used, true));
  q.component_count = q.triangle_count;
  DisjointSets joined(q.triangle_count);
  for (std::size_t i = 0, j = 0; i < sides.size(); i = j) {
    for (; j < sides.size() && sides[j].low == sides[i].low && sides[j].high == sides[i].high; ++j) {
      q.component_count -= joined.find(sides[i].triangle) != joined.find(sides[j].triangle);
      joined.unite(sides[i].triangle, sides[j].triangle);
    }
    ++q.edge_count;
    q.border_edges += j - i == 1;
    q.crowded_edges += j - i > 2;
  }
}

}  // namespace quality_detail

/// Measures the triangles of a mesh. O(n log n); coordinates up to 1e150, with areas up to the largest double.
///
/// Requires the indices of the triangles to be valid. Throws `Interrupted`.
inline SurfaceQuality surface_quality(const TetrahedralMesh& mesh, const Control& control = Control{}) {
  SurfaceQuality q;
  q.triangle_count = mesh.triangles.size();
  if (mesh.triangles.empty()) return q;
  quality_detail::count_elements(mesh, q, control);
  const PowerOfTwoScaling scaling(largest_absolute_coordinate(mesh.points));
  const auto count = [](auto& bins, double angle) {
    const auto bin = static_cast<std::size_t>(angle / SurfaceQuality::degrees_per_bin);
    ++bins[std::min(bin, bins.size() - 1)];
  };
  q.smallest_angle = 180;
  q.smallest_area = q.shortest_edge = std::numeric_limits<double>::infinity();
  PreciseSum total, angles;
  std::map<int, PreciseSum> areas;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (t % 4096 == 0) throw_if_stopped(control);
    const auto [i, j, k] = mesh.triangles[t];
    const Point3 a = scaling(mesh.points[i]), b = scaling(mesh.points[j]), c = scaling(mesh.points[k]);
    const std::array<double, 3> its{angle_degrees(b - a, c - a), angle_degrees(c - b, a - b), angle_degrees(a - c, b - c)};
    for (const double angle : its) count(q.all_angles, angle);
    const auto [smallest, largest] = std::ranges::minmax(its);
    count(q.smallest_angles, smallest);
    angles += smallest;
    q.smallest_angle = std::min(q.smallest_angle, smallest);
    q.largest_angle = std::max(q.largest_angle, largest);
    const double area = 0.5 * std::sqrt(squared_length(cross(b - a, c - a)));
    total += area;
    areas[mesh.triangle_markers.empty() ? 0 : mesh.triangle_markers[t]] += area;
    q.smallest_area = std::min(q.smallest_area, area);
    q.largest_area = std::max(q.largest_area, area);
    const std::array<double, 3> squared{squared_distance(a, b), squared_distance(b, c), squared_distance(c, a)};
    q.shortest_edge = std::min(q.shortest_edge, std::sqrt(std::ranges::min(squared)));
    q.longest_edge = std::max(q.longest_edge, std::sqrt(std::ranges::max(squared)));
  }
  q.mean_smallest_angle = angles.value() / static_cast<double>(q.triangle_count);
  q.total_area = scaling.original_area(total.value());
  for (const auto& [marker, area] : areas) q.areas[marker] = scaling.original_area(area.value());
  for (double* area : {&q.smallest_area, &q.largest_area}) *area = scaling.original_area(*area);
  for (double* edge : {&q.shortest_edge, &q.longest_edge}) *edge = scaling.original_length(*edge);
  return q;
}

/// The whole table, ending in a line feed. Of more than 20 markers the first 20 are spelled out.
inline std::string quality_table(const SurfaceQuality& q) {
  std::string text = fmt::format("vertices         {}\nedges            {}\ntriangles        {}\n", q.vertex_count, q.edge_count, q.triangle_count);
  if (q.triangle_count == 0) return text + "The mesh has no triangles: there is nothing to measure.\n";
  text += fmt::format("pieces           {}, Euler characteristic {}\n", q.component_count, q.euler_characteristic());
  text += q.border_edges == 0 ? "border           none: every edge has at least two triangles\n"
                              : fmt::format("border           {} edges have one triangle only\n", q.border_edges);
  if (q.crowded_edges != 0) text += fmt::format("crowded          {} edges have more than two triangles\n", q.crowded_edges);
  text += fmt::format("angles           {:.4g} to {:.4g} degrees; the smallest of a triangle is {:.4g} on average\n", q.smallest_angle,
                      q.largest_angle, q.mean_smallest_angle);
  text += fmt::format("edge lengths     {:.6g} to {:.6g}\n", q.shortest_edge, q.longest_edge);
  text += fmt::format("triangle areas   {:.6g} to {:.6g}, {:.10g} in all\n", q.smallest_area, q.largest_area, q.total_area);
  if (q.areas.size() > 1) {
    text += fmt::format("\nMarkers, {} of them:\n", q.areas.size());
    std::size_t told = 0;
    for (const auto& [marker, area] : q.areas) {
      if (told++ == 20) {
        text += fmt::format("  and {} more\n", q.areas.size() - 20);
        break;
      }
      text += fmt::format("  marker {:<10} area {:.10g}\n", marker, area);
    }
  }
  text += "\nSmallest angle of each triangle, in degrees (60 is equilateral):\n";
  text += histogram_text(q.smallest_angles, SurfaceQuality::degrees_per_bin);
  text += "\nAll angles, in degrees:\n";
  text += histogram_text(q.all_angles, SurfaceQuality::degrees_per_bin);
  return text;
}

}  // namespace delref
