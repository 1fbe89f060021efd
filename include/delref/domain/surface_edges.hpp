// SPDX-License-Identifier: GPL-3.0-or-later
//
// The edges of a grid that a surface crosses, and which of them one component crosses. Two crossings belong together when the
// surface runs from one to the other through a face of the grid, as in marching cubes (Lorensen and Cline 1987) with the faces of
// four crossings decided by the label at their centre (after Nielson and Hamann 1991). Two sheets within one cell are thus told
// apart.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/core/point.hpp>
#include <delref/domain/disjoint_sets.hpp>
#include <delref/domain/oracle.hpp>
#include <delref/domain/spread_points.hpp>

namespace delref {

/// No component is given more seeds.
inline constexpr std::size_t most_seeds = 32;

namespace detail {

template <Oracle O>
class SurfaceEdges {
 public:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  explicit SurfaceEdges(const O& oracle) : oracle_(oracle) {}

  /// One more edge, whose ends have different labels; gives its number. The ends may be at one place, on the bounds, where one of
  /// them stands for what is beyond.
  std::uint32_t add(Point3 a, Point3 b, int label_a) {
    edges_.push_back({a, b, label_a});
    return sets_.add();
  }

  /// Joins the crossed edges of a face, `none` standing for the others. Edge 0 runs from corner 0 to 1, 1 from 1 to 2, 2 from 2
  /// to 3 and 3 from 3 to 0; two opposite corners tell the centre.
  void join_face(const std::array<std::uint32_t, 4>& edges, const std::array<int, 4>& labels, Point3 corner, Point3 opposite) {
    const auto crossed = 4 - std::ranges::count(edges, none);
    if (crossed == 0) return;
    if (crossed == 4 && labels[0] == labels[2] && labels[1] == labels[3]) {
      const Point3 centre = midpoint(corner, opposite);
      int label = outside;
      oracle_.label(std::span<const Point3>(&centre, 1), std::span(&label, 1));
      const bool first_is_joined = label == labels[0];
      sets_.unite(edges[0], edges[first_is_joined ? 1 : 3]);
      sets_.unite(edges[2], edges[first_is_joined ? 3 : 1]);
      return;
    }
    std::uint32_t first = none;
    for (const std::uint32_t edge : edges) {
      if (edge == none) continue;
      if (first != none) sets_.unite(first, edge);
      first = edge;
    }
  }

  /// For each component up to `most_seeds` places where it crosses edges, within `tolerance` along them, spread widely.
  std::vector<std::vector<Point3>> seeds(double tolerance, const Control& control) {
    std::vector<std::vector<Point3>> all;
    std::vector<Point3> middles;
    const auto [members, begin] = sets_.groups();
    for (std::size_t c = 0; c + 1 < begin.size(); ++c) {
      middles.clear();
      for (std::size_t i = begin[c]; i < begin[c + 1]; ++i)
        middles.push_back(midpoint(edges_[members[i]].a, edges_[members[i]].b));
      auto& seeds = all.emplace_back();
      for (const Point3 p : spread_points(middles, most_seeds)) {
        const auto place = static_cast<std::size_t>(std::ranges::find(middles, p) - middles.begin());
        const Edge& edge = edges_[members[begin[c] + place]];
        seeds.push_back(edge.a == edge.b ? edge.a : oracle_.crossing(edge.a, edge.b, edge.label_a, tolerance));
      }
      throw_if_stopped(control);
    }
    return all;
  }

 private:
  struct Edge {
    Point3 a, b;
    int label_a;
  };
  const O& oracle_;
  DisjointSets sets_;
  std::vector<Edge> edges_;
};

}  // namespace detail

}  // namespace delref
