// SPDX-License-Identifier: MIT
//
// Shows how to read a domain, mesh it, judge the mesh and write it.
#include <cstdio>
#include <string>

#include <delref/algorithms/planar.hpp>
#include <delref/io/planar_formats.hpp>
#include <delref/mesh/quality_table.hpp>

int main(int argc, char** argv) try {
  // The format is told by the extension: .poly, .node, .geojson.
  const std::string path = argc > 1 ? argv[1] : "examples/data/greece.poly";
  const delref::PslgFile file = delref::read_pslg(path);

  // Ask for angles of at least 25 degrees. Everything else has a default.
  delref::PlanarOptions options;
  options.min_angle = delref::AngleBound::degrees(25);
  const delref::PlanarResult result = delref::mesh_planar(file.pslg, options);

  // What came out: a plain indexed triangle mesh. Of what cannot be met, the outcome says where and why (example 3).
  std::fputs(delref::quality_table(delref::planar_quality(result.mesh)).c_str(), stdout);
  for (const std::string& note : result.notes) std::printf("note: %s\n", note.c_str());
  std::printf("%zu triangles do not meet the bound\n", result.outcome.unmet.size());

  // The extension tells the format: .vtu for ParaView, .svg for a browser, .node for Triangle's files, .msh, .mesh, .off.
  delref::write_planar_mesh("coast.vtu", result.mesh);
  delref::write_planar_mesh("coast.svg", result.mesh);
  return result.outcome.complete() ? 0 : 1;
} catch (const delref::InvalidInput& refused) {
  std::fprintf(stderr, "%s\n", refused.what());
  return 3;
}
