// SPDX-License-Identifier: GPL-3.0-or-later
//
// The edges of the triangles of a surface, and the triangles at its vertices, both found by sorting.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <delref/mesh/verify_smooth/subject.hpp>

namespace delref::verification_smooth {

class SurfaceGraph {
 public:
  /// A side of a triangle.
  struct Side {
    Index low, high, triangle;
    friend auto operator<=>(const Side&, const Side&) = default;
  };

  /// Requires valid indices.
  explicit SurfaceGraph(const Subject& s) : begin_(s.points.size() + 2, 0) {
    const auto& triangles = s.mesh.triangles;
    sides_.reserve(3 * triangles.size());
    for (Index t = 0; t < triangles.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i) {
        const Index a = triangles[t][i], b = triangles[t][(i + 1) % 3];
        sides_.push_back({std::min(a, b), std::max(a, b), t});
        ++begin_[a + 2];
      }
    throw_if_stopped(s.control);
    std::ranges::sort(sides_);
    throw_if_stopped(s.control);
    for (std::size_t v = 2; v < begin_.size(); ++v) begin_[v] += begin_[v - 1];
    at_vertex_.resize(sides_.size());
    for (Index t = 0; t < triangles.size(); ++t)
      for (const Index v : triangles[t]) at_vertex_[begin_[v + 1]++] = t;
  }

  /// Calls f(sides) with the sides of triangles that are on one edge, for every edge.
  template <class F>
  void for_each_edge(F&& f) const {
    for (std::size_t i = 0, j = 0; i < sides_.size(); i = j) {
      while (j < sides_.size() && sides_[j].low == sides_[i].low && sides_[j].high == sides_[i].high) ++j;
      f(std::span(sides_).subspan(i, j - i));
    }
  }
  std::span<const Index> triangles_at(Index v) const {
    return std::span(at_vertex_).subspan(begin_[v], begin_[v + 1] - begin_[v]);
  }
  bool is_on_surface(Index v) const { return begin_[v] != begin_[v + 1]; }

 private:
  std::vector<Side> sides_;
  std::vector<std::size_t> begin_;
  std::vector<Index> at_vertex_;
};

}  // namespace delref::verification_smooth
