// SPDX-License-Identifier: GPL-3.0-or-later
//
// The smallest angle of each triangle, as pictures and cell data show it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <delref/core/point.hpp>
#include <delref/mesh/planar_mesh.hpp>

namespace delref {

/// Calls with a triangle's index give its smallest angle in degrees; 0 for a flat triangle. The mesh must outlive it; its indices
/// must be valid. Good to about 1e-13 degrees, whatever the size of the triangle.
class SmallestAngles {
 public:
  explicit SmallestAngles(const PlanarMesh& mesh) : mesh_(mesh) {}

  double operator()(std::size_t triangle) const {
    const auto& [a, b, c] = mesh_.triangles[triangle];
    const Point2 base = mesh_.points[a];
    Vector2 u = mesh_.points[b] - base, v = mesh_.points[c] - base;
    const double size = std::max({std::abs(u.x), std::abs(u.y), std::abs(v.x), std::abs(v.y)});
    if (!(size > 0 && std::isfinite(size))) return 0;
    u = {u.x / size, u.y / size};
    v = {v.x / size, v.y / size};
    // The smallest angle is opposite to the shortest edge.
    const Vector2 w = v - u;
    if (squared_length(w) <= std::min(squared_length(u), squared_length(v))) return between(u, v);
    return squared_length(u) <= squared_length(v) ? between(v, w) : between(u, u - v);
  }

 private:
  static double between(Vector2 a, Vector2 b) { return std::atan2(std::abs(cross(a, b)), dot(a, b)) * (180 / std::numbers::pi); }

  const PlanarMesh& mesh_;
};

}  // namespace delref
