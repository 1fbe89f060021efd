// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a criterion of space sees of a tetrahedron: measured once, without a square root.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include <delref/core/point.hpp>
#include <delref/criteria/circumcentre.hpp>

namespace delref {

/// A tetrahedron with its measures. Coordinates in the unit of the input.
struct TetrahedronShape {
  std::array<Point3, 4> corners;
  int region = 0;                   ///< the region number of the domain, not its label
  Point3 circumcentre;              ///< not finite when the tetrahedron is flat
  double squared_circumradius = 0;
  double shortest_squared = 0;      ///< squared length of the shortest edge
  double sixfold_volume = 0;        ///< positive
  double longest_squared = 0;       ///< of the edges at the first corner

  explicit TetrahedronShape(const std::array<Point3, 4>& points, int region_number = 0) : corners(points), region(region_number) {
    const Vector3 u = points[1] - points[0], v = points[2] - points[0], w = points[3] - points[0];
    const double uu = squared_length(u), vv = squared_length(v), ww = squared_length(w);
    const Vector3 vw = cross(v, w);
    sixfold_volume = dot(u, vw);
    const Vector3 r = (0.5 / sixfold_volume) * (uu * vw + vv * cross(w, u) + ww * cross(u, v));
    circumcentre = points[0] + r;
    squared_circumradius = squared_length(r);
    longest_squared = std::max({uu, vv, ww});
    shortest_squared = std::min({uu, vv, ww, squared_length(v - u), squared_length(w - v), squared_length(u - w)});
  }

  /// So flat that the circumcentre is noise.
  bool is_flat() const { return sixfold_volume * sixfold_volume <= 1e-24 * longest_squared * longest_squared * longest_squared; }
  /// The circumcentre of the face of greatest area.
  Point3 centre_of_largest_face() const {
    double largest = 0;
    Point3 centre;
    for (std::size_t i = 0; i < 4; ++i) {
      const Vector3 u = corners[(i + 1) % 4] - corners[i], v = corners[(i + 2) % 4] - corners[i];
      const double area = squared_length(cross(u, v));
      if (!(area > largest)) continue;
      largest = area;
      centre = corners[i] + to_circumcentre(u, v);
    }
    return centre;
  }
  /// The square of the circumradius over the shortest edge.
  double squared_radius_edge() const { return squared_circumradius / shortest_squared; }
};

}  // namespace delref
