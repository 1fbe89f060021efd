// SPDX-License-Identifier: GPL-3.0-or-later
//
// The facets between cells of different label: the surface of a restricted Delaunay triangulation, closed by construction. Kept
// beside the triangulation; the slot of a facet holds its number here.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <delref/core/point.hpp>
#include <delref/core/queue/refinement_queue.hpp>
#include <delref/triangulation/spatial_concept.hpp>

namespace delref {

/// The facets of the surface in `Tr`, numbered; numbers of facets that are gone are used again.
template <SpatialTriangulation Tr>
class SurfaceComplex {
 public:
  using Facet = typename Tr::Facet;
  using Vertex = typename Tr::Vertex;

  struct Record {
    Facet facet;                          ///< seen from one of its cells
    std::array<Vertex, 3> corners{};
    Point3 centre;                        ///< of its surface ball
    double squared_radius = 0;            ///< of that ball; negative for a number that is not in use
    std::array<int, 2> regions{};         ///< on its two sides, the greater first
    QueuePosition position = -1;          ///< its place in the set of its level
    std::array<QueuePosition, 3> next{};  ///< in the list of the facets at each corner
  };

  void assign_slot(std::size_t k) { slot_ = k; }
  void clear() {
    records_.clear(), unused_.clear(), first_at_.clear();
    is_linked_ = false;
  }
  std::size_t size() const { return records_.size() - unused_.size(); }

  /// The number of a facet; negative when it is not on the surface.
  QueuePosition number(const Tr& tr, const Facet& f) const { return tr.slot(f, slot_); }
  bool contains(const Tr& tr, const Facet& f) const { return number(tr, f) >= 0; }
  Record& operator[](QueuePosition i) { return records_[static_cast<std::size_t>(i)]; }
  const Record& operator[](QueuePosition i) const { return records_[static_cast<std::size_t>(i)]; }

  QueuePosition add(Tr& tr, const Record& record) {
    QueuePosition i = static_cast<QueuePosition>(records_.size());
    if (unused_.empty()) records_.push_back(record);
    else {
      i = unused_.back();
      unused_.pop_back();
      (*this)[i] = record;
    }
    tr.set_slot(record.facet, slot_, i);
    if (is_linked_) link(tr, i);
    return i;
  }
  void remove(Tr& tr, const Facet& f) {
    const QueuePosition i = number(tr, f);
    tr.set_slot(f, slot_, -1);
    Record& gone = (*this)[i];
    for (std::size_t k = 0; is_linked_ && k < 3; ++k) {
      QueuePosition* at = &first_at_[tr.index(gone.corners[k])];
      while (*at != i) at = &(*this)[*at].next[corner(*at, gone.corners[k])];
      *at = gone.next[k];
    }
    gone.squared_radius = -1;
    unused_.push_back(i);
  }
  /// Lists the facets at each vertex, and keeps these lists from now on.
  void link(const Tr& tr) {
    if (std::exchange(is_linked_, true)) return;
    for (std::size_t i = 0; i < records_.size(); ++i)
      if (records_[i].squared_radius >= 0) link(tr, static_cast<QueuePosition>(i));
  }
  bool is_linked() const { return is_linked_; }
  /// Calls f(number) for each facet at a vertex; for none unless they are listed.
  template <class F>
  void for_each_at(const Tr& tr, Vertex v, F&& f) const {
    const std::size_t index = tr.index(v);
    if (index >= first_at_.size()) return;
    for (QueuePosition i = first_at_[index]; i >= 0; i = (*this)[i].next[corner(i, v)]) f(i);
  }
  /// Calls f(record) for each facet, in the order of their numbers.
  template <class F>
  void for_each(F&& f) const {
    for (const Record& r : records_)
      if (r.squared_radius >= 0) f(r);
  }

 private:
  void link(const Tr& tr, QueuePosition i) {
    for (std::size_t k = 0; k < 3; ++k) {
      QueuePosition& first = first_at(tr.index((*this)[i].corners[k]));
      (*this)[i].next[k] = first;
      first = i;
    }
  }
  std::size_t corner(QueuePosition i, Vertex v) const {
    const auto& corners = (*this)[i].corners;
    return corners[0] == v ? 0 : corners[1] == v ? 1 : 2;
  }
  QueuePosition& first_at(std::size_t vertex) {
    if (vertex >= first_at_.size()) first_at_.resize(vertex + vertex / 2 + 1, -1);
    return first_at_[vertex];
  }

  std::vector<Record> records_;
  std::vector<QueuePosition> unused_;
  std::vector<QueuePosition> first_at_;  // by vertex number
  std::size_t slot_ = 0;
  bool is_linked_ = false;
};

}  // namespace delref
