// SPDX-License-Identifier: MIT
//
// Each name of the module delref.core, used once. A module exports no operators of the standard library: who compares a
// std::optional that delref gives includes <optional>.
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <limits>
#include <optional>
#include <ranges>
#include <span>
#include <string>
#include <thread>
#include <tuple>
#include <vector>

import delref.core;

namespace {

/// The shortest triangulation: an interval, cut at vertices in increasing order.
struct Interval {
  struct Point {
    double x = 0;
    friend bool is_finite(Point p) { return std::isfinite(p.x); }
  };
  using Vertex = std::size_t;
  using Edge = std::array<std::size_t, 2>;
  using Hint = Edge;
  struct Zone {
    Edge dying{};
    std::array<Vertex, 0> vanishing() const { return {}; }
  };
  static constexpr int dimension = 1;

  std::vector<Point> points{{0}, {1}};
  std::vector<std::size_t> next{1, 0};
  std::vector<delref::Carrier> carriers{{0, 0}, {0, 1}};
  std::vector<delref::LevelIndex> levels{delref::input_level, delref::input_level};

  delref::Location<Interval> conflict_zone(Point p, const Hint& hint, Zone& zone) {
    using Kind = delref::Location<Interval>::Kind;
    zone.dying = hint;
    const bool inside = points[hint[0]].x < p.x && p.x < points[hint[1]].x;
    return {inside ? Kind::zone : Kind::outside, hint};
  }
  Vertex insert(Point p, Zone& zone) {
    points.push_back(p);
    next.push_back(zone.dying[1]);
    carriers.push_back({});
    levels.push_back(0);
    return next[zone.dying[0]] = points.size() - 1;
  }
  Point point(Vertex v) const { return points[v]; }
  std::size_t index(Vertex v) const { return v; }
  delref::Carrier carrier(Vertex v) const { return carriers[v]; }
  delref::LevelIndex provenance(Vertex v) const { return levels[v]; }
  void set_origin(Vertex v, delref::Carrier carrier, delref::LevelIndex level) { carriers[v] = carrier, levels[v] = level; }
  std::size_t number_of_vertices() const { return points.size(); }
  bool is_simplex(std::span<const Vertex> v) const { return v.size() == 2 && next[v[0]] == v[1]; }
  Point barycentre(std::span<const Vertex> v) const { return {(points[v.front()].x + points[v.back()].x) / 2}; }
  void clear_slots() {}
  Edge vertices(const Edge& e) const { return e; }
  bool dies(const Edge& e, const Zone& zone) const { return e == zone.dying; }
};

/// Halves what is longer than a tenth.
struct Halve {
  using Element = Interval::Edge;
  std::vector<Element> set;

  void scan_triangulation(Interval& tr) {
    set.clear();
    for (std::size_t v = 0; v != 1; v = tr.next[v]) test(tr, {v, tr.next[v]});
  }
  bool empty() const { return set.empty(); }
  Element next_element() { return set.back(); }
  void pop_next_element(Interval&) { set.pop_back(); }
  Interval::Point refinement_point(const Interval& tr, const Element& e) { return {(tr.points[e[0]].x + tr.points[e[1]].x) / 2}; }
  delref::Verdict check_refinement_point(Interval&, const delref::Proposal<Interval>&) { return delref::Verdict::permitted; }
  void before_insertion(Interval&, const delref::Proposal<Interval>& p) { std::erase(set, p.zone->dying); }
  void after_insertion(Interval& tr, std::size_t v, const delref::Proposal<Interval>& p) {
    test(tr, {p.zone->dying[0], v});
    test(tr, {v, p.zone->dying[1]});
  }
  template <class F>
  void for_each_queued(F&& f) const { for (const Element& e : set) f(e); }

 private:
  void test(const Interval& tr, const Element& e) {
    if (tr.points[e[1]].x - tr.points[e[0]].x > 0.1) set.push_back(e);
  }
};

struct Watcher {
  int scans = 0, proposals = 0, insertions = 0, rejections = 0;
  std::size_t most_waiting = 0;
  void on_scanned(const Interval&) { ++scans; }
  void on_proposed(const Interval&, const delref::Proposal<Interval>&) { ++proposals; }
  void on_rejected(const Interval&, const delref::Proposal<Interval>&, delref::LevelIndex) { ++rejections; }
  void on_rejected_forever(const Interval&, const delref::Proposal<Interval>&, delref::Reason) { ++rejections; }
  void on_before_insertion(const Interval&, const delref::Proposal<Interval>&) {}
  void on_after_insertion(const Interval&, Interval::Vertex, const delref::Proposal<Interval>&) { ++insertions; }
  void on_progress(const Interval&, std::span<const std::size_t> queued) { most_waiting = std::max(most_waiting, queued.front()); }
};

static_assert(delref::TriangulationTypes<Interval> && delref::FindsConflictZones<Interval> && delref::InsertsIntoZones<Interval> &&
              delref::DescribesVertices<Interval> && delref::ClearsSlots<Interval> && delref::Triangulation<Interval>);
static_assert(delref::StoresElement<Interval, Interval::Edge> && delref::explain_triangulation<Interval>());
static_assert(delref::Scans<Halve, Interval> && delref::Queues<Halve, Interval> && delref::Proposes<Halve, Interval> &&
              delref::Checks<Halve, Interval> && delref::Follows<Halve, Interval> && delref::MesherLevel<Halve, Interval>);
static_assert(delref::explain_optional_members<Halve, Interval>() && delref::explain_level<Halve, Interval>() && !delref::MesherLevel<Watcher, Interval>);
static_assert(delref::ObservesScan<Watcher, Interval> && delref::ObservesProposal<Watcher, Interval> &&
              delref::ObservesRejection<Watcher, Interval> && delref::ObservesRejectionForever<Watcher, Interval> &&
              delref::ObservesBeforeInsertion<Watcher, Interval> && delref::ObservesAfterInsertion<Watcher, Interval> &&
              delref::ObservesProgress<Watcher, Interval> && delref::Observer<Watcher, Interval> && delref::explain_observer<Watcher, Interval>());
static_assert(delref::RefinementQueue<delref::LifoQueue<int>, int> && delref::RefinementQueue<delref::FifoQueue<int>, int> &&
              delref::RefinementQueue<delref::BucketQueue<int>, int> && delref::explain_queue<delref::LifoQueue<int>, int>());
static_assert(std::same_as<delref::LifoQueue<int>, delref::ListQueue<int, delref::ListOrder::last_in_first_out>>);

}  // namespace

