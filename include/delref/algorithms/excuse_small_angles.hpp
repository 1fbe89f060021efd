// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tells, of the triangles that were given up, which ones a small input angle forces (Shewchuk 2002, section 8: no algorithm can
// avoid small angles at and near small input angles).
#pragma once

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include <delref/core/outcome.hpp>
#include <delref/domain/planar_domain.hpp>
#include <delref/triangulation/planar_concept.hpp>

namespace delref {

/// Gives the reason `small_input_angle` to every triangle of the outcome that misses the criterion named `shape_criterion`
/// and has a vertex within twice its longest edge of a corner where segments meet under 60 degrees with the domain between.
template <PlanarTriangulation Tr>
void excuse_small_angles(Outcome<Point2>& outcome, const Tr& tr, const PlanarDomain& domain, std::string_view shape_criterion) {
  if (outcome.unmet.empty()) return;
  std::vector<Point2> points;
  for (const auto v : tr.finite_vertices()) {
    if (tr.index(v) >= points.size()) points.resize(tr.index(v) + 1);
    points[tr.index(v)] = tr.point(v);
  }
  std::vector<Point2> corners;
  for (std::size_t s = 0; s < domain.segments.size(); ++s)
    for (std::size_t end = 0; end < 2; ++end)
      if (domain.segments[s].sharp[end]) corners.push_back(domain.point(s, end));
  std::ranges::sort(corners, {}, &Point2::x);
  const auto is_near_corner = [&](Point2 p, double distance) {
    for (auto c = std::ranges::lower_bound(corners, p.x - distance, {}, &Point2::x); c != corners.end() && c->x <= p.x + distance; ++c)
      if (squared_distance(*c, p) <= distance * distance) return true;
    return false;
  };
  for (Unmet<Point2>& u : outcome.unmet) {
    if (u.vertex_count != 3 || u.criterion != shape_criterion || u.reason == Reason::budget) continue;
    const Point2 a = points[u.vertices[0]], b = points[u.vertices[1]], c = points[u.vertices[2]];
    const double reach = 2 * std::sqrt(std::max({squared_distance(a, b), squared_distance(b, c), squared_distance(c, a)}));
    if (is_near_corner(a, reach) || is_near_corner(b, reach) || is_near_corner(c, reach)) u.reason = Reason::small_input_angle;
  }
}

}  // namespace delref
