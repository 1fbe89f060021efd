// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <filesystem>
#include <stop_token>
#include <vector>

#include <catch2/catch_test_macros.hpp>

#include <delref/io/polyhedral_formats.hpp>
#include <delref/io/surface_formats.hpp>

#include "../io/scratch.hpp"

namespace {

using namespace delref;

/// A tetrahedron with digits that only an exact writer keeps, a point inside it that is on no triangle, and one before the others.
TetrahedralMesh sample() {
  TetrahedralMesh mesh;
  mesh.points = {{0.2, 0.2, 0.2}, {0.1, 1.0 / 3, -2e-17}, {1, std::sqrt(0.5), 0}, {0, 1, 1e-300}, {0, 0, 123456789.123456789}};
  mesh.triangles = {{1, 3, 2}, {1, 2, 4}, {2, 3, 4}, {3, 1, 4}};
  return mesh;
}

std::vector<std::array<Point3, 3>> triangles_of(const TetrahedralMesh& mesh) {
  std::vector<std::array<Point3, 3>> out;
  for (const auto& [a, b, c] : mesh.triangles) out.push_back({mesh.points[a], mesh.points[b], mesh.points[c]});
  return out;
}

std::vector<std::array<Point3, 3>> triangles_of(const Plc& plc) {
  std::vector<std::array<Point3, 3>> out;
  for (const auto& facet : plc.facets) {
    const auto& f = facet.polygons.at(0);
    out.push_back({plc.points[f.at(0)], plc.points[f.at(1)], plc.points[f.at(2)]});
  }
  return out;
}

/// Whether two triangles have the same corners in the same sense.
bool same_triangle(const std::array<Point3, 3>& a, const std::array<Point3, 3>& b) {
  for (std::size_t shift = 0; shift < 3; ++shift)
    if (a[0] == b[shift] && a[1] == b[(shift + 1) % 3] && a[2] == b[(shift + 2) % 3]) return true;
  return false;
}

}  // namespace

TEST_CASE("Surfaces are written so that the same doubles are read again, in the same order and sense") {
  const delref_test::Scratch folder;
  const auto wanted = triangles_of(sample());
  for (const char* name : {"a.off", "a.stl", "a.ply", "a.obj", "A.OFF"}) {
    INFO(name);
    write_surface(folder / name, sample());
    const auto found = triangles_of(read_plc(folder / name).plc);
    REQUIRE(found.size() == wanted.size());
    for (std::size_t t = 0; t < wanted.size(); ++t) CHECK(same_triangle(found[t], wanted[t]));
  }
}

TEST_CASE("A surface has only the points of its triangles") {
  const delref_test::Scratch folder;
  for (const char* name : {"a.off", "a.ply", "a.obj"}) {
    write_surface(folder / name, sample());
    CHECK(read_plc(folder / name).plc.points.size() == 4);
  }
}

TEST_CASE("The formats of surfaces are known by their extensions") {
  CHECK(is_surface_format("a.off"));
  CHECK(is_surface_format("folder.vtu/a.STL"));
  CHECK_FALSE(is_surface_format("a.vtu"));
  CHECK_FALSE(is_surface_format("off"));
  const delref_test::Scratch folder;
  CHECK_THROWS_AS(write_surface(folder / "a.vtu", sample()), OutputError);
  CHECK(std::filesystem::is_empty(folder / ""));
}

TEST_CASE("A surface that cannot be written whole is not there at all") {
  const delref_test::Scratch folder;
  CHECK_THROWS_AS(write_surface(folder / "nowhere/a.off", sample()), OutputError);
  std::stop_source stop;
  stop.request_stop();
  for (const char* name : {"a.off", "a.stl", "a.ply", "a.obj"})
    CHECK_THROWS_AS(write_surface(folder / name, sample(), Control({}, stop.get_token())), Interrupted);
  CHECK(std::filesystem::is_empty(folder / ""));
  std::filesystem::create_symlink("/dev/full", folder / "full.off");
  CHECK_THROWS_AS(write_surface(folder / "full.off", sample()), OutputError);
}
