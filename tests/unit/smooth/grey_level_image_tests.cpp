// SPDX-License-Identifier: GPL-3.0-or-later
#include <delref/domain/grey_level_image.hpp>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include "images.hpp"

using namespace delref;
using namespace delref_test;
using Catch::Matchers::ContainsSubstring;

namespace {

template <class O>
int label_at(const O& oracle, Point3 p) {
  int label = 7;
  oracle.label(std::span<const Point3>(&p, 1), std::span<int>(&label, 1));
  return label;
}

std::vector<Point3> random_points(const BoundingBox3& box, std::size_t count) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Point3> points(count);
  for (Point3& p : points) {
    const auto between = [&](double low, double high) { return low + unit(random) * (high - low); };
    p = {between(box.low.x, box.high.x), between(box.low.y, box.high.y), between(box.low.z, box.high.z)};
  }
  return points;
}

/// Between points of different labels, the label changes where `crossing` says.
void check_crossings(const GreyLevelImage& oracle, double tolerance) {
  const std::vector<Point3> points = random_points(oracle.bounds(), 600);
  std::size_t crossings = 0;
  for (std::size_t i = 1; i != points.size(); ++i) {
    const Point3 a = points[i - 1], b = points[i];
    const int label_a = label_at(oracle, a);
    if (label_a == label_at(oracle, b)) continue;
    ++crossings;
    const Point3 p = oracle.crossing(a, b, label_a, tolerance);
    const double length = std::sqrt(squared_distance(a, b));
    const Vector3 step = (1.01 * tolerance / length) * (b - a);
    CHECK(label_at(oracle, p + step) != label_at(oracle, p + -1.0 * step));
    CHECK(std::sqrt(squared_length(cross(p - a, b - a))) / length < 1e-12);
  }
  CHECK(crossings > 50);
}

}  // namespace

TEST_CASE("points of a grey-level image are inside where the value is at least the iso value") {
  const GreyLevelImage oracle(image_of(unit_grid(41), ball({0, 0, 0}, 0.7)), 0);
  CHECK(label_at(oracle, {0, 0, 0}) == 0);
  CHECK(label_at(oracle, {0.69, 0, 0}) == 0);
  CHECK(label_at(oracle, {0.71, 0, 0}) == outside);
  CHECK(label_at(oracle, {1.02, 1.02, 1.02}) == outside);
  check_crossings(oracle, 1e-6);
}

TEST_CASE("a slanted image with voxels that are no cubes is meshed where it is") {
  const ImageGrid grid = slanted_grid();
  const Point3 centre = grid.world({10, 16, 8});
  const GreyLevelImage oracle(image_of(grid, ball(centre, 0.7)), 0);
  for (const Point3 p : random_points(oracle.bounds(), 300)) {
    const double value = 0.7 - std::sqrt(squared_distance(p, centre));
    if (std::abs(value) > 0.01) CHECK(label_at(oracle, p) == (value > 0 ? 0 : outside));
  }
  check_crossings(oracle, 1e-7);
}

TEST_CASE("a grey-level image can be turned round and be closed at its border") {
  const Image<float> image = image_of(unit_grid(21), ball({0, 0, 0}, 0.7));
  CHECK_THAT(refusal([&] { GreyLevelImage(image, 0, {.inside_is_below = true}); }), ContainsSubstring("441 voxels at the border x = first"));
  const GreyLevelImage oracle(image, 0, {.inside_is_below = true, .close_at_border = true});
  CHECK(label_at(oracle, {0, 0, 0}) == outside);
  CHECK(label_at(oracle, {0.99, 0.99, -0.99}) == 0);
  CHECK(label_at(oracle, {1.01, 0, 0}) == outside);
  check_crossings(oracle, 1e-6);
  const Point3 at_border = oracle.crossing({0.9, 0.1, 0.2}, {1.05, 0.1, 0.2}, 0, 1e-3);
  CHECK(std::abs(at_border.x - 1) < 1e-14);
  const SurfaceComponents found = oracle.components(Control{});
  CHECK(found.components.size() == 2);
  CHECK(found.is_exact);
  CHECK(found.method == "from the grid of the image, exactly");
}

TEST_CASE("numbers that do not fit float keep all their digits") {
  Image<std::int32_t> image = image_of<std::int32_t>(unit_grid(4), [](Point3) { return 1 << 30; });
  image.at(1, 1, 1) += 1;
  const GreyLevelImage oracle(image, (1 << 30) + 0.5);
  CHECK(label_at(oracle, image.grid.world({1, 1, 1})) == 0);
  CHECK(label_at(oracle, image.grid.world({1, 1, 1.75})) == outside);
  CHECK(oracle.components(Control{}).components.size() == 1);
}

TEST_CASE("images without a surface are refused in words") {
  Image<float> image = image_of(unit_grid(5), ball({0, 0, 0}, 0.7));
  CHECK_THAT(refusal([&] { GreyLevelImage(image, 5); }), ContainsSubstring("no voxel is inside"));
  CHECK_THAT(refusal([&] { GreyLevelImage(image, -5, {.close_at_border = true}); }), ContainsSubstring("every voxel is inside"));
  CHECK_THAT(refusal([&] { GreyLevelImage(image, std::nan("")); }), ContainsSubstring("the iso value is nan"));
  CHECK_THAT(refusal([&] { GreyLevelImage(image_of(unit_grid(5), [](Point3) { return 3; }), 5); }),
             ContainsSubstring("all voxels have the value 3"));
  CHECK_THAT(refusal([&] {
               GreyLevelImage(Image<float>{{{4, 1, 4}}, std::vector<float>(16)}, 0);
             }),
             ContainsSubstring("one voxel thick along y"));
  image.at(1, 2, 3) = std::numeric_limits<float>::quiet_NaN();
  CHECK_THAT(refusal([&] { GreyLevelImage(image, 0); }),
             ContainsSubstring("1 voxel has a value that is not a finite number, the first at index (1, 2, 3)"));
}

TEST_CASE("the seeds of a grey-level image are where its label changes") {
  const GreyLevelImage oracle(image_of(unit_grid(25), torus(0.6, 0.25)), 0);
  for (const auto& component : oracle.components(Control{}).components) {
    for (const Point3 seed : component) {
      int different = 0;
      for (const Vector3 step : {Vector3{1e-9, 0, 0}, Vector3{0, 1e-9, 0}, Vector3{0, 0, 1e-9}}) {
        different += label_at(oracle, seed + step) != label_at(oracle, seed + -1.0 * step);
      }
      CHECK(different > 0);
    }
  }
}
