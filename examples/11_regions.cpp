// SPDX-License-Identifier: MIT
//
// Shows how to mesh two regions that share a facet, each with a label and a volume bound of its own.
#include <cmath>
#include <cstdio>

#include <delref/algorithms/polyhedral.hpp>
#include <delref/io/tetrahedral_formats.hpp>
#include <delref/mesh/tetrahedral_quality.hpp>

int main() try {
  // Two cubes side by side. The wall between them stands once in the list, and belongs to both.
  constexpr int wall = 7, outside = 1, fluid = 10, solid = 20;
  delref::Plc plc;
  for (const double x : {0.0, 1.0, 2.0})
    for (const delref::Point3 corner : {delref::Point3{x, 0, 0}, {x, 1, 0}, {x, 1, 1}, {x, 0, 1}}) plc.points.push_back(corner);
  plc.facets = {{{{0, 1, 2, 3}}, {}, outside}, {{{4, 5, 6, 7}}, {}, wall}, {{{8, 9, 10, 11}}, {}, outside}};
  for (const delref::Plc::Index cube : {0U, 4U})
    for (delref::Plc::Index side = 0; side < 4; ++side) {
      const delref::Plc::Index next = (side + 1) % 4;
      plc.facets.push_back({{{cube + side, cube + next, cube + next + 4, cube + side + 4}}, {}, outside});
    }

  // A seed is a point inside: its region is what the facets around it enclose. A hole seed in `plc.holes` would leave it empty.
  plc.regions = {{{0.5, 0.5, 0.5}, fluid, 0.0005}, {{1.5, 0.5, 0.5}, solid, 0.02}};
  const delref::PolyhedralResult result = delref::mesh_polyhedron(plc);

  const delref::TetrahedralQuality quality = delref::tetrahedral_quality(result.mesh);
  bool is_right = result.outcome.complete() && result.outcome.unmet.empty() && quality.regions.size() == 2;
  for (const auto& [label, region] : quality.regions) {
    std::printf("region %d: %zu tetrahedra, volume %.9f\n", label, region.tetrahedron_count, region.volume);
    is_right = is_right && std::abs(region.volume - 1) < 1e-9;
  }

  // The wall, as triangles that both regions share, knows its marker.
  double area = 0;
  for (std::size_t t = 0; t < result.mesh.triangles.size(); ++t) {
    if (result.mesh.triangle_markers[t] != wall) continue;
    const auto& [a, b, c] = result.mesh.triangles[t];
    const delref::Point3 p = result.mesh.points[a];
    area += 0.5 * std::sqrt(squared_length(cross(result.mesh.points[b] - p, result.mesh.points[c] - p)));
  }
  std::printf("the wall between them has an area of %.9f\n", area);

  delref::write_tetrahedral_mesh("cubes.vtu", result.mesh);
  return is_right && std::abs(area - 1) < 1e-9 ? 0 : 1;
} catch (const delref::InvalidInput& refused) {
  std::fprintf(stderr, "%s\n", refused.what());
  return 3;
}
