// SPDX-License-Identifier: GPL-3.0-or-later
//
// A folder for a test's files, broken texts, and a mesh that carries everything.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include <catch2/catch_test_macros.hpp>

#include <delref/mesh/planar_mesh.hpp>

namespace delref_test {

/// A new empty folder, gone at the end of the test.
class Scratch {
 public:
  Scratch() {
    std::string name = (std::filesystem::temp_directory_path() / "delref_io_XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  std::filesystem::path operator/(std::string_view name) const { return folder_ / name; }
  std::filesystem::path write(std::string_view name, std::string_view text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }

 private:
  std::filesystem::path folder_;
};

/// The text with another one in the place of the first `from`, which must be there.
inline std::string replaced(std::string text, std::string_view from, std::string_view to) {
  return text.replace(text.find(from), from.size(), to);
}

/// Two triangles of a square with labels, markers, carriers and provenance; coordinates that need all their digits.
inline delref::PlanarMesh square_mesh() {
  delref::PlanarMesh mesh;
  mesh.points = {{0, 0}, {1.0 / 3, -1e-150}, {0.1, 1e22}, {-0.7, 5e-324}};
  mesh.point_markers = {1, 0, -5, 2147483647};
  mesh.carriers = {{0, 0}, {1, 3}, {2, delref::Carrier::none}, {0, 1}};
  mesh.provenance = {delref::input_level, 0, 1, delref::input_level};
  mesh.level_names = {"edges", "faces"};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.regions = {-3, 0};
  mesh.edges = {{0, 1}, {2, 3}, {1, 2}};
  mesh.edge_markers = {7, 0, -2147483647 - 1};
  mesh.edge_segments = {0, 4, 1};
  return mesh;
}

/// Checks what every format that is read carries.
inline void check_same(const delref::PlanarMesh& read, const delref::PlanarMesh& mesh) {
  CHECK(read.points == mesh.points);
  CHECK(read.point_markers == mesh.point_markers);
  CHECK(read.triangles == mesh.triangles);
  CHECK(read.regions == mesh.regions);
  CHECK(read.edges == mesh.edges);
  CHECK(read.edge_markers == mesh.edge_markers);
}

}  // namespace delref_test