TEST_CASE("points and vectors of the imported module have their operators") {
  const delref::Point2 a{0, 0}, b{3, 4};
  const delref::Vector2 v = b - a;
  CHECK(v == delref::Vector2{3, 4});
  CHECK(a + v == b);
  CHECK(2 * v - v + v == delref::Vector2{6, 8});
  CHECK(dot(v, v) == 25);
  CHECK(cross(v, delref::Vector2{-4, 3}) == 25);
  CHECK(squared_length(v) == squared_distance(a, b));
  CHECK(midpoint(a, b) == delref::Point2{1.5, 2});
  CHECK(is_finite(a));
}

TEST_CASE("a triangulation and a level of one's own refine by import of the core alone") {
  Interval tr;
  Watcher watcher;
  delref::Mesher mesher(tr, Halve{});
  CHECK(mesher.step(watcher) == delref::Step::inserted);
  const delref::Outcome<Interval::Point> outcome = mesher.refine(delref::Control{}, watcher);
  CHECK(outcome.complete());
  CHECK(outcome.unmet.empty());
  CHECK(tr.number_of_vertices() == 17);
  CHECK(watcher.scans == 1);
  CHECK(watcher.insertions == 15);
  CHECK(watcher.rejections == 0);
  CHECK(watcher.most_waiting == 1);
  CHECK(mesher.queued() == std::array<std::size_t, 1>{0});
  const delref::LevelCounts counts = outcome.levels.front();
  CHECK(counts.inserted == 15);
  CHECK(tr.provenance(16) == 0);
  CHECK(tr.carrier(16).index == delref::Carrier::none);
}

TEST_CASE("a budget stops an imported mesher, and what is left is listed") {
  Interval tr;
  delref::Mesher mesher(tr, std::tuple(Halve{}));
  delref::Budget budget;
  budget.max_vertices = 5;
  const auto outcome = mesher.refine(delref::Control(budget));
  CHECK(outcome.stopped == delref::Stop::vertices);
  REQUIRE_FALSE(outcome.unmet.empty());
  const delref::Unmet<Interval::Point>& unmet = outcome.unmet.front();
  CHECK(unmet.reason == delref::Reason::budget);
  CHECK(delref::to_string(unmet.reason) == "budget");
}

TEST_CASE("a stop token interrupts through the imported control") {
  std::stop_source source;
  source.request_stop();
  const delref::Control control({}, source.get_token());
  CHECK(control.stop() == delref::Stop::token);
  CHECK_THROWS_AS(delref::throw_if_stopped(control), delref::Interrupted);
  delref::StopCheck check(control);
  CHECK_THROWS_AS(std::ranges::for_each(std::views::iota(0, 10'000), [&](int) { check(); }), delref::Interrupted);
}

TEST_CASE("an element set keeps places in slots of one's own") {
  struct Slots {
    std::array<delref::QueuePosition, 3> slots{-1, -1, -1};
    delref::QueuePosition slot(int e, std::size_t) const { return slots[static_cast<std::size_t>(e)]; }
    void set_slot(int e, std::size_t, delref::QueuePosition p) { slots[static_cast<std::size_t>(e)] = p; }
  } tr;
  delref::ElementSet<int, delref::FifoQueue<int>> set;
  CHECK(set.add(tr, 2, 0));
  CHECK_FALSE(set.add(tr, 2, 0));
  CHECK(set.add(tr, 1, 0));
  CHECK(set.front() == 2);
  set.erase(tr, 2);
  CHECK(set.front() == 1);
  set.pop(tr);
  CHECK(set.empty());
}

TEST_CASE("the law tests run on a level of one's own by import") {
  const auto broken = delref::testing::check_laws(
      [](auto run) {
        Interval tr;
        run(tr, std::tuple(Halve{}));
      },
      delref::testing::LawOptions{1000});
  CHECK(broken == std::vector<std::string>{});
}
