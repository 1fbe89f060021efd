// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes one mesh in every format into a folder, and the mesh itself as plain lines that read_back.py compares with. Labels and
// markers are negative, zero and positive; coordinates have digits that only an exact writer keeps.
#include <cmath>
#include <filesystem>

#include <delref/io/planar_formats.hpp>

namespace {

delref::PlanarMesh sample(unsigned n) {
  delref::PlanarMesh mesh;
  mesh.level_names = {"edges", "faces"};
  for (unsigned i = 0; i <= n; ++i) {
    for (unsigned j = 0; j <= n; ++j) {
      mesh.points.push_back({i + 0.1 * std::sin(7.0 * i + j), j / 3.0 + 0.05 * std::cos(3.0 * j + i)});
      mesh.point_markers.push_back(static_cast<int>(i) - 2);
      mesh.carriers.push_back(i == 0 ? delref::Carrier{1, j} : delref::Carrier{2, delref::Carrier::none});
      mesh.provenance.push_back(i == 0 ? delref::input_level : static_cast<delref::LevelIndex>(j % 2));
    }
  }
  for (unsigned i = 0; i < n; ++i) {
    for (unsigned j = 0; j < n; ++j) {
      const unsigned a = i * (n + 1) + j, b = a + n + 1;
      mesh.triangles.push_back({a, b, b + 1});
      mesh.triangles.push_back({a, b + 1, a + 1});
      mesh.regions.insert(mesh.regions.end(), {static_cast<int>(i % 4) - 1, static_cast<int>(j) * 100});
    }
    mesh.edges.push_back({i, i + 1});
    mesh.edge_markers.push_back(static_cast<int>(i % 5) - 2);
    mesh.edge_segments.push_back(i);
  }
  return mesh;
}

}  // namespace

int main(int, char** arguments) {
  const std::filesystem::path folder = arguments[1];
  std::filesystem::create_directories(folder);
  const delref::PlanarMesh mesh = sample(12);
  for (const char* name : {"sample.node", "sample.vtu", "sample.msh", "sample.mesh", "sample.off", "sample.svg"}) {
    delref::write_planar_mesh(folder / name, mesh);
  }
  delref::write_file(folder / "expected.txt", [&](delref::TextSink& out) {
    for (std::size_t i = 0; i != mesh.points.size(); ++i) {
      const auto& c = mesh.carriers[i];
      out << "p " << mesh.points[i].x << ' ' << mesh.points[i].y << ' ' << mesh.point_markers[i] << ' '
          << (mesh.provenance[i] == delref::input_level ? -1 : int{mesh.provenance[i]}) << ' ' << int{c.dimension} << ' '
          << static_cast<int>(c.index) << '\n';
    }
    for (std::size_t i = 0; i != mesh.triangles.size(); ++i) {
      const auto& t = mesh.triangles[i];
      out << "t " << t[0] << ' ' << t[1] << ' ' << t[2] << ' ' << mesh.regions[i] << '\n';
    }
    for (std::size_t i = 0; i != mesh.edges.size(); ++i) {
      out << "e " << mesh.edges[i][0] << ' ' << mesh.edges[i][1] << ' ' << mesh.edge_markers[i] << ' ' << mesh.edge_segments[i] << '\n';
    }
  });
}
