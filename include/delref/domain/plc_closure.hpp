// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether facets can enclose anything at all. A facet with a free side separates nothing, since a path leads around that side;
// what is left when such facets are taken away, again and again, may enclose a volume. If nothing is left the surface is open,
// and its boundary is told.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/domain/bounding_box_3.hpp>
#include <delref/domain/describe.hpp>
#include <delref/domain/merge_points_3.hpp>
#include <delref/domain/plc_names.hpp>
#include <delref/domain/segment_wedges.hpp>
#include <delref/domain/triangulated_plc.hpp>

namespace delref {

namespace plc_closure {

using Index = Plc::Index;

/// Per facet whether it hangs free: it has a side where no other facet is, or gets one when others that hang free are taken away.
inline std::vector<bool> hanging_facets(const TriangulatedPlc& plc, const SegmentWedges& wedges, const Control& control) {
  std::vector<bool> hangs(plc.size(), false);
  std::vector<Index> count(wedges.size()), stack;
  const auto take_from = [&](Index s) {  // the one facet that still has a side there, if one has
    if (count[s] != 1) return;
    for (const auto& wedge : wedges[s])
      if (!hangs[wedge.facet]) {
        hangs[wedge.facet] = true;
        stack.push_back(wedge.facet);
        return;
      }
  };
  for (Index s = 0; s < wedges.size(); ++s) count[s] = static_cast<Index>(wedges[s].size());
  for (Index s = 0; s < wedges.size(); ++s) take_from(s);
  std::vector<Index> sides;
  while (!stack.empty()) {
    if (stack.size() % 4096 == 0) throw_if_stopped(control);
    const Index f = stack.back();
    stack.pop_back();
    sides.clear();
    for (const auto& [a, b] : plc.outlines.sides(f)) sides.push_back(plc.segments.find(a, b));
    std::ranges::sort(sides);
    sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
    for (const Index s : sides) {
      count[s] -= static_cast<Index>(std::ranges::count(wedges[s], f, &SegmentWedges::Wedge::facet));
      take_from(s);
    }
  }
  return hangs;
}

/// The segments with one facet, as chains of vertices; a closed one ends with its first vertex.
inline std::vector<std::vector<Index>> boundary_chains(const TriangulatedPlc& plc, const SegmentWedges& wedges) {
  std::vector<std::array<Index, 3>> steps;  // from, to, segment
  for (Index s = 0; s < wedges.size(); ++s) {
    if (wedges[s].size() != 1) continue;
    const auto [a, b] = plc.segments[s];
    steps.push_back({a, b, s});
    steps.push_back({b, a, s});
  }
  std::ranges::sort(steps);
  std::vector<bool> used(wedges.size(), false);
  std::vector<std::vector<Index>> chains;
  for (const auto& start : steps) {
    if (used[start[2]]) continue;
    std::vector<Index> chain{start[0]};
    for (const std::array<Index, 3>* step = &start; step != nullptr;) {
      used[(*step)[2]] = true;
      chain.push_back((*step)[1]);
      if (chain.back() == chain.front()) break;
      const auto onward = std::ranges::equal_range(steps, chain.back(), {}, [](const auto& s) { return s[0]; });
      const auto next = std::ranges::find_if(onward, [&](const auto& s) { return !used[s[2]]; });
      step = next == onward.end() ? nullptr : &*next;
    }
    chains.push_back(std::move(chain));
  }
  return chains;
}

/// "; 4 of their vertices lie within 1e-09 of another: a merge tolerance of 1e-09 may close it"; empty where none is near.
inline std::string near_misses(const std::vector<std::vector<Index>>& chains, const PlcNames& names, const Control& control) {
  std::vector<Index> vertices;
  for (const auto& chain : chains) vertices.insert(vertices.end(), chain.begin(), chain.end());
  std::ranges::sort(vertices);
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  std::vector<Point3> points;
  for (const Index v : vertices) points.push_back(names.points[v]);
  const double extent = bounding_box_3(names.points).extent();
  for (const double part : {1e-12, 1e-9, 1e-6, 1e-4}) {
    const auto close = close_points(points, part * extent, control);
    std::size_t count = 0;
    double farthest = 0;
    for (std::size_t i = 0; i < close.size(); ++i) {
      if (close[i] == i) continue;
      ++count;
      farthest = std::max(farthest, std::sqrt(squared_distance(points[i], points[close[i]])));
    }
    if (count > 0)
      return "; " + count_of(count, "of these vertices lies", "of these vertices lie") + " within " + names.length(farthest) +
             " of another: a merge tolerance a little above that may close it";
  }
  return {};
}

inline std::string open_message(const TriangulatedPlc& plc, const SegmentWedges& wedges, const PlcNames& names,
                                const Control& control) {
  const std::vector<std::vector<Index>> chains = boundary_chains(plc, wedges);
  std::size_t edges = 0;
  ExampleList examples;
  for (const auto& chain : chains) {
    edges += chain.size() - 1;
    const bool closed = chain.front() == chain.back();
    if (examples.full())
      examples.add();
    else
      examples.add((closed ? "a closed one of vertices " : "one of vertices ") +
                   names.numbers(std::span(chain).first(chain.size() - (closed ? 1 : 0))) + ", from " +
                   names.placed_vertex(chain.front()));
  }
  return "the facets are open and enclose no volume: " + count_of(edges, "segment has", "segments have") +
         " a facet on one side only, in " + count_of(chains.size(), "chain", "chains") + ": " + examples.text() +
         near_misses(chains, names, control) + ". Close them with facets";
}

}  // namespace plc_closure

/// Adds a defect with the boundary when the facets cannot enclose anything; a note on facets that hang free when others can.
inline void check_closure(const TriangulatedPlc& plc, const SegmentWedges& wedges, const PlcNames& names, const Control& control,
                          DefectList& defects, std::vector<std::string>& notes) {
  if (plc.size() == 0) {
    defects.add("no facet has any area (after merging): nothing bounds a domain; give the facets of its boundary");
    return;
  }
  const std::vector<bool> hangs = plc_closure::hanging_facets(plc, wedges, control);
  const auto count = static_cast<std::size_t>(std::ranges::count(hangs, true));
  if (count == 0) return;
  if (count == plc.size()) {
    defects.add(plc_closure::open_message(plc, wedges, names, control));
    return;
  }
  ExampleList examples;
  for (std::size_t f = 0; f < hangs.size(); ++f) {
    if (!hangs[f]) continue;
    if (examples.full())
      examples.add();
    else
      examples.add(names.facet(plc.outlines.facets[f].original));
  }
  notes.push_back(
      count_of(count, "facet has a free side or adjoins one that has", "facets have a free side or adjoin one that has") +
      ", so that they separate nothing: " + examples.text());
}

}  // namespace delref
