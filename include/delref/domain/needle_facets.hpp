// SPDX-License-Identifier: GPL-3.0-or-later
//
// Facets so narrow that the vertices of refinement on one of their sides cannot be told from those on another: chains along such sides
// would get mixed up.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <delref/domain/describe.hpp>
#include <delref/domain/plc_names.hpp>
#include <delref/domain/triangulated_plc.hpp>

namespace delref {

/// Facets whose vertices are all within 16 units in the last place of their largest coordinate from one line, and that are a thousand
/// times as long, are defects.
inline void find_needle_facets(const TriangulatedPlc& plc, const PlcNames& names, DefectList& defects) {
  using Index = Plc::Index;
  const auto points = plc.points;
  std::vector<Index> vertices;
  for (std::size_t f = 0; f < plc.size(); ++f) {
    vertices.clear();
    for (const auto& triangle : plc.triangles_of(f)) vertices.insert(vertices.end(), triangle.begin(), triangle.end());
    if (vertices.empty()) continue;
    const Point3 a = points[vertices.front()];
    const auto farthest_from_a = [&](Index v) { return squared_distance(a, points[v]); };
    const Point3 b = points[std::ranges::max(vertices, {}, farthest_from_a)];
    const double length = std::sqrt(squared_distance(a, b));
    double width = 0, largest = 0;
    for (const Index v : vertices) {
      const Point3 p = points[v];
      const Vector3 n = cross((1 / length) * (b - a), p - a);
      width = std::max(width, std::sqrt(dot(n, n)));
      largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    }
    if (width > 16 * std::numeric_limits<double>::epsilon() * largest || 1000 * width > length) continue;
    std::ranges::sort(vertices);
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    defects.add(names.facet(plc.outlines.facets[f].original, vertices) + " is a needle: it is " + names.length(length) + " long and only " +
                names.length(width) + " wide, which coordinates of that size cannot resolve; merge near vertices by a merge tolerance");
  }
}

}  // namespace delref
