// SPDX-License-Identifier: GPL-3.0-or-later
//
// The edges of an indexed triangle mesh, found by sorting the half-edges at each vertex. A half-edge is numbered 3 t + k and
// goes from corner k of triangle t to the next corner; the triangle is on its left.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <delref/mesh/planar_mesh.hpp>

namespace delref::verification {

using Index = std::uint32_t;
inline constexpr Index none = std::numeric_limits<Index>::max();

class MeshTopology {
 public:
  struct Edge {
    Index a, b;            ///< a < b
    Index forward = none;  ///< the half-edge from a to b
    Index back = none;     ///< the half-edge from b to a
    bool crowded = false;  ///< more than one half-edge in one direction

    bool boundary() const { return (forward == none) != (back == none); }
    Index other(Index vertex) const { return vertex == a ? b : a; }
    /// The half-edge that leaves `vertex`, which is a or b.
    Index leaving(Index vertex) const { return vertex == a ? forward : back; }
  };

  /// Requires valid indices. Expected time linear for bounded degrees.
  explicit MeshTopology(const PlanarMesh& mesh) : triangles_(mesh.triangles), edge_of_(3 * mesh.triangles.size()) {
    find_edges(mesh.points.size());
    find_stars(mesh.points.size());
  }

  std::span<const Edge> edges() const { return edges_; }
  /// The indices of the edges at a vertex.
  std::span<const Index> star(Index vertex) const {
    return std::span(star_).subspan(star_begin_[vertex], star_begin_[vertex + 1] - star_begin_[vertex]);
  }
  Index edge_of(Index half_edge) const { return edge_of_[half_edge]; }
  Index origin(Index half_edge) const { return triangles_[half_edge / 3][half_edge % 3]; }
  /// The corner that faces a half-edge in its triangle.
  Index apex(Index half_edge) const { return triangles_[half_edge / 3][(half_edge % 3 + 2) % 3]; }
  static Index previous(Index half_edge) { return half_edge % 3 == 0 ? half_edge + 2 : half_edge - 1; }
  /// The half-edge on the other side, or none.
  Index twin(Index half_edge) const {
    const Edge& e = edges_[edge_of_[half_edge]];
    return e.forward == half_edge ? e.back : e.forward;
  }
  /// The edge between two vertices, or none.
  Index find(Index v, Index w) const {
    if (star(w).size() < star(v).size()) std::swap(v, w);
    for (const Index e : star(v))
      if (edges_[e].other(v) == w) return e;
    return none;
  }

 private:
  struct Outgoing {
    Index to, half_edge;
    friend bool operator<(Outgoing p, Outgoing q) { return p.to != q.to ? p.to < q.to : p.half_edge < q.half_edge; }
  };

  void find_edges(std::size_t vertex_count) {
    std::vector<Index> begin(vertex_count + 2, 0);
    const auto each = [&](auto&& take) {
      for (std::size_t t = 0; t < triangles_.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
          const Index from = triangles_[t][k], to = triangles_[t][(k + 1) % 3];
          take(std::min(from, to), Outgoing{std::max(from, to), static_cast<Index>(3 * t + k)});
        }
    };
    each([&](Index low, Outgoing) { ++begin[low + 2]; });
    for (std::size_t i = 2; i < begin.size(); ++i) begin[i] += begin[i - 1];
    std::vector<Outgoing> bucket(3 * triangles_.size());
    each([&](Index low, Outgoing o) { bucket[begin[low + 1]++] = o; });
    edges_.reserve(bucket.size() / 2 + 1);
    for (Index v = 0; v < vertex_count; ++v) {
      std::sort(bucket.begin() + begin[v], bucket.begin() + begin[v + 1]);
      for (std::size_t i = begin[v]; i < begin[v + 1]; ++i) add(v, bucket[i]);
    }
  }

  void add(Index v, Outgoing o) {
    if (edges_.empty() || edges_.back().a != v || edges_.back().b != o.to) edges_.push_back({v, o.to});
    Edge& e = edges_.back();
    Index& side = origin(o.half_edge) == v ? e.forward : e.back;
    if (side == none) side = o.half_edge;
    else e.crowded = true;
    edge_of_[o.half_edge] = static_cast<Index>(edges_.size() - 1);
  }

  void find_stars(std::size_t vertex_count) {
    star_begin_.assign(vertex_count + 2, 0);
    for (const Edge& e : edges_)
      for (const Index v : {e.a, e.b}) ++star_begin_[v + 2];
    for (std::size_t i = 2; i < star_begin_.size(); ++i) star_begin_[i] += star_begin_[i - 1];
    star_.resize(2 * edges_.size());
    for (Index i = 0; i < edges_.size(); ++i)
      for (const Index v : {edges_[i].a, edges_[i].b}) star_[star_begin_[v + 1]++] = i;
    star_begin_.pop_back();
  }

  std::span<const std::array<Index, 3>> triangles_;
  std::vector<Edge> edges_;
  std::vector<Index> edge_of_;
  std::vector<Index> star_begin_, star_;
};

}  // namespace delref::verification
