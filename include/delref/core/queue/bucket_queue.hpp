// SPDX-License-Identifier: MIT
//
// Coarse buckets by priority, the lowest first, first in first out within a bucket: four buckets to a factor of two are all the order
// that refinement profits from (benchmarks/results has the measurement; Shewchuk's Triangle keeps buckets by edge length for the
// same reason); a total order costs more than it gives. Even this order alone would sweep over the whole mesh once per bucket. So
// several neighbouring buckets make a class, and entries of a class enter their buckets a batch at a time, in the order in which
// they came: that is the order of storage or of their making, near by near, and work stays in warm memory.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include <delref/core/queue/entry_pool.hpp>

namespace delref {

/// A refinement queue of 8,192 buckets, four per binary exponent of the priority, in classes of 2^ClassBits buckets. The lowest class
/// comes first; its entries enter the buckets in batches of `BatchSize`, each when the buckets are empty. An entry of that class or
/// a lower one that is pushed meanwhile goes to its bucket at once.
template <class T, int ClassBits = 4, std::size_t BatchSize = 1024>
class BucketQueue {
 public:
  QueuePosition push(const T& value, double priority) {
    ++size_;
    const std::size_t bucket = bucket_of(priority), c = bucket >> ClassBits;
    const QueuePosition list = c <= current_class_ ? buckets_.open(bucket, pool_) : classes_.open(c, pool_);
    return pool_.insert_before(list, {value, static_cast<std::uint16_t>(bucket)});
  }
  QueuePosition front() {
    while (true) {
      const QueuePosition list = buckets_.first(pool_);
      if (list >= 0) return pool_.first(list);
      admit_batch();
    }
  }
  T& at(QueuePosition position) { return pool_.value(position).value; }
  void erase(QueuePosition position) {
    --size_;
    pool_.erase(position);
  }
  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }
  void clear() { *this = BucketQueue(); }
  template <class F>
  void for_each(F&& f) const {
    const auto visit = [&](QueuePosition list) {
      for (QueuePosition p = pool_.first(list); p != list; p = pool_.next(p)) f(pool_.value(p).value);
    };
    buckets_.for_each(visit);
    classes_.for_each(visit);
  }

 private:
  static constexpr int mantissa_bits = 2;
  static constexpr std::size_t bucket_count = std::size_t{2048} << mantissa_bits;

  struct Entry {
    T value{};
    std::uint16_t bucket = 0;
  };
  using Pool = EntryPool<Entry>;

  /// Lists of a pool by number, with a bit per list that may hold entries and a bit per word of those.
  template <std::size_t Count>
  class Lists {
   public:
    /// The list of that number, which is going to hold an entry.
    QueuePosition open(std::size_t k, Pool& pool) {
      if (lists_[k] < 0) lists_[k] = pool.make_list();
      words_[k / 64] |= std::uint64_t{1} << (k % 64);
      summary_[k / 4096] |= std::uint64_t{1} << (k / 64 % 64);
      return lists_[k];
    }
    /// The first list that holds entries; negative if there is none.
    QueuePosition first(const Pool& pool) {
      for (std::size_t s = 0; s < summary_.size(); ++s)
        while (summary_[s] != 0) {
          const std::size_t w = s * 64 + static_cast<std::size_t>(std::countr_zero(summary_[s]));
          const QueuePosition list = lists_[w * 64 + static_cast<std::size_t>(std::countr_zero(words_[w]))];
          if (!pool.is_empty(list)) return list;
          words_[w] &= words_[w] - 1;
          if (words_[w] == 0) summary_[s] &= summary_[s] - 1;
        }
      return -1;
    }
    template <class F>
    void for_each(F&& f) const {
      for (const QueuePosition list : lists_)
        if (list >= 0) f(list);
    }

   private:
    static constexpr std::array<QueuePosition, Count> none() {
      std::array<QueuePosition, Count> lists{};
      lists.fill(-1);
      return lists;
    }
    std::array<QueuePosition, Count> lists_ = none();
    std::array<std::uint64_t, (Count + 63) / 64> words_{};
    std::array<std::uint64_t, (Count + 4095) / 4096> summary_{};
  };

  /// The exponent of the double and the first bits of its mantissa: monotonic for priorities >= 0.
  static std::size_t bucket_of(double priority) {
    return static_cast<std::size_t>(std::bit_cast<std::uint64_t>(std::max(priority, 0.0)) >> (52 - mantissa_bits));
  }

  /// Moves a batch of the lowest class into the buckets, which are empty. There is an entry.
  void admit_batch() {
    const QueuePosition list = classes_.first(pool_);
    current_class_ = std::size_t{pool_.value(pool_.first(list)).bucket} >> ClassBits;
    for (std::size_t k = 0; k < BatchSize && !pool_.is_empty(list); ++k) {
      const QueuePosition p = pool_.first(list);
      pool_.move_before(buckets_.open(pool_.value(p).bucket, pool_), p);
    }
  }

  Pool pool_;
  Lists<bucket_count> buckets_;
  Lists<(bucket_count >> ClassBits)> classes_;
  std::size_t current_class_ = 0;
  std::size_t size_ = 0;
};

}  // namespace delref
