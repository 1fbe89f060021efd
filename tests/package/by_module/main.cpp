// SPDX-License-Identifier: MIT
//
// A program of somebody else: meshes a square by import.
import delref;

int main() {
  delref::Pslg square;
  square.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  square.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  delref::PlanarOptions options;
  options.max_area = 0.01;
  const delref::PlanarResult result = delref::mesh_planar(square, options);
  return result.outcome.complete() && result.outcome.unmet.empty() && result.mesh.triangles.size() >= 100 ? 0 : 1;
}
