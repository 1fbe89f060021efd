// SPDX-License-Identifier: MIT
//
// A queue that is one list: new entries enter at one of its ends, the next is taken from the front. Does not look at priorities.
#pragma once

#include <cstddef>

#include <delref/core/queue/entry_pool.hpp>

namespace delref {

/// Where a new entry of a `ListQueue` stands.
enum class ListOrder : unsigned char { last_in_first_out, first_in_first_out };

/// A refinement queue in the order in which the entries came, or the reverse of it.
template <class T, ListOrder order>
class ListQueue {
 public:
  QueuePosition push(const T& value, double /*priority*/) {
    ++size_;
    return pool_.insert_before(order == ListOrder::first_in_first_out ? list_ : pool_.first(list_), value);
  }
  QueuePosition front() const {
    const QueuePosition first = pool_.first(list_);
    pool_.prefetch_after(first, list_);
    return first;
  }
  T& at(QueuePosition position) { return pool_.value(position); }
  void erase(QueuePosition position) {
    --size_;
    pool_.erase(position);
  }
  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }
  void clear() { *this = ListQueue(); }
  template <class F>
  void for_each(F&& f) const {
    for (QueuePosition p = pool_.first(list_); p != list_; p = pool_.next(p)) f(pool_.value(p));
  }

 private:
  EntryPool<T> pool_;
  QueuePosition list_ = pool_.make_list();
  std::size_t size_ = 0;
};

}  // namespace delref
