// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes the .mesh format of MEDIT (Frey 2001, INRIA technical report 253), which the Mmg tools read. The reference of a vertex or
// edge is its marker, that of a triangle its region.
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include <delref/io/file.hpp>
#include <delref/mesh/planar_mesh.hpp>

namespace delref {

/// Writes vertices, subsegments and triangles with their references, in two dimensions, numbered from 1. Throws `OutputError`.
inline void write_medit(const std::filesystem::path& path, const PlanarMesh& mesh) {
  const auto reference = [](const std::vector<int>& references, std::size_t i) { return references.empty() ? 0 : references[i]; };
  write_file(path, [&](TextSink& out) {
    out << "MeshVersionFormatted 2\nDimension 2\nVertices\n" << mesh.points.size() << '\n';
    for (std::size_t i = 0; i != mesh.points.size(); ++i) {
      out << mesh.points[i].x << ' ' << mesh.points[i].y << ' ' << reference(mesh.point_markers, i) << '\n';
    }
    out << "Edges\n" << mesh.edges.size() << '\n';
    for (std::size_t i = 0; i != mesh.edges.size(); ++i) {
      out << mesh.edges[i][0] + 1 << ' ' << mesh.edges[i][1] + 1 << ' ' << reference(mesh.edge_markers, i) << '\n';
    }
    out << "Triangles\n" << mesh.triangles.size() << '\n';
    for (std::size_t i = 0; i != mesh.triangles.size(); ++i) {
      const auto& t = mesh.triangles[i];
      out << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << ' ' << reference(mesh.regions, i) << '\n';
    }
    out << "End\n";
  });
}

}  // namespace delref
