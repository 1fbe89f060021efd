// SPDX-License-Identifier: GPL-3.0-or-later
//
// The promise of `--keep-boundary`, checked from input and mesh alone: nothing was inserted on the boundary of the domain.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <delref/core/point.hpp>
#include <delref/domain/pslg.hpp>
#include <delref/mesh/planar_mesh.hpp>
#include <delref/mesh/verify/report.hpp>

namespace delref::program {

/// The edges that only one triangle has, each with its lower vertex first.
inline std::vector<std::array<PlanarMesh::Index, 2>> boundary_edges(const PlanarMesh& mesh) {
  std::vector<std::array<PlanarMesh::Index, 2>> edges, once;
  for (const auto& [a, b, c] : mesh.triangles)
    for (const auto& [v, w] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
      edges.push_back({std::min(v, w), std::max(v, w)});
  std::ranges::sort(edges);
  for (std::size_t i = 0, next = 0; i < edges.size(); i = next) {
    while (next < edges.size() && edges[next] == edges[i]) ++next;
    if (next == i + 1) once.push_back(edges[i]);
  }
  return once;
}

/// Whether every vertex on the boundary of the mesh is one of the input. Requires valid indices in the triangles.
inline Finding check_kept_boundary(const Pslg& input, const PlanarMesh& mesh) {
  Finding finding;
  finding.name = "no vertex was inserted on the boundary";
  finding.status = CheckStatus::passed;
  std::set<std::pair<double, double>> known;
  for (const Point2 p : input.points) known.emplace(p.x, p.y);
  std::set<PlanarMesh::Index> vertices;
  for (const auto& edge : boundary_edges(mesh)) vertices.insert(edge.begin(), edge.end());
  finding.examined = vertices.size();
  for (const PlanarMesh::Index v : vertices) {
    const Point2 p = mesh.points[v];
    if (!known.contains({p.x, p.y}))
      finding.fail([&] { return fmt::format("vertex {} at ({}, {}) is not in the input", v + input.first_index, p.x, p.y); });
  }
  return finding;
}

}  // namespace delref::program
