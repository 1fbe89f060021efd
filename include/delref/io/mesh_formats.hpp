// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes of either kind, for programs that are given a file and nothing else.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <variant>

#include <delref/core/budget.hpp>
#include <delref/core/point.hpp>
#include <delref/io/domain_dimension.hpp>
#include <delref/io/extension.hpp>
#include <delref/io/planar_formats.hpp>
#include <delref/io/tetrahedral_formats.hpp>
#include <delref/mesh/planar_mesh.hpp>
#include <delref/mesh/tetrahedral_mesh.hpp>

namespace delref {

/// A mesh of the plane or of space.
using AnyMesh = std::variant<PlanarMesh, TetrahedralMesh>;

/// Reads a mesh: one of space when the .node file says three dimensions, or a .vtu or .msh file has tetrahedra or triangles off the plane
/// z = 0, or the file is a .mesh; else a planar one. Throws as `read_planar_mesh` and `read_tetrahedral_mesh`.
inline AnyMesh read_mesh(const std::filesystem::path& path, const Control& control = Control{}) {
  const std::string extension = detail::lower_extension(path);
  if (extension == ".node" || extension == ".ele") {
    const auto node = std::filesystem::path(path).replace_extension(".node");
    if (domain_dimension(node, control) == Dimension::plane) return read_planar_mesh(path, control);
    return read_tetrahedral_mesh(path, control);
  }
  if (extension == ".mesh") return read_tetrahedral_mesh(path, control);
  if (extension == ".vtu" || extension == ".msh") {
    TetrahedralMesh mesh = read_tetrahedral_mesh(path, control);
    const bool is_surface = !mesh.triangles.empty() && std::ranges::any_of(mesh.points, [](Point3 p) { return p.z != 0; });
    if (!mesh.tetrahedra.empty() || is_surface) return mesh;
  }
  return read_planar_mesh(path, control);
}

}  // namespace delref
