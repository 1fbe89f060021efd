// SPDX-License-Identifier: GPL-3.0-or-later
//
// The checks of the topology of the surface: closed around every region, a disk at every vertex, and as many pieces and holes as it
// is said to have.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <delref/domain/disjoint_sets.hpp>
#include <delref/mesh/twofold.hpp>
#include <delref/mesh/verify/report.hpp>
#include <delref/mesh/verify_smooth/excuses.hpp>
#include <delref/mesh/verify_smooth/subject.hpp>
#include <delref/mesh/verify_smooth/surface_graph.hpp>

namespace delref::verification_smooth {

/// At every edge each region, and the outside, has an even number of triangles.
template <class Questions>
void check_closed(const Subject& s, const SurfaceGraph& graph, const Questions& questions, const std::vector<Sides>& sides, Finding& finding) {
  std::vector<int> regions;
  std::size_t crowded = 0;
  graph.for_each_edge([&](std::span<const SurfaceGraph::Side> edge) {
    s.breathe(finding.examined++);
    regions.clear();
    for (const auto& side : edge) regions.push_back(sides[side.triangle].behind), regions.push_back(sides[side.triangle].front);
    std::ranges::sort(regions);
    bool is_crowded = false;
    for (std::size_t i = 0, j = 0; i < regions.size(); i = j) {
      while (j < regions.size() && regions[j] == regions[i]) ++j;
      is_crowded = is_crowded || j - i > 2;
      if ((j - i) % 2 == 0) continue;
      finding.fail([&] {
        return fmt::format("the surface of {} ends at the {}, which has {} of its triangles", questions.words(regions[i]),
                           s.edge(edge[0].low, edge[0].high), j - i);
      });
      break;
    }
    crowded += is_crowded;
  });
  if (crowded != 0) finding.note = fmt::format("at {} edges a region has more than two triangles", crowded);
}

/// The triangles at a vertex between two regions, as their edges opposite to it.
class Link {
 public:
  void clear() { spokes_.clear(); }
  void add(Index a, Index b) { spokes_.push_back({a, b}); }

  /// Whether the triangles are one disk with the vertex inside it, or at its rim when that is allowed.
  bool is_disk(bool may_be_at_rim) {
    ends_.clear();
    for (std::uint32_t i = 0; i < spokes_.size(); ++i) ends_.push_back({spokes_[i].first, i}), ends_.push_back({spokes_[i].second, i});
    std::ranges::sort(ends_);
    DisjointSets joined(spokes_.size());
    std::size_t pieces = spokes_.size(), free_ends = 0;
    for (std::size_t i = 0, j = 0; i < ends_.size(); i = j) {
      while (j < ends_.size() && ends_[j].first == ends_[i].first) ++j;
      if (j - i > 2) return false;
      if (j - i == 1) {
        ++free_ends;
        continue;
      }
      pieces -= joined.find(ends_[i].second) != joined.find(ends_[i + 1].second);
      joined.unite(ends_[i].second, ends_[i + 1].second);
    }
    return pieces == 1 && (free_ends == 0 || (may_be_at_rim && free_ends == 2));
  }

