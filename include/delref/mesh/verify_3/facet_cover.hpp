// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which facet each listed triangle is on, and which edges border each facet: what the triangles of a facet must have as boundary.
#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <cstddef>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include <delref/mesh/verify_3/chains.hpp>
#include <delref/mesh/verify_3/facet_region.hpp>
#include <delref/mesh/verify_3/input_complex.hpp>
#include <delref/mesh/verify_3/subject.hpp>

namespace delref::verification_3 {

/// The edges of triangles, each with its triangle, sorted.
inline std::vector<EdgeEntry> edges_of_triangles(std::span<const std::array<Index, 3>> triangles) {
  std::vector<EdgeEntry> edges;
  edges.reserve(3 * triangles.size());
  for (Index t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v = triangles[t][k], w = triangles[t][(k + 1) % 3];
      edges.push_back({std::min(v, w), std::max(v, w), t});
    }
  std::ranges::sort(edges);
  return edges;
}

/// Calls `take` with each run of entries that have the same edge.
template <class Take>
void for_each_edge(std::span<const EdgeEntry> sorted, Take&& take) {
  for (std::size_t i = 0, j = 0; i < sorted.size(); i = j) {
    while (j < sorted.size() && sorted[j].a == sorted[i].a && sorted[j].b == sorted[i].b) ++j;
    take(sorted.subspan(i, j - i));
  }
}

/// The group of each listed triangle: as the mesh says or, where it does not, the group that most of the border of its connected
/// part of a facet belongs to. none where there is no answer.
inline std::vector<Index> groups_of_triangles(const Subject& s, const InputComplex& complex, const Chains& chains) {
  const TetrahedralMesh& mesh = s.mesh;
  std::vector<Index> group(mesh.triangles.size(), none);
  if (!mesh.triangle_facets.empty()) {
    for (std::size_t t = 0; t < group.size(); ++t) group[t] = complex.group_of(mesh.triangle_facets[t]);
    return group;
  }
  const std::vector<EdgeEntry> edges = edges_of_triangles(mesh.triangles);
  DisjointSets patch(group.size());
  for_each_edge(edges, [&](auto run) {
    if (run.size() == 2 && entries_of(chains.edges(), run[0].a, run[0].b).empty()) patch.unite(run[0].value, run[1].value);
  });
  std::map<std::pair<Index, Index>, std::size_t> votes;
  const auto suits = [&](Index t, const Group& g) {
    return (mesh.triangle_markers.empty() || mesh.triangle_markers[t] == s.input.facets[g.facets.front()].marker) &&
           std::ranges::all_of(mesh.triangles[t], [&](Index v) { return std::abs(g.height(s.points[v])) <= g.tolerance; });
  };
  for_each_edge(edges, [&](auto run) {
    for (const EdgeEntry& border : entries_of(chains.edges(), run[0].a, run[0].b))
      for (const Index f : complex.sides()[border.value].facets)
        for (const EdgeEntry& e : run)
          if (const Index g = complex.group_of(f); suits(e.value, complex.groups()[g])) ++votes[{patch.find(e.value), g}];
  });
  std::map<Index, std::pair<std::size_t, Index>> best;
  for (const auto& [key, count] : votes)
    if (auto& its = best.try_emplace(key.first, 0, none).first->second; count > its.first) its = {count, key.second};
  for (Index t = 0; t < group.size(); ++t)
    if (const auto found = best.find(patch.find(t)); found != best.end()) group[t] = found->second.second;
  return group;
}

/// An edge at the border of a facet, and on which side of it, from a to b and seen from the head of the facet's normal, the facet
/// is.
struct BorderEdge {
  Index a, b, group;
  bool left, right;
  std::array<Index, 3> key() const { return {a, b, group}; }
};

/// The edges of a group by the chains of its sides, or straight from end to end where there is no chain and `vertex` gives a
/// number for the missing vertices.
template <class Vertex>
std::vector<FacetRegion::Edge> edges_of_group(const InputComplex& complex, const Chains& chains, const Group& group,
                                              Vertex&& vertex) {
  std::vector<FacetRegion::Edge> edges;
  const auto add = [&](Index v, Index w) { edges.push_back({std::min(v, w), std::max(v, w)}); };
  for (const Index f : group.facets)
    for (const Facet::Use& use : complex.facets()[f].sides) {
      const auto chain = chains.chain(use.side);
      const Side& side = complex.sides()[use.side];
      if (chain.empty() && side.required) add(vertex(side.a), vertex(side.b));
      for (std::size_t i = 1; i < chain.size(); ++i) add(chain[i - 1], chain[i]);
    }
  std::ranges::sort(edges);
  edges.erase(std::ranges::unique(edges).begin(), edges.end());
  return edges;
}

/// The hole seeds of the facets of a group, scaled.
inline std::vector<Point3> holes_of_group(const Subject& s, const Group& group) {
  std::vector<Point3> holes;
  for (const Index f : group.facets)
    for (const Point3 hole : s.input.facets[f].holes) holes.push_back(s.scaling(hole));
  return holes;
}

/// The borders of the groups that are present, sorted. Groups whose segments cross are added to `unusable`.
inline std::vector<BorderEdge> borders_of_groups(const Subject& s, const InputComplex& complex, const Chains& chains,
                                                 const std::vector<bool>& present, std::vector<Index>& unusable) {
  std::vector<BorderEdge> borders;
  for (Index g = 0; g < complex.groups().size(); ++g) {
    s.breathe(g);
    const Group& group = complex.groups()[g];
    if (!present[g]) continue;
    if (group.simple) {
      for (const Index f : group.facets)
        for (const Facet::Use& use : complex.facets()[f].sides) {
          const auto chain = chains.chain(use.side);
          for (std::size_t i = 1; i < chain.size(); ++i) {
            const bool rising = chain[i - 1] < chain[i], left = (use.forward == group.agrees(complex.facets()[f])) == rising;
            borders.push_back({std::min(chain[i - 1], chain[i]), std::max(chain[i - 1], chain[i]), g, left, !left});
          }
        }
      continue;
    }
    const auto edges = edges_of_group(complex, chains, group, [](Index) { return none; });
    const FacetRegion region(
        group, edges, [&](Index v) { return s.points[v]; }, holes_of_group(s, group));
    if (!region.usable()) {
      unusable.push_back(g);
      continue;
    }
    for (const auto& [v, w] : edges) {
      const auto [left, right] = region.sides(v, w);
      borders.push_back({v, w, g, left, right});
    }
  }
  std::ranges::sort(borders, {}, &BorderEdge::key);
  std::size_t kept = 0;
  for (const BorderEdge& e : borders) {
    if (kept > 0 && borders[kept - 1].key() == e.key())
      borders[kept - 1].left |= e.left, borders[kept - 1].right |= e.right;
    else
      borders[kept++] = e;
  }
  borders.resize(kept);
  return borders;
}

}  // namespace delref::verification_3
