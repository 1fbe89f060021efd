// SPDX-License-Identifier: GPL-3.0-or-later
//
// A hash table from pairs of 64-bit words to indices. It is only ever asked for a given key, never walked, so that nothing
// depends on the hash; several times faster than sorting, which the reading of large coasts feels.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <delref/core/point.hpp>

namespace delref {

/// Finds indices by a pair of words. Open addressing; the capacity is fixed when it is made.
class PairTable {
 public:
  using Index = std::uint32_t;
  static constexpr Index none = std::numeric_limits<Index>::max();
  struct Key {
    std::uint64_t first, second;
    friend bool operator==(const Key&, const Key&) = default;
  };

  /// Room for `capacity` different keys.
  explicit PairTable(std::size_t capacity)
      : slots_(std::bit_ceil(2 * capacity + 2), Slot{{0, 0}, none}), mask_(slots_.size() - 1) {}

  /// The index of the key: `none` if it is new. A reference, so that the caller sets it.
  Index& operator[](Key key) {
    Slot& slot = slots_[place_of(key)];
    slot.key = key;
    return slot.index;
  }

  /// The index of the key, or `none`.
  Index find(Key key) const { return slots_[place_of(key)].index; }

  /// The key of two numbers; -0 and 0 have the same.
  static Key key(double x, double y) { return {std::bit_cast<std::uint64_t>(x + 0.0), std::bit_cast<std::uint64_t>(y + 0.0)}; }
  static Key key(Point2 p) { return key(p.x, p.y); }

 private:
  struct Slot {
    Key key;
    Index index;
  };

  /// Where the key is, or the free slot where it would be.
  std::size_t place_of(Key key) const {
    std::size_t place = hash(key) & mask_;
    while (slots_[place].index != none && slots_[place].key != key) place = (place + 1) & mask_;
    return place;
  }

  static std::size_t hash(Key key) {
    std::uint64_t h = key.first * 0x9e3779b97f4a7c15u;
    h = (h ^ (h >> 32)) + key.second;
    h *= 0xd6e8feb86659fd93u;
    h ^= h >> 32;
    h *= 0xd6e8feb86659fd93u;
    return static_cast<std::size_t>(h ^ (h >> 32));
  }

  std::vector<Slot> slots_;
  std::size_t mask_;
};

}  // namespace delref
