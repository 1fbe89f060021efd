// SPDX-License-Identifier: GPL-3.0-or-later
//
// What counts as a disk around a vertex of a surface, and the lists of the facets at each vertex.
#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <vector>

#include <catch2/catch_test_macros.hpp>

#include <delref/levels/surface_complex.hpp>
#include <delref/levels/umbrella.hpp>
#include <delref/triangulation/delaunay_3.hpp>

#include "../../property/generators.hpp"  // for its random numbers alone
#include "scenes.hpp"

using namespace delref;

namespace {

using Regions = std::array<int, 2>;
constexpr Regions usual{0, outside};

/// Spokes from each corner to the next, and from the last to the first when it is closed.
void add_ring(Umbrella& umbrella, const std::vector<std::size_t>& corners, bool is_closed = true, Regions regions = usual) {
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) umbrella.add(regions, corners[i], corners[i + 1]);
  if (is_closed) umbrella.add(regions, corners.back(), corners.front());
}
bool is_disk(const std::vector<std::vector<std::size_t>>& closed, const std::vector<std::vector<std::size_t>>& open = {}) {
  Umbrella umbrella;
  for (const auto& ring : closed) add_ring(umbrella, ring);
  for (const auto& fan : open) add_ring(umbrella, fan, false);
  return umbrella.is_disk();
}

}  // namespace

TEST_CASE("a closed ring of facets is a disk, however the facets are turned and ordered") {
  CHECK(is_disk({{1, 2, 3}}));
  CHECK(is_disk({{7, 3, 9, 1, 4, 100}}));
  Umbrella umbrella;
  umbrella.add(usual, 5, 2);
  umbrella.add(usual, 9, 5);
  umbrella.add(usual, 4, 2);
  umbrella.add(usual, 4, 9);
  CHECK(umbrella.is_disk());
  CHECK_FALSE(umbrella.empty());
  umbrella.clear();
  CHECK(umbrella.empty());
}

TEST_CASE("no facets are a disk: nothing is wrong with a vertex that is off the surface") {
  Umbrella umbrella;
  CHECK(umbrella.is_disk());
}

TEST_CASE("two facets on the same three vertices are a closed ring of two") {
  CHECK(is_disk({{1, 2}}));
}

TEST_CASE("two rings, a ring and a fan, and two fans are no disk") {
  CHECK_FALSE(is_disk({{1, 2, 3}, {4, 5, 6}}));
  CHECK_FALSE(is_disk({{1, 2, 3}}, {{4, 5, 6}}));
  CHECK_FALSE(is_disk({}, {{1, 2, 3}, {4, 5, 6}}));
}

TEST_CASE("rings that share a corner are no disk, for four facets meet in an edge") {
  CHECK_FALSE(is_disk({{1, 2, 3}, {3, 4, 5}}));
  CHECK_FALSE(is_disk({{1, 2, 3}, {3, 2, 5}}));
}

TEST_CASE("a fan with two free edges is no disk where only two regions meet") {
  CHECK_FALSE(is_disk({}, {{1, 2, 3}}));
  CHECK_FALSE(is_disk({}, {{1, 2}}));
}

TEST_CASE("at a junction each two regions may have a fan of their own") {
  Umbrella umbrella;
  add_ring(umbrella, {1, 2, 3}, false, {1, 0});
  add_ring(umbrella, {1, 4, 3}, false, {0, outside});
  add_ring(umbrella, {1, 5, 6, 3}, false, {1, outside});
  CHECK(umbrella.is_disk());
}

TEST_CASE("which pair of regions comes first does not matter to a fan") {
  for (const Regions& pair : {Regions{0, outside}, Regions{1, outside}, Regions{1, 0}, Regions{2, 1}}) {
    Umbrella umbrella;
    add_ring(umbrella, {1, 2, 3}, false, pair);
    for (const Regions& other : {Regions{0, outside}, Regions{1, outside}, Regions{1, 0}, Regions{2, 1}})
      if (other != pair) add_ring(umbrella, {1, 10 + static_cast<std::size_t>(other[0]), 3}, false, other);
    CHECK(umbrella.is_disk());
  }
}

