// SPDX-License-Identifier: MIT
//
// What one step of the frame does, in each of the ways that it can go.
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <limits>
#include <vector>

#include <delref/core/mesher.hpp>

#include "rule.hpp"

namespace {

using namespace track;
using delref::Mesher;
using delref::Reason;
using delref::Step;
using delref::Verdict;

/// Wants every piece of the road that is there at the scan to be refined once.
RoadRule once(std::string label = "once") {
  return {.label = std::move(label), .violates = [](const Road&, const Piece&) { return true; }, .ignores_the_new = true};
}

TEST_CASE("the first level is served before the second, which is served when the first has nothing left") {
  Road road(0, 1);
  Mesher mesher(road, shorter_than(0.3, "coarse"), shorter_than(0.2, "fine"));
  std::vector<int> levels;
  struct Watch {
    std::vector<int>& levels;
    void on_proposed(const Road&, const delref::Proposal<Road>& p) { levels.push_back(p.level); }
  } watch{levels};
  CHECK(mesher.refine(delref::Control{}, watch).complete());
  CHECK(levels == std::vector{0, 0, 0, 1, 1, 1, 1});
}

TEST_CASE("each level is told its name and its own slot") {
  Road road(0, 1);
  Mesher mesher(road, shorter_than(1, "a"), shorter_than(1, "b"));
  CHECK(mesher.level<0>().slot == 0);
  CHECK(mesher.level<1>().slot == 1);
  const auto outcome = mesher.refine();
  CHECK(outcome.levels[0].name == "a");
  CHECK(outcome.levels[1].name == "b");
}

TEST_CASE("a rejected point is not inserted, its element stays, and the level that rejected it works next") {
  Road road(0, 1);
  Mesher mesher(road, first_at(0.3), once());
  CHECK(mesher.step() == Step::rejected);
  CHECK(road.number_of_vertices() == 2);
  CHECK_FALSE(mesher.level<1>().empty());
  CHECK_FALSE(mesher.level<0>().empty());
  CHECK(mesher.step() == Step::inserted);
  CHECK(road.coordinates() == std::vector<double>{0, 0.3, 1});
  CHECK(mesher.outcome().levels[1].rejected == 1);
}

TEST_CASE("levels are asked from the first to the proposing one, and the others are not") {
  Road road(0, 1);
  std::vector<char> asked;
  const auto listen = [&](char who, RoadRule rule) {
    rule.judge = [&asked, who](RoadRule&, Road&, const RoadRule::Proposal&) {
      asked.push_back(who);
      return Verdict::permitted;
    };
    return rule;
  };
  Mesher mesher(road, listen('a', {}), listen('b', once()));
  CHECK(mesher.step() == Step::inserted);
  CHECK(asked == std::vector{'a', 'b'});

  asked.clear();
  Road other(0, 1);
  Mesher reversed(other, listen('a', once()), listen('b', {}));
  CHECK(reversed.step() == Step::inserted);
  CHECK(asked == std::vector{'a'});
}

TEST_CASE("an element whose point is rejected for ever leaves the set and is listed with the judge's reason") {
  Road road(0, 2);
  const auto never = [](RoadRule&, Road&, const RoadRule::Proposal&) { return Verdict::rejected_forever; };
  Mesher mesher(road, RoadRule{.label = "judge", .judge = never, .reason = Reason::protected_segment}, shorter_than(1));
  CHECK(mesher.step() == Step::rejected_forever);
  CHECK(mesher.step() == Step::done);

  const auto outcome = mesher.outcome();
  CHECK(road.number_of_vertices() == 2);
  CHECK(outcome.levels[1].rejected_forever == 1);
  REQUIRE(outcome.unmet.size() == 1);
  CHECK(outcome.unmet[0].level == 1);
  CHECK(outcome.unmet[0].reason == Reason::protected_segment);
  CHECK(outcome.unmet[0].criterion == "length criterion");
  CHECK(outcome.unmet[0].place.x == 1);
  CHECK(outcome.unmet[0].vertex_count == 2);
  CHECK(outcome.unmet[0].vertices[0] == 0);
  CHECK(outcome.unmet[0].vertices[1] == 1);
  CHECK(outcome.unmet_count(Reason::protected_segment) == 1);
  CHECK(outcome.unmet_count(Reason::precision) == 0);
}

TEST_CASE("a level may reject its own point for ever") {
  Road road(0, 1);
  RoadRule rule = shorter_than(0.6);
  rule.judge = [](RoadRule&, Road&, const RoadRule::Proposal&) { return Verdict::rejected_forever; };
  CHECK(Mesher(road, std::move(rule)).refine().unmet_count(Reason::rejected_by_level) == 1);
}

TEST_CASE("a level that rejects a point and queues nothing breaks the contract: the element is dropped, and refinement goes on") {
  Road road(0, 1);
  const auto break_contract = [](RoadRule&, Road&, const RoadRule::Proposal& p) {
    return p.point.x == 0.25 ? Verdict::rejected : Verdict::permitted;
  };
  const auto outcome = Mesher(road, RoadRule{.judge = break_contract}, shorter_than(0.3)).refine();
  CHECK(outcome.complete());
  CHECK(outcome.unmet_count(Reason::level_contract) == 1);
  CHECK(road.coordinates() == std::vector<double>{0, 0.5, 0.75, 1});
}

TEST_CASE("a level that rejects its own point breaks the contract") {
  Road road(0, 1);
  RoadRule rule = shorter_than(0.6);
  rule.judge = [](RoadRule&, Road&, const RoadRule::Proposal&) { return Verdict::rejected; };
  CHECK(Mesher(road, std::move(rule)).refine().unmet_count(Reason::level_contract) == 1);
}

TEST_CASE("an element that its level gives up beforehand is listed with that reason, and no point is computed") {
  Road road(0, 1);
  RoadRule rule = shorter_than(0.6);
  rule.skip = [](const Piece&) { return Reason::size_floor; };
  rule.target = [](const Road&, const Piece&) -> double { throw "a point was asked for"; };
  CHECK(Mesher(road, std::move(rule)).refine().unmet_count(Reason::size_floor) == 1);
}

/// The reason for which the only piece of a road of length 1 is dropped when the point `x` is proposed for it.
template <class Prepare>
Reason reason_for(double x, Prepare&& prepare) {
  Road road(0, 1);
  prepare(road);
  RoadRule rule = shorter_than(0.6);
  rule.target = [x](const Road&, const Piece&) { return x; };
  const std::size_t before = road.number_of_vertices();
  const auto outcome = Mesher(road, std::move(rule)).refine();
  CHECK(outcome.complete());
  CHECK(road.number_of_vertices() == before);
  REQUIRE(outcome.unmet.size() == 1);
  return outcome.unmet[0].reason;
}
Reason reason_for(double x) {
  return reason_for(x, [](Road&) {});
}

TEST_CASE("a point that is not finite drops its element for precision") {
  CHECK(reason_for(std::numeric_limits<double>::quiet_NaN()) == Reason::precision);
  CHECK(reason_for(std::numeric_limits<double>::infinity()) == Reason::precision);
}

TEST_CASE("a point on a vertex drops its element for precision") {
  CHECK(reason_for(0) == Reason::precision);
  CHECK(reason_for(1) == Reason::precision);
}

TEST_CASE("a point that has no valid star drops its element for precision") {
  CHECK(reason_for(0.5, [](Road& road) { road.make_degenerate(0.5); }) == Reason::precision);
}

TEST_CASE("a point that does not kill its element drops it for precision") {
  CHECK(reason_for(0.2, [](Road& road) { road.add(0.3); }) == Reason::precision);
}

TEST_CASE("a point outside drops its element as outside") {
  CHECK(reason_for(-1) == Reason::outside);
  CHECK(reason_for(2) == Reason::outside);
}

TEST_CASE("a point behind a constraint that no level owns drops its element as blocked") {
  CHECK(reason_for(0.2, [](Road& road) { road.add(0.3, true); }) == Reason::blocked);
}

/// A road with a wall at 0.4, whose long piece proposes a point behind it, under a first level that judges the wall.
struct BlockedScene {
  Road road{0, 1};
  Knot wall = road.add(0.4, true);
  RoadRule owner{.label = "owner"};
  RoadRule climber = once("climber");

