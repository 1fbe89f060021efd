// SPDX-License-Identifier: MIT
//
// The smallest observers and queue policy, each with the members that its concept requires and no other; the argument of
// `...Without` takes one of them away.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <delref/core/observer.hpp>
#include <delref/core/queue/refinement_queue.hpp>

#include "archetype_triangulation.hpp"

namespace archetypes {

/// The events that an observer may watch.
enum class Event { none, scanned, proposed, rejected, rejected_forever, before_insertion, after_insertion, progress };

/// Watches one event, or none.
template <Event event, class Tr = Line>
struct Watches {
  std::size_t times = 0;
  void on_scanned(const Tr&) requires (event == Event::scanned) { ++times; }
  void on_proposed(const Tr&, const delref::Proposal<Tr>&) requires (event == Event::proposed) { ++times; }
  void on_rejected(const Tr&, const delref::Proposal<Tr>&, delref::LevelIndex) requires (event == Event::rejected) { ++times; }
  void on_rejected_forever(const Tr&, const delref::Proposal<Tr>&, delref::Reason) requires (event == Event::rejected_forever) {
    ++times;
  }
  void on_before_insertion(const Tr&, const delref::Proposal<Tr>&) requires (event == Event::before_insertion) { ++times; }
  void on_after_insertion(const Tr&, Knot, const delref::Proposal<Tr>&) requires (event == Event::after_insertion) { ++times; }
  void on_progress(const Tr&, std::span<const std::size_t>) requires (event == Event::progress) { ++times; }
};

/// What is left out of an archetype queue.
enum class QueuePart { none, make, move, push, front, at, erase, empty, size, clear, for_each };

/// A last in, first out queue that never uses a position twice. `without` is the part that it lacks.
template <QueuePart without, class T = Interval>
class StackWithout {
  static constexpr bool has(QueuePart part) { return without != part; }

 public:
  StackWithout() requires (has(QueuePart::make)) = default;
  StackWithout(StackWithout&&) requires (has(QueuePart::move)) = default;
  StackWithout& operator=(StackWithout&&) requires (has(QueuePart::move)) = default;

  delref::QueuePosition push(const T& value, double) requires (has(QueuePart::push)) {
    values_.push_back(value);
    live_.push_back(true);
    ++size_;
    return static_cast<delref::QueuePosition>(values_.size() - 1);
  }
  delref::QueuePosition front() const requires (has(QueuePart::front)) {
    std::size_t i = values_.size() - 1;
    while (!live_[i]) --i;
    return static_cast<delref::QueuePosition>(i);
  }
  T& at(delref::QueuePosition position) requires (has(QueuePart::at)) { return values_[static_cast<std::size_t>(position)]; }
  void erase(delref::QueuePosition position) requires (has(QueuePart::erase)) {
    live_[static_cast<std::size_t>(position)] = false;
    --size_;
  }
  bool empty() const requires (has(QueuePart::empty)) { return size_ == 0; }
  std::size_t size() const requires (has(QueuePart::size)) { return size_; }
  void clear() requires (has(QueuePart::clear)) {
    values_.clear();
    live_.clear();
    size_ = 0;
  }
  template <class F>
  void for_each(F&& f) const requires (has(QueuePart::for_each)) {
    for (std::size_t i = 0; i < values_.size(); ++i)
      if (live_[i]) f(values_[i]);
  }

 private:
  std::vector<T> values_;
  std::vector<bool> live_;
  std::size_t size_ = 0;
};

/// With all its parts.
using Stack = StackWithout<QueuePart::none>;

}  // namespace archetypes
