// SPDX-License-Identifier: GPL-3.0-or-later
//
// The checks of what vertices say of themselves: what they lie on, their markers, and who inserted them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <delref/mesh/verify/check_who_inserted.hpp>
#include <delref/mesh/verify/report.hpp>
#include <delref/mesh/verify_3/elements.hpp>

namespace delref::verification_3 {

/// 0 at input vertices, 1 inside segments, 2 inside facets, 3 everywhere else. (By which index they name it is not known here.)
inline void check_carriers(const Subject& s, const Chains& chains, const ElementsOfVertices& elements, Finding& finding) {
  for (Index v = 0; v < s.points.size(); ++v) {
    if (!chains.present(v)) continue;
    ++finding.examined;
    const int dimension = s.mesh.carriers[v].dimension;
    const int truth = chains.input_of_vertex(v) != none       ? 0
                      : elements[v].empty()                   ? 3
                      : elements.is_side(elements[v].front()) ? 1
                                                              : 2;
    constexpr const char* words[] = {"at an input vertex", "inside an input segment", "inside an input facet",
                                     "inside the domain"};
    if (dimension != truth)
      finding.fail([&] {
        return fmt::format("{} says that it lies {}, and lies {}", s.vertex(v), words[std::min(dimension, 3)], words[truth]);
      });
  }
}

/// An input vertex keeps its marker; others have that of a segment, or else a facet, that they lie on, or 0.
inline void check_point_markers(const Subject& s, const InputComplex& complex, const Chains& chains,
                                const ElementsOfVertices& elements, Finding& finding) {
  std::vector<std::vector<int>> merged(s.input_points.size());
  for (Index v = 0; v < s.input_points.size(); ++v)
    if (complex.canonical(v) != v) merged[complex.canonical(v)].push_back(s.input.point_marker(v));
  for (Index v = 0; v < s.points.size(); ++v) {
    if (!chains.present(v)) continue;
    ++finding.examined;
    std::vector<int> allowed;
    if (const Index input = chains.input_of_vertex(v); input != none) {
      allowed = merged[input];
      allowed.insert(allowed.begin(), s.input.point_marker(input));
    } else if (const auto its = elements[v]; !its.empty()) {
      const bool on_side = elements.is_side(its.front());
      for (const Index e : its) {
        if (elements.is_side(e) != on_side) continue;
        const auto& of_side = on_side ? complex.sides()[e].markers : std::vector<int>{};
        if (on_side && of_side.empty()) allowed.push_back(0);
        allowed.insert(allowed.end(), of_side.begin(), of_side.end());
        if (!on_side) allowed.push_back(s.input.facets[complex.groups()[elements.group(e)].facets.front()].marker);
      }
    } else {
      allowed.push_back(0);
    }
    if (std::ranges::find(allowed, s.mesh.point_markers[v]) == allowed.end())
      finding.fail(
          [&] { return fmt::format("{} has marker {} instead of {}", s.vertex(v), s.mesh.point_markers[v], allowed.front()); });
  }
}

inline void check_provenance(const Subject& s, const Chains& chains, Finding& finding) {
  verification::check_who_inserted(s, [&](Index v) { return chains.present(v); }, [&](Index v) { return chains.input_of_vertex(v) != none; },
                                   finding);
}

}  // namespace delref::verification_3
