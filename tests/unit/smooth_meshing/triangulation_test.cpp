// SPDX-License-Identifier: GPL-3.0-or-later
//
// What smooth meshing asks of the triangulation of space beside the rest: faces with slots, and a filter of the in-sphere predicate that
// is never wrong.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

#include <catch2/catch_test_macros.hpp>

#include <delref/triangulation/delaunay_3.hpp>
#include <delref/triangulation/detail/spatial_filters.hpp>

#include "../../property/generators.hpp"  // for its random numbers alone
#include "scenes.hpp"

using namespace delref;

namespace {

template <class Tr>
std::array<std::size_t, 3> corners(const Tr& tr, const typename Tr::Facet& f) {
  std::array<std::size_t, 3> numbers{};
  const auto v = tr.vertices(f);
  for (std::size_t i = 0; i < 3; ++i) numbers[i] = tr.is_infinite(v[i]) ? std::numeric_limits<std::size_t>::max() : tr.index(v[i]);
  std::ranges::sort(numbers);
  return numbers;
}

/// Inserts points of a generator and compares the slots of all faces with a table by their corners.
template <class Tr, class NextPoint>
void check_slots(std::uint64_t seed, int count, NextPoint next_point) {
  property::Random random(seed);
  Tr tr;
  start(tr, {{-1, -1, -1}, {1, 1, 1}});
  tr.clear_slots();
  constexpr std::size_t slots = Tr::template slot_count<typename Tr::Facet>;
  std::map<std::array<std::size_t, 3>, std::array<QueuePosition, slots>> table;
  typename Tr::Zone zone;
  for (int step = 0; step < count; ++step) {
    const Point3 p = next_point(random);
    if (tr.conflict_zone(p, typename Tr::Hint(tr.infinite_cell()), zone).kind != Location<Tr>::Kind::zone) continue;
    tr.insert(p, zone);
    std::map<std::array<std::size_t, 3>, std::array<QueuePosition, slots>> now;
    for (const auto c : tr.all_cells())
      for (int i = 0; i < 4; ++i) {
        const auto f = tr.facet(c, i);
        std::array<QueuePosition, slots> held{};
        for (std::size_t k = 0; k < slots; ++k) {
          held[k] = tr.slot(f, k);
          REQUIRE(tr.slot(tr.mirror(f), k) == held[k]);
        }
        const auto key = corners(tr, f);
        const auto before = table.find(key);
        if (now.contains(key)) {
          REQUIRE(now[key] == held);
          continue;
        }
        if (before != table.end()) {
          REQUIRE(held == before->second);
        } else {
          for (const QueuePosition position : held) REQUIRE(position == -1);
        }
        if (random.chance(0.3))
          for (std::size_t k = 0; k < slots; ++k) tr.set_slot(random.chance(0.5) ? f : tr.mirror(f), k, held[k] = random.integer(-1, 1000));
        now[key] = held;
      }
    table = std::move(now);
  }
}

using Exact = CGAL::Exact_predicates_inexact_constructions_kernel;
Exact::Point_3 exact(Point3 p) { return {p.x, p.y, p.z}; }

struct Tally {
  int told = 0, open = 0, wrong = 0;
  void ask(std::array<Point3, 5> p) {
    const auto side = CGAL::orientation(exact(p[0]), exact(p[1]), exact(p[2]), exact(p[3]));
    if (side == CGAL::COPLANAR) return;
    if (side == CGAL::NEGATIVE) std::swap(p[0], p[1]);
    const int filtered = detail::filtered_side_of_sphere(p[0], p[1], p[2], p[3], p[4]);
    if (filtered == 0) {
      ++open;
      return;
    }
    ++told;
    const auto truth = CGAL::side_of_oriented_sphere(exact(p[0]), exact(p[1]), exact(p[2]), exact(p[3]), exact(p[4]));
    wrong += filtered != static_cast<int>(truth);
  }
};

Point3 on_sphere(property::Random& random, Point3 centre, double r) {
  while (true) {
    const Vector3 d{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    const double l = std::sqrt(squared_length(d));
    if (l > 0.1 && l < 1) return centre + (r / l) * d;
  }
}

}  // namespace

TEST_CASE("a face keeps its slots from both sides while it is there, and a new one has none") {
  const auto anywhere = [](property::Random& random) { return Point3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)}; };
  check_slots<Delaunay3<1, 1>>(1, 120, anywhere);
  check_slots<Delaunay3<2, 2>>(2, 60, anywhere);
}

