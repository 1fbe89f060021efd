// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_facts.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <tuple>

#include <delref/domain/disjoint_sets.hpp>
#include <delref/mesh/scaling.hpp>
#include <delref/mesh/tetrahedron_measures.hpp>

namespace delref::program {
namespace {

using Index = TetrahedralMesh::Index;

/// An edge of a triangle of a list: the numbers in the list of the two corners at it, corner k of triangle t being 3 t + k.
struct Side {
  Index low, high;
  std::uint32_t corner_at_low, corner_at_high;
};

std::vector<Side> sorted_sides(const TetrahedralMesh& mesh, const std::vector<Index>& triangles) {
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t i = 3 * t + k, j = 3 * t + (k + 1) % 3;
      const Index a = mesh.triangles[triangles[t]][k], b = mesh.triangles[triangles[t]][(k + 1) % 3];
      sides.push_back(a < b ? Side{a, b, i, j} : Side{b, a, j, i});
    }
  std::ranges::sort(sides, {}, [](const Side& s) { return std::tuple(s.low, s.high, s.corner_at_low); });
  return sides;
}

/// Corners at one vertex belong together when edges join their triangles: on a manifold, all do.
ReportedBoundary topology(int label, const TetrahedralMesh& mesh, const std::vector<Index>& triangles) {
  ReportedBoundary boundary{.label = label, .triangles = triangles.size()};
  const std::vector<Side> sides = sorted_sides(mesh, triangles);
  DisjointSets corners(3 * triangles.size()), surfaces(3 * triangles.size());
  std::int64_t edges = 0;
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end, ++edges) {
    for (end = i; end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high; ++end) {
      corners.unite(sides[i].corner_at_low, sides[end].corner_at_low);
      corners.unite(sides[i].corner_at_high, sides[end].corner_at_high);
      for (const std::uint32_t corner : {sides[i].corner_at_low, sides[i].corner_at_high, sides[end].corner_at_low})
        surfaces.unite(corner, sides[end].corner_at_high);
    }
    boundary.crowded_edges += end - i != 2;
  }
  std::vector<Index> vertices;
  for (const Index t : triangles) vertices.insert(vertices.end(), mesh.triangles[t].begin(), mesh.triangles[t].end());
  std::ranges::sort(vertices);
  const auto vertex_count = static_cast<std::size_t>(std::ranges::unique(vertices).begin() - vertices.begin());
  std::vector<Index> umbrellas;  // the vertex of each
  for (std::uint32_t i = 0; i < corners.size(); ++i) {
    if (corners.find(i) == i) umbrellas.push_back(mesh.triangles[triangles[i / 3]][i % 3]);
    boundary.components += surfaces.find(i) == i;
  }
  std::ranges::sort(umbrellas);
  for (std::size_t i = 0, end = 0; i < umbrellas.size(); i = end) {
    while (end < umbrellas.size() && umbrellas[end] == umbrellas[i]) ++end;
    boundary.pinched_vertices += end - i > 1;
  }
  boundary.euler_characteristic = static_cast<std::int64_t>(vertex_count) - edges + static_cast<std::int64_t>(triangles.size());
  return boundary;
}

void add_angles_and_vertices(ReportedSurface& surface, const TetrahedralMesh& mesh) {
  const PowerOfTwoScaling scaling(largest_absolute_coordinate(mesh.points));
  std::vector<bool> is_used(mesh.points.size());
  surface.smallest_angle_degrees = mesh.triangles.empty() ? 0 : 180;
  for (const auto& [i, j, k] : mesh.triangles) {
    is_used[i] = is_used[j] = is_used[k] = true;
    const Point3 a = scaling(mesh.points[i]), b = scaling(mesh.points[j]), c = scaling(mesh.points[k]);
    surface.smallest_angle_degrees =
        std::min({surface.smallest_angle_degrees, angle_degrees(b - a, c - a), angle_degrees(c - b, a - b), angle_degrees(a - c, b - c)});
  }
  surface.vertices = static_cast<std::size_t>(std::ranges::count(is_used, true));
}

}  // namespace

void add_surface_facts(ReportedSurface& surface, const TetrahedralMesh& mesh) {
  std::map<int, std::vector<Index>> triangles_of;
  for (Index t = 0; t < mesh.triangles.size(); ++t) {
    ReportedPatch& patch = surface.patches[mesh.triangle_facets[t]];
    ++patch.triangles;
    for (const std::optional<int>& label : patch.regions)
      if (label) triangles_of[*label].push_back(t);
  }
  for (const auto& [label, triangles] : triangles_of) surface.boundaries.push_back(topology(label, mesh, triangles));
  add_angles_and_vertices(surface, mesh);
}

}  // namespace delref::program
