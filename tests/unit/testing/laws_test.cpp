// SPDX-License-Identifier: MIT
//
// The law tests pass a level that keeps the laws, and name the law that another one breaks.
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include <delref/testing/laws.hpp>

#include "../../concepts/archetype_level.hpp"
#include "../core/rule.hpp"

namespace {

using namespace track;
using delref::Verdict;
using delref::testing::check_laws;
using Proposal = RoadRule::Proposal;

/// The laws that `make()`, as the second of two levels, breaks on a road of length 1.
template <class Make>
std::vector<std::string> laws_broken_by(Make make) {
  return check_laws([&](auto run) {
    Road road(0, 1);
    run(road, std::tuple(first_at(0.3), make()));
  });
}

/// One of the sentences begins so.
bool names(const std::vector<std::string>& sentences, std::string_view beginning) {
  for (const std::string& s : sentences) UNSCOPED_INFO(s);
  return std::ranges::any_of(sentences, [&](const std::string& s) { return s.starts_with(beginning); });
}

TEST_CASE("levels that keep the laws break none") {
  CHECK(laws_broken_by([] { return shorter_than(0.02); }).empty());
  CHECK(laws_broken_by([] {
          RoadRule rule = shorter_than(0.02);
          rule.skip = [](const Piece& e) { return e.left.number == 2 ? std::optional(delref::Reason::size_floor) : std::nullopt; };
          return rule;
        }).empty());
}

TEST_CASE("a level with the required members alone can be tried") {
  CHECK(check_laws([](auto run) {
          archetypes::Line line(0, 1);
          run(line, std::tuple(archetypes::Halves(0.02)));
        }).empty());
}

TEST_CASE("a level that makes another set when it scans again is named") {
  CHECK(names(laws_broken_by([] {
                RoadRule rule = shorter_than(0.02);
                rule.scans_without_clearing = true;
                return rule;
              }),
              "level \"length\" does not make the same set when it scans again"));
}

TEST_CASE("a level that overlooks new elements is named") {
  CHECK(names(laws_broken_by([] {
                RoadRule rule = shorter_than(0.02);
                rule.ignores_the_new = true;
                return rule;
              }),
              "level \"length\" leaves an element that violates its rule, neither refined nor given up"));
}

TEST_CASE("a level that says that it is done and is not is named") {
  CHECK(names(laws_broken_by([] {
                RoadRule rule = shorter_than(0.02);
                rule.hides_its_set = true;
                return rule;
              }),
              "level \"length\" says that its set is empty and lists elements"));
}

TEST_CASE("a level that drops an element of its set is named") {
  CHECK(names(laws_broken_by([] {
                RoadRule rule = shorter_than(0.02);
                rule.after = [](RoadRule& self, Road& on, const Proposal&) {
                  if (self.set.size() > 0) self.set.pop(on);
                };
                return rule;
              }),
              "level \"length\" drops an element from its set that was not popped and does not die"));
}

TEST_CASE("a level that keeps dying elements is named") {
  CHECK(names(laws_broken_by([] {
                RoadRule rule = shorter_than(0.02);
                rule.keeps_the_dead = true;
                return rule;
              }),
              "level \"length\" keeps a dying element in its set"));
}

TEST_CASE("a level may drop what it no longer holds, and is named when it keeps that") {
  struct Shrinking : RoadRule {
    std::shared_ptr<double> begin = std::make_shared<double>(0);  // of the part of the road that is its own
    bool holds(const Road& on, std::span<const Knot> ends) const { return on.point(ends[0]).x >= *begin; }
  };
  const auto laws_broken = [](bool keeps) {
    return check_laws([&](auto run) {
      Road road(0, 1);
      for (const double x : {0.2, 0.4, 0.6, 0.8}) road.add(x);
      Shrinking rule{shorter_than(0.02)};
      rule.violates = [begin = rule.begin](const Road& on, const Piece& e) { return on.length(e) > 0.02 && on.point(e.left).x >= *begin; };
      rule.after = [begin = rule.begin, keeps](RoadRule& self, Road& on, const Proposal&) {
        *begin += 0.02;
        std::vector<Piece> lost;
        self.set.for_each([&](const Piece& e) {
          if (on.point(e.left).x < *begin) lost.push_back(e);
        });
        for (const Piece& e : lost)
          if (!keeps) self.set.erase(on, e);
      };
      run(road, std::tuple(std::move(rule)));
    });
  };
  CHECK(laws_broken(false).empty());
  CHECK(names(laws_broken(true), "level \"length\" keeps a dead element in its set"));
}

TEST_CASE("a level that pops something else than its next element is named") {
  struct Shuffled : RoadRule {
    void pop_next_element(Road& on) {
      Piece other = next_element();
      set.for_each([&](const Piece& e) { other = e; });
      set.erase(on, other);
    }
  };
  CHECK(names(check_laws([](auto run) {
                Road road(0, 1);
                road.add(0.5);
                Shuffled rule{shorter_than(0.3)};
                rule.skip = [](const Piece&) { return delref::Reason::size_floor; };
                run(road, std::tuple(std::move(rule)));
              }),
              "level \"length\" pops something else than its next element"));
}

/// The laws that a first level which judges points by `judge` breaks above a level that refines.
template <class Judge>
std::vector<std::string> laws_broken_by_judge(Judge judge) {
  return check_laws([&](auto run) {
    Road road(0, 1);
    run(road, std::tuple(RoadRule{.label = "judge", .judge = judge}, shorter_than(0.1)));
  });
}

TEST_CASE("a level that rejects a point and has no work is named") {
  CHECK(names(laws_broken_by_judge([](RoadRule&, Road&, const Proposal&) { return Verdict::rejected; }),
              "level \"judge\" rejects a point and has no work of its own"));
}

TEST_CASE("a level that rejects for ever and queues something is named") {
  CHECK(names(laws_broken_by_judge([](RoadRule& self, Road& on, const Proposal& p) {
                if (p.level == 0) return Verdict::permitted;
                self.set.add(on, p.zone->dying.front(), 0);
                return Verdict::rejected_forever;
              }),
              "level \"judge\" rejects a point for ever and changes its set"));
}

TEST_CASE("a level that rejects its own points is named") {
  CHECK(names(laws_broken_by([] {
                RoadRule rule = shorter_than(0.02);
                rule.judge = [](RoadRule&, Road&, const Proposal&) { return Verdict::rejected; };
                return rule;
              }),
              "level \"length\" rejects points of its own"));
}

TEST_CASE("a refinement that does not end is named") {
  CHECK(names(check_laws(
                  [](auto run) {
                    Road road(0, 1);
                    run(road, std::tuple(shorter_than(1e-9)));
                  },
                  {.max_steps = 200}),
              "the refinement does not end (once: within 200 steps)"));
}

TEST_CASE("a level that does something else each time is named") {
  double share = 0.4;
  CHECK(names(check_laws([&](auto run) {
                Road road(0, 1);
                RoadRule rule = shorter_than(0.1);
                rule.target = [s = share](const Road& on, const Piece& e) { return on.point(e.left).x + s * on.length(e); };
                share += 0.1;
                run(road, std::tuple(std::move(rule)));
              }),
              "the refinement does not do the same when it is run again"));
}

TEST_CASE("a scene that runs nothing is named") {
  CHECK(names(check_laws([](auto) {}), "the scene never calls run"));
}

}  // namespace
