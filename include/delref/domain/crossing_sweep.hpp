// SPDX-License-Identifier: GPL-3.0-or-later
//
// A sweep over segments that finds a set of them without which no two cross or overlap (after Shamos and Hoey 1976, "Geometric
// intersection problems"): when neighbours on the sweep line do, one of the two is set aside and the sweep goes on. O(n log n)
// whatever the input, by exact predicates on input points only. Every crossing involves a segment that was set aside.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <set>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/domain/pslg.hpp>
#include <delref/domain/segment_contact.hpp>

namespace delref {

/// Two segments that cross or overlap, by index; `first` is the lower one.
struct SegmentPair {
  Pslg::Index first, second;
  SegmentContact contact;
  friend bool operator==(const SegmentPair& a, const SegmentPair& b) { return a.first == b.first && a.second == b.second; }
  friend bool operator<(const SegmentPair& a, const SegmentPair& b) {
    return a.first != b.first ? a.first < b.first : a.second < b.second;
  }
};

/// One sweep over the segments of a graph. Requires finite points, valid indices and segments of positive length.
class CrossingSweep {
 public:
  using Index = Pslg::Index;

  /// Sweeps. Throws `Interrupted`. The graph must outlive the object.
  CrossingSweep(const Pslg& pslg, const Control& control) : pslg_(pslg), status_(Below{this}) {
    rank_points();
    place_.resize(pslg.segments.size(), status_.end());
    set_aside_.resize(pslg.segments.size(), false);
    std::size_t steps = 0;
    for (const Event& event : events()) {
      if (++steps % 1024 == 0) throw_if_stopped(control);
      if (event.starts)
        start(event.segment);
      else
        end(event.segment);
    }
  }

  CrossingSweep(const CrossingSweep&) = delete;
  CrossingSweep& operator=(const CrossingSweep&) = delete;

  /// The pairs that made the sweep set one aside, in the order of the sweep.
  const std::vector<SegmentPair>& pairs() const { return pairs_; }
  /// Per segment: whether it was set aside.
  const std::vector<bool>& set_aside() const { return set_aside_; }

 private:
  struct Event {
    std::uint32_t rank;
    bool starts;  // at one point, ends come before starts
    Index segment;
  };
  struct Below {
    const CrossingSweep* sweep;
    bool operator()(Index a, Index b) const { return sweep->below(a, b); }
  };
  using Status = std::set<Index, Below>;

  Point2 left(Index s) const { return pslg_.points[ends_[s][0]]; }
  Point2 right(Index s) const { return pslg_.points[ends_[s][1]]; }

  /// Points with the same coordinates have the same rank. A vertical segment starts at its lower end.
  void rank_points() {
    std::vector<Index> order(pslg_.points.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::sort(order, lexicographically_less, [this](Index i) { return pslg_.points[i]; });
    rank_.resize(order.size());
    for (std::size_t i = 0; i < order.size(); ++i)
      rank_[order[i]] =
          i > 0 && pslg_.points[order[i]] == pslg_.points[order[i - 1]] ? rank_[order[i - 1]] : static_cast<Index>(i);
    ends_ = pslg_.segments;
    for (auto& ends : ends_)
      if (rank_[ends[1]] < rank_[ends[0]]) std::swap(ends[0], ends[1]);
  }

  std::vector<Event> events() const {
    std::vector<Event> events;
    events.reserve(2 * ends_.size());
    for (Index s = 0; s < ends_.size(); ++s) {
      events.push_back({rank_[ends_[s][0]], true, s});
      events.push_back({rank_[ends_[s][1]], false, s});
    }
    std::ranges::sort(events, [](const Event& a, const Event& b) {
      if (a.rank != b.rank) return a.rank < b.rank;
      if (a.starts != b.starts) return !a.starts;
      return a.segment < b.segment;
    });
    return events;
  }

  /// The order of two segments on the sweep line, where the later one starts or just after; collinear ones are equivalent.
  bool below(Index a, Index b) const {
    if (a == b) return false;
    const bool b_is_later = rank_[ends_[a][0]] <= rank_[ends_[b][0]];
    const Index earlier = b_is_later ? a : b, later = b_is_later ? b : a;
    int side = exact_side(left(earlier), right(earlier), left(later));
    if (side == 0) side = exact_side(left(earlier), right(earlier), right(later));
    return b_is_later ? side > 0 : side < 0;
  }

  void start(Index s) {
    const auto [place, is_new] = status_.insert(s);
    if (!is_new) {
      note(s, *place, SegmentContact::overlap);
      set_aside_[s] = true;
      return;
    }
    place_[s] = place;
    if (place != status_.begin()) settle(std::prev(place));
    if (!set_aside_[s]) settle(place);
  }

  void end(Index s) {
    if (set_aside_[s]) return;
    const auto after = status_.erase(place_[s]);
    if (after != status_.begin()) settle(std::prev(after));
  }

  /// Sets segments aside until `lower` (or what takes its place) and its upper neighbour neither cross nor overlap.
  void settle(Status::iterator lower) {
    for (auto upper = std::next(lower); upper != status_.end(); upper = std::next(lower)) {
      const Index a = *lower, b = *upper;
      const SegmentContact found = contact({left(a), right(a)}, {left(b), right(b)});
      if (found == SegmentContact::valid) return;
      note(a, b, found);
      // The one that reaches farther would meet more of the others: this keeps the set small.
      const Index aside = rank_[ends_[a][1]] > rank_[ends_[b][1]] ? a : b;
      set_aside_[aside] = true;
      const auto next = status_.erase(place_[aside]);
      if (aside == b) continue;
      if (next == status_.begin()) return;
      lower = std::prev(next);
    }
  }

  void note(Index a, Index b, SegmentContact found) { pairs_.push_back({std::min(a, b), std::max(a, b), found}); }

  const Pslg& pslg_;
  std::vector<Index> rank_;
  std::vector<std::array<Index, 2>> ends_;  // lower rank first
  Status status_;
  std::vector<Status::iterator> place_;
  std::vector<bool> set_aside_;
  std::vector<SegmentPair> pairs_;
};

}  // namespace delref
