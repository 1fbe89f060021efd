// SPDX-License-Identifier: MIT
//
// What a queue policy is. A queue gives each entry a position; the entry's element keeps that number in its slot, so that a dying
// element leaves the queue in constant time and no entry is ever searched for or stale.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>

namespace delref {

/// The place of an entry in a queue. Stays the same until the entry is taken out.
using QueuePosition = std::int32_t;

/// A queue of values of type `T`, in an order of its own:
/// 1. `push(value, priority)` gives the position of the new entry; entries of lower priority number come first where the policy
///    looks at it; a priority is a finite double >= 0.
/// 2. `front()` is the position of the next entry, of a queue that is not empty; `at(position)` its value, which may be changed.
/// 3. `erase(position)` takes an entry out, in constant time.
/// 4. `empty()`, `size()`, `clear()`, and `for_each(f)`, which calls `f(value)` for each entry.
/// Law: the order depends on the calls alone.
///
/// The queues here announce what comes next: for a `T` with a hidden friend `prefetch(value, n)`, `front()` calls that for the n-th
/// value after the front, n = 1, 2, 3. Elements that follow each other lie far apart in memory, and this hides half of the wait.
template <class Q, class T>
concept RefinementQueue = std::default_initializable<Q> && std::movable<Q> &&
    requires(Q& q, const Q& cq, const T& value, double priority, QueuePosition position, void (*f)(const T&)) {
      { q.push(value, priority) } -> std::same_as<QueuePosition>;
      { q.front() } -> std::same_as<QueuePosition>;
      { q.at(position) } -> std::same_as<T&>;
      q.erase(position);
      { cq.empty() } -> std::same_as<bool>;
      { cq.size() } -> std::convertible_to<std::size_t>;
      q.clear();
      cq.for_each(f);
    };

template <class Q, class T>
consteval bool explain_queue() {
  static_assert(RefinementQueue<Q, T>,
                "a queue policy needs: push(value, priority), front(), at(position), erase(position), empty(), size(), clear(), "
                "for_each(f)");
  return RefinementQueue<Q, T>;
}

}  // namespace delref
