// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes for the tests of mesh/: the constrained Delaunay triangulation of a planar straight line graph and some Steiner points,
// with every label that a finished mesh has. Made by CGAL and nothing of delref.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <delref/domain/pslg.hpp>
#include <delref/mesh/planar_mesh.hpp>
#include <delref/mesh/verify/report.hpp>

namespace delref::testing_mesh {

/// The constrained Delaunay mesh of the domain. A Steiner point that lies exactly on segments is taken to be on the first of them.
PlanarMesh triangulated(const Pslg& input, const std::vector<Point2>& steiner_points = {});

/// Two rooms, labelled 1 (areas up to 1) and 2, side by side in a square of side 4; a square hole in the second, which has marker 9; a slit
/// in the first, from the wall.
Pslg two_rooms();
/// A mesh of them with Steiner vertices inside and on segments, no four of them on a circle.
PlanarMesh two_rooms_mesh();

/// The names of the checks that failed.
std::vector<std::string> failed(const VerifyReport& report);

}  // namespace delref::testing_mesh
