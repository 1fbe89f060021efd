// SPDX-License-Identifier: GPL-3.0-or-later
//
// Images that the tests make.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>

#include <delref/core/point.hpp>
#include <delref/domain/image.hpp>
#include <delref/domain/invalid_input.hpp>

namespace delref_test {

/// An image of a function of the world's points.
template <class Value = float, class F>
delref::Image<Value> image_of(const delref::ImageGrid& grid, F&& f) {
  delref::Image<Value> image{grid, {}};
  image.values.reserve(grid.voxels());
  for (int z = 0; z != grid.size[2]; ++z) {
    for (int y = 0; y != grid.size[1]; ++y) {
      for (int x = 0; x != grid.size[0]; ++x) {
        image.values.push_back(static_cast<Value>(f(grid.world({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)}))));
      }
    }
  }
  return image;
}

/// n voxels along each axis, spread over the cube from -1 to 1.
inline delref::ImageGrid unit_grid(int n) {
  const double spacing = 2.0 / (n - 1);
  return {{n, n, n}, {spacing, spacing, spacing}, {-1, -1, -1}};
}

/// A grid of voxels that are no cubes, turned and moved.
inline delref::ImageGrid slanted_grid() {
  const double c = 0.6, s = 0.8;
  return {{21, 33, 17}, {0.1, 0.0625, 0.125}, {3, -2, 1}, {{{c, s, 0}, {-s, c, 0}, {0, 0, 1}}}};
}

/// Positive within a ball.
inline auto ball(delref::Point3 centre, double radius) {
  return [=](delref::Point3 p) { return radius - std::sqrt(squared_distance(p, centre)); };
}

/// Positive within a torus around the z axis.
inline auto torus(double large, double small) {
  return [=](delref::Point3 p) { return small - std::hypot(std::hypot(p.x, p.y) - large, p.z); };
}

template <class Value, class Distribution>
delref::Image<Value> random_image(std::array<int, 3> size, unsigned seed, Distribution distribution) {
  std::mt19937 random(seed);
  delref::Image<Value> image{{size}, {}};
  image.values.resize(image.grid.voxels());
  for (Value& v : image.values) v = static_cast<Value>(distribution(random));
  return image;
}

/// The words with which something is refused; empty when it is not.
template <class F>
std::string refusal(F&& f) {
  try {
    f();
  } catch (const delref::InvalidInput& error) {
    return error.what();
  }
  return "";
}

}  // namespace delref_test
