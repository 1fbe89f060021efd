// SPDX-License-Identifier: GPL-3.0-or-later
//
// Functions whose surfaces are known.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <delref/core/point.hpp>
#include <delref/domain/bounding_box_3.hpp>
#include <delref/domain/implicit_function.hpp>

namespace delref_test {

using delref::BoundingBox3;
using delref::Point3;

inline constexpr BoundingBox3 cube(double half) { return {{-half, -half, -half}, {half, half, half}}; }

/// The distance to a sphere, negative in it.
struct Sphere {
  Point3 centre;
  double radius;
  double operator()(Point3 p) const { return std::sqrt(squared_distance(p, centre)) - radius; }
};

/// The distance to the nearest of some spheres. Changes no faster than the distance of points.
struct Spheres {
  std::vector<Sphere> spheres;
  double operator()(Point3 p) const {
    double least = 1e300;
    for (const Sphere& sphere : spheres) least = std::min(least, sphere(p));
    return least;
  }
  delref::ValueRange range(const BoundingBox3& box) const {
    const double value = (*this)(midpoint(box.low, box.high)), reach = 0.5 * box.diagonal() * (1 + 1e-12) + 1e-12;
    return {value - reach, value + reach};
  }
};

/// 300 spheres on a grid in `cube(3)`, of radii from 0.1 to 0.2, no two closer than 0.4.
inline Spheres many_spheres() {
  Spheres all;
  for (int i = 0; i < 300; ++i)
    all.spheres.push_back({{0.8 * (i % 7) - 2.4, 0.8 * (i / 7 % 7) - 2.4, 0.8 * (i / 49) - 2.4}, 0.1 + 0.1 / 3 * (i % 4)});
  return all;
}

inline double tangle(Point3 p) {
  const auto part = [](double t) { return t * t * t * t - 5 * t * t; };
  return part(p.x) + part(p.y) + part(p.z) + 11.8;
}

inline double torus(Point3 p) { return std::hypot(std::hypot(p.x, p.y) - 1, p.z) - 0.3; }

inline double gyroid(Point3 p) {
  return std::sin(p.x) * std::cos(p.y) + std::sin(p.y) * std::cos(p.z) + std::sin(p.z) * std::cos(p.x);
}

/// Between two spheres around the origin.
struct Shell {
  double inner, outer;
  double operator()(Point3 p) const {
    const double r = std::sqrt(squared_distance(p, Point3{}));
    return std::max(inner - r, r - outer);
  }
};

/// Counts the points that a function is asked about.
template <class F>
struct Counted {
  F function;
  std::size_t* count;
  double operator()(Point3 p) const {
    ++*count;
    return function(p);
  }
};
template <class F>
Counted(F, std::size_t*) -> Counted<F>;

}  // namespace delref_test
