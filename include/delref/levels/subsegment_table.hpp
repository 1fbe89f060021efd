// SPDX-License-Identifier: GPL-3.0-or-later
//
// The subsegments of a complex in space: triangulations of space store no edges, so the edges level keeps them here, found by the
// numbers of their ends.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <delref/core/queue/refinement_queue.hpp>
#include <delref/triangulation/simplex_table.hpp>

namespace delref {

/// Subsegments between vertices of `Tr`, present in it or not. Numbers of subsegments that were removed are given again.
template <class Tr>
class SubsegmentTable {
 public:
  using Vertex = typename Tr::Vertex;
  using Id = std::uint32_t;
  static constexpr Id none = SimplexTable<2>::none;

  struct Subsegment {
    std::array<Vertex, 2> ends{};
    std::uint32_t segment = none;  ///< the input segment that it is a part of; `none`: not in use
    QueuePosition slot = -1;
    Vertex cause{};  ///< while it is queued: the vertex that encroaches it, if one is known
  };

  Id add(const Tr& tr, Vertex a, Vertex b, std::uint32_t segment) {
    Id id = static_cast<Id>(subsegments_.size());
    if (free_.empty()) subsegments_.emplace_back();
    else id = free_.back(), free_.pop_back();
    subsegments_[id] = {{a, b}, segment, -1, {}};
    table_.set(key(tr, a, b), id);
    return id;
  }
  void remove(const Tr& tr, Id id) {
    Subsegment& s = subsegments_[id];
    table_.erase(key(tr, s.ends[0], s.ends[1]));
    s.segment = none;
    free_.push_back(id);
  }
  Id find(const Tr& tr, Vertex a, Vertex b) const { return table_.find(key(tr, a, b)); }
  const Subsegment& operator[](Id id) const { return subsegments_[id]; }

  void set_cause(Id id, Vertex cause) { subsegments_[id].cause = cause; }
  /// Calls `f(id)` for each, in the order of their numbers.
  template <class F>
  void for_each(F&& f) const {
    for (Id id = 0; id < subsegments_.size(); ++id)
      if (subsegments_[id].segment != none) f(id);
  }

  // One slot each, for the set of the level that owns the table.
  QueuePosition slot(Id id, std::size_t) const { return subsegments_[id].slot; }
  void set_slot(Id id, std::size_t, QueuePosition position) { subsegments_[id].slot = position; }
  void clear_slots() {
    for (Subsegment& s : subsegments_) s.slot = -1;
  }

 private:
  static auto key(const Tr& tr, Vertex a, Vertex b) { return SimplexTable<2>::key(tr.index(a), tr.index(b)); }

  std::vector<Subsegment> subsegments_;
  std::vector<Id> free_;
  SimplexTable<2> table_;
};

}  // namespace delref
