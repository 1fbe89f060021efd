// SPDX-License-Identifier: GPL-3.0-or-later
//
// Unordered pairs of vertices, each once, found by their ends in the time of a short search. Sorted by buckets of the lower end:
// linear where vertices have few segments, and independent of the order in which pairs come.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace delref {

/// A set of segments between vertices, numbered by their lower, then their higher end.
class SegmentTable {
 public:
  using Index = std::uint32_t;
  using Ends = std::array<Index, 2>;
  static constexpr Index none = std::numeric_limits<Index>::max();

  SegmentTable() = default;
  /// All pairs of all `lists`, in any order and direction, repeated or not. Requires that the two ends differ and are less than
  /// `vertex_count`.
  SegmentTable(std::size_t vertex_count, std::initializer_list<std::span<const Ends>> lists) : begin_(vertex_count + 1, 0) {
    for (const auto list : lists)
      for (const auto& [a, b] : list) ++begin_[std::min(a, b) + 1];
    for (std::size_t v = 0; v < vertex_count; ++v) begin_[v + 1] += begin_[v];
    std::vector<Index> high(begin_.back()), place(begin_.begin(), begin_.end() - 1);
    for (const auto list : lists)
      for (const auto& [a, b] : list) high[place[std::min(a, b)]++] = std::max(a, b);
    unite(high);
  }

  std::size_t size() const { return ends_.size(); }
  const Ends& operator[](std::size_t s) const { return ends_[s]; }
  std::span<const Ends> all() const { return ends_; }

  /// The number of the segment between two vertices, in either direction; `none` if there is none.
  Index find(Index a, Index b) const {
    if (b < a) std::swap(a, b);
    const auto first = ends_.begin() + begin_[a], last = ends_.begin() + begin_[a + 1];
    const auto found = std::lower_bound(first, last, b, [](const Ends& ends, Index high) { return ends[1] < high; });
    return found != last && (*found)[1] == b ? static_cast<Index>(found - ends_.begin()) : none;
  }

 private:
  void unite(std::vector<Index>& high) {
    for (std::size_t v = 0; v + 1 < begin_.size(); ++v) {
      const auto first = high.begin() + begin_[v], last = high.begin() + begin_[v + 1];
      begin_[v] = static_cast<Index>(ends_.size());
      std::sort(first, last);
      for (auto h = first; h != last; ++h)
        if (h == first || *h != *(h - 1)) ends_.push_back({static_cast<Index>(v), *h});
    }
    begin_.back() = static_cast<Index>(ends_.size());
  }

  std::vector<Index> begin_{0};
  std::vector<Ends> ends_;
};

}  // namespace delref
