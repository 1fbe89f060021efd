// SPDX-License-Identifier: MIT
//
// Coarse buckets by priority: the lowest bucket first, first in first out within a bucket. Four buckets to a factor of two of the
// priority is all the order that refinement profits from (benchmarks/results has the measurement; Shewchuk's Triangle keeps
// buckets by edge length for the same reason); a total order costs more than it gives.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include <delref/core/queue/entry_pool.hpp>

namespace delref {

/// A refinement queue of 8,192 buckets, four per binary exponent of the priority.
template <class T>
class BucketQueue {
 public:
  QueuePosition push(const T& value, double priority) {
    const std::size_t b = bucket_of(priority);
    if (lists_[b] < 0) lists_[b] = pool_.make_list();
    mark(b);
    ++size_;
    return pool_.insert_before(lists_[b], value);
  }
  QueuePosition front() {
    std::size_t b = first_marked();
    while (pool_.is_empty(lists_[b])) {
      unmark(b);
      b = first_marked();
    }
    const QueuePosition first = pool_.first(lists_[b]);
    pool_.prefetch_after(first, lists_[b]);
    return first;
  }
  T& at(QueuePosition position) { return pool_.value(position); }
  void erase(QueuePosition position) {
    --size_;
    pool_.erase(position);
  }
  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }
  void clear() { *this = BucketQueue(); }
  template <class F>
  void for_each(F&& f) const {
    for (const QueuePosition list : lists_)
      if (list >= 0)
        for (QueuePosition p = pool_.first(list); p != list; p = pool_.next(p)) f(pool_.value(p));
  }

 private:
  static constexpr int mantissa_bits = 2;
  static constexpr std::size_t bucket_count = std::size_t{2048} << mantissa_bits;
  static constexpr std::size_t word_count = bucket_count / 64;

  /// The exponent of the double and the first bits of its mantissa: monotonic for priorities >= 0.
  static std::size_t bucket_of(double priority) {
    return static_cast<std::size_t>(std::bit_cast<std::uint64_t>(std::max(0.0, priority)) >> (52 - mantissa_bits));
  }
  // A bit per bucket that may be non-empty, and a bit per word of those.
  void mark(std::size_t b) {
    words_[b / 64] |= std::uint64_t{1} << (b % 64);
    summary_[b / 4096] |= std::uint64_t{1} << (b / 64 % 64);
  }
  void unmark(std::size_t b) {
    words_[b / 64] &= ~(std::uint64_t{1} << (b % 64));
    if (words_[b / 64] == 0) summary_[b / 4096] &= ~(std::uint64_t{1} << (b / 64 % 64));
  }
  std::size_t first_marked() const {
    const std::size_t half = summary_[0] != 0 ? 0 : 1;
    const std::size_t w = half * 64 + static_cast<std::size_t>(std::countr_zero(summary_[half]));
    return w * 64 + static_cast<std::size_t>(std::countr_zero(words_[w]));
  }
  static constexpr std::array<QueuePosition, bucket_count> no_lists() {
    std::array<QueuePosition, bucket_count> lists{};
    lists.fill(-1);
    return lists;
  }

  EntryPool<T> pool_;
  std::array<QueuePosition, bucket_count> lists_ = no_lists();
  std::array<std::uint64_t, word_count> words_{};
  std::array<std::uint64_t, word_count / 64> summary_{};
  std::size_t size_ = 0;
};

}  // namespace delref
