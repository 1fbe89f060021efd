// SPDX-License-Identifier: MIT
//
// The storage of all queue policies: entries in doubly linked lists, in blocks that never move, so that growth costs no copy
// and no doubled memory. A list is named by a head entry that the policy makes.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include <delref/core/queue/refinement_queue.hpp>

namespace delref {

/// Linked entries of `T`. All operations take constant time.
template <class T>
class EntryPool {
 public:
  /// An empty list; its position never holds a value.
  QueuePosition make_list() {
    const QueuePosition head = allocate();
    entry(head).previous = entry(head).next = head;
    return head;
  }
  bool is_empty(QueuePosition list) const { return entry(list).next == list; }
  QueuePosition first(QueuePosition list) const { return entry(list).next; }
  QueuePosition next(QueuePosition position) const { return entry(position).next; }

  T& value(QueuePosition position) { return entry(position).value; }
  const T& value(QueuePosition position) const { return entry(position).value; }

  /// Says `prefetch(value, n)` to the value of the n-th entry after `first`, for n = 1, 2, 3, if values understand it.
  void prefetch_after(QueuePosition first, QueuePosition list) const {
    if constexpr (requires(const T& v) { prefetch(v, 1); }) {
      QueuePosition p = next(first);
      for (int ahead = 1; ahead <= 3 && p != list; ++ahead, p = next(p)) prefetch(value(p), ahead);
    }
  }

  /// Puts a new entry before `after`, which is an entry or a list; before a list is at its end.
  QueuePosition insert_before(QueuePosition after, const T& value) {
    const QueuePosition position = allocate();
    entry(position).value = value;
    link_before(after, position);
    return position;
  }
  /// Takes an entry out of its list and puts it there instead.
  void move_before(QueuePosition after, QueuePosition position) {
    unlink(position);
    link_before(after, position);
  }

  void erase(QueuePosition position) {
    unlink(position);
    entry(position).next = free_;
    free_ = position;
  }

 private:
  struct Entry {
    T value{};
    QueuePosition previous = -1, next = -1;
  };
  static constexpr std::size_t block_bits = 12;
  using Block = std::array<Entry, std::size_t{1} << block_bits>;

  void link_before(QueuePosition after, QueuePosition position) {
    Entry &e = entry(position), &a = entry(after);
    e.next = after;
    e.previous = a.previous;
    entry(a.previous).next = position;
    a.previous = position;
  }
  void unlink(QueuePosition position) {
    const Entry& e = entry(position);
    entry(e.previous).next = e.next;
    entry(e.next).previous = e.previous;
  }

  Entry& entry(QueuePosition p) {
    const auto i = static_cast<std::size_t>(p);
    return (*blocks_[i >> block_bits])[i & ((std::size_t{1} << block_bits) - 1)];
  }
  const Entry& entry(QueuePosition p) const { return const_cast<EntryPool*>(this)->entry(p); }

  QueuePosition allocate() {
    if (free_ >= 0) {
      const QueuePosition position = free_;
      free_ = entry(position).next;
      return position;
    }
    if ((used_ >> block_bits) == blocks_.size()) blocks_.push_back(std::make_unique<Block>());
    return static_cast<QueuePosition>(used_++);
  }

  std::vector<std::unique_ptr<Block>> blocks_;
  std::size_t used_ = 0;
  QueuePosition free_ = -1;
};

}  // namespace delref
