// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the levels of space are built on and needs no triangulation: the table of simplices and the measures of a tetrahedron.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

#include <delref/criteria/tetrahedron_shape.hpp>
#include <delref/triangulation/simplex_table.hpp>

#include "../../property/generators.hpp"  // for its random numbers alone

using namespace delref;
using Catch::Approx;

namespace {

/// Sets and erases keys of small numbers at random, so that many are set twice and erased twice.
template <std::size_t N, class KeyOf>
void check_against_a_map(std::uint64_t seed, int range, KeyOf key_of) {
  property::Random random(seed);
  SimplexTable<N> table;
  std::map<typename SimplexTable<N>::Key, std::uint32_t> truth;
  for (std::uint32_t step = 0; step < 20'000; ++step) {
    const auto key = key_of([&] { return static_cast<std::uint32_t>(random.integer(0, range)); });
    const bool grows = step / 4000 % 2 == 0;
    if (random.chance(grows ? 0.7 : 0.3)) {
      table.set(key, step);
      truth[key] = step;
    } else {
      table.erase(key);
      truth.erase(key);
    }
    REQUIRE(table.size() == truth.size());
    const auto asked = key_of([&] { return static_cast<std::uint32_t>(random.integer(0, range)); });
    const auto found = truth.find(asked);
    REQUIRE(table.find(asked) == (found == truth.end() ? SimplexTable<N>::none : found->second));
  }
  for (const auto& [key, index] : truth) REQUIRE(table.find(key) == index);
  table.clear();
  CHECK(table.size() == 0);
  for (const auto& [key, index] : truth) CHECK(table.find(key) == SimplexTable<N>::none);
}

TetrahedronShape regular() { return TetrahedronShape({{{1, 1, 1}, {-1, 1, -1}, {1, -1, -1}, {-1, -1, 1}}}); }

}  // namespace

TEST_CASE("A key does not depend on the order of the vertices") {
  using Table = SimplexTable<3>;
  for (const auto& [a, b, c] : {std::array{1, 2, 3}, {1, 3, 2}, {2, 1, 3}, {2, 3, 1}, {3, 1, 2}, {3, 2, 1}})
    CHECK(Table::key(a, b, c) == Table::Key{1, 2, 3});
  CHECK(SimplexTable<2>::key(9, 4) == SimplexTable<2>::Key{4, 9});
}

TEST_CASE("A table of edges holds what a map would, after sets and erasures at random") {
  for (std::uint64_t seed = 0; seed < 4; ++seed)
    check_against_a_map<2>(seed, seed % 2 == 0 ? 12 : 100, [](auto number) { return SimplexTable<2>::key(number(), number()); });
}

TEST_CASE("A table of triangles holds what a map would, after sets and erasures at random") {
  for (std::uint64_t seed = 0; seed < 4; ++seed)
    check_against_a_map<3>(seed, seed % 2 == 0 ? 6 : 20, [](auto number) { return SimplexTable<3>::key(number(), number(), number()); });
}

TEST_CASE("Nothing is found in and nothing erased from an empty table") {
  SimplexTable<2> table;
  CHECK(table.find({1, 2}) == SimplexTable<2>::none);
  table.erase({1, 2});
  CHECK(table.size() == 0);
}

TEST_CASE("A regular tetrahedron has its measures") {
  const TetrahedronShape t = regular();
  CHECK(t.sixfold_volume == Approx(16));
  CHECK(std::sqrt(squared_distance(t.circumcentre, Point3{})) < 1e-15);
  CHECK(t.squared_circumradius == Approx(3));
  CHECK(t.shortest_squared == Approx(8));
  CHECK(t.longest_squared == Approx(8));
  CHECK(t.squared_radius_edge() == Approx(0.375));
  CHECK_FALSE(t.is_flat());
}

TEST_CASE("The circumcentre is as far from every corner as the circumradius says") {
  property::Random random(1);
  for (int k = 0; k < 1000; ++k) {
    std::array<Point3, 4> p;
    for (Point3& q : p) q = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    const TetrahedronShape t(p);
    if (std::abs(t.sixfold_volume) < 1e-3) continue;
    for (const Point3 q : p) CHECK(squared_distance(t.circumcentre, q) == Approx(t.squared_circumradius).epsilon(1e-8));
  }
}

TEST_CASE("A tetrahedron is flat when its volume is rounding, whatever its size") {
  for (const double s : {1e-9, 1.0, 1e9}) {
    CHECK(TetrahedronShape({{{0, 0, 0}, {s, 0, 0}, {0, s, 0}, {s, s, 1e-14 * s}}}).is_flat());
    CHECK_FALSE(TetrahedronShape({{{0, 0, 0}, {s, 0, 0}, {0, s, 0}, {s, s, 1e-9 * s}}}).is_flat());
  }
}

TEST_CASE("The centre of the largest face is that of its circle") {
  const TetrahedronShape t({{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0.1, 0.1, 0.1}}});
  CHECK(std::sqrt(squared_distance(t.centre_of_largest_face(), {1, 1, 0})) < 1e-12);
}
