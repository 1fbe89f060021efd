// SPDX-License-Identifier: MIT
//
// Finds what a level keeps of an edge or a triangle by the numbers of its vertices, where the triangulation stores no such element.
// It is only ever asked for a given key, never walked, so that nothing depends on the hash.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace delref {

/// A hash table from sets of `N` vertex numbers to indices, by open addressing with linear probing.
template <std::size_t N>
class SimplexTable {
 public:
  using Index = std::uint32_t;
  using Key = std::array<std::uint32_t, N>;
  static constexpr Index none = std::numeric_limits<Index>::max();

  /// The key of vertex numbers in any order.
  template <class... Numbers>
  static Key key(Numbers... numbers) {
    static_assert(sizeof...(Numbers) == N);
    Key k{static_cast<std::uint32_t>(numbers)...};
    if constexpr (N == 2) {
      if (k[0] > k[1]) std::swap(k[0], k[1]);
    } else {
      std::ranges::sort(k);
    }
    return k;
  }

  std::size_t size() const { return size_; }
  /// The index of the key, or `none`.
  Index find(const Key& key) const { return slots_.empty() ? none : slots_[place_of(key)].index; }
  /// Sets the index of the key, new or not; it must not be `none`.
  void set(const Key& key, Index index) {
    if (4 * (size_ + 1) > 3 * slots_.size()) grow();
    Slot& slot = slots_[place_of(key)];
    if (slot.index == none) ++size_;
    slot = {key, index};
  }
  /// Forgets the key, if it is there.
  void erase(const Key& key) {
    if (slots_.empty()) return;
    std::size_t hole = place_of(key);
    if (slots_[hole].index == none) return;
    --size_;
    slots_[hole].index = none;
    // Those that the hole would hide from their place move up.
    for (std::size_t i = next(hole); slots_[i].index != none; i = next(i)) {
      const std::size_t home = hash(slots_[i].key) & mask();
      if (((i - home) & mask()) < ((i - hole) & mask())) continue;
      slots_[hole] = slots_[i];
      slots_[i].index = none;
      hole = i;
    }
  }
  void clear() { slots_.clear(), size_ = 0; }

 private:
  struct Slot {
    Key key{};
    Index index = none;
  };

  std::size_t mask() const { return slots_.size() - 1; }
  std::size_t next(std::size_t i) const { return (i + 1) & mask(); }
  std::size_t place_of(const Key& key) const {
    std::size_t place = hash(key) & mask();
    while (slots_[place].index != none && slots_[place].key != key) place = next(place);
    return place;
  }
  static std::size_t hash(const Key& key) {
    std::uint64_t h = 0;
    for (const std::uint32_t k : key) {
      h = (h ^ k) * 0x9e3779b97f4a7c15u;
      h ^= h >> 29;
    }
    return static_cast<std::size_t>(h);
  }
  void grow() {
    std::vector<Slot> old = std::exchange(slots_, std::vector<Slot>(std::max<std::size_t>(64, 2 * slots_.size())));
    for (const Slot& s : old)
      if (s.index != none) slots_[place_of(s.key)] = s;
  }

  std::vector<Slot> slots_;
  std::size_t size_ = 0;
};

}  // namespace delref
