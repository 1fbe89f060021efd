// SPDX-License-Identifier: GPL-3.0-or-later
//
// The circumcentre of a triangle, in the plane and in space: from a corner, so that no digits are lost far from the origin.
#pragma once

#include <delref/core/point.hpp>

namespace delref {

/// From a corner of a triangle to its circumcentre; `u` and `v` are the edges from that corner, `doubled_area` twice the signed area that
/// they span. Not finite when the triangle is flat.
inline Vector2 to_circumcentre(Vector2 u, Vector2 v, double doubled_area) {
  const double uu = squared_length(u), vv = squared_length(v), scale = 0.5 / doubled_area;
  return {(uu * v.y - vv * u.y) * scale, (vv * u.x - uu * v.x) * scale};
}

/// The same in space.
inline Vector3 to_circumcentre(Vector3 u, Vector3 v) {
  const Vector3 n = cross(u, v);
  return (0.5 / squared_length(n)) * (squared_length(v) * cross(n, u) + squared_length(u) * cross(v, n));
}

}  // namespace delref
