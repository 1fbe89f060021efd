// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes and reads meshes as TetGen does (Si 2015, wias-berlin.de/software/tetgen/fformats.html): a .node, an .ele, a .face and an
// .edge file of one stem. The .ele file carries the labels of the regions, the .face file the triangles on input facets and the .edge
// file the edges on input segments, both with their markers.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <delref/core/budget.hpp>
#include <delref/domain/plc.hpp>
#include <delref/io/element_records.hpp>
#include <delref/io/file.hpp>
#include <delref/io/file_set.hpp>
#include <delref/io/mesh_blocks.hpp>
#include <delref/io/tetgen_poly.hpp>
#include <delref/io/text_sink.hpp>
#include <delref/mesh/tetrahedral_mesh.hpp>

namespace delref {

/// The files that `write_tetgen_mesh` writes for a path: `.node`, `.ele`, `.face` and `.edge`, whatever the path's extension.
inline std::array<std::filesystem::path, 4> tetgen_mesh_files(const std::filesystem::path& path) {
  return files_of_stem(path, {".node", ".ele", ".face", ".edge"});
}

/// Writes the four files of `tetgen_mesh_files(path)`, all of them or none.
/// Numbers start at `input.first_index`; attributes are the input's, which may be empty, and 0 at a Steiner vertex. `original_point`
/// gives per vertex of the polyhedral domain its index in the input; empty: they are the same. Throws `OutputError`, and `Interrupted`
/// when the control says stop.
inline void write_tetgen_mesh(const std::filesystem::path& path, const TetrahedralMesh& mesh, const Plc& input = {},
                              std::span<const Plc::Index> original_point = {}, const Control& control = Control{}) {
  const auto original = [&](std::size_t vertex) {
    return vertex < original_point.size() ? std::size_t{original_point[vertex]} : vertex;
  };
  const auto write = [&](const std::array<TextSink*, 4>& sinks) {
    const auto [node, ele, face, edge] = sinks;
    const auto [tetrahedra, triangles, edges] = detail::mesh_blocks(mesh);
    const std::size_t first = input.first_index;
    detail::write_node_records(*node, mesh, input, original);
    detail::write_ele_records(*ele, tetrahedra, first);
    *face << mesh.triangles.size() << " 1\n";
    detail::write_cell_records(*face, triangles, first, true);
    *edge << mesh.edges.size() << " 1\n";
    detail::write_cell_records(*edge, edges, first, true);
  };
  write_file_set(tetgen_mesh_files(path), write, control);
}

/// The text of a mesh in TetGen's format; an empty `face` or `edge` is a file that is not there.
struct TetgenMeshText {
  std::string_view node, ele, face, edge;
};

/// The mesh in those texts; `stem` is what complaints call the files, with their extensions. Every row of the .face and .edge files is
/// a triangle on a facet, or an edge on a segment. Carriers, provenance and input elements are not in these files. Throws
/// `InvalidInput` with the line and what was expected there, `Interrupted` when the control says stop.
inline TetrahedralMesh parse_tetgen_mesh(const TetgenMeshText& text, const std::string& stem, const Control& control = Control{}) {
  Plc nodes = parse_tetgen_node(text.node, stem + ".node", control);
  TetrahedralMesh mesh;
  const auto [tetrahedra, triangles, edges] = detail::mesh_blocks(mesh);
  detail::read_ele_records(text.ele, stem + ".ele", nodes, "tetrahedron", "tetrahedra", tetrahedra, control);
  if (!text.face.empty()) detail::read_marked_records(text.face, stem + ".face", nodes, "vertex", "face", triangles, false, control);
  if (!text.edge.empty()) detail::read_marked_records(text.edge, stem + ".edge", nodes, "end", "edge", edges, false, control);
  mesh.points = std::move(nodes.points);
  mesh.point_markers = std::move(nodes.point_markers);
  return mesh;
}

/// Reads the .node and .ele files of the path's stem, and the .face and .edge files if they are there.
/// Throws as `read_file` and `parse_tetgen_mesh`.
inline TetrahedralMesh read_tetgen_mesh(const std::filesystem::path& path, const Control& control = Control{}) {
  const auto [node, ele, face, edge] = tetgen_mesh_files(path);
  const auto read_if_there = [&](const std::filesystem::path& file) {
    return std::filesystem::exists(file) ? read_file(file, control) : std::string();
  };
  const std::string node_text = read_file(node, control), ele_text = read_file(ele, control);
  const std::string face_text = read_if_there(face), edge_text = read_if_there(edge);
  return parse_tetgen_mesh({node_text, ele_text, face_text, edge_text}, std::filesystem::path(path).replace_extension().string(), control);
}

}  // namespace delref
