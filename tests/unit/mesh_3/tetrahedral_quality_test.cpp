// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <numeric>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

#include <delref/mesh/tetrahedral_quality.hpp>
#include <delref/mesh/tetrahedral_quality_table.hpp>

using Catch::Approx;
using namespace delref;

namespace {

TetrahedralMesh one_tetrahedron(Point3 a, Point3 b, Point3 c, Point3 d) {
  TetrahedralMesh mesh;
  mesh.points = {a, b, c, d};
  mesh.tetrahedra = {{0, 1, 2, 3}};
  return mesh;
}

TetrahedralMesh regular(double side) { return one_tetrahedron({0, 0, 0}, {0, side, side}, {side, 0, side}, {side, side, 0}); }

/// A cube of the given side as five tetrahedra, the regular one in the middle with label 2.
TetrahedralMesh cube(double side) {
  TetrahedralMesh mesh;
  for (const double z : {0.0, side})
    for (const double y : {0.0, side})
      for (const double x : {0.0, side}) mesh.points.push_back({x, y, z});
  mesh.tetrahedra = {{0, 1, 2, 4}, {3, 2, 1, 7}, {5, 1, 4, 7}, {6, 4, 2, 7}, {1, 2, 4, 7}};
  for (auto& t : mesh.tetrahedra) {
    const Point3 p = mesh.points[t[0]];
    if (dot(mesh.points[t[1]] - p, cross(mesh.points[t[2]] - p, mesh.points[t[3]] - p)) < 0) std::swap(t[0], t[1]);
  }
  mesh.regions = {1, 1, 1, 1, 2};
  mesh.triangles = {{0, 1, 2}, {1, 3, 2}};
  return mesh;
}

template <class Bins>
std::size_t sum(const Bins& bins) {
  return std::accumulate(bins.begin(), bins.end(), std::size_t{0});
}

}  // namespace

TEST_CASE("the figures of a regular tetrahedron are known") {
  const TetrahedralQuality q = tetrahedral_quality(regular(1));
  CHECK(q.worst_radius_edge == Approx(std::sqrt(0.375)));
  CHECK(q.smallest_dihedral == Approx(std::acos(1.0 / 3) * degrees_per_radian));
  CHECK(q.largest_dihedral == Approx(q.smallest_dihedral));
  CHECK(q.shortest_edge == Approx(std::sqrt(2)));
  CHECK(q.total_volume == Approx(1.0 / 3));
  CHECK(q.all_dihedrals[14] == 6);
  CHECK(q.smallest_dihedrals[14] == 1);
  CHECK(q.radius_edge[0] == 1);
  CHECK(q.under_10_degrees == 0);
}

TEST_CASE("the figures of a cube of five tetrahedra are those of its corners and its core") {
  const TetrahedralQuality q = tetrahedral_quality(cube(2));
  CHECK(q.tetrahedron_count == 5);
  CHECK(q.total_volume == Approx(8));
  CHECK(q.regions.at(1).tetrahedron_count == 4);
  CHECK(q.regions.at(1).volume == Approx(16.0 / 3));
  CHECK(q.regions.at(2).volume == Approx(8.0 / 3));
  CHECK(q.smallest_volume == Approx(4.0 / 3));
  CHECK(q.shortest_edge == 2);
  CHECK(q.longest_edge == Approx(2 * std::sqrt(2)));
  CHECK(q.largest_dihedral == Approx(90));
  CHECK(q.smallest_dihedral == Approx(std::acos(1 / std::sqrt(3)) * degrees_per_radian));
  CHECK(q.worst_radius_edge == Approx(std::sqrt(3) / 2));
  CHECK(q.smallest_triangle_angle == Approx(45));
  CHECK(sum(q.radius_edge) == 5);
  CHECK(sum(q.all_dihedrals) == 30);
  CHECK(sum(q.smallest_dihedrals) == 5);
  CHECK(sum(q.edge_lengths) == 30);
  CHECK(q.first_length == Approx(2));
  CHECK(q.edge_lengths == std::vector<std::size_t>{12, 18});
}

