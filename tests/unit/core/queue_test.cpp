// SPDX-License-Identifier: MIT
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include <delref/core/queue/bucket_queue.hpp>
#include <delref/core/queue/element_set.hpp>
#include <delref/core/queue/fifo_queue.hpp>
#include <delref/core/queue/lifo_queue.hpp>

#include "track.hpp"

namespace {

using delref::QueuePosition;

/// Takes everything out, in order.
template <class Queue>
std::vector<int> drain(Queue& queue) {
  std::vector<int> values;
  while (!queue.empty()) {
    values.push_back(queue.at(queue.front()));
    queue.erase(queue.front());
  }
  return values;
}

TEST_CASE("a last in, first out queue gives the newest entry first") {
  delref::LifoQueue<int> queue;
  for (const int i : {1, 2, 3}) queue.push(i, 10 - i);
  CHECK(drain(queue) == std::vector{3, 2, 1});
}

TEST_CASE("a first in, first out queue gives the oldest entry first") {
  delref::FifoQueue<int> queue;
  for (const int i : {1, 2, 3}) queue.push(i, 10 - i);
  CHECK(drain(queue) == std::vector{1, 2, 3});
}

TEST_CASE("a bucket queue gives lower priorities first, and the oldest first within a bucket") {
  delref::BucketQueue<int> queue;
  queue.push(1, 100);
  queue.push(2, 1);
  queue.push(3, 1e-9);
  queue.push(4, 1.01);
  queue.push(5, 1);
  CHECK(drain(queue) == std::vector{3, 2, 4, 5, 1});
}

TEST_CASE("a bucket queue orders zero, denormal, huge and infinite priorities") {
  using Limits = std::numeric_limits<double>;
  delref::BucketQueue<int> queue;
  queue.push(5, Limits::infinity());
  queue.push(4, Limits::max());
  queue.push(3, 1.0);
  queue.push(2, Limits::min());
  queue.push(0, 0.0);
  queue.push(1, Limits::denorm_min());
  CHECK(drain(queue) == std::vector{0, 1, 2, 3, 4, 5});
}

TEST_CASE("a bucket queue takes a negative zero, and what is not a number, for zero") {
  delref::BucketQueue<int> queue;
  queue.push(4, 1e-300);
  queue.push(1, -0.0);
  queue.push(2, std::numeric_limits<double>::quiet_NaN());
  queue.push(3, -std::numeric_limits<double>::quiet_NaN());
  CHECK(drain(queue) == std::vector{1, 2, 3, 4});
}

TEST_CASE("priorities a factor of 1.25 apart are never in the wrong order in a bucket queue") {
  delref::BucketQueue<int> queue;
  std::vector<int> expected;
  double priority = 1e-12;
  for (int i = 0; i < 250; ++i, priority *= 1.25) {
    queue.push(i, priority);
    expected.push_back(i);
  }
  CHECK(drain(queue) == expected);
}

TEST_CASE("a bucket that became empty is filled again") {
  delref::BucketQueue<int> queue;
  queue.push(1, 1);
  queue.push(9, 1e6);
  queue.erase(queue.front());
  CHECK(queue.at(queue.front()) == 9);
  queue.push(2, 1);
  CHECK(drain(queue) == std::vector{2, 9});
}

TEMPLATE_TEST_CASE("a queue holds what was put in and not taken out, whatever the order", "", delref::LifoQueue<int>,
                   delref::FifoQueue<int>, delref::BucketQueue<int>) {
  TestType queue;
  std::vector<std::pair<QueuePosition, int>> held;
  std::mt19937 random(7);
  for (int i = 0; i < 20'000; ++i) {
    if (held.empty() || random() % 5 < 3) {
      held.emplace_back(queue.push(i, static_cast<double>(random() % 1000) / 8), i);
    } else {
      const std::size_t k = random() % held.size();
      REQUIRE(queue.at(held[k].first) == held[k].second);
      queue.erase(held[k].first);
      held[k] = held.back();
      held.pop_back();
    }
    REQUIRE(queue.size() == held.size());
  }
  std::vector<int> expected, listed;
  for (const auto& [position, value] : held) expected.push_back(value);
  queue.for_each([&](int value) { listed.push_back(value); });
  std::ranges::sort(expected);
  std::ranges::sort(listed);
  CHECK(listed == expected);

  std::vector<int> drained = drain(queue);
  std::ranges::sort(drained);
  CHECK(drained == expected);
}

TEMPLATE_TEST_CASE("a position stays the same while others come and go", "", delref::LifoQueue<int>, delref::FifoQueue<int>,
                   delref::BucketQueue<int>) {
  TestType queue;
  const QueuePosition first = queue.push(42, 1);
  for (int i = 0; i < 10'000; ++i) queue.push(i, i);
  for (int i = 0; i < 10'000; ++i) queue.erase(queue.front() == first ? queue.push(-1, 0) : queue.front());
  CHECK(queue.at(first) == 42);
  queue.at(first) = 43;
  CHECK(queue.at(first) == 43);
}

TEMPLATE_TEST_CASE("a cleared queue is empty and can be used again", "", delref::LifoQueue<int>, delref::FifoQueue<int>,
                   delref::BucketQueue<int>) {
  TestType queue;
  for (int i = 0; i < 5000; ++i) queue.push(i, i);
  queue.clear();
  CHECK(queue.empty());
  CHECK(queue.size() == 0);
  queue.for_each([](int) { FAIL("a cleared queue lists something"); });
  queue.push(1, 1);
  CHECK(drain(queue) == std::vector{1});
}

TEMPLATE_TEST_CASE("a queue that was moved holds what it held", "", delref::LifoQueue<int>, delref::FifoQueue<int>,
                   delref::BucketQueue<int>) {
  TestType queue;
  const QueuePosition position = queue.push(5, 0.5);
  TestType other = std::move(queue);
  CHECK(other.at(position) == 5);
  CHECK(other.front() == position);
}

using track::Piece;
using Road = track::Track<2>;
using Set = delref::ElementSet<Piece, delref::LifoQueue<Piece>>;

TEST_CASE("an element set holds an element once, and the element's slot knows") {
  Road road(0, 1);
  const Piece e = road.piece_from({0});
  Set set;
  set.assign_slot(1);
  CHECK(set.add(road, e, 1));
  CHECK_FALSE(set.add(road, e, 1));
  CHECK(set.size() == 1);
  CHECK(set.front() == e);
  CHECK(road.slot(e, 0) == Set::absent);
  CHECK(road.slot(e, 1) >= 0);
}

TEST_CASE("an element leaves an element set by pop or by erase, and erasing what is not there does nothing") {
  Road road(0, 1);
  road.add(0.5);
  const Piece a = road.piece_from({0}), b = road.piece_from({2});
  Set set;
  set.assign_slot(0);
  set.erase(road, a);
  CHECK(set.add(road, a, 1));
  CHECK(set.add(road, b, 1));
  set.erase(road, a);
  CHECK(road.slot(a, 0) == Set::absent);
  CHECK(set.front() == b);
  set.pop(road);
  CHECK(set.empty());
  CHECK(set.add(road, b, 1));
}

TEST_CASE("what an element set gave up does not enter it again") {
  Road road(0, 1);
  const Piece e = road.piece_from({0});
  Set set;
  set.assign_slot(0);
  set.give_up(road, e);
  CHECK(set.is_given_up(road, e));
  CHECK_FALSE(set.add(road, e, 1));
  set.erase(road, e);
  CHECK(set.is_given_up(road, e));
  CHECK(set.empty());
}

TEST_CASE("two element sets with different slots do not disturb each other") {
  Road road(0, 1);
  const Piece e = road.piece_from({0});
  Set first, second;
  first.assign_slot(0);
  second.assign_slot(1);
  CHECK(first.add(road, e, 1));
  CHECK(second.add(road, e, 1));
  first.pop(road);
  CHECK(second.size() == 1);
}

TEST_CASE("an element set that is told of a new handle gives that one") {
  Road road(0, 1);
  const Piece e = road.piece_from({0});
  Set set;
  set.assign_slot(0);
  set.add(road, e, 1);
  const Piece renamed{e.left, {7}};  // the slot is found from the left vertex
  set.rename(road, renamed);
  CHECK(set.front() == renamed);
}

}  // namespace
