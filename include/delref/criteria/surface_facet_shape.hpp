// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a criterion sees of a facet of a restricted Delaunay triangulation: the triangle, and the surface ball, which has its centre
// where the dual edge of the facet meets the surface, and its corners on the sphere (Boissonnat and Oudot 2005, section 3).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include <delref/core/point.hpp>

namespace delref {

/// A facet of the surface with its measures. Coordinates in the unit of the input.
struct SurfaceFacetShape {
  std::array<Point3, 3> corners;
  std::array<int, 2> regions{};              ///< on its two sides, the greater first; -1 is the outside
  Point3 centre;                             ///< of the surface ball: a point of the surface
  double squared_radius = 0;                 ///< of the surface ball
  std::array<double, 3> squared_lengths{};   ///< of the edge opposite to each corner
  double doubled_area_squared = 0;           ///< the square of twice the area
  std::size_t shortest = 0;                  ///< the corner opposite to the shortest edge

  SurfaceFacetShape(const std::array<Point3, 3>& points, Point3 surface_centre, std::array<int, 2> sides)
      : corners(points), regions(sides), centre(surface_centre) {
    const auto& [a, b, c] = corners;
    squared_radius = std::max({squared_distance(centre, a), squared_distance(centre, b), squared_distance(centre, c)});
    squared_lengths = {squared_distance(b, c), squared_distance(a, c), squared_distance(a, b)};
    doubled_area_squared = squared_length(cross(b - a, c - a));
    const auto [bc, ac, ab] = squared_lengths;
    shortest = ab < std::min(bc, ac) ? 2 : ac < bc ? 1 : 0;
  }

  double shortest_squared() const { return squared_lengths[shortest]; }
  /// The squared sine of the smallest angle, which is opposite to the shortest edge.
  double squared_sine() const {
    const auto [a, b, c] = squared_lengths;
    const double others = shortest == 0 ? b * c : shortest == 1 ? a * c : a * b;
    return others > 0 ? doubled_area_squared / others : 0;
  }
  /// The squared distance between the circumcentre of the triangle and the centre of the surface ball.
  double squared_distance_to_surface() const {
    const auto [a2, b2, c2] = squared_lengths;
    if (!(doubled_area_squared > 0)) return squared_radius;
    return std::max(0.0, squared_radius - a2 * b2 * c2 / (4 * doubled_area_squared));
  }
};

}  // namespace delref