TEST_CASE("every dihedral angle is counted in its bin") {
  for (int degrees = 1; degrees < 180; ++degrees) {
    if (degrees % 5 == 0) continue;
    const double angle = degrees / degrees_per_radian;
    const TetrahedralQuality q =
        tetrahedral_quality(one_tetrahedron({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, -std::sin(angle), std::cos(angle)}));
    const TetrahedralQuality r =
        tetrahedral_quality(one_tetrahedron({0, 0, 0}, {1, 0, 0}, {0, std::sin(angle), std::cos(angle)}, {0, 0, 1}));
    CHECK(q.all_dihedrals[static_cast<std::size_t>(degrees / 5)] > 0);
    CHECK(q.all_dihedrals == r.all_dihedrals);
  }
}

TEST_CASE("slivers are counted by their smallest dihedral angle") {
  const auto sliver = [](double h) { return one_tetrahedron({-1, 0, 0}, {1, 0, 0}, {0, -1, h}, {0, 1, h}); };
  CHECK(tetrahedral_quality(sliver(0.04)).under_5_degrees == 1);
  CHECK(tetrahedral_quality(sliver(0.1)).under_5_degrees == 0);
  CHECK(tetrahedral_quality(sliver(0.1)).under_10_degrees == 1);
  CHECK(tetrahedral_quality(sliver(0.3)).under_10_degrees == 0);
  const TetrahedralQuality q = tetrahedral_quality(sliver(1e-12));
  CHECK(q.smallest_dihedral == Approx(std::sqrt(2) * 1e-12 * degrees_per_radian));
  CHECK(q.worst_radius_edge == Approx(1 / std::sqrt(2)));
}

TEST_CASE("a flat tetrahedron, one with two equal corners, and an inverted one are counted as such") {
  const TetrahedralQuality flat = tetrahedral_quality(one_tetrahedron({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}));
  CHECK(flat.flat_or_inverted == 1);
  CHECK(flat.worst_radius_edge == std::numeric_limits<double>::infinity());
  CHECK(flat.smallest_dihedral == 0);
  CHECK(flat.largest_dihedral == Approx(180));
  CHECK(sum(flat.all_dihedrals) == 6);
  const TetrahedralQuality point = tetrahedral_quality(one_tetrahedron({0, 0, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}));
  CHECK(point.worst_radius_edge == std::numeric_limits<double>::infinity());
  CHECK(point.shortest_edge == 0);
  const TetrahedralQuality inverted = tetrahedral_quality(one_tetrahedron({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}));
  CHECK(inverted.flat_or_inverted == 1);
  CHECK(inverted.total_volume == Approx(-1.0 / 6));
}

TEST_CASE("coordinates of 1e100 and 1e-100 are measured like those of 1 in space") {
  for (const double side : {1e100, 1e-100}) {
    const TetrahedralQuality q = tetrahedral_quality(cube(side));
    CHECK(q.worst_radius_edge == Approx(std::sqrt(3) / 2));
    CHECK(q.total_volume == Approx(side * side * side).epsilon(1e-12));
    CHECK(q.shortest_edge == side);
    CHECK(q.edge_lengths.size() <= 3);
  }
}

TEST_CASE("a mesh without tetrahedra has figures of 0, and its table says so") {
  const TetrahedralQuality q = tetrahedral_quality({});
  CHECK(q.worst_radius_edge == 0);
  CHECK(quality_table(q).find("nothing to measure") != std::string::npos);
}

TEST_CASE("the table of a cube names its figures and its regions") {
  const std::string table = quality_table(tetrahedral_quality(cube(1)));
  for (const char* words : {"tetrahedra       5", "0.866 at worst", "54.74 to 90 degrees", "Regions, 2 of them", "label 2",
                            "45 degrees is their smallest angle"})
    CHECK(table.find(words) != std::string::npos);
}

TEST_CASE("measuring stops when it is told to") {
  std::stop_source source;
  source.request_stop();
  CHECK_THROWS_AS(tetrahedral_quality(cube(1), Control({}, source.get_token())), Interrupted);
}
