// SPDX-License-Identifier: GPL-3.0-or-later
//
// The topology of a surface given as triangles, counted from their corner numbers alone: is it closed, is it a manifold, how many
// components, which Euler characteristic. Shares no code with a mesher.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace benchmark {

/// Sets that only unite.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }
  std::size_t find(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void unite(std::size_t a, std::size_t b) { parent_[find(a)] = find(b); }

 private:
  std::vector<std::size_t> parent_;
};

using Triangle = std::array<std::size_t, 3>;
using Tetrahedron = std::array<std::size_t, 4>;

struct SurfaceTopology {
  std::size_t vertices = 0;
  std::size_t open_edges = 0;        ///< of one triangle
  std::size_t branching_edges = 0;   ///< of three triangles or more
  std::size_t pinched_vertices = 0;  ///< whose triangles are several fans that share no edge; counted where no edge branches
  std::size_t components = 0;
  long euler = 0;  ///< vertices - edges + triangles, of all components together
};

inline SurfaceTopology surface_topology(const std::vector<Triangle>& triangles, std::size_t point_count) {
  struct Side {
    std::size_t low, high;        // the edge's ends
    std::size_t of_low, of_high;  // the triangle's corners there, as 3 * triangle + place
    bool operator<(const Side& other) const { return std::tie(low, high) < std::tie(other.low, other.high); }
  };
  std::vector<Side> sides;
  for (std::size_t t = 0; t != triangles.size(); ++t)
    for (std::size_t i = 0; i != 3; ++i) {
      Side side{triangles[t][i], triangles[t][(i + 1) % 3], 3 * t + i, 3 * t + (i + 1) % 3};
      if (side.low > side.high) std::swap(side.low, side.high), std::swap(side.of_low, side.of_high);
      sides.push_back(side);
    }
  std::sort(sides.begin(), sides.end());

  SurfaceTopology result;
  DisjointSets pieces(point_count), fans(3 * triangles.size());
  std::size_t edges = 0;
  for (std::size_t i = 0, end = 0; i != sides.size(); i = end, ++edges) {
    for (end = i + 1; end != sides.size() && !(sides[i] < sides[end]); ++end)
      fans.unite(sides[i].of_low, sides[end].of_low), fans.unite(sides[i].of_high, sides[end].of_high);
    pieces.unite(sides[i].low, sides[i].high);
    result.open_edges += end - i == 1;
    result.branching_edges += end - i > 2;
  }
  std::vector<unsigned> fan_count(point_count, 0);
  std::vector<char> used(point_count, 0);
  for (std::size_t corner = 0; corner != 3 * triangles.size(); ++corner) {
    const std::size_t v = triangles[corner / 3][corner % 3];
    used[v] = 1;
    fan_count[v] += fans.find(corner) == corner;
  }
  for (std::size_t v = 0; v != point_count; ++v) {
    result.vertices += used[v] ? 1 : 0;
    result.pinched_vertices += fan_count[v] > 1;
    result.components += used[v] && pieces.find(v) == v;
  }
  result.euler = static_cast<long>(result.vertices) - static_cast<long>(edges) + static_cast<long>(triangles.size());
  return result;
}

/// The triangles between a tetrahedron and none, or one of another region, each once, corners ascending; sorted.
inline std::vector<Triangle> interfaces(const std::vector<Tetrahedron>& tetrahedra, const std::vector<int>& regions) {
  std::vector<std::pair<Triangle, int>> faces;
  faces.reserve(4 * tetrahedra.size());
  for (std::size_t t = 0; t != tetrahedra.size(); ++t)
    for (std::size_t i = 0; i != 4; ++i) {
      Triangle face{tetrahedra[t][(i + 1) % 4], tetrahedra[t][(i + 2) % 4], tetrahedra[t][(i + 3) % 4]};
      std::sort(face.begin(), face.end());
      faces.emplace_back(face, regions[t]);
    }
  std::sort(faces.begin(), faces.end());
  std::vector<Triangle> result;
  for (std::size_t i = 0; i != faces.size();) {
    const bool has_twin = i + 1 != faces.size() && faces[i].first == faces[i + 1].first;
    if (!has_twin || faces[i].second != faces[i + 1].second) result.push_back(faces[i].first);
    i += has_twin ? 2 : 1;
  }
  return result;
}

}  // namespace benchmark
