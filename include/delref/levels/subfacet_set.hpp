// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which subfacets the triangulation of space has as faces, and which are to be refined: the state of the facets level, kept up while
// facets and space are triangulated anew around a new vertex.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <delref/core/proposal.hpp>
#include <delref/core/queue/element_set.hpp>
#include <delref/levels/facet_complex.hpp>
#include <delref/triangulation/spatial_concept.hpp>

namespace delref {

/// The subfacets of a complex with their queue. Faces of `Tr` that are subfacets are marked.
template <SpatialTriangulation Tr, class Queue>
class SubfacetSet {
 public:
  using Complex = FacetComplex<Tr>;
  using Id = typename Complex::Id;
  using Vertex = typename Tr::Vertex;
  using Facet = typename Tr::Facet;

  explicit SubfacetSet(Complex complex) : complex_(std::move(complex)) {}

  Complex& complex() { return complex_; }
  const Complex& complex() const { return complex_; }
  const ElementSet<Id, Queue>& queued() const { return set_; }
  /// The number of subfacets that the triangulation does not have.
  std::size_t missing() const { return missing_; }

  /// Looks for every subfacet, and queues those that are missing.
  void scan(Tr& tr) {
    set_.clear();
    complex_.clear_slots();
    missing_ = 0;
    complex_.for_each([&](Id e) {
      complex_.set_present(e, false);
      ++missing_;
      const auto [a, b, c] = complex_[e].corners;
      if (const auto f = tr.find_facet(a, b, c)) found(tr, e, *f);
      if (!complex_[e].is_present) queue(tr, e);
    });
  }

  // -- the queue
  Id next() { return set_.front(); }
  void pop() { set_.pop(complex_); }
  void give_up(Id e) { set_.give_up(complex_, e); }
  bool is_given_up(Id e) const { return set_.is_given_up(complex_, e); }
  /// `cause` is the vertex on another facet that is in the way, if one is.
  void queue(const Tr& tr, Id e, Vertex cause = {}) {
    if (!set_.add(complex_, e, shortest_squared(tr, e))) return;
    if (causes_.size() <= e) causes_.resize(e + e / 2 + 16);
    causes_[e] = cause;
  }
  /// The cause of a subfacet that is queued.
  Vertex cause(Id e) const { return causes_[e]; }
  /// Out of the queue, and not given up any more: the subfacet changes.
  void forget(Id e) {
    set_.erase(complex_, e);
    complex_.set_slot(e, 0, -1);
  }
  double shortest_squared(const Tr& tr, Id e) const {
    const auto [a, b, c] = complex_[e].corners;
    return std::min({squared_distance(tr.point(a), tr.point(b)), squared_distance(tr.point(b), tr.point(c)),
                     squared_distance(tr.point(c), tr.point(a))});
  }

  // -- presence
  /// The triangulation has the subfacet, as `f`.
  void found(Tr& tr, Id e, const Facet& f) {
    tr.mark(f, true);
    if (complex_[e].is_present) return;
    complex_.set_present(e, true);
    --missing_;
  }
  /// An insertion is about to destroy the face.
  void lose(Id e) {
    if (!complex_[e].is_present) return;
    complex_.set_present(e, false);
    ++missing_;
  }
  /// The subfacet and the one beside it take the other diagonal; both are missing then.
  void flip(Tr& tr, typename Complex::Side side) {
    complex_.flip(tr, side, [&](Id removed) {
      forget(removed);
      if (!complex_[removed].is_present) return;
      const auto [a, b, c] = complex_[removed].corners;
      if (const auto f = tr.find_facet(a, b, c)) unmark(tr, *f);
      ++missing_;
    });
  }

