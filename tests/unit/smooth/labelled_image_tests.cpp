// SPDX-License-Identifier: GPL-3.0-or-later
#include <delref/domain/labelled_image.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <vector>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include "images.hpp"

using namespace delref;
using namespace delref_test;
using Catch::Matchers::ContainsSubstring;

namespace {

using Labels = Image<std::int32_t>;

Labels empty_image(int n) { return {{{n, n, n}}, std::vector<std::int32_t>(static_cast<std::size_t>(n * n * n))}; }

int label_at(const LabelledImage& oracle, Point3 p) {
  int label = 77;
  oracle.label(std::span<const Point3>(&p, 1), std::span<int>(&label, 1));
  return label;
}

std::size_t components_of(const LabelledImage& oracle) { return oracle.components(Control{}).components.size(); }

/// The boundary surfaces of all parts of regions by floods: around each part, its complement's parts that touch it.
std::size_t surfaces_by_floods(const Labels& image);

/// Two balls of labels 5 and 9 that share a wall.
Labels two_halves(const ImageGrid& grid) {
  return image_of<std::int32_t>(grid, [](Point3 p) { return squared_distance(p, {0, 0, 0}) > 0.49 ? 0 : p.x < 0.01 ? 5 : 9; });
}

void check_crossings(const LabelledImage& oracle, double tolerance) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1.1, 1.1);
  Point3 a{0, 0, 0};
  int crossings = 0;
  for (int i = 0; i != 500; ++i) {
    const Point3 b{unit(random), unit(random), unit(random)};
    const int label_a = label_at(oracle, a);
    if (label_a != label_at(oracle, b)) {
      const Point3 p = oracle.crossing(a, b, label_a, tolerance);
      const Vector3 step = (1.01 * tolerance / std::sqrt(squared_distance(a, b))) * (b - a);
      CHECK(label_at(oracle, p + -1.0 * step) == label_a);
      CHECK(label_at(oracle, p + step) != label_a);
      ++crossings;
    }
    a = b;
  }
  CHECK(crossings > 50);
}

}  // namespace

TEST_CASE("every label of an image is a region but that of what is outside") {
  const LabelledImage oracle(two_halves(unit_grid(15)));
  CHECK(oracle.region_labels() == std::vector{5, 9});
  CHECK(label_at(oracle, {-0.3, 0, 0}) == 0);
  CHECK(label_at(oracle, {0.3, 0, 0}) == 1);
  CHECK(label_at(oracle, {0.9, 0.9, 0}) == outside);
  check_crossings(oracle, 1e-6);
}

TEST_CASE("without a label for the outside every label is a region, and the image's border is their boundary") {
  const LabelledImage oracle(two_halves(unit_grid(15)), {.outside_label = std::nullopt});
  CHECK(oracle.region_labels() == std::vector{0, 5, 9});
  CHECK(label_at(oracle, {1.06, 0, 0}) == 0);
  CHECK(label_at(oracle, {1.08, 0, 0}) == outside);
  CHECK(components_of(oracle) == 4);  // the border, the ball and its halves
  check_crossings(oracle, 1e-6);
}

TEST_CASE("smoothed boundaries are close to those that were sampled") {
  const LabelledImage oracle(two_halves(unit_grid(41)), {.smoothing = 1});
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  double sum = 0, worst = 0;
  for (int i = 0; i != 200; ++i) {
    const Vector3 v{normal(random), normal(random), normal(random)};
    const Point3 far = Point3{0, 0, 0} + (1 / std::sqrt(squared_length(v))) * v,
                 near = Point3{0, 0, 0} + (0.4 / std::sqrt(squared_length(v))) * v;
    const Point3 p = oracle.crossing(far, near, outside, 1e-6);
    const double error = std::abs(std::sqrt(squared_distance(p, {0, 0, 0})) - 0.7);
    worst = std::max(worst, error), sum += error;
  }
  // Voxels are 0.05 wide, and the staircase is off by up to 0.87 of one.
  CHECK(worst < 0.7 * 0.05);
  CHECK(sum / 200 < 0.2 * 0.05);
  check_crossings(oracle, 1e-6);
}

TEST_CASE("a label of one voxel is found, and its loss by smoothing is told") {
  Labels image = empty_image(9);
  image.at(4, 4, 4) = 3;
  const LabelledImage oracle(image);
  const SurfaceComponents found = oracle.components(Control{});
  REQUIRE(found.components.size() == 1);
  CHECK(found.is_exact);
  CHECK(found.components[0].size() == 6);
  for (const Point3 seed : found.components[0]) CHECK(std::sqrt(squared_distance(seed, {4, 4, 4})) == 0.5);
  CHECK(oracle.lost_labels().empty());
  CHECK(LabelledImage(image, {.smoothing = 0.4}).lost_labels().empty());
  const LabelledImage smoothed(image, {.smoothing = 1});
  CHECK(smoothed.lost_labels() == std::vector{3});
  CHECK_FALSE(smoothed.components(Control{}).is_exact);
}

TEST_CASE("boundaries that two regions have in common come once") {
  Labels image = empty_image(9);
  for (int z = 2; z != 7; ++z) {
    for (int y = 2; y != 7; ++y) {
      for (int x = 2; x != 7; ++x) image.at(x, y, z) = 1;
    }
  }
  image.at(4, 4, 4) = 2;
  CHECK(components_of(LabelledImage(image)) == 2);
  image.at(4, 4, 4) = 0;  // a cavity
  CHECK(components_of(LabelledImage(image)) == 2);
  image.at(6, 6, 6) = 2;  // at the corner: its boundary and that of the rest are different surfaces
  CHECK(components_of(LabelledImage(image)) == 3);
}

