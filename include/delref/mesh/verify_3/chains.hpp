// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds each segment of the input in the mesh as a chain of edges, by walking from end to end along its line: over the edges that
// the mesh lists as lying on segments or, when it lists none, over those of listed triangles and, for segments on no facet, all
// others.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <delref/mesh/twofold.hpp>
#include <delref/mesh/verify_3/input_complex.hpp>
#include <delref/mesh/verify_3/subject.hpp>
#include <delref/mesh/verify_3/topology.hpp>

namespace delref::verification_3 {

/// A vertex of a chain lies within this many units in the last place, of the largest coordinate of the segment, of the segment.
inline constexpr double segment_tolerance_ulps = 4;

/// The line of an input segment, and where points are with respect to it.
class SegmentLine {
 public:
  SegmentLine(Point3 a, Point3 b)
      : a_(a),
        b_(b),
        length_(std::sqrt(squared_distance(a, b))),
        ulp_(verification::ulp(
            std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z), std::abs(b.x), std::abs(b.y), std::abs(b.z)}))) {}
  double length() const { return length_; }
  double ulp() const { return ulp_; }
  double tolerance() const { return segment_tolerance_ulps * ulp_; }
  double distance(Point3 p) const {
    const double x = precise_cross({a_.y, a_.z}, {b_.y, b_.z}, {p.y, p.z});
    const double y = precise_cross({a_.z, a_.x}, {b_.z, b_.x}, {p.z, p.x});
    const double z = precise_cross({a_.x, a_.y}, {b_.x, b_.y}, {p.x, p.y});
    return std::sqrt(x * x + y * y + z * z) / length_;
  }
  /// How far along the segment the foot of p is, as a length.
  double along(Point3 p) const { return dot(b_ - a_, p - a_) / length_; }

 private:
  Point3 a_, b_;
  double length_, ulp_;
};

/// An edge of the mesh, lower vertex first, and something about it.
struct EdgeEntry {
  Index a, b, value;
  friend auto operator<=>(const EdgeEntry&, const EdgeEntry&) = default;
};

/// The entries of an edge in a sorted list.
inline std::span<const EdgeEntry> entries_of(std::span<const EdgeEntry> sorted, Index v, Index w) {
  const std::pair key(std::min(v, w), std::max(v, w));
  const auto range = std::ranges::equal_range(sorted, key, {}, [](const EdgeEntry& e) { return std::pair(e.a, e.b); });
  return {range.begin(), range.end()};
}

class Chains {
 public:
  Chains(const Subject& subject, const InputComplex& complex, const MeshTopology& topology)
      : s_(subject),
        complex_(complex),
        vertex_of_input_(subject.input_points.size(), none),
        input_of_vertex_(subject.points.size(), none),
        chains_(complex.sides().size()) {
    find_present(topology);
    match_vertices();
    collect_edges();
    for (Index i = 0; i < chains_.size(); ++i) {
      s_.breathe(i);
      find(i);
    }
    std::ranges::sort(edges_);
  }

  /// The mesh vertex at a canonical input vertex, or none; the canonical input vertex at a mesh vertex, or none.
  Index vertex_of_input(Index canonical) const { return vertex_of_input_[canonical]; }
  Index input_of_vertex(Index vertex) const { return input_of_vertex_[vertex]; }
  /// Pairs of mesh vertices at one place.
  std::span<const std::pair<Index, Index>> repeated_vertices() const { return repeated_; }
  /// Whether an element of the mesh has that vertex.
  bool present(Index vertex) const { return present_[vertex]; }
  /// The vertices of the chain of a side from a to b; empty when there is none.
  std::span<const Index> chain(Index side) const { return chains_[side]; }
  /// Edges of chains with their side, sorted.
  std::span<const EdgeEntry> edges() const { return edges_; }
  SegmentLine line(Index side) const {
    const Side& its = complex_.sides()[side];
    return {s_.input_points[its.a], s_.input_points[its.b]};
  }
  bool ends_present(Index side) const {
    const Side& its = complex_.sides()[side];
    return vertex_of_input_[its.a] != none && vertex_of_input_[its.b] != none;
  }

 private:
  void find_present(const MeshTopology& topology) {
    present_.assign(s_.points.size(), false);
    for (Index v = 0; v < s_.points.size(); ++v) present_[v] = topology.used(v);
    for (const auto& triangle : s_.mesh.triangles)
      for (const Index v : triangle) present_[v] = true;
    for (const auto& edge : s_.mesh.edges)
      for (const Index v : edge) present_[v] = true;
  }