  /// After the insertion of a vertex on a facet or segment: `change(removed, created)` triangulates the facets anew. All subfacets that it
  /// creates have the new vertex.
  template <class Change>
  void retriangulate(Tr& tr, Vertex v, std::span<const typename Tr::Cell> new_cells, Change&& change) {
    begin_insertion();
    surviving_.clear();
    change(
        [&](Id e) {
          forget(e);
          if (complex_[e].is_present) surviving_.push_back(complex_[e].corners);
          else --missing_;
        },
        created_);
    for (const auto& [a, b, c] : surviving_)
      if (const auto f = tr.find_facet(a, b, c)) unmark(tr, *f);
    missing_ += created_.size();
    find_created(tr, v, new_cells);
    settle_ties(tr);
    for (const Id e : created_)
      if (!complex_[e].is_present) queue(tr, e);
  }
  /// After that of any other vertex.
  void begin_insertion() { created_.clear(), changed_.clear(); }

  /// The subfacets that the last insertion created, and those that were flipped after it.
  const std::vector<Id>& created() const { return created_; }
  /// Faces that were there before the last insertion and are subfacets only since then, or no longer.
  const std::vector<Facet>& changed() const { return changed_; }

 private:
  /// A face that is no subfacet any more, though the insertion left it in place.
  void unmark(Tr& tr, const Facet& f) {
    tr.mark(f, false);
    changed_.push_back(f);
  }
  /// Which of the new subfacets are faces of the new cells.
  void find_created(Tr& tr, Vertex v, std::span<const typename Tr::Cell> new_cells) {
    for (const auto c : new_cells)
      for (int i = 0; i < 4; ++i) {
        if (tr.vertex(c, i) == v) continue;
        std::array<Vertex, 2> others;
        std::size_t n = 0;
        for (int k = 0; k < 4; ++k)
          if (k != i && !(tr.vertex(c, k) == v)) others[n++] = tr.vertex(c, k);
        const auto e = std::ranges::find_if(created_, [&](Id id) { return has_corners(id, v, others[0], others[1]); });
        if (e != created_.end() && !complex_[*e].is_present) found(tr, *e, tr.facet(c, i));
      }
  }
  bool has_corners(Id e, Vertex a, Vertex b, Vertex c) const {
    const auto& corners = complex_[e].corners;
    const auto has = [&](Vertex v) { return corners[0] == v || corners[1] == v || corners[2] == v; };
    return has(b) && has(c) && has(a);
  }

  /// Cocircular corners have two triangulations; where the triangulation of space has the other one, that is taken.
  void settle_ties(Tr& tr) {
    for (std::size_t rounds = 0; rounds < 4; ++rounds) {
      bool changed = false;
      for (std::size_t k = 0; k < created_.size(); ++k)
        if (!complex_[created_[k]].is_present) changed = settle_tie(tr, created_[k]) || changed;
      if (!changed) return;
    }
  }
  bool settle_tie(Tr& tr, Id e) {
    for (int side = 0; side < 3; ++side) {
      const auto pair = complex_.tie(tr, {e, side});
      if (!pair) continue;
      const auto others = complex_.other_triangles({e, side});
      std::array<std::optional<Facet>, 2> facets;
      for (std::size_t i = 0; i < 2; ++i) facets[i] = tr.find_facet(others[i][0], others[i][1], others[i][2]);
      const int now = int{complex_[(*pair)[0]].is_present} + int{complex_[(*pair)[1]].is_present};
      if (int{facets[0].has_value()} + int{facets[1].has_value()} <= now) continue;
      flip(tr, {e, side});
      for (std::size_t i = 0; i < 2; ++i) {
        if (std::ranges::find(created_, (*pair)[i]) == created_.end()) created_.push_back((*pair)[i]);
        if (!facets[i]) continue;
        changed_.push_back(*facets[i]);
        found(tr, (*pair)[i], *facets[i]);
      }
      return true;
    }
    return false;
  }

  Complex complex_;
  std::vector<Vertex> causes_;  // by subfacet that is queued
  ElementSet<Id, Queue> set_;
  std::size_t missing_ = 0;
  std::vector<Id> created_;
  std::vector<std::array<Vertex, 3>> surviving_;
  std::vector<Facet> changed_;
};

}  // namespace delref