  BlockedScene() {
    climber.violates = [](const Road& on, const Piece& e) { return on.length(e) > 0.55; };
    climber.target = [](const Road& on, const Piece& e) { return on.point(e.left).x == 0.4 ? 0.1 : 0.5; };
  }
};

TEST_CASE("the owner of a blocking constraint rejects the point, queues work, and the point is proposed again") {
  BlockedScene scene;
  scene.owner.judge_wall = [&](RoadRule& self, Road& on, Knot wall) {
    CHECK(wall == scene.wall);
    self.set.add(on, on.piece_from(wall), 0);
    return Verdict::rejected;
  };
  Mesher mesher(scene.road, std::move(scene.owner), std::move(scene.climber));
  CHECK(mesher.step() == Step::rejected);
  CHECK(mesher.step() == Step::inserted);
  CHECK(scene.road.coordinates() == std::vector<double>{0, 0.4, 0.7, 1});
  CHECK(mesher.step() == Step::done);
}

TEST_CASE("the owner of a blocking constraint can reject the point for ever, with its reason") {
  BlockedScene scene;
  scene.owner.judge_wall = [](RoadRule&, Road&, Knot) { return Verdict::rejected_forever; };
  scene.owner.reason = Reason::protected_segment;
  const auto outcome = Mesher(scene.road, std::move(scene.owner), std::move(scene.climber)).refine();
  CHECK(outcome.unmet_count(Reason::protected_segment) == 1);
}

TEST_CASE("the owner of a blocking constraint that rejects and queues nothing breaks the contract") {
  BlockedScene scene;
  scene.owner.judge_wall = [](RoadRule&, Road&, Knot) { return Verdict::rejected; };
  CHECK(Mesher(scene.road, std::move(scene.owner), std::move(scene.climber)).refine().unmet_count(Reason::level_contract) == 1);
}

TEST_CASE("a new vertex knows its level and what its level says it lies on") {
  Road road(0, 1);
  RoadRule rule = once();
  rule.on_what = delref::Carrier{1, 17};
  Mesher mesher(road, RoadRule{}, std::move(rule));
  mesher.refine();
  CHECK(road.provenance({2}) == 1);
  CHECK(road.carrier({2}) == delref::Carrier{1, 17});
  CHECK(road.provenance({0}) == delref::input_level);
}

TEST_CASE("everybody sees the vertices that vanish before they do, and what was given up at them is forgotten") {
  Road road(0, 8);
  road.add(1);  // 2: vanishes
  road.add(4);  // 3
  RoadRule sweeper{.label = "sweeper"};
  sweeper.violates = [](const Road& on, const Piece& e) { return on.point(e.left).x == 1; };
  sweeper.vanishes = [](Knot v) { return v.number == 2; };
  sweeper.ignores_the_new = true;

  // The first level gives both pieces at vertex 2 up, and another one; then the second removes the vertex.
  RoadRule helpless{.label = "helpless", .violates = [](const Road&, const Piece&) { return true; }};
  helpless.skip = [](const Piece&) { return Reason::size_floor; };
  helpless.ignores_the_new = true;
  std::vector<Knot> seen;
  helpless.before = [&](RoadRule&, Road& on, const RoadRule::Proposal& p) {
    for (const Knot v : p.zone->vanishing()) {
      seen.push_back(v);
      CHECK(on.point(v).x == 1);
    }
  };

  Mesher mesher(road, std::move(helpless), std::move(sweeper));
  const auto outcome = mesher.refine();
  CHECK(seen == std::vector<Knot>{{2}});
  CHECK(road.coordinates() == std::vector<double>{0, 2.5, 4, 8});
  REQUIRE(outcome.unmet.size() == 1);
  CHECK(outcome.unmet[0].place.x == 6);
}

TEST_CASE("an element that was given up and died later is not listed") {
  Road road(0, 1);
  RoadRule helpless{.violates = [](const Road& on, const Piece& e) { return on.length(e) == 1; }};
  helpless.skip = [](const Piece&) { return Reason::size_floor; };
  const auto outcome = Mesher(road, std::move(helpless), shorter_than(0.6)).refine();
  CHECK(outcome.levels[0].rejected_forever == 1);
  CHECK(outcome.unmet.empty());
}

}  // namespace
