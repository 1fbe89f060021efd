// SPDX-License-Identifier: GPL-3.0-or-later
//
// The levels of smooth domains keep the laws: on surfaces that are round, thin, creased, closed at their bounds and between several
// regions, alone and with tetrahedra behind them.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <catch2/catch_test_macros.hpp>

#include <delref/algorithms/smooth_levels.hpp>
#include <delref/testing/laws.hpp>
#include <delref/triangulation/delaunay_3.hpp>

#include "scenes.hpp"

using namespace delref;

namespace {

using Tr = Delaunay3<1, 1>;

void expect_none(const std::vector<std::string>& broken) {
  for (const std::string& sentence : broken) UNSCOPED_INFO(sentence);
  CHECK(broken.empty());
}
/// Where the way from the middle of the bounds leaves the region that is there, in six directions.
std::vector<Point3> seeds(const Regions3& domain, Point3 from) {
  std::vector<Point3> points;
  for (const Vector3 d : {Vector3{1, 0.1, 0}, {-1, 0, 0.2}, {0, 1, 0.1}, {0.1, -1, 0}, {0, 0.2, 1}, {0.1, 0, -1}})
    for (double t = 0.01; t < 1.9; t += 0.01)
      if (domain.region(from + t * d) != domain.region(from + (t - 0.01) * d)) {
        points.push_back(domain.crossing(from + (t - 0.01) * d, from + t * d, domain.region(from + (t - 0.01) * d), 1e-9));
        break;
      }
  return points;
}
void check_surface(const Regions3& domain, const SmoothOptions& options, Point3 from = {}) {
  expect_none(testing::check_laws([&](auto run) {
    Tr tr;
    start(tr, domain.bounds());
    for (const Point3 p : seeds(domain, from)) insert_seed(tr, p);
    run(tr, surface_levels<Tr>(domain, options));
  }));
}
void check_volume(const Regions3& domain, const SmoothOptions& options, Point3 from = {}) {
  expect_none(testing::check_laws([&](auto run) {
    Tr tr;
    start(tr, domain.bounds());
    for (const Point3 p : seeds(domain, from)) insert_seed(tr, p);
    run(tr, volume_levels<Tr>(domain, options));
  }));
}
SmoothOptions sizes(double facet_size, double smallest = 0.01) {
  SmoothOptions options;
  options.facet_size = facet_size;
  options.smallest_facet = smallest;
  return options;
}

Regions3 ball() {
  return {[](Point3 p) { return radius(p) < 1 ? 0 : outside; }};
}
Regions3 shell(double thickness) {
  return {[thickness](Point3 p) { return radius(p) < 1 && radius(p) > 1 - thickness ? 0 : outside; }};
}
Regions3 box() {
  return {[](Point3 p) { return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) < 0.8 ? 0 : outside; }};
}
Regions3 halves() {
  return {[](Point3 p) { return radius(p) > 1 ? outside : p.z > 0.1 ? 1 : 0; }};
}
Regions3 beyond_bounds() {
  return {[](Point3 p) { return radius(p) < 2.3 ? 0 : outside; }};
}

}  // namespace

TEST_CASE("the surface level keeps the laws on a ball") {
  check_surface(ball(), sizes(0.3));
  SmoothOptions near = sizes(SmoothOptions::unbounded);
  near.facet_distance = 0.02;
  check_surface(ball(), near);
  SmoothOptions fields = sizes(0.5);
  fields.facet_size_field = [](Point3 p) { return 0.15 + 0.2 * std::abs(p.z); };
  fields.facet_distance_field = [](Point3 p) { return 0.02 + 0.05 * std::abs(p.x); };
  check_surface(ball(), fields);
}

TEST_CASE("the surface level keeps the laws where facets do not have to be disks") {
  SmoothOptions options = sizes(0.4);
  options.manifold = false;
  check_surface(shell(0.3), options, {0.85, 0, 0});
}

TEST_CASE("the surface level keeps the laws on a shell, at creases and where the bounds end the domain") {
  check_surface(shell(0.3), sizes(0.25), {0.85, 0, 0});
  check_surface(box(), sizes(0.4, 0.05));
  check_surface(beyond_bounds(), sizes(0.7, 0.1), {1.9, 1.9, 1.9});
}

TEST_CASE("the surface level keeps the laws between several regions") {
  check_surface(halves(), sizes(0.3, 0.05));
}

TEST_CASE("the surface level and the tetrahedra level together keep the laws on a ball") {
  SmoothOptions options = sizes(0.4);
  check_volume(ball(), options);
  options.cell_size = 0.25;
  check_volume(ball(), options);
  options.cell_size = SmoothOptions::unbounded;
  options.cell_size_field = [](Point3 p) { return 0.2 + 0.2 * std::abs(p.z); };
  options.radius_edge = 1.5;
  check_volume(ball(), options);
}

TEST_CASE("the two levels together keep the laws on a shell, at creases and where the bounds end the domain") {
  check_volume(shell(0.35), sizes(0.3), {0.85, 0, 0});
  check_volume(box(), sizes(0.5, 0.05));
  check_volume(beyond_bounds(), sizes(0.8, 0.1), {1.9, 1.9, 1.9});
}

TEST_CASE("the two levels together keep the laws between several regions") {
  SmoothOptions options = sizes(0.4, 0.05);
  options.region_cell_sizes = {0.2, 0};
  check_volume(halves(), options);
}
