// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds each piece of the input segments in the mesh as a chain of edges. The mesh's own list of subsegments is tried first;
// without one, the search walks along the segment among the vertices that lie on it within the tolerance.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include <delref/core/carrier.hpp>
#include <delref/mesh/twofold.hpp>
#include <delref/mesh/verify/input_domain.hpp>
#include <delref/mesh/verify/subject.hpp>
#include <delref/mesh/verify/topology.hpp>

namespace delref::verification {

/// A vertex of a chain lies within this many units in the last place, of the largest coordinate of the segment, of the segment.
inline constexpr double segment_tolerance_ulps = 4;

/// The line of an input segment, and where points are with respect to it.
class SegmentLine {
 public:
  SegmentLine(Point2 a, Point2 b)
      : a_(a), b_(b), length_(std::sqrt(squared_distance(a, b))),
        tolerance_(segment_tolerance_ulps * ulp(std::max({std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y)}))) {}
  double length() const { return length_; }
  double tolerance() const { return tolerance_; }
  double distance(Point2 p) const { return std::abs(precise_cross(a_, b_, p)) / length_; }
  /// How far along the segment the foot of p is, as a length.
  double along(Point2 p) const { return precise_dot(a_, b_, p) / length_; }

 private:
  Point2 a_, b_;
  double length_, tolerance_;
};

/// The chains of all pieces that border or lie in the domain.
class Chains {
 public:
  Chains(const Subject& subject, const InputDomain& domain, const MeshTopology& topology)
      : subject_(subject), domain_(domain), topology_(topology), piece_of_edge_(topology.edges().size(), none),
        piece_of_vertex_(subject.points.size(), none), input_of_vertex_(subject.points.size(), none),
        vertex_of_input_(subject.input_points.size(), none), seen_(subject.points.size(), none), came_by_(subject.points.size(), none),
        chains_(domain.pieces().size()) {
    match_vertices();
    sort_listed_edges();
    for (Index p = 0; p < domain.pieces().size(); ++p) {
      subject.breathe(p);
      if (domain.bounds_domain(domain.pieces()[p])) find(p);
    }
  }

  /// The mesh vertex at a canonical input vertex, or none; the canonical input vertex at a mesh vertex, or none.
  Index vertex_of_input(Index canonical) const { return vertex_of_input_[canonical]; }
  Index input_of_vertex(Index vertex) const { return input_of_vertex_[vertex]; }
  /// Mesh vertices at an input vertex that another one occupies already.
  std::span<const Index> repeated_vertices() const { return repeated_; }
  /// The vertices of the chain of a piece from end to end; empty when there is none.
  std::span<const Index> chain(Index piece) const { return chains_[piece]; }
  /// The piece that an edge is part of, that a vertex is inside of; or none.
  Index piece_of_edge(Index edge) const { return piece_of_edge_[edge]; }
  Index piece_of_vertex(Index vertex) const { return piece_of_vertex_[vertex]; }
  SegmentLine line(const Piece& piece) const {
    const auto& [a, b] = subject_.input.segments[piece.segments.front()];
    return {subject_.input_points[a], subject_.input_points[b]};
  }
  bool ends_present(const Piece& piece) const {
    return vertex_of_input_[piece.from] != none && vertex_of_input_[piece.to] != none;
  }

 private:
  /// How a step from vertex to vertex is admitted: as a listed subsegment of this segment wherever it lies; as an edge near enough.
  enum class Search { listed, near, loose };

  void match_vertices() {
    std::vector<Index> sorted;
    for (Index v = 0; v < subject_.input_points.size(); ++v)
      if (domain_.canonical(v) == v) sorted.push_back(v);
    const auto less = [](Point2 p, Point2 q) { return p.x != q.x ? p.x < q.x : p.y < q.y; };
    const auto place = [&](Index v) { return subject_.input_points[v]; };
    std::ranges::sort(sorted, less, place);
    for (Index v = 0; v < subject_.points.size(); ++v) {
      if (topology_.star(v).empty()) continue;
      const auto found = std::ranges::lower_bound(sorted, subject_.points[v], less, place);
      if (found == sorted.end() || place(*found) != subject_.points[v]) continue;
      input_of_vertex_[v] = *found;
      if (vertex_of_input_[*found] == none) vertex_of_input_[*found] = v;
      else repeated_.push_back(v);
    }
  }

