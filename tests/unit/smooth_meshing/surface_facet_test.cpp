// SPDX-License-Identifier: GPL-3.0-or-later
//
// The measures of facets of smooth surfaces, and the criteria on them, on triangles whose measures are known.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

#include <delref/criteria/surface_facet_criteria.hpp>
#include <delref/criteria/surface_facet_shape.hpp>
#include <delref/domain/invalid_input.hpp>
#include <delref/domain/oracle.hpp>

#include "../../property/generators.hpp"  // for its random numbers alone

using namespace delref;
using Catch::Approx;

namespace {

constexpr std::array<int, 2> sides{0, outside};
using Corners = std::array<Point3, 3>;

/// A triangle with angles of 30, 60 and 90 degrees; its circle has the radius 1 and the centre (1, 0, 0).
const Corners half_equilateral{{{0, 0, 0}, {2, 0, 0}, {0.5, std::sqrt(0.75), 0}}};

double smallest_angle(const Corners& c) {
  double least = 4;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3 u = c[(i + 1) % 3] - c[i], v = c[(i + 2) % 3] - c[i];
    least = std::min(least, std::atan2(std::sqrt(squared_length(cross(u, v))), dot(u, v)));
  }
  return least;
}

}  // namespace

TEST_CASE("a triangle of 30, 60 and 90 degrees has its measures") {
  const SurfaceFacetShape f(half_equilateral, {1, 0, 0.75}, sides);
  CHECK(f.squared_radius == Approx(1 + 0.5625));
  CHECK(std::sqrt(f.squared_distance_to_surface()) == Approx(0.75));
  CHECK(f.shortest_squared() == Approx(1));
  CHECK(f.shortest == 1);
  CHECK(std::sqrt(f.doubled_area_squared) == Approx(std::sqrt(3.0)));
  CHECK(std::sqrt(f.squared_sine()) == Approx(0.5));
  CHECK(f.regions == sides);
}

TEST_CASE("the measures do not depend on the order of the corners") {
  Corners c = half_equilateral;
  std::ranges::sort(c, {}, [](Point3 p) { return p.x; });
  do {
    const SurfaceFacetShape f(c, {1, 0, -0.5}, sides);
    CHECK(std::sqrt(f.squared_sine()) == Approx(0.5));
    CHECK(f.shortest_squared() == Approx(1));
    CHECK(std::sqrt(f.squared_distance_to_surface()) == Approx(0.5));
  } while (std::next_permutation(c.begin(), c.end(), [](Point3 a, Point3 b) { return a.x < b.x; }));
}

TEST_CASE("a facet whose surface ball has its centre in its plane is at no distance") {
  const SurfaceFacetShape f(half_equilateral, {1, 0, 0}, sides);
  CHECK(f.squared_distance_to_surface() < 1e-15);
}

TEST_CASE("the sine of the smallest angle is right for triangles at random") {
  property::Random random(5);
  for (int k = 0; k < 2000; ++k) {
    Corners c;
    for (Point3& p : c) p = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    const SurfaceFacetShape f(c, {}, sides);
    REQUIRE(std::sqrt(f.squared_sine()) == Approx(std::sin(smallest_angle(c))).epsilon(1e-9));
  }
}

TEST_CASE("a flat facet has no angle and is as far from the surface as its ball is large") {
  const SurfaceFacetShape line({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}}, {1, 1, 0}, sides);
  CHECK(line.squared_sine() == 0);
  CHECK(line.squared_distance_to_surface() == line.squared_radius);
  const SurfaceFacetShape point({{{1, 1, 1}, {1, 1, 1}, {2, 1, 1}}}, {1, 1, 1}, sides);
  CHECK(point.squared_sine() == 0);
}

TEST_CASE("each criterion bounds its measure, the bound itself included") {
  const SurfaceFacetShape f(half_equilateral, {1, 0, 0.75}, sides);
  CHECK(MinimumFacetAngle{AngleBound::degrees(29.999)}.is_met(f));
  CHECK_FALSE(MinimumFacetAngle{AngleBound::degrees(30.001)}.is_met(f));
  CHECK(MaximumFacetSize{1.25}.is_met(f));
  CHECK_FALSE(MaximumFacetSize{1.249}.is_met(f));
  CHECK(MaximumFacetDistance{0.7501}.is_met(f));
  CHECK_FALSE(MaximumFacetDistance{0.7499}.is_met(f));
  CHECK(MinimumFacetAngle{AngleBound::degrees(0)}.is_met(f));
}

TEST_CASE("fields are asked at the centre of the surface ball, and must be positive there") {
  const SurfaceFacetShape f(half_equilateral, {1, 0, 0.75}, sides);
  const auto height = [](Point3 p) { return 2 * p.z; };
  CHECK(FacetSizeAtCentre{height}.is_met(f));
  CHECK(FacetDistanceAtCentre{height}.is_met(f));
  const auto small = [](Point3 p) { return 0.5 * p.z; };
  CHECK_FALSE(FacetSizeAtCentre{small}.is_met(f));
  CHECK_FALSE(FacetDistanceAtCentre{small}.is_met(f));
  for (const double bad : {0.0, -1.0, std::nan("")}) {
    const auto field = [bad](Point3) { return bad; };
    CHECK_THROWS_AS(FacetSizeAtCentre{field}.is_met(f), InvalidInput);
    CHECK_THROWS_AS(FacetDistanceAtCentre{field}.is_met(f), InvalidInput);
  }
}

TEST_CASE("of several criteria the first that is not met is named") {
  const SurfaceFacetShape f(half_equilateral, {1, 0, 0.75}, sides);
  const SurfaceFacetCriteria loose(MaximumFacetSize{2}, MinimumFacetAngle{AngleBound::degrees(20)});
  CHECK(loose.is_met(f));
  CHECK(loose.unmet(f).empty());
  const SurfaceFacetCriteria strict(MaximumFacetSize{2}, MaximumFacetDistance{0.1}, MinimumFacetAngle{AngleBound::degrees(40)});
  CHECK_FALSE(strict.is_met(f));
  CHECK(std::string(strict.unmet(f)) == "facet distance");
}
