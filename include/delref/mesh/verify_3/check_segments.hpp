// SPDX-License-Identifier: GPL-3.0-or-later
//
// The checks of input vertices and segments: present, in place, listed, and with their markers.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <delref/mesh/verify/report.hpp>
#include <delref/mesh/verify_3/chains.hpp>
#include <delref/mesh/verify_3/topology.hpp>

namespace delref::verification_3 {

/// Whether the mesh must carry a side for the sake of a facet that it has triangles of.
inline bool borders_present_facet(const InputComplex& complex, const std::vector<bool>& group_present, const Side& side) {
  return std::ranges::any_of(side.facets, [&](Index f) { return group_present[complex.group_of(f)]; });
}

/// The vertices of the facets that the mesh has. Others are looked for in `check_isolated`, where what is in the domain is known.
inline void check_input_vertices(const Subject& s, const InputComplex& complex, const Chains& chains,
                                 const std::vector<bool>& group_present, Finding& finding) {
  std::vector<bool> needed(s.input_points.size(), false);
  for (const Side& side : complex.sides())
    if (borders_present_facet(complex, group_present, side)) needed[side.a] = needed[side.b] = true;
  for (const auto& [vertex, group] : complex.points_in_facets())
    if (group != none && group_present[group]) needed[vertex] = true;
  for (Index v = 0; v < needed.size(); ++v) {
    if (!needed[v]) continue;
    ++finding.examined;
    if (chains.vertex_of_input(v) == none) finding.fail([&] { return s.input_vertex(v) + " is not in the mesh"; });
  }
  for (const auto& [v, w] : chains.repeated_vertices())
    finding.fail([&] { return fmt::format("{} is at the same place as vertex {}", s.vertex(v), s.number(w)); });
}

/// Sides with an end that is missing are left to `check_input_vertices`.
inline void check_chains(const Subject& s, const InputComplex& complex, const Chains& chains,
                         const std::vector<bool>& group_present, Finding& finding) {
  for (Index i = 0; i < complex.sides().size(); ++i) {
    const Side& side = complex.sides()[i];
    if (!side.required || !borders_present_facet(complex, group_present, side)) continue;
    ++finding.examined;
    if (chains.ends_present(i) && chains.chain(i).empty())
      finding.fail([&] { return "no chain of listed edges along " + s.segment(side.a, side.b); });
  }
}

/// Distance of Steiner vertices from the segment. Their order along it is what the search for chains follows.
inline void check_positions(const Subject& s, const InputComplex& complex, const Chains& chains, Finding& finding) {
  double farthest = 0;
  for (Index i = 0; i < complex.sides().size(); ++i) {
    s.breathe(i);
    const auto chain = chains.chain(i);
    if (chain.size() < 3) continue;
    const SegmentLine line = chains.line(i);
    for (const Index v : chain.subspan(1, chain.size() - 2)) {
      if (chains.input_of_vertex(v) != none) continue;
      const double distance = line.distance(s.points[v]);
      ++finding.examined;
      if (distance > 0) farthest = std::max(farthest, distance / line.ulp());
      if (distance > line.tolerance())
        finding.fail([&] {
          return fmt::format("{} is {} off {}: {:.4g} ulp", s.vertex(v), s.scaling.original_length(distance),
                             s.segment(complex.sides()[i].a, complex.sides()[i].b), distance / line.ulp());
        });
    }
  }
  finding.note =
      fmt::format("farthest {:.3g} ulp of the segment's largest coordinate, allowed {}", farthest, segment_tolerance_ulps);
}

/// The list of edges is the union of the chains, each edge once. (That they are edges of triangles follows from the check of
/// facets.)
inline void check_edge_list(const Subject& s, const Chains& chains, Finding& finding) {
  const auto& listed = s.mesh.edges;
  finding.examined = listed.size();
  std::vector<std::pair<Index, Index>> keys;
  for (const auto& [v, w] : listed) {
    keys.push_back({std::min(v, w), std::max(v, w)});
    if (entries_of(chains.edges(), v, w).empty())
      finding.fail([&] { return s.edge(v, w) + " is listed and lies on no input segment, or beside its chain"; });
  }
  std::ranges::sort(keys);
  for (auto twice = std::ranges::adjacent_find(keys); twice != keys.end(); twice = std::adjacent_find(twice + 1, keys.end()))
    finding.fail([&] { return s.edge(twice->first, twice->second) + " is listed twice"; });
}

/// An edge has the marker of an explicit segment that it lies on, or 0 where there is none.
inline void check_edge_markers(const Subject& s, const InputComplex& complex, const Chains& chains, Finding& finding) {
  finding.examined = s.mesh.edge_markers.size();
  for (std::size_t i = 0; i < s.mesh.edge_markers.size(); ++i) {
    const auto& [v, w] = s.mesh.edges[i];
    std::vector<int> markers;
    for (const EdgeEntry& e : entries_of(chains.edges(), v, w)) {
      const auto& its = complex.sides()[e.value].markers;
      markers.insert(markers.end(), its.begin(), its.end());
    }
    if (markers.empty()) markers.push_back(0);
    if (std::ranges::find(markers, s.mesh.edge_markers[i]) == markers.end())
      finding.fail(
          [&] { return fmt::format("{} has marker {} instead of {}", s.edge(v, w), s.mesh.edge_markers[i], markers.front()); });
  }
}

}  // namespace delref::verification_3
