// SPDX-License-Identifier: MIT
//
// The set of elements to be refined, as a level holds it: a queue policy together with the slot that the mesher gave the level in
// each element. The slot of an element says whether it is in the set, and where.
#pragma once

#include <cstddef>

#include <delref/core/queue/refinement_queue.hpp>

namespace delref {

/// The elements of type `Element` that wait to be refined, in the order of `Queue`. The triangulation
/// keeps the slots, or whatever else is handed in its place with `slot(element, k)` and `set_slot(element, k, position)`.
template <class Element, class Queue>
class ElementSet {
  static_assert(explain_queue<Queue, Element>());

 public:
  /// Slot values other than positions.
  static constexpr QueuePosition absent = -1, given_up = -2;

  void assign_slot(std::size_t k) { slot_ = k; }
  bool empty() const { return queue_.empty(); }
  std::size_t size() const { return queue_.size(); }
  const Element& front() { return queue_.at(queue_.front()); }

  /// Adds `e` unless it is there already or was given up. True when it was added.
  template <class Tr>
  bool add(Tr&& tr, const Element& e, double priority) {
    if (tr.slot(e, slot_) != absent) return false;
    tr.set_slot(e, slot_, queue_.push(e, priority));
    return true;
  }
  /// Takes `e` out if it is there.
  template <class Tr>
  void erase(Tr&& tr, const Element& e) {
    const QueuePosition position = tr.slot(e, slot_);
    if (position < 0) return;
    queue_.erase(position);
    tr.set_slot(e, slot_, absent);
  }
  template <class Tr>
  void pop(Tr&& tr) {
    const QueuePosition position = queue_.front();
    tr.set_slot(queue_.at(position), slot_, absent);
    queue_.erase(position);
  }
  /// `e`, which is not in the set, is not to enter it again.
  template <class Tr>
  void give_up(Tr&& tr, const Element& e) { tr.set_slot(e, slot_, given_up); }
  template <class Tr>
  bool is_given_up(const Tr& tr, const Element& e) const { return tr.slot(e, slot_) == given_up; }
  /// The handle under which the triangulation knows an element has changed: from now on it is `e`.
  template <class Tr>
  void rename(const Tr& tr, const Element& e) {
    if (const QueuePosition position = tr.slot(e, slot_); position >= 0) queue_.at(position) = e;
  }
  /// Empties the set; the slots are the triangulation's to clear.
  void clear() { queue_.clear(); }
  template <class F>
  void for_each(F&& f) const { queue_.for_each(f); }

 private:
  Queue queue_;
  std::size_t slot_ = 0;
};

}  // namespace delref
