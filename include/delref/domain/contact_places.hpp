// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where two triangles meet, rounded: for messages, and to tell crossings from the rounding of points that two facets share.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include <delref/core/point.hpp>
#include <delref/domain/exact_side_3.hpp>

namespace delref {

namespace contact_places {

using Corners3 = std::array<Point3, 3>;

/// True when the projection of `p` along the normal of a triangle is in it, up to a little.
inline bool covers(const Corners3& t, Point3 p) {
  const Vector3 normal = cross(t[1] - t[0], t[2] - t[0]);
  const double slack = -1e-9 * squared_length(normal);
  for (std::size_t i = 0; i < 3; ++i)
    if (dot(cross(t[(i + 1) % 3] - t[i], p - t[i]), normal) < slack) return false;
  return true;
}

/// Where the edges of `s` pass through `t`, or end in it.
inline void add_piercings(const Corners3& s, const Corners3& t, std::vector<Point3>& places) {
  const Vector3 normal = cross(t[1] - t[0], t[2] - t[0]);
  for (std::size_t i = 0; i < 3; ++i) {
    const Point3 a = s[i], b = s[(i + 1) % 3];
    const int side_a = exact_side(t[0], t[1], t[2], a), side_b = exact_side(t[0], t[1], t[2], b);
    Point3 x = a;
    if (side_a * side_b < 0) {
      const double from = std::abs(dot(a - t[0], normal)), to = std::abs(dot(b - t[0], normal));
      if (from + to > 0) x = a + (from / (from + to)) * (b - a);
    } else if (side_a != 0) {
      continue;
    }
    if (covers(t, x)) places.push_back(x);
  }
}

/// Where the edges of two triangles in one plane cross.
inline void add_crossings(const Corners3& s, const Corners3& t, std::vector<Point3>& places) {
  const Vector3 normal = cross(t[1] - t[0], t[2] - t[0]);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const Point3 a = s[i], b = s[(i + 1) % 3], c = t[j], d = t[(j + 1) % 3];
      const double side_a = dot(cross(d - c, a - c), normal), side_b = dot(cross(d - c, b - c), normal);
      const double side_c = dot(cross(b - a, c - a), normal), side_d = dot(cross(b - a, d - a), normal);
      if (side_a * side_b < 0 && side_c * side_d < 0) places.push_back(a + (side_a / (side_a - side_b)) * (b - a));
    }
}

}  // namespace contact_places

/// Points in which two triangles meet: the ends of what they have in common, if they are not coplanar; vertices and crossings
/// otherwise. Vertices that they share are not among them.
inline std::vector<Point3> contact_places_of(const std::array<Point3, 3>& s, const std::array<Point3, 3>& t) {
  std::vector<Point3> places;
  contact_places::add_piercings(s, t, places);
  contact_places::add_piercings(t, s, places);
  contact_places::add_crossings(s, t, places);
  std::erase_if(places, [&](Point3 p) { return std::ranges::find(s, p) != s.end() && std::ranges::find(t, p) != t.end(); });
  return places;
}

}  // namespace delref
