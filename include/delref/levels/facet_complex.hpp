// SPDX-License-Identifier: GPL-3.0-or-later
//
// The triangulations of all facets of a complex, each in the plane of its facet, kept beside the triangulation of space: its
// triangles are the subfacets that space must show. Points are inserted by flips (Lawson 1977); subsegments are never flipped. A
// tie between cocircular points is settled as the triangulation of space settles it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <delref/core/queue/refinement_queue.hpp>
#include <delref/criteria/circumcentre.hpp>
#include <delref/domain/polyhedral_domain.hpp>
#include <delref/triangulation/simplex_table.hpp>

namespace delref {

/// The constrained Delaunay triangulations of the facets of a `PolyhedralDomain`, over the vertices of `Tr`. The domain must outlive
/// it. Numbers of subfacets that were removed are given again.
template <class Tr>
class FacetComplex {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

 public:
  using Vertex = typename Tr::Vertex;
  using Id = std::uint32_t;
  static constexpr Id none = SimplexTable<3>::none;

  /// A triangle of a facet's triangulation, counterclockwise in the facet's frame.
  struct Subfacet {
    std::array<Vertex, 3> corners{};
    std::array<Id, 3> neighbours{none, none, none};  ///< across the edge opposite to each corner; `none` across a subsegment
    std::uint32_t facet = none;                      ///< the input facet; `none`: not in use
    std::array<int, 2> regions{-1, -1};              ///< in front of it, whence its corners are counterclockwise, and behind it
    QueuePosition slot = -1;
    bool is_present = false;                         ///< the triangulation of space has it
  };
  /// The edge of `subfacet` that is opposite to its corner `side`.
  struct Side {
    Id subfacet = none;
    int side = 0;
  };
  /// Where a point of a facet is: in a subfacet, or behind a subsegment.
  struct Place {
    Id subfacet = none;
    std::optional<Side> blocker;
  };

  FacetComplex(const Tr& tr, const PolyhedralDomain& domain, std::span<const Vertex> vertices) : domain_(&domain) {
    SimplexTable<2> open;  // edges with one triangle so far
    SimplexTable<2> segments;
    for (std::uint32_t s = 0; s < domain.segments.size(); ++s) segments.set(key(domain.segments[s].ends), s);
    for (std::uint32_t f = 0; f < domain.facets.size(); ++f) {
      open.clear();
      for (const auto& t : domain.facets[f].triangles) {
        const Id id = allocate(f, {vertices[t[0]], vertices[t[1]], vertices[t[2]]});
        for (int i = 0; i < 3; ++i) connect(open, segments, id, i, t);
        attach(tr, id);
      }
    }
  }

  const Subfacet& operator[](Id id) const { return subfacets_[id]; }
  Id find(const Tr& tr, Vertex a, Vertex b, Vertex c) const {
    return triangles_.find(SimplexTable<3>::key(tr.index(a), tr.index(b), tr.index(c)));
  }
  void set_present(Id id, bool present) { subfacets_[id].is_present = present; }
  /// What refinement makes of a subfacet has the same regions on its sides: they are bounded by subsegments.
  void set_regions(Id id, std::array<int, 2> regions) { subfacets_[id].regions = regions; }
  /// Calls `f(id)` for each, in the order of their numbers.
  template <class F>
  void for_each(F&& f) const {
    for (Id id = 0; id < subfacets_.size(); ++id)
      if (subfacets_[id].facet != none) f(id);
  }
  std::array<Vertex, 2> ends(Side s) const {
    const auto& c = subfacets_[s.subfacet].corners;
    return {c[place(s.side + 1)], c[place(s.side + 2)]};
  }

