// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes for the tests of verify_polyhedral: the Delaunay triangulation of the vertices of a complex and some Steiner points,
// which must have the facets as unions of its triangles, with every label that a finished mesh has. Made by CGAL and nothing of
// delref.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <delref/domain/plc.hpp>
#include <delref/mesh/tetrahedral_mesh.hpp>
#include <delref/mesh/verify/report.hpp>

namespace delref::testing_mesh_3 {

/// What `label` says of tetrahedra outside the domain.
inline constexpr int outside = -1;

/// The mesh of the input's vertices and the Steiner points, less the tetrahedra whose barycentre `label` says is outside.
/// Triangles and edges are found by exact coplanarity.
TetrahedralMesh meshed(const Plc& input, const std::vector<Point3>& steiner_points, const std::function<int(Point3)>& label);

/// Adds a box with six facets, marked from `first_marker` on; the sides named in `without` ("x" for the lower one, "X" for the
/// upper one, ...) are left out, and existing vertices are used again.
void add_box(Plc& plc, Point3 low, Point3 high, int first_marker, const std::string& without = "");
/// Adds a facet of one polygon.
void add_facet(Plc& plc, const std::vector<Point3>& polygon, int marker);

/// Three boxes in a row from x = 0 to 1, 3 and 4. The first has label 1 and an isolated vertex, the second label 2 and a square
/// that floats in it, the third is a cavity. An edge of the first has marker 50.
Plc three_rooms();
int label_in_three_rooms(Point3 p);
TetrahedralMesh three_rooms_mesh();

/// The names of the checks that failed.
std::vector<std::string> failed(const VerifyReport& report);

}  // namespace delref::testing_mesh_3
