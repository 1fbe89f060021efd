// SPDX-License-Identifier: GPL-3.0-or-later
//
// The parts of the check of complexes, against definitions that a person can read.
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>
#include <vector>

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

#include <delref/domain/enumerated.hpp>
#include <delref/domain/facet_frame.hpp>
#include <delref/domain/merge_points_3.hpp>
#include <delref/domain/segment_table.hpp>
#include <delref/domain/triangle_contact.hpp>

using namespace delref;
using Catch::Approx;

namespace {

using Corners = std::array<std::uint32_t, 3>;

/// Asks in all orders of corners and both orders of triangles, which must agree.
bool meet(const std::vector<Point3>& points, Corners s, Corners t) {
  std::ranges::sort(s);
  std::ranges::sort(t);
  std::set<bool> answers;
  do do
      answers.insert({triangles_meet(points, s, t), triangles_meet(points, t, s)});
    while (std::ranges::next_permutation(t).found);
  while (std::ranges::next_permutation(s).found);
  REQUIRE(answers.size() == 1);
  return *answers.begin();
}

}  // namespace

TEST_CASE("Two triangles on an edge meet elsewhere only when one lies on the other") {
  const std::vector<Point3> p{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0.3, 2, 0}, {0, 1, 1e-300}, {0.1, 0.1, 5}};
  CHECK_FALSE(meet(p, {0, 1, 2}, {0, 1, 3}));
  CHECK(meet(p, {0, 1, 2}, {0, 1, 4}));
  CHECK_FALSE(meet(p, {0, 1, 2}, {0, 1, 5}));
  CHECK_FALSE(meet(p, {0, 1, 2}, {0, 1, 6}));
  CHECK(meet(p, {0, 1, 2}, {2, 0, 1}));
}

TEST_CASE("Two triangles on a vertex meet elsewhere when an edge of one passes through the other, or both overlap in a plane") {
  const std::vector<Point3> p{{0, 0, 0},  {2, 0, 0},  {0, 2, 0},  {1, 1, 1}, {1, 1, -1},  {-1, -1, 1}, {-1, -1, -1}, {9, 9, 1},
                              {9, 9, -1}, {-1, 0, 0}, {0, -1, 0}, {1, 1, 0}, {-1, -1, 0}, {4, 0, 0},   {4, 0, 1}};
  CHECK(meet(p, {0, 1, 2}, {0, 3, 4}));         // pierced inside
  CHECK(meet(p, {0, 1, 2}, {0, 7, 8}));         // its edge passes beyond, the other's passes through it
  CHECK_FALSE(meet(p, {0, 1, 2}, {0, 5, 6}));   // behind the vertex
  CHECK_FALSE(meet(p, {0, 1, 2}, {0, 9, 10}));  // in the plane, in another sector
  CHECK(meet(p, {0, 1, 2}, {0, 11, 9}));        // in the plane, overlapping
  CHECK(meet(p, {0, 1, 2}, {0, 11, 3}));        // one edge along the inside
  CHECK_FALSE(meet(p, {0, 1, 2}, {0, 12, 3}));  // one vertex in the plane, behind
  CHECK(meet(p, {0, 1, 2}, {0, 13, 14}));       // one edge along an edge
}

TEST_CASE("Triangles without common vertices meet when they have a point in common, be it a vertex") {
  const std::vector<Point3> p{{0, 0, 0}, {4, 0, 0},  {0, 4, 0}, {1, 1, 0}, {1, 1, 1},
                              {2, 2, 3}, {1, 1, -1}, {9, 0, 0}, {9, 1, 1}, {8, 4, 1}};
  CHECK(meet(p, {0, 1, 2}, {3, 4, 5}));
  CHECK(meet(p, {0, 1, 2}, {6, 4, 5}));
  CHECK_FALSE(meet(p, {0, 1, 2}, {7, 8, 9}));
}