  /// The circumcentre of a subfacet, in the plane of its facet. Not finite when the subfacet is flat.
  Point3 circumcentre(const Tr& tr, Id id) const {
    const PlaneFrame& frame = frame_of(id);
    const auto& c = subfacets_[id].corners;
    const Point2 a = project(tr, frame, c[0]);
    const Vector2 u = project(tr, frame, c[1]) - a, v = project(tr, frame, c[2]) - a;
    return frame.lift(a + to_circumcentre(u, v, cross(u, v)));
  }
  /// Whether a point of the facet is strictly inside the circumcircle of a subfacet.
  bool in_circumcircle(const Tr& tr, Id id, Point3 p) const {
    const PlaneFrame& frame = frame_of(id);
    const auto& c = subfacets_[id].corners;
    return side_of_circle(project(tr, frame, c[0]), project(tr, frame, c[1]), project(tr, frame, c[2]), frame.project(p)) > 0;
  }
  /// Walks from a subfacet to a point of its facet.
  Place locate(const Tr& tr, Id from, Point3 p) const;

  /// Splits the subsegment between `a` and `b` in every facet that has it; `v` is the new vertex on it. `removed(id)` is called for
  /// each subfacet before it changes, `created` lists those that are new, all around `v`.
  template <class F>
  void split_subsegment(const Tr& tr, Vertex a, Vertex b, Vertex v, F&& removed, std::vector<Id>& created);
  /// Inserts `v` into the subfacet `id`, in which it was located.
  template <class F>
  void insert(const Tr& tr, Id id, Vertex v, F&& removed, std::vector<Id>& created);

  /// The subfacet and the one across its edge `side`, if their four corners are cocircular as far as rounding lets one tell, so that
  /// the other diagonal is as good. Nothing otherwise.
  std::optional<std::array<Id, 2>> tie(const Tr& tr, Side side) const;
  /// The side that one subfacet shares with another.
  std::optional<Side> side_between(Id a, Id b) const {
    for (int i = 0; i < 3; ++i)
      if (subfacets_[a].neighbours[place(i)] == b) return Side{a, i};
    return std::nullopt;
  }
  /// Whether the subfacet and the one across its edge `side` make a convex quadrilateral, so that the edge can be flipped.
  bool is_convex(const Tr& tr, Side side) const;
  /// The triangles that the other diagonal of a tie would make.
  std::array<std::array<Vertex, 3>, 2> other_triangles(Side side) const;
  /// Takes the other diagonal. Calls `removed(id)` for both before they change; they keep their numbers.
  template <class F>
  void flip(const Tr& tr, Side side, F&& removed);

  // One slot each, for the set of the level that owns the complex.
  QueuePosition slot(Id id, std::size_t) const { return subfacets_[id].slot; }
  void set_slot(Id id, std::size_t, QueuePosition position) { subfacets_[id].slot = position; }
  void clear_slots() {
    for (Subfacet& s : subfacets_) s.slot = -1;
  }

 private:
  static constexpr std::size_t place(int i) { return static_cast<std::size_t>(i % 3); }
  static auto key(const std::array<PolyhedralDomain::Index, 2>& e) { return SimplexTable<2>::key(e[0], e[1]); }
  auto edge_key(const Tr& tr, Side s) const {
    const auto [a, b] = ends(s);
    return SimplexTable<2>::key(tr.index(a), tr.index(b));
  }
  const PlaneFrame& frame_of(Id id) const { return domain_->facets[subfacets_[id].facet].frame; }
  static Point2 project(const Tr& tr, const PlaneFrame& frame, Vertex v) { return frame.project(tr.point(v)); }

  static Kernel::Point_2 cgal(Point2 p) { return {p.x, p.y}; }
  static int orientation(Point2 a, Point2 b, Point2 c) { return CGAL::orientation(cgal(a), cgal(b), cgal(c)); }
  /// Positive when `d` is strictly inside the circle through the others, counterclockwise.
  static int side_of_circle(Point2 a, Point2 b, Point2 c, Point2 d) {
    return CGAL::side_of_oriented_circle(cgal(a), cgal(b), cgal(c), cgal(d));
  }

