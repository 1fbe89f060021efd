// SPDX-License-Identifier: GPL-3.0-or-later
#include <delref/domain/implicit_domain.hpp>
#include <delref/domain/sampled_components.hpp>

#include <chrono>
#include <cmath>
#include <stop_token>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include "functions.hpp"

using namespace delref;
using namespace delref_test;
using Catch::Matchers::ContainsSubstring;

namespace {

/// Every seed is on the surface of the function, within a small part of the distance.
template <class F>
void check_seeds(const SurfaceComponents& found, const F& function, double tolerance) {
  for (const auto& seeds : found.components) {
    CHECK(!seeds.empty());
    CHECK(seeds.size() <= most_seeds);
    for (const Point3 p : seeds) CHECK(std::abs(function(p)) <= tolerance);
  }
}

template <class F>
std::size_t count(const F& function, const BoundingBox3& box, double distance) {
  return sample_components(ImplicitDomain(function, box), distance, Control{}).components.size();
}

}  // namespace

TEST_CASE("connected surfaces are one component each", "[sampled_components]") {
  CHECK(count(Sphere{{}, 1}, cube(1.5), 0.1) == 1);
  CHECK(count(torus, cube(1.5), 0.1) == 1);
  CHECK(count(tangle, cube(3), 0.1) == 1);
}

TEST_CASE("nested and thin shells are two components, also within one cell", "[sampled_components]") {
  CHECK(count(Shell{0.5, 1}, cube(1.5), 0.1) == 2);
  CHECK(count(Shell{0.94, 1}, cube(1.5), 0.05) == 2);
}

TEST_CASE("touching spheres are one or two components, and both have seeds", "[sampled_components]") {
  const Spheres pair{{{{-0.5, 0, 0}, 0.5}, {{0.5, 0, 0}, 0.5}}};
  const SurfaceComponents found = sample_components(ImplicitDomain(pair, cube(1.5)), 0.05, Control{});
  CHECK(found.components.size() <= 2);
  bool left = false, right = false;
  for (const auto& seeds : found.components)
    for (const Point3 p : seeds) left |= p.x<-0.3, right |= p.x> 0.3;
  CHECK(left);
  CHECK(right);
}

TEST_CASE("all of 300 spheres are found", "[sampled_components]") {
  const Spheres spheres = many_spheres();
  const SurfaceComponents found = sample_components(ImplicitDomain(spheres, cube(3)), 0.09, Control{});
  CHECK(found.components.size() == 300);
  CHECK(!found.is_exact);
  CHECK_THAT(found.method, ContainsSubstring("0.09"));
  check_seeds(found, spheres, 1e-6);
}

TEST_CASE("a surface that ends at the bounds is joined over the faces of the box", "[sampled_components]") {
  const ImplicitDomain halves([](Point3 p) { return std::abs(p.x) - 0.5; }, cube(1));
  CHECK(sample_components(halves, 0.1, Control{}).components.size() == 1);
  const ImplicitDomain walls([](Point3 p) { return 0.5 - std::abs(p.x); }, cube(1));
  CHECK(sample_components(walls, 0.1, Control{}).components.size() == 2);
  CHECK(sample_components(ImplicitDomain(gyroid, cube(6)), 0.2, Control{}).components.size() >= 1);
}

TEST_CASE("the first seeds are far apart", "[sampled_components]") {
  const SurfaceComponents found = sample_components(ImplicitDomain(Sphere{{}, 1}, cube(1.5)), 0.1, Control{});
  REQUIRE(found.components.size() == 1);
  REQUIRE(found.components[0].size() >= 4);
  const auto& seeds = found.components[0];
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < i; ++j) CHECK(squared_distance(seeds[i], seeds[j]) > 1.5);
}

TEST_CASE("boxes of any shape are sampled, whatever the distance", "[sampled_components]") {
  const BoundingBox3 flat{{-2, -1.5, -1.25}, {2, 1.25, 1.1}};
  CHECK(count(Sphere{{}, 1}, flat, 0.17) == 1);
  CHECK(count(Sphere{{}, 1}, flat, 100) == 0);
  CHECK_THROWS_AS(count(Sphere{{}, 1}, flat, 0), InvalidInput);
  CHECK_THROWS_AS(count(Sphere{{}, 1}, flat, 1e-9), InvalidInput);
}

TEST_CASE("sampling stops when it must", "[sampled_components]") {
  std::stop_source source;
  source.request_stop();
  CHECK_THROWS_AS(sample_components(ImplicitDomain(tangle, cube(3)), 0.01, Control({}, source.get_token())), Interrupted);
}

TEST_CASE("the same samples give the same seeds", "[sampled_components]") {
  const ImplicitDomain domain(many_spheres(), cube(3));
  CHECK(sample_components(domain, 0.1, Control{}).components == sample_components(domain, 0.1, Control{}).components);
}
