// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes the .mesh format of MEDIT (Frey 2001, INRIA technical report 253), which the Mmg tools read. The reference of a vertex is
// its marker, that of a cell its region (of a mesh's own cells) or its marker (of those on input segments and facets).
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string_view>

#include <delref/core/budget.hpp>
#include <delref/io/file.hpp>
#include <delref/io/mesh_blocks.hpp>

namespace delref {

namespace detail {

/// By dimension.
inline constexpr std::array<std::string_view, 4> medit_keywords{"Vertices", "Edges", "Triangles", "Tetrahedra"};

}  // namespace detail

/// Writes vertices, subsegments, triangles and tetrahedra with their references, numbered from 1. Throws `OutputError`, and
/// `Interrupted` when the control says stop.
template <IndexedMesh Mesh>
void write_medit(const std::filesystem::path& path, const Mesh& mesh, const Control& control = Control{}) {
  const auto write = [&](TextSink& out) {
    constexpr std::size_t dimension = detail::dimension_of<Mesh>;
    out << "MeshVersionFormatted 2\nDimension " << dimension << "\nVertices\n" << mesh.points.size() << '\n';
    for (std::size_t i = 0; i != mesh.points.size(); ++i) {
      const auto point = detail::coordinates(mesh.points[i]);
      for (std::size_t k = 0; k != dimension; ++k) out << point[k] << ' ';
      out << (mesh.point_markers.empty() ? 0 : mesh.point_markers[i]) << '\n';
    }
    detail::for_each_block_from_edges(mesh, [&](const auto& block) {
      out << detail::medit_keywords[block.dimension] << '\n' << block.cells.size() << '\n';
      for (std::size_t i = 0; i != block.cells.size(); ++i) {
        for (const auto corner : block.cells[i]) out << std::size_t{corner} + 1 << ' ';
        out << block.label(i) << '\n';
      }
    });
    out << "End\n";
  };
  write_file(path, write, control);
}

}  // namespace delref
