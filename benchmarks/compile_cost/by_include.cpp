// SPDX-License-Identifier: MIT
//
// The smallest program that meshes a planar straight line graph, by include.
#include <delref/algorithms/planar.hpp>

int main() {
  delref::Pslg square;
  square.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  square.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  return delref::mesh_planar(square, {}).mesh.triangles.empty() ? 1 : 0;
}
