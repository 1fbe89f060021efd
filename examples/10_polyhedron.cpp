// SPDX-License-Identifier: MIT
//
// Shows how to fill a polyhedron with tetrahedra, judge the mesh and write it.
#include <cstdio>

#include <delref/algorithms/polyhedral.hpp>
#include <delref/io/tetrahedral_formats.hpp>
#include <delref/mesh/tetrahedral_quality.hpp>

namespace {

/// A box with a corner at the origin. `read_plc` of <delref/io/polyhedral_formats.hpp> reads a domain from a file instead.
delref::Plc box(double x, double y, double z) {
  delref::Plc plc;
  plc.points = {{0, 0, 0}, {x, 0, 0}, {x, y, 0}, {0, y, 0}, {0, 0, z}, {x, 0, z}, {x, y, z}, {0, y, z}};
  // A facet is a list of polygons in one plane: its outline, and outlines of holes if it has any. Which way round does not matter.
  const auto side = [&](delref::Plc::Index a, delref::Plc::Index b, delref::Plc::Index c, delref::Plc::Index d, int marker) {
    plc.facets.push_back({{{a, b, c, d}}, {}, marker});
  };
  side(0, 1, 2, 3, 1);
  side(4, 5, 6, 7, 2);
  side(0, 1, 5, 4, 3);
  side(1, 2, 6, 5, 4);
  side(2, 3, 7, 6, 5);
  side(3, 0, 4, 7, 6);
  return plc;
}

}  // namespace

int main() try {
  delref::PolyhedralOptions options;
  options.radius_edge = 1.414;  // no circumradius over 1.414 times the shortest edge
  options.max_volume = 0.01;
  const delref::PolyhedralResult result = delref::mesh_polyhedron(box(2, 1, 1), options);

  // What came out: points, tetrahedra, and the triangles and edges on the input, with markers.
  const delref::TetrahedralQuality quality = delref::tetrahedral_quality(result.mesh);
  std::printf("%zu tetrahedra, %zu triangles on facets, volume %.6g\n", quality.tetrahedron_count, quality.triangle_count,
              quality.total_volume);
  std::printf("radius-edge ratio at most %.3f, dihedral angles %.1f to %.1f degrees\n", quality.worst_radius_edge, quality.smallest_dihedral,
              quality.largest_dihedral);
  std::printf("%zu tetrahedra under 5 degrees: slivers, which no radius-edge bound forbids\n", quality.under_5_degrees);

  // The extension tells the format: .vtu for ParaView, .svg for a cut in a browser, .msh for gmsh, .mesh, or TetGen's .node and .ele.
  delref::write_tetrahedral_mesh("box.vtu", result.mesh);
  delref::write_tetrahedral_mesh("box.svg", result.mesh);
  return result.outcome.complete() && result.outcome.unmet.empty() ? 0 : 1;
} catch (const delref::InvalidInput& refused) {
  std::fprintf(stderr, "%s\n", refused.what());
  return 3;
}