TEST_CASE("voxels that touch in edges or corners are apart") {
  Labels image = empty_image(6);
  image.at(1, 1, 1) = 1;
  image.at(2, 2, 1) = 1;
  image.at(3, 3, 2) = 1;
  CHECK(components_of(LabelledImage(image)) == 3);
  image.at(2, 1, 1) = 1;
  CHECK(components_of(LabelledImage(image)) == 2);
}

TEST_CASE("smoothed seeds are where the label changes") {
  const LabelledImage oracle(two_halves(unit_grid(21)), {.smoothing = 0.7});
  const SurfaceComponents found = oracle.components(Control{});
  CHECK(found.components.size() == 2);
  for (const auto& component : found.components) {
    for (const Point3 seed : component) {
      int different = 0;
      for (const Vector3 step : {Vector3{1e-6, 0, 0}, Vector3{0, 1e-6, 0}, Vector3{0, 0, 1e-6}}) {
        different += label_at(oracle, seed + step) != label_at(oracle, seed + -1.0 * step);
      }
      CHECK(different > 0);
    }
  }
}

TEST_CASE("the boundary surfaces of random labels are those that floods count") {
  for (unsigned seed = 0; seed != 40; ++seed) {
    CAPTURE(seed);
    const Labels image = random_image<std::int32_t>({5, 4, 3}, seed, std::uniform_int_distribution<int>(0, 1));
    if (std::ranges::find(image.values, 1) == image.values.end()) continue;
    CHECK(components_of(LabelledImage(image)) == surfaces_by_floods(image));
  }
}

TEST_CASE("labels that are none are refused in words") {
  CHECK_THAT(refusal([] { LabelledImage(empty_image(3)); }), ContainsSubstring("no region"));
  Image<float> grey{{{2, 2, 2}}, std::vector<float>(8, 1.5F)};
  CHECK_THAT(refusal([&] { LabelledImage{grey}; }), ContainsSubstring("has the value 1.5, which is no label"));
  Labels image = empty_image(3);
  image.at(1, 1, 1) = -4;
  CHECK(LabelledImage(image).region_labels() == std::vector{-4});
  CHECK_THAT(refusal([&] { LabelledImage(image, {.smoothing = 9}); }), ContainsSubstring("smoothing of labels is 9 voxels"));
  Labels many = empty_image(41);
  for (std::size_t i = 0; i != many.values.size(); ++i) many.values[i] = static_cast<std::int32_t>(i);
  CHECK_THAT(refusal([&] { LabelledImage{many}; }), ContainsSubstring("more than 65535 labels"));
}

namespace {

std::size_t surfaces_by_floods(const Labels& image) {
  // Each part of label 1 (joined by faces) and each part of all else (joined by faces, edges and corners) around it: one surface.
  const std::array<int, 3> n{image.grid.size[0] + 2, image.grid.size[1] + 2, image.grid.size[2] + 2};
  const auto place = [&](int x, int y, int z) { return static_cast<std::size_t>((z * n[1] + y) * n[0] + x); };
  std::vector<int> inside(static_cast<std::size_t>(n[0] * n[1] * n[2]));
  for (int z = 0; z != image.grid.size[2]; ++z) {
    for (int y = 0; y != image.grid.size[1]; ++y) {
      for (int x = 0; x != image.grid.size[0]; ++x) inside[place(x + 1, y + 1, z + 1)] = image.at(x, y, z);
    }
  }
  const auto each_neighbour = [&](std::size_t from, bool faces_only, auto&& visit) {
    const int i = static_cast<int>(from), x = i % n[0], y = i / n[0] % n[1], z = i / (n[0] * n[1]);
    for (int dz = -1; dz <= 1; ++dz) {
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          const bool within = x + dx >= 0 && y + dy >= 0 && z + dz >= 0 && x + dx < n[0] && y + dy < n[1] && z + dz < n[2];
          if (within && (!faces_only || std::abs(dx) + std::abs(dy) + std::abs(dz) == 1)) visit(place(x + dx, y + dy, z + dz));
        }
      }
    }
  };
  const auto flood = [&](std::vector<int>& part, std::size_t from, int number, bool faces_only, auto&& belongs) {
    std::vector<std::size_t> front{from};
    part[from] = number;
    while (!front.empty()) {
      const std::size_t at = front.back();
      front.pop_back();
      each_neighbour(at, faces_only, [&](std::size_t next) {
        if (belongs(next) && part[next] != number) part[next] = number, front.push_back(next);
      });
    }
  };
  std::size_t surfaces = 0;
  std::vector<int> part(inside.size());
  for (std::size_t i = 0; i != inside.size(); ++i) {
    if (inside[i] == 0 || part[i] != 0) continue;
    std::vector<int> own(inside.size()), rest(inside.size());
    flood(own, i, 1, true, [&](std::size_t v) { return inside[v] == 1; });
    for (std::size_t v = 0; v != own.size(); ++v) part[v] |= own[v];
    int number = 0;
    for (std::size_t v = 0; v != own.size(); ++v) {
      if (own[v] == 0 && rest[v] == 0) flood(rest, v, ++number, false, [&](std::size_t w) { return own[w] == 0; });
    }
    surfaces += static_cast<std::size_t>(number);
  }
  return surfaces;
}

}  // namespace