  /// For each edge of the mesh, the segment that the mesh says it lies on.
  void sort_listed_edges() {
    const PlanarMesh& mesh = subject_.mesh;
    if (mesh.edge_segments.empty()) return;
    listed_segment_.assign(topology_.edges().size(), none);
    for (std::size_t i = 0; i < mesh.edges.size(); ++i)
      if (const Index e = topology_.find(mesh.edges[i][0], mesh.edges[i][1]); e != none) listed_segment_[e] = mesh.edge_segments[i];
  }

  void find(Index p) {
    const Piece& piece = domain_.pieces()[p];
    if (!ends_present(piece)) return;
    const bool found = (!listed_segment_.empty() && search(p, Search::listed)) || search(p, Search::near) || search(p, Search::loose);
    if (!found) return;
    std::vector<Index>& chain = chains_[p];
    for (Index v = vertex_of_input_[piece.to]; v != vertex_of_input_[piece.from]; v = topology_.edges()[came_by_[v]].other(v)) {
      chain.push_back(v);
      piece_of_edge_[came_by_[v]] = p;
      if (input_of_vertex_[v] == none) piece_of_vertex_[v] = p;
    }
    chain.push_back(vertex_of_input_[piece.from]);
    std::ranges::reverse(chain);
  }

  /// Depth first from end to end over vertices that are no input vertices, the most likely neighbour first.
  bool search(Index p, Search how) {
    const Piece& piece = domain_.pieces()[p];
    const Index start = vertex_of_input_[piece.from], goal = vertex_of_input_[piece.to];
    const SegmentLine along = line(piece);
    const double direction = along.along(subject_.points[goal]) > along.along(subject_.points[start]) ? 1 : -1;
    const Index mark = 3 * p + static_cast<Index>(how);
    struct Step {
      double rank;
      Index edge, vertex;
    };
    std::vector<Step> steps;
    std::vector<Index> stack{start};
    seen_[start] = mark;
    while (!stack.empty()) {
      const Index v = stack.back();
      stack.pop_back();
      if (v == goal) return true;
      steps.clear();
      for (const Index e : topology_.star(v)) {
        const Index w = topology_.edges()[e].other(v);
        if (seen_[w] == mark || (w != goal && input_of_vertex_[w] != none) || piece_of_edge_[e] != none) continue;
        if (w != goal && piece_of_vertex_[w] != none) continue;
        const bool admitted = how == Search::listed ? listed_on(piece, e) : ahead(along, v, w, direction, how);
        if (admitted) steps.push_back({rank(piece, along, w), e, w});
      }
      std::ranges::sort(steps, [](const Step& s, const Step& t) { return s.rank != t.rank ? s.rank > t.rank : s.vertex > t.vertex; });
      for (const Step& s : steps) {
        seen_[s.vertex] = mark;
        came_by_[s.vertex] = s.edge;
        stack.push_back(s.vertex);
      }
    }
    return false;
  }

  bool listed_on(const Piece& piece, Index e) const {
    return listed_segment_[e] != none && subject_.is_named(piece.segments, listed_segment_[e]);
  }

  bool ahead(const SegmentLine& along, Index v, Index w, double direction, Search how) const {
    const double tolerance = how == Search::near ? along.tolerance() : along.tolerance() + 1e-6 * along.length();
    const Point2 from = subject_.points[v], to = subject_.points[w];
    return along.distance(to) <= tolerance && direction * (along.along(to) - along.along(from)) > 0;
  }

  /// Vertices that the mesh says lie on this segment come before others, then what is nearer to its line.
  double rank(const Piece& piece, const SegmentLine& along, Index w) const {
    const auto& carriers = subject_.mesh.carriers;
    const bool carried = !carriers.empty() && carriers[w].dimension == 1 && subject_.is_named(piece.segments, carriers[w].index);
    return along.distance(subject_.points[w]) + (carried || input_of_vertex_[w] != none ? 0 : along.length());
  }

  const Subject& subject_;
  const InputDomain& domain_;
  const MeshTopology& topology_;
  std::vector<Index> piece_of_edge_, piece_of_vertex_, input_of_vertex_, vertex_of_input_, repeated_, listed_segment_;
  std::vector<Index> seen_, came_by_;
  std::vector<std::vector<Index>> chains_;
};

}  // namespace delref::verification
