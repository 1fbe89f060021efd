// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points around thin places: on both sheets, as far apart as the sheets are.
#include <algorithm>
#include <cmath>
#include <vector>

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

#include <delref/domain/anchor_points.hpp>

#include "../../property/generators.hpp"  // for its random numbers alone
#include "scenes.hpp"

using namespace delref;
using Catch::Approx;

namespace {

double distance(Point3 a, Point3 b) { return std::sqrt(squared_distance(a, b)); }

/// Between two parallel planes, turned any way.
struct Slab {
  Vector3 normal{};
  double thickness = 0;
  double height(Point3 p) const { return dot(p - Point3{}, normal); }
  Regions3 domain() const {
    return {[*this](Point3 p) { return std::abs(height(p)) < 0.5 * thickness ? 0 : outside; }};
  }
};
Slab random_slab(property::Random& random, double thickness) {
  Vector3 n{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.2, 1)};
  return {(1 / std::sqrt(squared_length(n))) * n, thickness};
}

}  // namespace

TEST_CASE("around a point of a thin slab the anchors are on both of its sides and as far apart as it is thick") {
  property::Random random(1);
  for (const double thickness : {0.3, 0.05, 0.01})
    for (int k = 0; k < 20; ++k) {
      const Slab slab = random_slab(random, thickness);
      const Regions3 domain = slab.domain();
      const AnchorFinder finder(domain, 1e-4, 1e-3, 0.5);
      const Point3 p = Point3{} + (k % 2 == 0 ? 0.5 : -0.5) * thickness * slab.normal;
      const AnchorPoints found = finder.around(p);
      CAPTURE(thickness, k, found.points.size());
      REQUIRE(found.points.size() >= 10);
      CHECK(found.points.size() <= 26);
      CHECK(found.distance > 0.1 * thickness);
      CHECK(found.distance < 0.6 * thickness);
      bool above = false, below = false;
      for (const Point3 q : found.points) {
        CHECK(std::abs(slab.height(q)) == Approx(0.5 * thickness).epsilon(1e-5));
        CHECK(distance(p, q) < 3 * thickness);
        (slab.height(q) > 0 ? above : below) = true;
      }
      CHECK(above);
      CHECK(below);
    }
}

TEST_CASE("a slit between two bodies is found as a slab is") {
  const Regions3 domain{[](Point3 p) { return std::abs(p.z) > 0.02 && radius(p) < 1.5 ? 0 : outside; }};
  const AnchorPoints found = AnchorFinder(domain, 1e-4, 1e-3, 0.4).around({0.2, 0.1, 0.02});
  REQUIRE(found.points.size() >= 10);
  for (const Point3 q : found.points) CHECK(std::abs(q.z) == Approx(0.02).epsilon(1e-4));
}

TEST_CASE("around a point of a sphere that is small against the reach the anchors are on the sphere") {
  for (const double r : {0.05, 0.2}) {
    const Regions3 domain{[r](Point3 p) { return radius(p) < r ? 0 : outside; }};
    const AnchorPoints found = AnchorFinder(domain, 1e-3 * r, 0.01 * r, 3 * r).around({0, r, 0});
    REQUIRE(found.points.size() >= 20);
    for (const Point3 q : found.points) CHECK(radius(q) == Approx(r).epsilon(1e-4));
    CHECK(found.distance > 0.2 * r);
    CHECK(found.distance < r);
  }
}

TEST_CASE("where no two regions meet within reach there are no anchors") {
  const Regions3 domain{[](Point3 p) { return radius(p) < 0.5 ? 0 : outside; }};
  CHECK(AnchorFinder(domain, 1e-3, 1e-3, 0.1).around({1, 1, 1}).points.empty());
  CHECK(AnchorFinder(domain, 1e-3, 1e-3, 0.1).around({0, 0, 0}).points.empty());
}

TEST_CASE("a region thinner than the thinnest that counts has no anchors") {
  const Slab slab{{0, 0, 1}, 0.01};
  const Regions3 domain = slab.domain();
  CHECK(AnchorFinder(domain, 1e-4, 0.02, 0.5).around({0, 0, 0.005}).points.empty());
  CHECK_FALSE(AnchorFinder(domain, 1e-4, 0.005, 0.5).around({0, 0, 0.005}).points.empty());
}

TEST_CASE("what is out of bounds is never asked about") {
  // Scenes throw when they are.
  const Regions3 domain{[](Point3 p) { return p.z > 1.95 ? 0 : outside; }};
  const AnchorPoints found = AnchorFinder(domain, 1e-4, 1e-3, 1).around({1.99, -1.99, 1.95});
  for (const Point3 q : found.points) CHECK(q.z >= 1.95 - 1e-4);
}

TEST_CASE("the anchors of a layer between two other regions are on both of its sides") {
  const Regions3 domain{[](Point3 p) { return p.z > 0.03 ? 2 : p.z > 0 ? 1 : 0; }};
  const AnchorPoints found = AnchorFinder(domain, 1e-4, 1e-3, 0.5).around({0.3, 0.3, 0});
  REQUIRE(found.points.size() >= 10);
  CHECK(std::ranges::any_of(found.points, [](Point3 q) { return std::abs(q.z) < 1e-5; }));
  CHECK(std::ranges::any_of(found.points, [](Point3 q) { return std::abs(q.z - 0.03) < 1e-5; }));
}
