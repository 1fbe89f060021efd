// SPDX-License-Identifier: GPL-3.0-or-later
#include <delref/domain/image.hpp>
#include <delref/domain/spread_points.hpp>
#include <delref/domain/trilinear.hpp>

#include <limits>
#include <random>
#include <vector>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include "images.hpp"

using namespace delref;
using namespace delref_test;
using Catch::Matchers::ContainsSubstring;

TEST_CASE("a point of a slanted image comes back from its index") {
  const ImageGrid grid = slanted_grid();
  check_grid(grid);
  const WorldToIndex to_index(grid);
  for (const Point3 index : {Point3{0, 0, 0}, Point3{20, 32, 16}, Point3{3.25, 7.5, -1}}) {
    CHECK(squared_distance(to_index(grid.world(index)), index) < 1e-24);
  }
  CHECK(grid.world({0, 0, 0}) == Point3{3, -2, 1});
  CHECK(squared_distance(grid.world({1, 0, 0}), Point3{3.06, -1.92, 1}) < 1e-24);
}

TEST_CASE("a left-handed image is an image") {
  ImageGrid grid = unit_grid(4);
  grid.axes[0] = {-1, 0, 0};
  check_grid(grid);
  CHECK(squared_distance(WorldToIndex(grid)(grid.world({1, 2, 3})), Point3{1, 2, 3}) < 1e-24);
}

TEST_CASE("the box of an image holds all its voxels") {
  const ImageGrid grid = slanted_grid();
  const BoundingBox3 box = grid.world_box({0, 0, 0}, {20, 32, 16});
  for (const Point3 index : {Point3{0, 32, 0}, Point3{20, 0, 16}, Point3{10, 10, 10}}) {
    const Point3 p = grid.world(index);
    CHECK((box.low.x <= p.x && p.x <= box.high.x && box.low.y <= p.y && p.y <= box.high.y && box.low.z <= p.z && p.z <= box.high.z));
  }
}

TEST_CASE("a grid that is none is refused with all that is wrong") {
  ImageGrid grid = unit_grid(4);
  grid.size[1] = 0;
  grid.spacing[2] = std::numeric_limits<double>::quiet_NaN();
  grid.axes[1] = {0.1, 0.99498743710662, 0};
  grid.origin.x = std::numeric_limits<double>::infinity();
  const std::string words = refusal([&] { check_grid(grid); });
  CHECK_THAT(words, ContainsSubstring("0 voxels along y"));
  CHECK_THAT(words, ContainsSubstring("spacing of the voxels along z is nan"));
  CHECK_THAT(words, ContainsSubstring("x and y are not at right angles"));
  CHECK_THAT(words, ContainsSubstring("origin"));
  for (const double bad : {0.0, -1.0, std::numeric_limits<double>::infinity()}) {
    ImageGrid other = unit_grid(4);
    other.spacing[0] = bad;
    CHECK_THAT(refusal([&] { check_grid(other); }), ContainsSubstring("spacing of the voxels along x"));
  }
}

TEST_CASE("an image needs a value for each voxel") {
  Image<float> image{unit_grid(3), std::vector<float>(26)};
  CHECK_THAT(refusal([&] { check_image(image); }), ContainsSubstring("27 voxels but 26 values"));
}

TEST_CASE("interpolation meets the voxels' values exactly and is linear between them") {
  const Image<float> image = random_image<float>({4, 3, 5}, 1, std::uniform_real_distribution<float>(-1, 1));
  const detail::Trilinear value(image.grid, image.values.data());
  for (int z = 0; z != 5; ++z) {
    for (int y = 0; y != 3; ++y) {
      for (int x = 0; x != 4; ++x) CHECK(value({double(x), double(y), double(z)}) == static_cast<double>(image.at(x, y, z)));
    }
  }
  const double expected = 0.25 * static_cast<double>(image.at(1, 2, 3)) + 0.75 * static_cast<double>(image.at(2, 2, 3));
  CHECK(std::abs(value({1.75, 2, 3}) - expected) < 1e-15);
}

TEST_CASE("spread points are different and far from each other") {
  std::vector<Point3> line;
  for (int i = 0; i != 101; ++i) line.push_back({double(i), 0, 0});
  CHECK(spread_points(line, 3) == std::vector<Point3>{{100, 0, 0}, {0, 0, 0}, {50, 0, 0}});
  CHECK(spread_points(std::vector<Point3>(9, Point3{1, 2, 3}), 5).size() == 1);
  CHECK(spread_points(line, 1000).size() == 101);
  CHECK(spread_points({}, 5).empty());
}
