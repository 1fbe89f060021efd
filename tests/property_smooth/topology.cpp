// SPDX-License-Identifier: GPL-3.0-or-later
#include "topology.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <span>
#include <utility>

#include <delref/domain/disjoint_sets.hpp>

namespace delref::property_smooth {
namespace {

/// Which nodes of a grid are in a region. A layer around it is outside.
class Grid {
 public:
  Grid(const Domain& domain, int region, std::size_t steps) {
    const auto [low, high] = domain.bounds();
    const double step = domain.bounds().extent() / static_cast<double>(steps);
    const auto count = [&](double length) { return static_cast<std::size_t>(std::ceil(length / step)) + 3; };
    size_ = {count(high.x - low.x), count(high.y - low.y), count(high.z - low.z)};
    inside_.assign(size_[0] * size_[1] * size_[2], false);
    // A little off what is regular in many domains.
    const Point3 start = low + Vector3{-0.49712 * step, -0.48361 * step, -0.47918 * step};
    std::vector<Point3> row;
    std::vector<std::size_t> at;
    std::vector<int> labels;
    for (std::size_t k = 1; k + 1 < size_[2]; ++k)
      for (std::size_t j = 1; j + 1 < size_[1]; ++j) {
        row.clear(), at.clear();
        for (std::size_t i = 1; i + 1 < size_[0]; ++i) {
          const Point3 p = start + step * Vector3{static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)};
          if (p.x < low.x || p.x > high.x || p.y < low.y || p.y > high.y || p.z < low.z || p.z > high.z) continue;
          row.push_back(p), at.push_back(node(i, j, k));
        }
        labels.resize(row.size());
        domain.label(row, labels);
        for (std::size_t n = 0; n < row.size(); ++n) inside_[at[n]] = labels[n] == region;
      }
  }
  std::size_t node(std::size_t i, std::size_t j, std::size_t k) const { return (k * size_[1] + j) * size_[0] + i; }
  /// The node at the corner of the cube of node `n` that the bits say.
  std::size_t corner(std::size_t n, unsigned bits) const {
    return n + (bits & 1u) + (bits >> 1 & 1u) * size_[0] + (bits >> 2 & 1u) * size_[0] * size_[1];
  }
  std::size_t nodes() const { return inside_.size(); }
  bool inside(std::size_t n) const { return inside_[n]; }
  template <class F>
  void for_each_cube(F&& f) const {
    for (std::size_t k = 0; k + 1 < size_[2]; ++k)
      for (std::size_t j = 0; j + 1 < size_[1]; ++j)
        for (std::size_t i = 0; i + 1 < size_[0]; ++i) f(node(i, j, k));
  }

 private:
  std::array<std::size_t, 3> size_{};
  std::vector<bool> inside_;
};

}  // namespace

// The simplices of a cube that contain its first node are the chains of its corners, by inclusion of their bits (Freudenthal 1942). A
// crossed edge is a vertex of the surface, a crossed triangle an edge, a crossed tetrahedron a polygon.
Topology counted_topology(const Domain& domain, int region, std::size_t steps) {
  const Grid grid(domain, region, steps);
  const auto includes = [](unsigned big, unsigned small) { return big != small && (big & small) == small; };
  std::vector<std::uint32_t> number(grid.nodes() * 8, 0);  // of crossed edges, by first node and bits; 0: not crossed
  std::uint32_t vertices = 0;
  long euler = 0;
  std::vector<std::array<std::uint32_t, 2>> same;
  const auto edge = [&](std::size_t n, unsigned a, unsigned b) -> std::uint32_t { return number[grid.corner(n, a) * 8 + (b - a)]; };
  grid.for_each_cube([&](std::size_t n) {
    for (unsigned a = 1; a < 8; ++a)
      if (grid.inside(n) != grid.inside(grid.corner(n, a))) number[n * 8 + a] = ++vertices;
  });
  euler = static_cast<long>(vertices);
  grid.for_each_cube([&](std::size_t n) {
    for (unsigned a = 1; a < 8; ++a)
      for (unsigned b = 1; b < 8; ++b) {
        if (!includes(b, a)) continue;
        const bool at_n = grid.inside(n), at_a = grid.inside(grid.corner(n, a)), at_b = grid.inside(grid.corner(n, b));
        if (at_n != at_a || at_n != at_b) {
          --euler;
          std::uint32_t first = 0;
          for (const std::uint32_t e : {edge(n, 0, a), edge(n, 0, b), edge(n, a, b)}) {
            if (e != 0 && first != 0) same.push_back({first, e});
            if (e != 0) first = e;
          }
        }
        if (b == 7 || (at_n == at_a && at_n == at_b && at_n == grid.inside(grid.corner(n, 7)))) continue;
        ++euler;
      }
  });
  DisjointSets sets(vertices + 1);
  for (const auto& [a, b] : same) sets.unite(a, b);
  Topology result{0, euler};
  for (std::uint32_t e = 1; e <= vertices; ++e) result.components += sets.find(e) == e;
  return result;
}

std::optional<Topology> sure_topology(const Domain& domain, int region, std::size_t steps) {
  const Topology fine = counted_topology(domain, region, steps);
  if (counted_topology(domain, region, steps / 2) == fine) return fine;
  return std::nullopt;
}

Topology topology_of(const TetrahedralMesh& mesh) {
  std::set<std::array<TetrahedralMesh::Index, 2>> edges;
  std::set<TetrahedralMesh::Index> vertices;
  DisjointSets sets(mesh.points.size());
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto a = t[i], b = t[(i + 1) % 3];
      edges.insert({std::min(a, b), std::max(a, b)});
      vertices.insert(a);
      sets.unite(a, b);
    }
  Topology result;
  result.euler_characteristic = static_cast<long>(vertices.size()) - static_cast<long>(edges.size()) + static_cast<long>(mesh.triangles.size());
  for (const auto v : vertices) result.components += sets.find(v) == v;
  return result;
}

}  // namespace delref::property_smooth