TEST_CASE("the same holds for points on a sphere, on a grid, and outside the hull") {
  check_slots<Delaunay3<1, 1>>(3, 80, [](property::Random& random) { return on_sphere(random, {}, 1); });
  check_slots<Delaunay3<1, 1>>(4, 100, [](property::Random& random) {
    return Point3{random.integer(-2, 2) * 0.5, random.integer(-2, 2) * 0.5, random.integer(-2, 2) * 0.5};
  });
  check_slots<Delaunay3<1, 1>>(5, 60, [](property::Random& random) {
    return Point3{random.uniform(-6, 6), random.uniform(-6, 6), random.uniform(-6, 6)};
  });
}

TEST_CASE("what the filter tells of points at random is right, and it tells nearly always") {
  property::Random random(11);
  Tally tally;
  for (int i = 0; i < 20'000; ++i) {
    std::array<Point3, 5> p;
    for (Point3& q : p) q = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    tally.ask(p);
  }
  CHECK(tally.wrong == 0);
  CHECK(tally.told > 19'900);
}

TEST_CASE("what the filter tells of points all but on one sphere is right, at any size and distance") {
  property::Random random(12);
  Tally tally;
  for (const double scale : {1e-20, 1e-6, 1.0, 1e6, 1e20})
    for (const double away : {0.0, 1.0, 1e3, 1e8})
      for (int i = 0; i < 2000; ++i) {
        const Point3 centre = Point3{} + (scale * away) * Vector3{1, -0.7, 0.3};
        std::array<Point3, 5> p;
        for (Point3& q : p) q = on_sphere(random, centre, scale);
        const double nudge = std::array{0.0, 1e-16, 1e-15, 1e-14, 1e-12, 1e-9}[static_cast<std::size_t>(random.integer(0, 5))];
        p[4] = p[4] + (random.chance(0.5) ? nudge : -nudge) * (p[4] - centre);
        tally.ask(p);
      }
  CHECK(tally.wrong == 0);
  CHECK(tally.told > 1000);
  CHECK(tally.open > 1000);
}

TEST_CASE("the filter leaves points of a grid that are on one sphere open, and is right about the others") {
  property::Random random(13);
  for (const double offset : {0.0, 1e5, 1e15}) {
    Tally tally;
    int cospherical = 0;
    for (int i = 0; i < 20'000; ++i) {
      std::array<Point3, 5> p;
      for (Point3& q : p) q = {offset + random.integer(0, 3), offset + random.integer(0, 3), offset + random.integer(0, 3)};
      const int open = tally.open;
      if (CGAL::orientation(exact(p[0]), exact(p[1]), exact(p[2]), exact(p[3])) == CGAL::COPLANAR) continue;
      const bool is_on = CGAL::side_of_oriented_sphere(exact(p[0]), exact(p[1]), exact(p[2]), exact(p[3]), exact(p[4])) == CGAL::ON_ORIENTED_BOUNDARY;
      tally.ask(p);
      cospherical += is_on;
      if (is_on) CHECK(tally.open == open + 1);
    }
    CHECK(tally.wrong == 0);
    CHECK(cospherical > 500);
    CHECK(tally.told > 5000);
  }
}

TEST_CASE("coordinates so small or large that products leave the range of numbers are left open or told right") {
  property::Random random(14);
  Tally tally;
  for (const double scale : {1e-300, 1e-120, 1e-80, 1e60, 1e75, 1e150, 1e300})
    for (int i = 0; i < 500; ++i) {
      std::array<Point3, 5> p;
      for (Point3& q : p) q = {scale * random.uniform(-1, 1), scale * random.uniform(-1, 1), scale * random.uniform(-1, 1)};
      tally.ask(p);
    }
  CHECK(tally.wrong == 0);
}