TEST_CASE("at a junction two fans between the same regions are no disk") {
  Umbrella umbrella;
  add_ring(umbrella, {1, 2, 3}, false, {1, 0});
  add_ring(umbrella, {4, 5, 6}, false, {1, 0});
  add_ring(umbrella, {1, 7, 6}, false, {0, outside});
  add_ring(umbrella, {3, 8, 4}, false, {1, outside});
  CHECK_FALSE(umbrella.is_disk());
}

TEST_CASE("a ring between two regions and a ring between two others at one vertex pass, for each is a disk") {
  Umbrella umbrella;
  add_ring(umbrella, {1, 2, 3}, true, {0, outside});
  add_ring(umbrella, {4, 5, 6}, true, {1, outside});
  CHECK(umbrella.is_disk());
}

TEST_CASE("the lists of the complex are those of a map, after additions and removals at random") {
  using Tr = Delaunay3<1, 1>;
  Tr tr;
  property::Random random(3);
  start(tr, {{-2, -2, -2}, {2, 2, 2}});
  Tr::Zone zone;
  for (int i = 0; i < 60; ++i) {
    const Point3 p{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    if (tr.conflict_zone(p, Tr::Hint(tr.infinite_cell()), zone).kind == Location<Tr>::Kind::zone) tr.insert(p, zone);
  }
  std::vector<Tr::Facet> facets;
  for (const auto c : tr.finite_cells())
    for (int i = 0; i < 4; ++i) facets.push_back(tr.facet(c, i));

  SurfaceComplex<Tr> complex;
  complex.assign_slot(0);
  std::map<std::set<std::size_t>, double> truth;  // the squared radius that was given, by corners
  const auto corners = [&](const Tr::Facet& f) {
    std::set<std::size_t> numbers;
    for (const auto v : tr.vertices(f)) numbers.insert(tr.index(v));
    return numbers;
  };
  for (int step = 0; step < 6000; ++step) {
    if (step == 1500) complex.link(tr);
    REQUIRE(complex.is_linked() == (step >= 1500));
    const Tr::Facet f = facets[static_cast<std::size_t>(random.integer(0, static_cast<int>(facets.size()) - 1))];
    const auto key = corners(f);
    REQUIRE(complex.contains(tr, f) == (truth.count(key) == 1));
    REQUIRE(complex.contains(tr, tr.mirror(f)) == complex.contains(tr, f));
    if (!complex.contains(tr, f) && random.chance(step / 1000 % 2 == 0 ? 0.9 : 0.4)) {
      complex.add(tr, {f, tr.vertices(f), {}, double(step), {0, outside}, -1, {}});
      truth[key] = step;
    } else if (complex.contains(tr, f) && random.chance(step / 1000 % 2 == 0 ? 0.4 : 0.9)) {
      complex.remove(tr, random.chance(0.5) ? f : tr.mirror(f));
      truth.erase(key);
    }
    REQUIRE(complex.size() == truth.size());
    if (step % 100 != 0) continue;
    std::map<std::set<std::size_t>, double> listed;
    complex.for_each([&](const auto& r) { REQUIRE(listed.emplace(corners(r.facet), r.squared_radius).second); });
    REQUIRE(listed == truth);
    for (const auto v : tr.finite_vertices()) {
      std::map<std::set<std::size_t>, double> at_v, expected;
      complex.for_each_at(tr, v, [&](QueuePosition i) { REQUIRE(at_v.emplace(corners(complex[i].facet), complex[i].squared_radius).second); });
      for (const auto& entry : truth)
        if (complex.is_linked() && entry.first.contains(tr.index(v))) expected.insert(entry);
      REQUIRE(at_v == expected);
    }
  }
}
