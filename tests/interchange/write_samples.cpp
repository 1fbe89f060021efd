// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes a planar and a tetrahedral mesh in every format into a folder, and the meshes themselves as plain lines that read_back.py
// compares with. Labels and markers are negative, zero and positive; coordinates have digits that only an exact writer keeps.
// With two arguments it reads a surface that another program wrote and prints it.
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <utility>

#include <delref/io/planar_formats.hpp>
#include <delref/io/polyhedral_formats.hpp>
#include <delref/io/tetrahedral_formats.hpp>

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

/// A box of cubes, each cut into six tetrahedra around a diagonal. The bottom is a facet per row, its front edge a segment per cube.
delref::TetrahedralMesh solid_sample(unsigned n) {
  delref::TetrahedralMesh mesh;
  mesh.level_names = {"edges", "facets", "tetrahedra"};
  const auto vertex = [&](const std::array<unsigned, 3>& at) { return (at[0] * (n + 1) + at[1]) * (n + 1) + at[2]; };
  for (unsigned v = 0; v != (n + 1) * (n + 1) * (n + 1); ++v) {
    const unsigned i = v / (n + 1) / (n + 1), j = v / (n + 1) % (n + 1), k = v % (n + 1);
    mesh.points.push_back({i + 0.1 * std::sin(7.0 * i + j), j / 3.0 + 0.01 * k, k + 0.05 * std::cos(3.0 * j + i)});
    mesh.point_markers.push_back(static_cast<int>(i) - 2);
    mesh.carriers.push_back(k == 0 ? delref::Carrier{2, j} : delref::Carrier{3, delref::Carrier::none});
    mesh.provenance.push_back(i == 0 ? delref::input_level : static_cast<delref::LevelIndex>(j % 3));
  }
  constexpr std::array<std::array<unsigned, 3>, 6> orders{{{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {1, 0, 2}, {2, 1, 0}}};
  for (unsigned cube = 0; cube != n * n * n; ++cube) {
    const std::array<unsigned, 3> corner{cube / n / n, cube / n % n, cube % n};
    for (std::size_t o = 0; o != orders.size(); ++o) {
      auto at = corner;
      std::array<delref::TetrahedralMesh::Index, 4> t{vertex(at)};
      for (std::size_t step = 0; step != 3; ++step) {
        ++at[orders[o][step]];
        t[step + 1] = vertex(at);
      }
      if (o >= 3) std::swap(t[1], t[2]);
      mesh.tetrahedra.push_back(t);
      mesh.regions.push_back(static_cast<int>(corner[0] % 4) - 1);
    }
    if (corner[2] != 0) continue;
    const auto a = vertex(corner), b = vertex({corner[0] + 1, corner[1], 0}), c = vertex({corner[0] + 1, corner[1] + 1, 0});
    mesh.triangles.push_back({a, c, b});
    mesh.triangle_markers.push_back(static_cast<int>(corner[1] * 2) - 2);
    mesh.triangle_facets.push_back(corner[1]);
    if (corner[1] != 0) continue;
    mesh.edges.push_back({a, b});
    mesh.edge_markers.push_back(static_cast<int>(corner[0]) - 1);
    mesh.edge_segments.push_back(corner[0]);
  }
  return mesh;
}

/// The mesh as lines: `p x y z marker provenance dimension carrier` and `N corner ... label element` for cells of N corners.
template <class Mesh>
void write_expected(const std::filesystem::path& path, const Mesh& mesh) {
  delref::write_file(path, [&](delref::TextSink& out) {
    for (std::size_t i = 0; i != mesh.points.size(); ++i) {
      const auto& c = mesh.carriers[i];
      out << 'p';
      for (const double x : delref::detail::coordinates(mesh.points[i])) out << ' ' << x;
      out << ' ' << mesh.point_markers[i] << ' ' << (mesh.provenance[i] == delref::input_level ? -1 : int{mesh.provenance[i]}) << ' '
          << int{c.dimension} << ' ' << static_cast<int>(c.index) << '\n';
    }
    delref::detail::for_each_block(mesh, [&](const auto& block) {
      for (std::size_t i = 0; i != block.cells.size(); ++i) {
        out << block.corners;
        for (const auto corner : block.cells[i]) out << ' ' << corner;
        out << ' ' << block.labels[i] << ' ' << (block.elements == nullptr ? 0 : (*block.elements)[i]) << '\n';
      }
    });
  });
}

/// The surface as lines of coordinates and of corners.
void print_surface(const std::filesystem::path& path) {
  const delref::Plc plc = delref::read_plc(path).plc;
  for (const auto& p : plc.points) std::fputs(fmt::format("p {} {} {}\n", p.x, p.y, p.z).c_str(), stdout);
  for (const auto& facet : plc.facets) {
    std::fputs("f", stdout);
    for (const auto v : facet.polygons[0]) std::fputs(fmt::format(" {}", v).c_str(), stdout);
    std::fputs("\n", stdout);
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count == 3) {
    print_surface(arguments[2]);
    return 0;
  }
  const std::filesystem::path folder = arguments[1];
  std::filesystem::create_directories(folder);
  const delref::PlanarMesh mesh = sample(12);
  for (const char* name : {"sample.node", "sample.vtu", "sample.msh", "sample.mesh", "sample.off", "sample.svg"}) {
    delref::write_planar_mesh(folder / name, mesh);
  }
  write_expected(folder / "expected.txt", mesh);
  const delref::TetrahedralMesh solid = solid_sample(6);
  for (const char* name : {"solid.node", "solid.vtu", "solid.msh", "solid.mesh"}) delref::write_tetrahedral_mesh(folder / name, solid);
  write_expected(folder / "solid.txt", solid);
}
