// SPDX-License-Identifier: MIT
//
// A run of the frame as a whole: budgets, stopping and going on, step by step, observers, exceptions, levels that move on.
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <optional>
#include <span>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include <delref/core/mesher.hpp>

#include "rule.hpp"

namespace {

using namespace track;
using delref::Budget;
using delref::Control;
using delref::Mesher;
using delref::Reason;
using delref::Step;
using delref::Stop;
using delref::Verdict;

/// Two levels, the first of which rejects a point of the second.
auto two_levels() { return std::tuple(first_at(0.375), shorter_than(0.02)); }

std::vector<double> whole_run() {
  Road road(0, 1);
  Mesher(road, two_levels()).refine();
  return road.coordinates();
}

TEST_CASE("a run whose sets are all empty is complete and lists nothing") {
  Road road(0, 1);
  Mesher mesher(road, two_levels());
  CHECK_FALSE(mesher.done());
  const auto outcome = mesher.refine();
  CHECK(outcome.complete());
  CHECK_FALSE(outcome.stopped);
  CHECK(outcome.unmet.empty());
  CHECK(mesher.done());
  CHECK(outcome.levels[0].inserted + outcome.levels[1].inserted + 2 == road.number_of_vertices());
}

TEST_CASE("a run stops at its number of vertices, lists what is left, and goes on to the same mesh") {
  Road road(0, 1);
  Mesher mesher(road, two_levels());
  const auto outcome = mesher.refine(Control{Budget{.max_vertices = 9}});
  CHECK(outcome.stopped == Stop::vertices);
  CHECK_FALSE(outcome.complete());
  CHECK(road.number_of_vertices() == 9);
  CHECK(outcome.levels[1].queued > 0);
  CHECK(outcome.unmet_count(Reason::budget) == outcome.levels[1].queued);

  const auto rest = mesher.refine();
  CHECK(rest.complete());
  CHECK(rest.levels[1].queued == 0);
  CHECK(road.coordinates() == whole_run());
}

TEST_CASE("a budget of just enough vertices is no reason to say that the run was stopped") {
  Road road(0, 1);
  CHECK(Mesher(road, shorter_than(0.25)).refine(Control{Budget{.max_vertices = 5}}).complete());
  CHECK(road.number_of_vertices() == 5);
}

TEST_CASE("a run without time stops at once, and goes on when it gets some") {
  Road road(0, 1);
  Mesher mesher(road, two_levels());
  const auto outcome = mesher.refine(Control{Budget{.time_limit = std::chrono::seconds(-1)}});
  CHECK(outcome.stopped == Stop::time);
  CHECK(road.number_of_vertices() == 2);
  CHECK(outcome.unmet_count(Reason::budget) == 1);
  CHECK(mesher.refine().complete());
  CHECK(road.coordinates() == whole_run());
}

TEST_CASE("a stop request stops the run within some hundred steps, whoever makes it") {
  Road road(0, 1);
  Mesher mesher(road, shorter_than(1e-4));
  std::stop_source source;
  struct Stopper {
    std::stop_source& source;
    std::size_t vertices = 0;
    void on_after_insertion(const Road&, Knot, const delref::Proposal<Road>&) {
      if (++vertices == 100) source.request_stop();
    }
  } stopper{source};
  const auto outcome = mesher.refine(Control{{}, source.get_token()}, stopper);
  CHECK(outcome.stopped == Stop::token);
  CHECK(road.number_of_vertices() < 1000);
}

TEST_CASE("a run that has nothing to do is complete even when it is told to stop") {
  Road road(0, 1);
  CHECK(Mesher(road, shorter_than(2)).refine(Control{Budget{.time_limit = std::chrono::seconds(-1)}}).complete());
}

TEST_CASE("a user can do the steps one by one, look at the mesh between them, and gets the same mesh") {
  Road road(0, 1);
  Mesher mesher(road, two_levels());
  std::size_t vertices = 2;
  for (Step step = mesher.step(); step != Step::done; step = mesher.step()) {
    if (step == Step::inserted) ++vertices;
    CHECK(road.number_of_vertices() == vertices);
    CHECK(mesher.triangulation().pieces().size() == vertices - 1);
  }
  CHECK(mesher.done());
  CHECK(mesher.step() == Step::done);
  CHECK(road.coordinates() == whole_run());
}

TEST_CASE("an outcome that is asked for between steps is complete only when every set is empty") {
  Road road(0, 1);
  Mesher mesher(road, shorter_than(0.6));
  CHECK_FALSE(mesher.outcome().complete());
  mesher.scan();
  CHECK_FALSE(mesher.outcome().complete());
  CHECK(mesher.step() == Step::inserted);
  CHECK(mesher.outcome().complete());
}

TEST_CASE("vertices that are added after a refinement are refined with after a scan") {
  Road road(0, 1);
  Mesher mesher(road, shorter_than(0.25));
  mesher.refine();
  road.add(0.01);
  mesher.scan();
  CHECK(mesher.refine().complete());
  for (const Piece& e : road.pieces()) CHECK(road.length(e) <= 0.25);
}

TEST_CASE("what was rejected for ever is reconsidered by a scan") {
  Road road(0, 1);
  bool forbidden = true;
  RoadRule rule = shorter_than(0.6);
  rule.skip = [&](const Piece&) { return forbidden ? std::optional(Reason::size_floor) : std::nullopt; };
  Mesher mesher(road, std::move(rule));
  CHECK(mesher.refine().unmet.size() == 1);
  CHECK(mesher.refine().unmet.size() == 1);
  forbidden = false;
  mesher.scan();
  CHECK(mesher.refine().unmet.empty());
  CHECK(road.number_of_vertices() == 3);
}

TEST_CASE("a level goes on in another mesher with what it has learnt") {
  Road road(0, 1);
  RoadRule learner = shorter_than(0.3, "learner");
  learner.after = [](RoadRule& self, Road&, const RoadRule::Proposal&) { self.label += '+'; };
  Mesher first(road, std::move(learner));
  first.refine();
  Mesher second(road, RoadRule{}, first.release<0>());
  CHECK(second.level<1>().label == "learner+++");
  CHECK(second.level<1>().slot == 1);
  CHECK(second.outcome().levels[1].name == "learner+++");
  road.add(0.01);
  CHECK(second.refine().complete());
}

TEST_CASE("a mesher refines a mesh that another one has refined") {
  Road road(0, 1);
  Mesher(road, shorter_than(0.3)).refine();
  Mesher(road, two_levels()).refine();
  for (const Piece& e : road.pieces()) CHECK(road.length(e) <= 0.02);
}

/// Writes one letter for each event.
struct Diary {
  std::string text;
  void on_scanned(const Road&) { text += 's'; }
  void on_proposed(const Road&, const delref::Proposal<Road>& p) {
    CHECK(p.element_vertices().size() == 2);
    text += 'p';
  }
  void on_rejected(const Road&, const delref::Proposal<Road>&, delref::LevelIndex by) { text += "r" + std::to_string(by); }
  void on_rejected_forever(const Road&, const delref::Proposal<Road>&, Reason why) {
    text += "f(" + std::string(to_string(why)) + ")";
  }
  void on_before_insertion(const Road& on, const delref::Proposal<Road>& p) {
    CHECK(p.zone->dying.size() == 1);
    text += "b" + std::to_string(on.number_of_vertices());
  }
  void on_after_insertion(const Road& on, Knot v, const delref::Proposal<Road>& p) {
    CHECK(on.point(v) == p.point);
    CHECK(on.provenance(v) == p.level);
    text += "a" + std::to_string(on.number_of_vertices());
  }
};

/// Watches one event.
struct Counter {
  std::size_t insertions = 0;
  void on_after_insertion(const Road&, Knot, const delref::Proposal<Road>&) { ++insertions; }
};

TEST_CASE("observers see every event in order, each those that it watches") {
  Road road(0, 1);
  RoadRule rule = shorter_than(0.6);
  rule.skip = [](const Piece& e) { return e.left.number == 2 ? std::optional(Reason::size_floor) : std::nullopt; };
  Mesher mesher(road, first_at(0.375), std::move(rule));
  Diary diary;
  Counter counter;
  mesher.refine(Control{}, diary, counter);
  CHECK(diary.text == "spr0pb2a3f(size floor)");
  CHECK(counter.insertions == 1);
}

TEST_CASE("observers are called after the levels") {
  Road road(0, 1);
  std::string order;
  RoadRule rule = shorter_than(0.6);
  rule.before = [&](RoadRule&, Road&, const RoadRule::Proposal&) { order += "level "; };
  rule.after = rule.before;
  struct Last {
    std::string& order;
    void on_before_insertion(const Road&, const delref::Proposal<Road>&) { order += "observer "; }
    void on_after_insertion(const Road&, Knot, const delref::Proposal<Road>&) { order += "observer "; }
  } last{order};
  Mesher(road, std::move(rule)).refine(Control{}, last);
  CHECK(order == "level observer level observer ");
}

/// Writes down what it is told of how far a run is.
struct Watcher {
  std::vector<std::size_t> vertices, waiting;
  void on_progress(const Road& road, std::span<const std::size_t> queued) {
    CHECK(queued.size() == 2);
    vertices.push_back(road.number_of_vertices());
    waiting.push_back(queued[1]);
  }
};

TEST_CASE("observers are told every few hundred steps how many elements wait") {
  Road road(0, 1);
  Mesher mesher(road, RoadRule{}, shorter_than(1e-3));
  Watcher watcher;
  mesher.refine(Control{}, watcher);
  CHECK(watcher.vertices == std::vector<std::size_t>{2, 258, 514, 770});
  CHECK(watcher.waiting.front() == 1);
  CHECK(watcher.waiting.back() > 0);
}

TEST_CASE("a mesher tells how many elements wait in each of its levels") {
  Road road(0, 1);
  Mesher mesher(road, first_at(0.375), shorter_than(0.3));
  mesher.scan();
  CHECK(mesher.queued() == std::array<std::size_t, 2>{0, 1});
  mesher.step();
  CHECK(mesher.queued() == std::array<std::size_t, 2>{1, 1});
  mesher.refine();
  CHECK(mesher.queued() == std::array<std::size_t, 2>{0, 0});
}

TEST_CASE("refinement stops earlier by the time that is kept back for each vertex") {
  Road road(0, 1);
  Mesher mesher(road, shorter_than(1e-4));
  const auto hour = std::chrono::hours(1);
  const auto outcome = mesher.refine(Control{Budget{.time_limit = hour, .kept_back_per_vertex = std::chrono::duration<double>(hour) / 1000}});
  CHECK(outcome.stopped == Stop::time);
  CHECK(road.number_of_vertices() >= 1000 - 1);
  CHECK(road.number_of_vertices() < 1000 + 256);
}

/// A level whose elements have more vertices than the frame can name, when `many`.
struct Star : RoadRule {
  bool many = true;
  std::vector<Knot> element_vertices(const Road&, const Piece& e) const {
    return std::vector<Knot>(many ? 5 : 2, e.left);
  }
};

TEST_CASE("an element of too many vertices is refused when it is met") {
  Road road(0, 1);
  Mesher mesher(road, Star{shorter_than(0.6)});
  CHECK_THROWS_AS(mesher.refine(), std::length_error);
  mesher.level<0>().many = false;
  CHECK(mesher.refine().complete());
}

struct Mishap : std::runtime_error {
  Mishap() : std::runtime_error("a mishap in user code") {}
};

/// Refines a road by a level that throws once, in the hook that `plant` chooses, and then to the end.
template <class Plant>
void survive(Plant&& plant) {
  Road road(0, 1);
  RoadRule rule = shorter_than(0.02);
  int calls = 0;
  const auto mishap = [&calls] {
    if (++calls == 5) throw Mishap();
  };
  plant(rule, mishap);
  Mesher mesher(road, first_at(0.375), std::move(rule));
  CHECK_THROWS_AS(mesher.refine(), Mishap);
  CHECK_FALSE(mesher.done());

  // The triangulation is valid: pieces in order, none empty.
  for (const Piece& e : road.pieces()) CHECK(road.length(e) > 0);
  CHECK(road.pieces().size() + 1 == road.number_of_vertices());

  CHECK(mesher.refine().complete());
  CHECK(road.coordinates() == whole_run());
}

TEST_CASE("if user code throws, in whatever hook, the mesh is valid and refinement can go on") {
  using Proposal = RoadRule::Proposal;
  SECTION("when it tests an element") {
    survive([](RoadRule& rule, auto mishap) {
      rule.violates = [mishap](const Road& on, const Piece& e) { return mishap(), on.length(e) > 0.02; };
    });
  }
  SECTION("when it gives a refinement point") {
    survive([](RoadRule& rule, auto mishap) {
      rule.target = [mishap](const Road& on, const Piece& e) { return mishap(), 0.5 * (on.point(e.left).x + on.point(e.right).x); };
    });
  }
  SECTION("when it judges a point") {
    survive([](RoadRule& rule, auto mishap) {
      rule.judge = [mishap](RoadRule&, Road&, const Proposal&) { return mishap(), Verdict::permitted; };
    });
  }
  SECTION("before an insertion") {
    survive([](RoadRule& rule, auto mishap) { rule.before = [mishap](RoadRule&, Road&, const Proposal&) { mishap(); }; });
  }
  SECTION("after an insertion") {
    survive([](RoadRule& rule, auto mishap) { rule.after = [mishap](RoadRule&, Road&, const Proposal&) { mishap(); }; });
  }
}

TEST_CASE("if an observer throws, refinement can go on") {
  Road road(0, 1);
  Mesher mesher(road, two_levels());
  struct Nervous {
    std::size_t events = 0;
    void on_proposed(const Road&, const delref::Proposal<Road>&) {
      if (++events == 7) throw Mishap();
    }
  } nervous;
  CHECK_THROWS_AS(mesher.refine(Control{}, nervous), Mishap);
  CHECK(mesher.refine(Control{}, nervous).complete());
  CHECK(road.coordinates() == whole_run());
}

TEST_CASE("a control that says stop interrupts a stage that has nothing to show") {
  std::stop_source source;
  const Control control{{}, source.get_token()};
  CHECK_FALSE(control.stop());
  CHECK_NOTHROW(throw_if_stopped(control));
  source.request_stop();
  CHECK(control.stop() == Stop::token);
  CHECK_THROWS_AS(throw_if_stopped(control), delref::Interrupted);
}

TEST_CASE("every reason has a name of its own") {
  std::vector<std::string_view> names;
  for (int i = 0; i <= static_cast<int>(Reason::budget); ++i) names.push_back(to_string(static_cast<Reason>(i)));
  std::ranges::sort(names);
  CHECK(std::ranges::adjacent_find(names) == names.end());
  CHECK(std::ranges::find(names, "unknown") == names.end());
}

}  // namespace