 private:
  std::vector<std::pair<Index, Index>> spokes_;
  std::vector<std::pair<Index, std::uint32_t>> ends_;
};

/// The triangles between each two regions at each vertex are a topological disk (Cheng, Dey, Ramos and Ray 2007).
template <class Questions>
void check_disks(const Subject& s, const SurfaceGraph& graph, const Questions& questions, const std::vector<Sides>& sides, Excuses& excuses,
                 Finding& finding) {
  Link link;
  std::vector<std::pair<Sides, Index>> star;
  std::size_t left = 0;
  for (Index v = 0; v < s.points.size(); ++v) {
    s.breathe(v);
    if (!graph.is_on_surface(v)) continue;
    ++finding.examined;
    star.clear();
    for (const Index t : graph.triangles_at(v)) star.push_back({sides[t], t});
    std::ranges::sort(star);
    const bool has_one_pair = star.front().first == star.back().first;
    for (std::size_t i = 0, j = 0; i < star.size(); i = j) {
      link.clear();
      for (; j < star.size() && star[j].first == star[i].first; ++j) {
        const auto& t = s.mesh.triangles[star[j].second];
        const std::size_t k = t[0] == v ? 0 : t[1] == v ? 1 : 2;
        link.add(t[(k + 1) % 3], t[(k + 2) % 3]);
      }
      if (link.is_disk(!has_one_pair)) continue;
      if (!s.expected.strict && std::ranges::all_of(star, [&](const auto& e) { return excuses.is_left(e.second); })) ++left;
      else if (!excuses.settle_unfinished())
        finding.fail([&] {
          return fmt::format("the {} triangles at {} between {} and {} are no disk", j - i, s.vertex(v), questions.words(star[i].first.behind),
                             questions.words(star[i].first.front));
        });
      break;
    }
  }
  if (left != 0) finding.note = fmt::format("at {} more vertices all facets are left as they are", left);
}

/// The closed surfaces around regions: triangles are joined where two sides of one region meet at an edge.
template <class Questions>
std::vector<SurfacePiece> surface_pieces(const Subject& s, const SurfaceGraph& graph, const Questions& questions,
                                         const std::vector<Sides>& sides) {
  const auto region = [&](std::uint32_t side) { return side % 2 == 0 ? sides[side / 2].behind : sides[side / 2].front; };
  DisjointSets joined(2 * sides.size());
  std::vector<std::pair<int, std::uint32_t>> around;
  graph.for_each_edge([&](std::span<const SurfaceGraph::Side> edge) {
    around.clear();
    for (const auto& side : edge)
      for (const std::uint32_t i : {2 * side.triangle, 2 * side.triangle + 1}) around.push_back({region(i), i});
    std::ranges::sort(around);
    for (std::size_t i = 1; i < around.size(); ++i)
      if (around[i].first == around[i - 1].first) joined.unite(around[i].second, around[i - 1].second);
  });
  std::vector<SurfacePiece> pieces;
  const auto groups = joined.groups();
  std::vector<Index> vertices;
  std::vector<std::pair<Index, Index>> edges;
  for (std::size_t g = 0; g + 1 < groups.begin.size(); ++g) {
    s.breathe(0);
    const auto its = std::span(groups.members).subspan(groups.begin[g], groups.begin[g + 1] - groups.begin[g]);
    if (region(its[0]) == outside) continue;
    vertices.clear(), edges.clear();
    PreciseSum six_volumes;
    const Point3 origin = s.points[s.mesh.triangles[its[0] / 2][0]];
    for (const std::uint32_t side : its) {
      const auto& t = s.mesh.triangles[side / 2];
      for (std::size_t i = 0; i < 3; ++i) vertices.push_back(t[i]), edges.push_back(std::minmax(t[i], t[(i + 1) % 3]));
      const double six = dot(s.points[t[0]] - origin, cross(s.points[t[1]] - origin, s.points[t[2]] - origin));
      six_volumes += side % 2 == 0 ? six : -six;
    }
    const auto distinct = [](auto& all) {
      std::ranges::sort(all);
      return static_cast<std::size_t>(std::ranges::unique(all).begin() - all.begin());
    };
    pieces.push_back({questions.label(region(its[0])), distinct(vertices), distinct(edges), its.size(),
                      s.scaling.original_volume(six_volumes.value() / 6)});
  }
  std::vector<std::size_t> order(pieces.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return std::tuple(pieces[i].region, ~pieces[i].triangles, i); });
  std::vector<SurfacePiece> sorted;
  for (const std::size_t i : order) sorted.push_back(pieces[i]);
  return sorted;
}

/// The number of connected pieces of the whole surface, and its Euler characteristic, are what the caller expects.
inline void check_expected_topology(const Subject& s, const SurfaceGraph& graph, Finding& finding) {
  DisjointSets joined(s.mesh.triangles.size());
  std::size_t edges = 0, vertices = 0;
  graph.for_each_edge([&](std::span<const SurfaceGraph::Side> edge) {
    ++edges;
    for (const auto& side : edge) joined.unite(side.triangle, edge[0].triangle);
  });
  for (Index v = 0; v < s.points.size(); ++v) vertices += graph.is_on_surface(v);
  const std::size_t components = joined.groups().begin.size() - 1;
  const long euler = static_cast<long>(vertices) - static_cast<long>(edges) + static_cast<long>(s.mesh.triangles.size());
  finding.note = fmt::format("components {}, Euler characteristic {}", components, euler);
  const auto compare = [&](const auto& expected, auto its, const char* what) {
    if (!expected) return;
    ++finding.examined;
    if (*expected != its) finding.fail([&] { return fmt::format("the {} is {} instead of {}", what, its, *expected); });
  };
  compare(s.expected.components, components, "number of components");
  compare(s.expected.euler_characteristic, euler, "Euler characteristic");
}

}  // namespace delref::verification_smooth
