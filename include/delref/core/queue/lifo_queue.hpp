// SPDX-License-Identifier: MIT
//
// Last in, first out: works where it worked last, so that memory is warm. Does not look at priorities.
#pragma once

#include <delref/core/queue/entry_pool.hpp>

namespace delref {

/// A last in, first out refinement queue.
template <class T>
class LifoQueue {
 public:
  QueuePosition push(const T& value, double /*priority*/) {
    ++size_;
    return pool_.insert_before(pool_.first(list_), value);
  }
  QueuePosition front() const { return pool_.first(list_); }
  T& at(QueuePosition position) { return pool_.value(position); }
  void erase(QueuePosition position) {
    --size_;
    pool_.erase(position);
  }
  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }
  void clear() { *this = LifoQueue(); }
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
