// SPDX-License-Identifier: GPL-3.0-or-later
#include <delref/domain/level_set_components.hpp>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include <catch2/catch_test_macros.hpp>

#include "images.hpp"
#include "level_set_reference.hpp"

using namespace delref;
using namespace delref_test;

namespace {

std::vector<LevelSetComponent> components_of(const Image<float>& image, double iso = 0) {
  return level_set_components(image.grid, std::span<const float>(image.values), iso);
}

Topology topology_of(const Image<float>& image, double iso = 0) {
  Topology out;
  for (const LevelSetComponent& c : components_of(image, iso)) ++out.components, out.euler_characteristic += c.euler_characteristic;
  return out;
}

/// One cube of an image.
Image<float> cube(std::array<float, 8> values) { return {{{2, 2, 2}}, {values.begin(), values.end()}}; }

}  // namespace

TEST_CASE("the level set of a ball is a sphere, and that of a torus a torus") {
  CHECK(topology_of(image_of(unit_grid(20), ball({0.05, 0, 0}, 0.7))) == Topology{1, 2});
  CHECK(topology_of(image_of(unit_grid(30), torus(0.6, 0.2))) == Topology{1, 0});
}

TEST_CASE("every component of many is found, and told with its Euler characteristic") {
  const auto many = [](Point3 p) {
    return std::max({ball({-0.5, -0.5, -0.5}, 0.3)(p), ball({0.5, 0.5, 0.5}, 0.1)(p), torus(0.8, 0.1)(p + Vector3{0, 0, -0.1})});
  };
  const auto found = components_of(image_of(unit_grid(40), many));
  REQUIRE(found.size() == 3);
  CHECK(found[0].euler_characteristic == 2);
  CHECK(std::ranges::count_if(found, [](const auto& c) { return c.euler_characteristic == 0; }) == 1);
}

TEST_CASE("a shell has two surfaces") {
  CHECK(topology_of(image_of(unit_grid(30), [](Point3 p) {
          return std::min(ball({0, 0, 0}, 0.8)(p), -ball({0, 0, 0}, 0.5)(p));
        })) == Topology{2, 4});
}

TEST_CASE("one voxel is a component") {
  Image<float> image = image_of(unit_grid(5), [](Point3) { return -1; });
  image.at(2, 2, 2) = 1;
  const auto found = components_of(image);
  REQUIRE(found.size() == 1);
  CHECK(found[0].crossings == 6);
  CHECK(found[0].euler_characteristic == 2);
  CHECK(found[0].seeds.size() == 6);
}

TEST_CASE("seeds are on the level set, different and spread over it") {
  const ImageGrid grid = slanted_grid();
  const Point3 centre = grid.world({10, 16, 8});
  const auto found = components_of(image_of(grid, ball(centre, 0.6)));
  REQUIRE(found.size() == 1);
  const std::vector<Point3>& seeds = found[0].seeds;
  REQUIRE(seeds.size() == 32);
  for (const Point3 seed : seeds) CHECK(std::abs(std::sqrt(squared_distance(seed, centre)) - 0.6) < 0.01);
  CHECK(squared_distance(seeds[0], seeds[1]) > 1.1 * 1.1);
  for (std::size_t i = 0; i != seeds.size(); ++i) {
    for (std::size_t j = 0; j != i; ++j) CHECK(squared_distance(seeds[i], seeds[j]) > 0.01);
  }
}

TEST_CASE("a level set that leaves the image is closed at the border") {
  CHECK(topology_of(image_of(unit_grid(9), [](Point3) { return 1; })) == Topology{1, 2});
  CHECK(topology_of(image_of(unit_grid(12), [](Point3 p) { return 0.4 - std::abs(p.z); })) == Topology{1, 2});
  // A pillar from top to bottom, taken out of all: what is left is a ring.
  CHECK(topology_of(image_of(unit_grid(12), [](Point3 p) { return std::hypot(p.x, p.y) - 0.4; })) == Topology{1, 0});
}

TEST_CASE("two opposite corners of a cube are joined inside only when the function says so") {
  // The value at the middle saddle is positive in the second: a tunnel of the inside, between two corners that no face joins.
  CHECK(topology_of(cube({1, -0.9F, -0.9F, -0.9F, -0.9F, -0.9F, -0.9F, 1})) == Topology{2, 4});
  const Image<float> joined = cube({1, -0.12F, -0.12F, -0.12F, -0.12F, -0.12F, -0.12F, 1});
  CHECK(topology_of(joined) == Topology{1, 2});
  CHECK(topology_by_tetrahedra(joined, 0, 32) == Topology{1, 2});
}

TEST_CASE("two opposite corners of a face are joined when its saddle is inside") {
  CHECK(topology_of(cube({1, -0.5F, -0.5F, 1, -2, -2, -2, -2})) == Topology{1, 2});
  CHECK(topology_of(cube({0.5F, -1, -1, 0.5F, -2, -2, -2, -2})) == Topology{2, 4});
}

TEST_CASE("random images have as many components as a refined grid counts") {
  for (unsigned seed = 0; seed != 60; ++seed) {
    CAPTURE(seed);
    const std::array<int, 3> size = seed < 30 ? std::array{2, 2, 2} : std::array{3, 5, 4};
    const Image<float> image = random_image<float>(size, seed, std::uniform_real_distribution<float>(-1, 1));
    const Topology found = topology_of(image);
    // Refined until both agree: a grid that is too coarse joins what is close.
    bool agreed = false;
    for (int fineness = 8; !agreed && fineness <= 64; fineness *= 2) agreed = topology_by_tetrahedra(image, 0, fineness) == found;
    CHECK(agreed);
  }
}

TEST_CASE("values equal to the iso value are inside, wherever they are") {
  for (unsigned seed = 0; seed != 40; ++seed) {
    CAPTURE(seed);
    const Image<float> image = random_image<float>({4, 4, 4}, seed, std::uniform_int_distribution<int>(-1, 1));
    for (const LevelSetComponent& c : components_of(image)) {
      CHECK(c.euler_characteristic % 2 == 0);  // of a closed surface that has two sides
      CHECK(c.euler_characteristic <= 2);
      CHECK(!c.seeds.empty());
    }
  }
}

TEST_CASE("finding components stops when told to") {
  Budget budget;
  budget.time_limit = std::chrono::seconds(0);
  const Image<float> image = image_of(unit_grid(20), ball({0, 0, 0}, 0.7));
  CHECK_THROWS_AS(level_set_components(image.grid, std::span<const float>(image.values), 0, Control(budget)), Interrupted);
}
