// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numeric>

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

#include <delref/mesh/quality.hpp>
#include <delref/mesh/quality_table.hpp>

using Catch::Approx;
using namespace delref;

namespace {

/// A square of the given side as a fan of four triangles around its centre.
PlanarMesh square_fan(double side) {
  PlanarMesh mesh;
  mesh.points = {{0, 0}, {side, 0}, {side, side}, {0, side}, {side / 2, side / 2}};
  mesh.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  return mesh;
}

PlanarMesh one_triangle(Point2 a, Point2 b, Point2 c) {
  PlanarMesh mesh;
  mesh.points = {a, b, c};
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

}  // namespace

TEST_CASE("the figures of a square fan are those of its right-angled triangles") {
  const PlanarQuality q = planar_quality(square_fan(2));
  CHECK(q.vertex_count == 5);
  CHECK(q.triangle_count == 4);
  CHECK(q.smallest_angle == Approx(45));
  CHECK(q.mean_smallest_angle == Approx(45));
  CHECK(q.largest_angle == Approx(90));
  CHECK(q.smallest_area == Approx(1));
  CHECK(q.largest_area == Approx(1));
  CHECK(q.total_area == 4);
  CHECK(q.shortest_edge == Approx(std::sqrt(2)));
  CHECK(q.longest_edge == 2);
  CHECK(q.worst_radius_edge == Approx(1 / std::sqrt(2)));
}

TEST_CASE("every triangle and every angle is counted once in the histograms") {
  const PlanarQuality q = planar_quality(square_fan(1));
  CHECK(std::accumulate(q.smallest_angles.begin(), q.smallest_angles.end(), std::size_t{0}) == 4);
  CHECK(std::accumulate(q.all_angles.begin(), q.all_angles.end(), std::size_t{0}) == 12);
}

TEST_CASE("an equilateral triangle falls into the last bin of the smallest angles") {
  const PlanarQuality q = planar_quality(one_triangle({0, 0}, {1, 0}, {0.5, std::sqrt(3) / 2}));
  CHECK(q.smallest_angles[11] == 1);
  CHECK(q.worst_radius_edge == Approx(1 / std::sqrt(3)));
}

TEST_CASE("coordinates of 1e150 and 1e-150 are measured like those of 1") {
  for (const double side : {1e150, 1e-150}) {
    const PlanarQuality q = planar_quality(square_fan(side));
    CHECK(q.smallest_angle == Approx(45));
    CHECK(q.total_area == Approx(side * side).epsilon(1e-12));
    CHECK(q.longest_edge == side);
  }
}

TEST_CASE("tiny angles are measured to many digits, far from the origin too") {
  CHECK(planar_quality(one_triangle({0, 0}, {1, 0}, {1, 1e-11})).smallest_angle == Approx(1e-11 * degrees_per_radian).epsilon(1e-10));
  CHECK(planar_quality(one_triangle({1e9, 1e9}, {1e9 + 1, 1e9}, {1e9 + 1, 1e9 + 1})).smallest_angle == Approx(45));
}

TEST_CASE("a flat triangle has angle zero and an infinite radius-edge ratio") {
  const PlanarQuality q = planar_quality(one_triangle({0, 0}, {1, 0}, {3, 0}));
  CHECK(q.smallest_angle == 0);
  CHECK(q.worst_radius_edge == std::numeric_limits<double>::infinity());
}

TEST_CASE("the table of a mesh without triangles says so") {
  CHECK(quality_table(planar_quality(PlanarMesh{})) ==
        "vertices         0\ntriangles        0\nThe mesh has no triangles: there is nothing to measure.\n");
}

TEST_CASE("the table has a line for each figure and a bar for each bin") {
  const std::string text = quality_table(planar_quality(square_fan(1)));
  CHECK(text.find("angles           45 to 90 degrees; the smallest of a triangle is 45 on average\n") != std::string::npos);
  CHECK(text.find("triangle areas   0.25 to 0.25, 1 in all\n") != std::string::npos);
  CHECK(text.find("45 - 50           4  100.0 %  ########################################\n") != std::string::npos);
}

TEST_CASE("a bin that is nearly empty has a dot") {
  const std::array<std::size_t, 3> bins{0, 1, 1000};
  CHECK(histogram_text(bins, 5) == "    5 - 10           1    0.1 %  .\n   10 - 15        1000   99.9 %  ########################################\n");
}
