// SPDX-License-Identifier: GPL-3.0-or-later

#include <cmath>
#include <string>

#include <catch2/catch_test_macros.hpp>

#include <delref/mesh/surface_quality.hpp>

using namespace delref;

namespace {

/// The corner of a cube of side `size`, cut off: three right isosceles triangles and an equilateral one.
TetrahedralMesh corner(double size) {
  TetrahedralMesh mesh;
  mesh.points = {{0, 0, 0}, {size, 0, 0}, {0, size, 0}, {0, 0, size}, {9 * size, 9 * size, 9 * size}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  mesh.triangle_markers = {1, 1, 1, 2};
  return mesh;
}
bool is_near(double a, double b) { return std::abs(a - b) <= 1e-12 * std::abs(b); }

}  // namespace

TEST_CASE("a surface is measured by its triangles alone") {
  for (const double size : {1.0, 1e-100, 1e100}) {
    const SurfaceQuality q = surface_quality(corner(size));
    CHECK(q.vertex_count == 4);
    CHECK(q.edge_count == 6);
    CHECK(q.triangle_count == 4);
    CHECK(q.component_count == 1);
    CHECK(q.euler_characteristic() == 2);
    CHECK(q.border_edges == 0);
    CHECK(is_near(q.smallest_angle, 45));
    CHECK(is_near(q.largest_angle, 90));
    CHECK(is_near(q.mean_smallest_angle, (3 * 45 + 60) / 4.0));
    CHECK(q.smallest_angles[9] + q.smallest_angles[8] == 3);
    CHECK(is_near(q.shortest_edge, size));
    CHECK(is_near(q.longest_edge, std::sqrt(2) * size));
    CHECK(is_near(q.areas.at(1), 1.5 * size * size));
    CHECK(is_near(q.areas.at(2), std::sqrt(0.75) * size * size));
    CHECK(is_near(q.total_area, (1.5 + std::sqrt(0.75)) * size * size));
    CHECK(is_near(q.smallest_area, 0.5 * size * size));
  }
}

TEST_CASE("the pieces, the borders and the crowded edges of a surface are counted") {
  TetrahedralMesh mesh = corner(1);
  mesh.triangles.pop_back(), mesh.triangle_markers.pop_back();
  CHECK(surface_quality(mesh).border_edges == 3);
  mesh.triangles.push_back({0, 1, 4}), mesh.triangle_markers.push_back(1);
  const SurfaceQuality q = surface_quality(mesh);
  CHECK(q.crowded_edges == 1);
  CHECK(q.component_count == 1);
  mesh = corner(1);
  mesh.triangles = {{0, 1, 2}, {0, 3, 4}};
  CHECK(surface_quality(mesh).component_count == 2);
  CHECK(quality_table(surface_quality(mesh)).find("border           6 edges") != std::string::npos);
}

TEST_CASE("a surface without triangles has figures of 0") {
  const SurfaceQuality q = surface_quality({});
  CHECK(q.smallest_angle == 0);
  CHECK(q.shortest_edge == 0);
  CHECK(quality_table(q).find("nothing to measure") != std::string::npos);
}
