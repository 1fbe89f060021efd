// SPDX-License-Identifier: GPL-3.0-or-later
//
// A tetrahedral mesh that carries everything.
#pragma once

#include <delref/mesh/tetrahedral_mesh.hpp>

namespace delref_test {

/// Two tetrahedra on a common triangle with labels, markers, carriers and provenance; coordinates that need all their digits.
inline delref::TetrahedralMesh two_tetrahedra() {
  delref::TetrahedralMesh mesh;
  mesh.points = {{0, 0, 0}, {1.0 / 3, -1e-150, 0}, {0.1, 1e22, 0}, {-0.7, 5e-324, 0.1}, {0.25, 0.5, -1e300}};
  mesh.point_markers = {1, 0, -5, 2147483647, 0};
  mesh.carriers = {{0, 0}, {1, 3}, {2, 1}, {3, delref::Carrier::none}, {0, 2}};
  mesh.provenance = {delref::input_level, 0, 1, 2, delref::input_level};
  mesh.level_names = {"edges", "facets", "tetrahedra"};
  mesh.tetrahedra = {{0, 1, 2, 3}, {0, 2, 1, 4}};
  mesh.regions = {-3, 0};
  mesh.triangles = {{0, 1, 2}, {0, 3, 1}, {4, 1, 2}};
  mesh.triangle_markers = {0, 12, -2147483647 - 1};
  mesh.triangle_facets = {0, 5, 2};
  mesh.edges = {{0, 1}, {2, 3}, {1, 2}};
  mesh.edge_markers = {7, 0, 12};
  mesh.edge_segments = {0, 4, 1};
  return mesh;
}

}  // namespace delref_test
