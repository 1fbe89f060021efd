// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sets of numbers that are united two at a time (union-find with path halving; Tarjan and van Leeuwen 1984).
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace delref {

/// Each set is known by its smallest member, whatever the order in which sets were united.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t size = 0) : parent_(size) { std::iota(parent_.begin(), parent_.end(), std::uint32_t{0}); }

  std::size_t size() const { return parent_.size(); }
  /// A new set of one member. Requires fewer than 2^32 members.
  std::uint32_t add() {
    const auto member = static_cast<std::uint32_t>(parent_.size());
    parent_.push_back(member);
    return member;
  }
  /// The smallest member of the set.
  std::uint32_t find(std::uint32_t member) {
    while (parent_[member] != member) member = parent_[member] = parent_[parent_[member]];
    return member;
  }
  void unite(std::uint32_t a, std::uint32_t b) {
    a = find(a), b = find(b);
    if (a == b) return;
    if (a > b) std::swap(a, b);
    parent_[b] = a;
  }

  /// The members of all sets, one set after the other, each in increasing order and the sets by their smallest members.
  struct Groups {
    std::vector<std::uint32_t> members;
    /// Where each set begins in `members`, and where the last one ends.
    std::vector<std::size_t> begin;
  };
  Groups groups() {
    Groups out;
    std::vector<std::uint32_t> group(size());
    for (std::uint32_t i = 0; i != size(); ++i) {
      const std::uint32_t root = find(i);
      if (root == i) {
        group[i] = static_cast<std::uint32_t>(out.begin.size());
        out.begin.push_back(0);
      } else {
        group[i] = group[root];
      }
      ++out.begin[group[i]];
    }
    std::exclusive_scan(out.begin.begin(), out.begin.end(), out.begin.begin(), std::size_t{0});
    out.begin.push_back(size());
    std::vector<std::size_t> next(out.begin.begin(), out.begin.end() - 1);
    out.members.resize(size());
    for (std::uint32_t i = 0; i != size(); ++i) out.members[next[group[i]]++] = i;
    return out;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace delref