TEST_CASE("A segment meets a triangle beyond a common vertex only when it goes on inside it") {
  const std::vector<Point3> p{{0, 0, 0},  {2, 0, 0},     {0, 2, 0},      {1, 1, 0},
                              {-1, 0, 0}, {0.5, 0.5, 1}, {0.5, 0.5, -1}, {0.5, 0.5, 0}};
  const auto meets = [&](std::array<std::uint32_t, 2> s) { return segment_meets_triangle(p, s, {0, 1, 2}); };
  CHECK(meets({0, 3}));
  CHECK(meets({7, 0}));
  CHECK(meets({1, 0}));
  CHECK_FALSE(meets({0, 4}));
  CHECK_FALSE(meets({5, 0}));
  CHECK(meets({5, 6}));
  CHECK(meets({5, 7}));
  CHECK_FALSE(meets({4, 5}));
  CHECK(segments_meet(p, {0, 3}, {0, 7}));
  CHECK_FALSE(segments_meet(p, {0, 3}, {0, 4}));
  CHECK(segments_meet(p, {5, 6}, {0, 3}));
}

TEST_CASE("Close points are represented by the first that is no farther and represents itself") {
  std::mt19937 generator(1);
  const double distance = GENERATE(0.0, 1e-3, 0.05, 0.4, 3.0);
  const double offset = GENERATE(0.0, -1e6);
  std::uniform_real_distribution<double> place(offset, offset + 1);
  std::vector<Point3> points(600);
  for (std::size_t i = 0; i < points.size(); ++i)
    points[i] = i % 7 == 6 ? points[i / 2] : Point3{place(generator), place(generator), place(generator)};
  const auto found = close_points(points, distance, Control{});
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    std::uint32_t expected = i;
    for (std::uint32_t j = 0; j < i && expected == i; ++j)
      if (found[j] == j && squared_distance(points[i], points[j]) <= distance * distance) expected = j;
    REQUIRE(found[i] == expected);
  }
}

TEST_CASE("A segment table holds each pair once and finds it in both directions") {
  const std::vector<SegmentTable::Ends> one{{4, 1}, {1, 4}, {0, 2}}, other{{2, 0}, {1, 3}};
  const SegmentTable table(5, {one, other});
  REQUIRE(table.size() == 3);
  CHECK(table[0] == SegmentTable::Ends{0, 2});
  CHECK(table[1] == SegmentTable::Ends{1, 3});
  CHECK(table[2] == SegmentTable::Ends{1, 4});
  CHECK(table.find(4, 1) == 2);
  CHECK(table.find(1, 4) == 2);
  CHECK(table.find(2, 3) == SegmentTable::none);
  CHECK(SegmentTable().size() == 0);
}

TEST_CASE("The normal of a triangle is right however slim the triangle") {
  const double slim = GENERATE(1.0, 1e-5, 1e-10, 1e-15);
  const Point3 a{1, 1, 1}, b{2, 2, 2}, c{1.5, 1.5, 1.5 + slim};
  const Vector3 n = triangle_normal(a, b, c), exact = unit({1, -1, 0});
  CHECK(squared_length(n - exact) < 1e-28);
}

TEST_CASE("Frames are right-handed, of length 1, and exact in upright planes") {
  const PlaneFrame upright = plane_frame({1, 2, 3}, {0, -1, 0}, {1, 0, 1});
  CHECK(upright.lift(upright.project({0.25, 2, 0.75})) == Point3{0.25, 2, 0.75});
  std::mt19937 generator(1);
  std::normal_distribution<double> normal;
  for (int k = 0; k < 100; ++k) {
    const auto random = [&] { return Vector3{normal(generator), normal(generator), normal(generator)}; };
    const PlaneFrame frame = plane_frame({}, unit(random()), random());
    CHECK(squared_length(cross(frame.u, frame.v) - frame.normal) < 1e-28);
    CHECK(squared_length(frame.u) == Approx(1));
    CHECK(squared_length(frame.v) == Approx(1));
  }
  CHECK(unit({3e-200, 0, 4e-200}).x == Approx(0.6));
  CHECK(unit({3e200, 0, 4e200}).z == Approx(0.8));
}

TEST_CASE("Lists are written out up to a length") {
  using Words = std::vector<std::string>;
  CHECK(enumerated(Words{}).empty());
  CHECK(enumerated(Words{"1"}) == "1");
  CHECK(enumerated(Words{"1", "2", "3"}) == "1, 2 and 3");
  CHECK(enumerated(Words{"1", "2", "3", "4"}, 3) == "1, 2 and 2 more");
}