  Id allocate(std::uint32_t facet, std::array<Vertex, 3> corners) {
    Id id = static_cast<Id>(subfacets_.size());
    if (free_.empty()) subfacets_.emplace_back();
    else id = free_.back(), free_.pop_back();
    subfacets_[id] = Subfacet{};
    subfacets_[id].facet = facet;
    subfacets_[id].corners = corners;
    return id;
  }
  /// A part of a subfacet.
  Id allocate_part(Id of, std::array<Vertex, 3> corners) {
    const Id id = allocate(subfacets_[of].facet, corners);
    subfacets_[id].regions = subfacets_[of].regions;
    return id;
  }
  void connect(SimplexTable<2>& open, const SimplexTable<2>& segments, Id id, int i, const std::array<PolyhedralDomain::Index, 3>& t) {
    const auto edge = SimplexTable<2>::key(t[place(i + 1)], t[place(i + 2)]);
    if (segments.find(edge) != SimplexTable<2>::none) return;
    const auto other = open.find(edge);
    if (other == SimplexTable<2>::none) return open.set(edge, id * 3 + static_cast<Id>(i));
    subfacets_[id].neighbours[place(i)] = other / 3;
    subfacets_[other / 3].neighbours[other % 3] = id;
  }
  /// Enters a subfacet, and its sides on subsegments, into the tables.
  void attach(const Tr& tr, Id id) {
    const auto& c = subfacets_[id].corners;
    triangles_.set(SimplexTable<3>::key(tr.index(c[0]), tr.index(c[1]), tr.index(c[2])), id);
    if (next_.size() < 3 * subfacets_.size()) next_.resize(3 * subfacets_.size(), none);
    for (int i = 0; i < 3; ++i) {
      if (subfacets_[id].neighbours[place(i)] != none) continue;
      const auto k = edge_key(tr, {id, i});
      const Id code = id * 3 + static_cast<Id>(i);
      next_[code] = on_subsegments_.find(k);
      on_subsegments_.set(k, code);
    }
  }
  void detach(const Tr& tr, Id id) {
    const auto& c = subfacets_[id].corners;
    const auto triangle = SimplexTable<3>::key(tr.index(c[0]), tr.index(c[1]), tr.index(c[2]));
    if (triangles_.find(triangle) == id) triangles_.erase(triangle);
    for (int i = 0; i < 3; ++i)
      if (subfacets_[id].neighbours[place(i)] == none) unlink(edge_key(tr, {id, i}), id * 3 + static_cast<Id>(i));
  }
  void unlink(const SimplexTable<2>::Key& k, Id code) {
    Id at = on_subsegments_.find(k);
    if (at == code) {
      if (next_[code] == none) on_subsegments_.erase(k);
      else on_subsegments_.set(k, next_[code]);
      return;
    }
    while (next_[at] != code) at = next_[at];
    next_[at] = next_[code];
  }
  /// Makes `n`, behind the edge `side` of `id`, know it as its neighbour instead of `old`.
  void relink(Id n, Id old, Id id) {
    if (n == none) return;
    for (Id& m : subfacets_[n].neighbours)
      if (m == old) {
        m = id;
        return;
      }
  }
  /// Two subfacets can share two edges (around a vertex inside two of them), so the edge is named by its ends.
  int side_opposite(Id id, Vertex a, Vertex b) const {
    for (int i = 0; i < 3; ++i)
      if (const auto [c, d] = ends({id, i}); (c == a && d == b) || (c == b && d == a)) return i;
    return -1;
  }
  template <class F>
  void legalise(const Tr& tr, Vertex v, F&& removed, std::vector<Id>& created);
  bool is_illegal(const Tr& tr, Side side) const;

  const PolyhedralDomain* domain_;
  std::vector<Subfacet> subfacets_;
  std::vector<Id> free_;
  SimplexTable<3> triangles_;
  SimplexTable<2> on_subsegments_;  // the first of the sides on a subsegment, as 3 * subfacet + side
  std::vector<Id> next_;            // the next of them
  std::vector<Id> stack_;
};

}  // namespace delref

#include <delref/levels/detail/facet_complex_flips.hpp>
