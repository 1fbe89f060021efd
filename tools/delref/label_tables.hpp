// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tables of how many elements carry each label. Each begins with an empty line; of a vector that the mesh does not carry they say so.
#pragma once

#include <string>

#include <delref/mesh/planar_mesh.hpp>
#include <delref/mesh/tetrahedral_mesh.hpp>

namespace delref::program {

/// Triangles and area, or tetrahedra and volume, of each region.
std::string regions_table(const PlanarMesh& mesh);
std::string regions_table(const TetrahedralMesh& mesh);

/// Regions, triangles on facets, edges on segments, vertices, and who made these.
std::string label_tables(const PlanarMesh& mesh);
std::string label_tables(const TetrahedralMesh& mesh);

}  // namespace delref::program