  void match_vertices() {
    std::vector<std::pair<Point3, Index>> sorted;
    const auto less = [](const auto& p, const auto& q) {
      const auto key = [](const auto& e) { return std::array{e.first.x, e.first.y, e.first.z}; };
      return key(p) != key(q) ? key(p) < key(q) : p.second < q.second;
    };
    for (Index v = 0; v < s_.points.size(); ++v)
      if (present_[v]) sorted.push_back({s_.points[v], v});
    std::ranges::sort(sorted, less);
    for (std::size_t i = 1; i < sorted.size(); ++i)
      if (sorted[i].first == sorted[i - 1].first) repeated_.push_back({sorted[i - 1].second, sorted[i].second});
    for (Index v = 0; v < s_.input_points.size(); ++v) {
      const auto found = std::ranges::lower_bound(sorted, std::pair(s_.input_points[v], Index{0}), less);
      if (found == sorted.end() || found->first != s_.input_points[v]) continue;
      const Index c = complex_.canonical(v);
      input_of_vertex_[found->second] = c;
      if (vertex_of_input_[c] == none) vertex_of_input_[c] = found->second;
    }
  }

  void collect_edges() {
    std::vector<std::pair<Index, Index>> both_ways;
    const auto add = [&](Index v, Index w) { both_ways.push_back({v, w}), both_ways.push_back({w, v}); };
    for (const auto& [v, w] : s_.mesh.edges) add(v, w);
    if (s_.mesh.edges.empty()) {
      for (const auto& [a, b, c] : s_.mesh.triangles) add(a, b), add(b, c), add(c, a);
      if (std::ranges::any_of(complex_.sides(), [](const Side& side) { return side.facets.empty(); }))
        for (const auto& t : s_.mesh.tetrahedra)
          for (const auto& [i, j] : TetrahedronMeasures::edge_corners) add(t[i], t[j]);
    }
    throw_if_stopped(s_.control);
    std::ranges::sort(both_ways);
    both_ways.erase(std::ranges::unique(both_ways).begin(), both_ways.end());
    star_begin_.assign(s_.points.size() + 1, 0);
    for (const auto& [v, w] : both_ways) ++star_begin_[v + 1];
    for (std::size_t i = 1; i < star_begin_.size(); ++i) star_begin_[i] += star_begin_[i - 1];
    for (const auto& [v, w] : both_ways) star_.push_back(w);
  }

  void find(Index i) {
    if (!ends_present(i)) return;
    std::vector<Index>& chain = chains_[i];
    const SegmentLine along = line(i);
    if (!walk(i, along, along.tolerance(), chain) && !walk(i, along, along.tolerance() + 1e-6 * along.length(), chain)) {
      chain.clear();
      return;
    }
    for (std::size_t k = 1; k < chain.size(); ++k)
      edges_.push_back({std::min(chain[k - 1], chain[k]), std::max(chain[k - 1], chain[k]), i});
  }

  /// Goes to the nearest vertex ahead, again and again; whether the other end was reached.
  bool walk(Index i, const SegmentLine& along, double tolerance, std::vector<Index>& chain) const {
    const Index goal = vertex_of_input_[complex_.sides()[i].b];
    chain.assign(1, vertex_of_input_[complex_.sides()[i].a]);
    double here = 0;
    while (chain.back() != goal) {
      Index next = none;
      double nearest = std::numeric_limits<double>::infinity();
      for (std::size_t k = star_begin_[chain.back()]; k < star_begin_[chain.back() + 1]; ++k) {
        const Index w = star_[k];
        const double there = w == goal ? along.length() : along.along(s_.points[w]);
        if (there > here && there < nearest && there <= along.length() && along.distance(s_.points[w]) <= tolerance)
          nearest = there, next = w;
      }
      if (next == none) return false;
      chain.push_back(next);
      here = nearest;
    }
    return true;
  }

  const Subject& s_;
  const InputComplex& complex_;
  std::vector<bool> present_;
  std::vector<Index> vertex_of_input_, input_of_vertex_;
  std::vector<std::pair<Index, Index>> repeated_;
  std::vector<std::size_t> star_begin_;
  std::vector<Index> star_;
  std::vector<std::vector<Index>> chains_;
  std::vector<EdgeEntry> edges_;
};

}  // namespace delref::verification_3
