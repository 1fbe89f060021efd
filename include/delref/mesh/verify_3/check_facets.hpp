// SPDX-License-Identifier: GPL-3.0-or-later
//
// The checks of the triangles on facets. Triangles in a plane that all turn the same way cover a polygon, all of it and once,
// exactly when their boundary is the polygon's: a sum of triangles is determined by its boundary.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <delref/mesh/verify/report.hpp>
#include <delref/mesh/verify_3/facet_cover.hpp>

namespace delref::verification_3 {

inline Vector3 twice_area(const Subject& s, const std::array<Index, 3>& t) {
  return cross(s.points[t[1]] - s.points[t[0]], s.points[t[2]] - s.points[t[0]]);
}

/// Every listed triangle is on a facet, as near to its plane as rounding allows, and is seen from the front there.
inline void check_planes(const Subject& s, const InputComplex& complex, const std::vector<Index>& group_of, Finding& finding) {
  finding.examined = s.mesh.triangles.size();
  double farthest = 0;
  for (std::size_t t = 0; t < s.mesh.triangles.size(); ++t) {
    s.breathe(t);
    const auto& triangle = s.mesh.triangles[t];
    if (group_of[t] == none) {
      finding.fail([&] { return s.triangle(triangle) + " is on no facet"; });
      continue;
    }
    const Group& group = complex.groups()[group_of[t]];
    for (const Index v : triangle) {
      const double height = std::abs(group.height(s.points[v]));
      farthest = std::max(farthest, height / group.tolerance);
      if (height > group.tolerance)
        finding.fail([&] {
          return fmt::format("{} is {} off the plane of {}, allowed {}", s.vertex(v), s.scaling.original_length(height),
                             s.facet(group.facets.front()), s.scaling.original_length(group.tolerance));
        });
    }
    if (dot(twice_area(s, triangle), group.normal) == 0)
      finding.fail([&] { return s.triangle(triangle) + " has no area in the plane of " + s.facet(group.facets.front()); });
  }
  finding.note = fmt::format("farthest {:.2g} of what is allowed", farthest);
}

/// The triangles of each facet have the facet's border and no other.
inline void check_cover(const Subject& s, const InputComplex& complex, const Chains& chains, const std::vector<Index>& group_of,
                        const std::vector<bool>& present, Finding& finding) {
  struct Half {
    std::array<Index, 3> key;
    bool left;
  };
  std::vector<Half> halves;
  for (std::size_t t = 0; t < s.mesh.triangles.size(); ++t) {
    const auto& triangle = s.mesh.triangles[t];
    const bool front = dot(twice_area(s, triangle), complex.groups()[group_of[t]].normal) > 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v = triangle[k], w = triangle[(k + 1) % 3];
      halves.push_back({{std::min(v, w), std::max(v, w), group_of[t]}, (v < w) == front});
    }
  }
  std::ranges::sort(halves, {}, &Half::key);
  throw_if_stopped(s.control);
  std::vector<Index> unusable;
  const std::vector<BorderEdge> borders = borders_of_groups(s, complex, chains, present, unusable);
  for (const Index g : unusable)
    finding.fail([&] { return "the segments of " + s.facet(complex.groups()[g].facets.front()) + " cross each other"; });
  const auto judge = [&](const std::array<Index, 3>& key, const BorderEdge* border, std::size_t lefts, std::size_t rights) {
    ++finding.examined;
    const bool left = border == nullptr || border->left, right = border == nullptr || border->right;
    if (lefts == (left ? 1U : 0U) && rights == (right ? 1U : 0U)) return;
    if (std::ranges::find(unusable, key[2]) != unusable.end()) return;
    finding.fail([&] {
      return fmt::format("{} in {} has {} and {} triangles on its sides instead of {} and {}", s.edge(key[0], key[1]),
                         s.facet(complex.groups()[key[2]].facets.front()), lefts, rights, left ? 1 : 0, right ? 1 : 0);
    });
  };
  std::size_t b = 0;
  for (std::size_t i = 0, j = 0; i < halves.size(); i = j) {
    s.breathe(i);
    std::size_t lefts = 0;
    for (; j < halves.size() && halves[j].key == halves[i].key; ++j) lefts += halves[j].left;
    for (; b < borders.size() && borders[b].key() < halves[i].key; ++b) judge(borders[b].key(), &borders[b], 0, 0);
    const bool at_border = b < borders.size() && borders[b].key() == halves[i].key;
    judge(halves[i].key, at_border ? &borders[b] : nullptr, lefts, j - i - lefts);
    if (at_border) ++b;
  }
  for (; b < borders.size(); ++b) judge(borders[b].key(), &borders[b], 0, 0);
}

/// A triangle has the marker of its facet, or of another one with the same sides.
inline void check_triangle_markers(const Subject& s, const InputComplex& complex, const std::vector<Index>& group_of,
                                   Finding& finding) {
  finding.examined = s.mesh.triangle_markers.size();
  std::vector<Index> repeated;
  for (Index f = 0; f < complex.facets().size(); ++f)
    if (complex.facets()[f].same_as != none) repeated.push_back(f);
  for (std::size_t t = 0; t < s.mesh.triangle_markers.size(); ++t) {
    const Group& group = complex.groups()[group_of[t]];
    const int marker = s.mesh.triangle_markers[t], expected = s.input.facets[group.facets.front()].marker;
    if (marker == expected) continue;
    const auto has_it = [&](Index f) { return complex.group_of(f) == group_of[t] && s.input.facets[f].marker == marker; };
    if (std::ranges::none_of(repeated, has_it))
      finding.fail([&] {
        return fmt::format("{} has marker {}, and {} has {}", s.triangle(s.mesh.triangles[t]), marker,
                           s.facet(group.facets.front()), expected);
      });
  }
}

}  // namespace delref::verification_3
