// SPDX-License-Identifier: MIT
//
// Law tests: what a refinement rule must do and no compiler can check, tried on a scene of your own. Needs no test framework.
//
//     std::vector<std::string> broken = delref::testing::check_laws([](auto run) {
//       Triangulation tr = ...;                                 // built anew each time
//       run(tr, std::tuple(EdgesRule(...), MyRule(...)));       // your levels, in the order of their priority
//     });
//     for (const std::string& sentence : broken) std::cerr << sentence << '\n';
//     return broken.empty() ? 0 : 1;
//
// The laws, for each level:
//  - scanning twice gives the same set, whatever the set held before;
//  - its set is empty when the refinement is complete, and then it finds no element that violates its rule, but those given up;
//  - an element leaves the set by being popped or by dying, and in no other way; a dying element leaves it before the insertion,
//    or, where the level keeps its elements in a table of its own (it has the member `holds`), when the table loses it;
//  - who rejects a point has work of its own, and it is never a point of its own; who rejects for ever leaves its set as it is;
// and for the whole run: it ends, and run again it does the same, event by event.
#pragma once

#include <algorithm>
#include <any>
#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <delref/core/mesher.hpp>
#include <delref/testing/law_book.hpp>
#include <delref/testing/run_trace.hpp>
#include <delref/testing/watched_level.hpp>

namespace delref::testing {

struct LawOptions {
  /// A refinement that takes more steps than this is said not to end.
  std::size_t max_steps = 100'000;
};

/// One run of `levels` on `tr`, watched, on its way through the laws.
template <class Tr, class... Levels>
class LawRun {
 public:
  LawRun(Tr& tr, std::tuple<Levels...> levels, LawBook& book)
      : book_(&book), mesher_(tr, watch(std::move(levels), book, std::index_sequence_for<Levels...>{})) {}

  /// Refines, at most so many steps. Gives what was done.
  RunTrace<Tr> run(std::size_t max_steps) {
    RunTrace<Tr> trace;
    check_scan(trace);
    Step step = Step::inserted;
    for (std::size_t i = 0; i < max_steps && step != Step::done && !book_->ended(); ++i) step = mesher_.step(trace);
    if (step == Step::done) check_end();
    else if (!book_->ended()) book_->breach("the refinement", "does not end", "within " + std::to_string(max_steps) + " steps");
    return trace;
  }

 private:
  using Watching = Mesher<Tr, WatchedLevel<Levels, Tr>...>;

  template <std::size_t... I>
  static std::tuple<WatchedLevel<Levels, Tr>...> watch(std::tuple<Levels...> levels, LawBook& book, std::index_sequence<I...>) {
    return {WatchedLevel<Levels, Tr>(std::get<I>(std::move(levels)), static_cast<LevelIndex>(I), book)...};
  }
  template <class F>
  void each_level(F&& f) {
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      (f(static_cast<LevelIndex>(I), mesher_.template level<I>()), ...);
    }(std::index_sequence_for<Levels...>{});
  }

  void check_scan(RunTrace<Tr>& trace) {
    using Key = std::array<std::size_t, 4>;
    std::array<std::vector<Key>, sizeof...(Levels)> first;
    mesher_.scan(trace);
    each_level([&](LevelIndex i, auto& level) { first[i] = level.queued_keys(mesher_.triangulation()); });
    mesher_.scan(trace);
    each_level([&](LevelIndex i, auto& level) {
      const auto second = level.queued_keys(mesher_.triangulation());
      if (second != first[i])
        book_->breach(level.who(), "does not make the same set when it scans again",
                      std::to_string(first[i].size()) + " elements, then " + std::to_string(second.size()));
    });
  }

  void check_end() {
    each_level([&](LevelIndex, auto& level) {
      if (const auto left = level.queued_keys(mesher_.triangulation()); !left.empty())
        book_->breach(level.who(), "says that its set is empty and lists elements", std::to_string(left.size()) + " of them");
    });
    const auto outcome = mesher_.outcome();
    mesher_.scan();
    each_level([&](LevelIndex i, auto& level) {
      for (const auto& key : level.queued_keys(mesher_.triangulation()))
        if (!is_given_up(outcome, i, key))
          book_->breach(level.who(), "leaves an element that violates its rule, neither refined nor given up",
                        "vertices " + std::to_string(key[0]) + ", " + std::to_string(key[1]) + ", ...");
    });
  }
  static bool is_given_up(const Outcome<typename Tr::Point>& outcome, LevelIndex level, const std::array<std::size_t, 4>& key) {
    return std::ranges::any_of(outcome.unmet, [&](const auto& unmet) {
      std::array<std::size_t, 4> vertices;
      vertices.fill(std::numeric_limits<std::size_t>::max());
      std::copy_n(unmet.vertices.begin(), unmet.vertex_count, vertices.begin());
      std::ranges::sort(vertices);
      return unmet.level == level && vertices == key;
    });
  }

  LawBook* book_;
  Watching mesher_;
};

/// Tries the laws on a scene: a callable that, given `run`, builds a triangulation and a `std::tuple` of levels afresh and calls
/// `run(tr, std::move(levels))` once. Gives one sentence for each law that a level breaks; none when it keeps them all. A level
/// without the optional member `for_each_queued` is tried on fewer laws. Takes time in proportion to steps and set sizes: use scenes
/// of some hundreds of elements.
template <class Scene>
std::vector<std::string> check_laws(Scene&& scene, LawOptions options = {}) {
  LawBook book, second_book;
  std::any first;
  scene([&]<class Tr, class... Levels>(Tr& tr, std::tuple<Levels...> levels) {
    first = LawRun<Tr, Levels...>(tr, std::move(levels), book).run(options.max_steps);
  });
  scene([&]<class Tr, class... Levels>(Tr& tr, std::tuple<Levels...> levels) {
    const auto second = LawRun<Tr, Levels...>(tr, std::move(levels), second_book).run(options.max_steps);
    if (const std::string d = difference(std::any_cast<const RunTrace<Tr>&>(first), second); !d.empty())
      book.breach("the refinement", "does not do the same when it is run again", d);
  });
  if (!first.has_value()) book.breach("the scene", "never calls run", "so that no law was tried");
  return book.sentences();
}

}  // namespace delref::testing
