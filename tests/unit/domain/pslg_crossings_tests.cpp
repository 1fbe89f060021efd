// SPDX-License-Identifier: GPL-3.0-or-later
//
// Crossings and overlaps are found as comparing all pairs finds them, named, and split so that none are left.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/generators/catch_generators_range.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <delref/domain/pslg_check.hpp>
#include <delref/domain/pslg_crossings.hpp>
#include <delref/domain/pslg_split.hpp>

#include "graphs.hpp"

using namespace delref;
using namespace graphs;
using Catch::Matchers::ContainsSubstring;

namespace {

std::string told(const Pslg& pslg) { return InvalidInput(find_crossings(pslg, Control{})).what(); }

std::vector<SegmentPair> all_pairs_compared(const Pslg& pslg) {
  std::vector<SegmentPair> pairs;
  for (Pslg::Index a = 0; a < pslg.segments.size(); ++a)
    for (Pslg::Index b = a + 1; b < pslg.segments.size(); ++b)
      if (const auto kind = contact(pslg_crossings::ends(pslg, a), pslg_crossings::ends(pslg, b)); kind != SegmentContact::valid)
        pairs.push_back({a, b, kind});
  return pairs;
}

/// Each segment has two vertices of its own.
Pslg loose_segments(std::size_t count, auto&& make_point) {
  Pslg pslg;
  while (pslg.segments.size() < count) {
    const Point2 a = make_point(), b = make_point();
    if (a == b) continue;
    const auto first = static_cast<Pslg::Index>(pslg.points.size());
    pslg.points.insert(pslg.points.end(), {a, b});
    pslg.segments.push_back({first, first + 1});
  }
  return pslg;
}

double distance_to(Point2 p, Ends2 s) {
  const Vector2 along = s[1] - s[0];
  const double t = std::clamp(dot(p - s[0], along) / squared_length(along), 0.0, 1.0);
  return std::sqrt(squared_distance(p, s[0] + t * along));
}

/// What splitting promises: nothing crosses, each input segment is covered by a chain of its pieces, near it.
void check_split(const Pslg& input, double nearness) {
  const CheckedPslg before = merge_doubles(input, 0, Control{});
  const CheckedPslg after = split_crossings(input, Control{});
  CHECK(all_pairs_compared(after.pslg).empty());
  CHECK(find_crossings(after, Control{}).empty());
  REQUIRE(after.original_point.size() == after.pslg.points.size());
  REQUIRE(after.original_segment.size() == after.pslg.segments.size());
  const bool snapped = contains(joined(after.notes), "were rounded to multiples of");
  if (!snapped) CHECK(std::equal(before.pslg.points.begin(), before.pslg.points.end(), after.pslg.points.begin()));
  double farthest = 0;
  for (std::size_t s = 0; s < after.pslg.segments.size(); ++s) {
    const Ends2 whole = pslg_crossings::ends(input, after.original_segment[s]);
    for (const Pslg::Index v : after.pslg.segments[s]) farthest = std::max(farthest, distance_to(after.pslg.points[v], whole));
  }
  CHECK(farthest <= nearness);
}

}  // namespace

TEST_CASE("Crossing diagonals of a square are named with their vertices and the place") {
  const Pslg pslg = with_segments(square(), {{0, 2}, {1, 3}});
  const auto defects = find_crossings(pslg, Control{});
  REQUIRE(defects.size() == 1);
  CHECK(defects[0].message ==
        "segment 4 (vertices 0 and 2, (0, 0) to (1, 1)) and segment 5 (vertices 1 and 3, (1, 0) to (0, 1)) cross at (0.5, 0.5). "
        "Let segments meet only in vertices, or ask for a split at crossings (split_crossings, --split-crossings)");
  CHECK(defects[0].places == std::vector<Point2>{{0.5, 0.5}});
}

TEST_CASE("A bowtie crosses itself") {
  CHECK_THAT(told(graph({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 2}, {2, 1}, {1, 3}, {3, 0}})),
             ContainsSubstring("segment 0 (vertices 0 and 2") && ContainsSubstring("segment 2 (vertices 1 and 3") &&
                 ContainsSubstring("cross at (0.5, 0.5)"));
}

TEST_CASE("Overlapping segments are named with what they share") {
  const Pslg pslg = with_segments(with_points(square(), {{0.2, 0.5}, {0.6, 0.5}, {0.4, 0.5}, {0.8, 0.5}}), {{4, 5}, {6, 7}});
  CHECK_THAT(told(pslg), ContainsSubstring("segment 4 (vertices 4 and 5, (0.2, 0.5) to (0.6, 0.5))") &&
                             ContainsSubstring("segment 5 (vertices 6 and 7") &&
                             ContainsSubstring("overlap from (0.4, 0.5) to (0.6, 0.5)"));
}

TEST_CASE("Overlaps that share a vertex or lie within the other are found, upright ones too") {
  CHECK_THAT(told(graph({{0, 0}, {0, 2}, {0, 1}}, {{0, 1}, {0, 2}})), ContainsSubstring("overlap from (0, 0) to (0, 1)"));
  CHECK_THAT(told(graph({{0, 0}, {0, 2}, {0, 1}}, {{0, 1}, {1, 2}})), ContainsSubstring("overlap from (0, 1) to (0, 2)"));
  CHECK_THAT(told(graph({{0, 0}, {3, 3}, {1, 1}, {2, 2}}, {{3, 2}, {1, 0}})), ContainsSubstring("overlap from (1, 1) to (2, 2)"));
}

TEST_CASE("Messages about a checked graph use the numbers of the file") {
  Pslg pslg =
      with_segments(with_points(square(), {{0, 0}, {0.2, 0.5}, {0.6, 0.9}, {0.6, 0.5}, {0.2, 0.9}}), {{4, 4}, {5, 6}, {7, 8}});
  pslg.first_index = 1;
  const CheckedPslg result = check_pslg(pslg, {}, Control{});
  const auto defects = find_crossings(result, Control{});
  REQUIRE(defects.size() == 1);
  CHECK_THAT(defects[0].message,
             ContainsSubstring("segment 6 (vertices 6 and 7, ") && ContainsSubstring("segment 7 (vertices 8 and 9, "));
}

TEST_CASE("Segments that touch are valid") {
  CHECK(find_crossings(square(), Control{}).empty());
  CHECK(find_crossings(graph({{0, 0}, {2, 0}, {1, 0}, {1, 1}}, {{0, 1}, {2, 3}}), Control{}).empty());
  CHECK(find_crossings(graph({{0, 0}, {0, 2}, {0, 1}, {-1, 1}, {1, 1}}, {{0, 1}, {2, 3}, {2, 4}}), Control{}).empty());
  CHECK(find_crossings(graph({{0, 0}, {1, 0}, {2, 0}}, {{0, 1}, {1, 2}}), Control{}).empty());
}

TEST_CASE("A pair that only starts to cross where a third segment ends is found") {
  CHECK_THAT(told(graph({{0, 0}, {2, 2}, {0, 2}, {2, 0}, {0, 1}, {1, 1}}, {{0, 1}, {2, 3}, {4, 5}})),
             ContainsSubstring("cross at (1, 1)"));
}

TEST_CASE("The sweep finds the same pairs as comparing all") {
  const auto seed = static_cast<unsigned>(GENERATE(range(0, 60)));
  std::mt19937 random(seed);
  // A small grid of integers makes every degenerate case likely.
  std::uniform_int_distribution<int> grid(0, 2 + static_cast<int>(seed % 12));
  const std::size_t count = 3 + seed % 40;
  const Pslg pslg = loose_segments(count, [&] { return Point2{double(grid(random)), double(grid(random))}; });
  const CrossingPairs found = crossing_pairs(pslg, {}, Control{});
  CHECK(found.complete);
  const auto expected = all_pairs_compared(pslg);
  REQUIRE(found.pairs.size() == expected.size());
  CHECK(std::equal(expected.begin(), expected.end(), found.pairs.begin(),
                   [](const SegmentPair& a, const SegmentPair& b) { return a == b && a.contact == b.contact; }));
}

TEST_CASE("Fans and combs without crossings have none") {
  Pslg fan = graph({{0, 0}}, {});
  for (Pslg::Index i = 1; i <= 2000; ++i) {
    fan.points.push_back({std::cos(i * 1e-9), std::sin(i * 1e-9)});
    fan.segments.push_back({0, i});
  }
  CHECK(find_crossings(fan, Control{}).empty());
}

TEST_CASE("Hostile input ends quickly with an honest count") {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  const Pslg pslg = loose_segments(20000, [&] { return Point2{unit(random), unit(random)}; });
  const auto defects = find_crossings(pslg, Control{});
  REQUIRE(defects.size() == 20);
  CHECK_THAT(defects.back().message, ContainsSubstring("at least") && ContainsSubstring("more pairs of segments"));
}

TEST_CASE("Looking for crossings stops when told to") {
  std::stop_source source;
  source.request_stop();
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  const Pslg pslg = loose_segments(2000, [&] { return Point2{unit(random), unit(random)}; });
  CHECK_THROWS_AS(find_crossings(pslg, Control(Budget{}, source.get_token())), Interrupted);
}

TEST_CASE("Splitting the diagonals of a square makes its centre a vertex and keeps the markers") {
  Pslg pslg = with_segments(square(), {{0, 2}, {1, 3}});
  pslg.segment_markers = {1, 2, 3, 4, 5, 6};
  pslg.point_markers = {9, 9, 9, 9};
  const CheckedPslg result = check_pslg(pslg, {.split_crossings = true}, Control{});
  REQUIRE(result.pslg.points.size() == 5);
  CHECK(result.pslg.points[4] == Point2{0.5, 0.5});
  CHECK(result.original_point[4] == PslgNames::made);
  CHECK(result.pslg.point_markers[4] == 5);
  CHECK(result.pslg.segment_markers == std::vector{1, 2, 3, 4, 5, 5, 6, 6});
  CHECK(result.original_segment == std::vector<Pslg::Index>{0, 1, 2, 3, 4, 4, 5, 5});
  REQUIRE(result.notes.size() == 2);
  CHECK_THAT(result.notes[0], ContainsSubstring("1 pair of segments was split") && ContainsSubstring("cross at (0.5, 0.5)"));
  CHECK_THAT(result.notes[1], ContainsSubstring("1 new vertex"));
}

TEST_CASE("Splitting an overlap leaves the shared piece once, with a marker that is not 0") {
  Pslg pslg = with_segments(with_points(square(), {{0.2, 0.5}, {0.6, 0.5}, {0.4, 0.5}, {0.8, 0.5}}), {{4, 5}, {7, 6}});
  pslg.segment_markers = {1, 1, 1, 1, 0, 8};
  const CheckedPslg result = split_crossings(pslg, Control{});
  CHECK(result.pslg.segments.size() == 7);
  const auto shared = std::ranges::find(result.pslg.segments, std::array<Pslg::Index, 2>{6, 5});
  REQUIRE(shared != result.pslg.segments.end());
  CHECK(result.pslg.segment_markers[static_cast<std::size_t>(shared - result.pslg.segments.begin())] == 8);
  CHECK_THAT(joined(result.notes), ContainsSubstring("pieces shared by several segments were kept once (1 dropped)"));
}

TEST_CASE("A graph without crossings is left as it is by splitting") {
  const CheckedPslg result = split_crossings(square(), Control{});
  CHECK(result.pslg.points == square().points);
  CHECK(result.pslg.segments == square().segments);
  CHECK(result.notes.empty());
}

TEST_CASE("Random segments are split so that nothing crosses, at any magnitude") {
  const double size = GENERATE(1.0, 1e150, 1e-150);
  const auto seed = static_cast<unsigned>(GENERATE(range(0, 4)));
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0, size);
  check_split(loose_segments(150, [&] { return Point2{unit(random), unit(random)}; }), 1e-12 * size);
}

TEST_CASE("Segments on a small grid, which overlap and meet in vertices, are split") {
  const auto seed = static_cast<unsigned>(GENERATE(range(0, 10)));
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> grid(0, 7);
  check_split(loose_segments(60, [&] { return Point2{grid(random) / 7.0, grid(random) / 7.0}; }), 1e-13);
}

TEST_CASE("Segments that are nearly parallel and nearly the same are split") {
  const auto seed = static_cast<unsigned>(GENERATE(range(0, 10)));
  std::mt19937_64 random(seed);
  const double thickness = GENERATE(1e-10, 1e-14, 1e-15);
  std::uniform_real_distribution<double> unit(0, 1), noise(-thickness, thickness);
  check_split(loose_segments(80,
                             [&] {
                               const double t = unit(random);
                               return Point2{t, 0.3 * t + 0.1 + noise(random)};
                             }),
              1e-12);
}

TEST_CASE("A bundle of nearly equal segments is snap rounded, which is told, and keeps markers") {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(0, 1), noise(-1e-16, 1e-16);
  Pslg pslg = loose_segments(60, [&] {
    const double t = unit(random);
    return Point2{t, 0.3 * t + noise(random)};
  });
  pslg.segment_markers.assign(pslg.segments.size(), 0);
  pslg.segment_markers.front() = 7;
  const CheckedPslg result = split_crossings(pslg, Control{});
  CHECK_THAT(joined(result.notes), ContainsSubstring("all vertices were rounded to multiples of"));
  CHECK(all_pairs_compared(result.pslg).empty());
  CHECK(std::ranges::count(result.pslg.segment_markers, 7) > 0);
  CHECK(result.original_point.size() == result.pslg.points.size());
}

TEST_CASE("A pixel holds its lower and left edges and no others") {
  const SnapGrid grid({{1, 1}});
  const double q = grid.spacing(), half = q / 2;
  const Point2 centre{4 * q, 4 * q};
  CHECK(grid.centre({4 * q - half, 4 * q}) == centre);
  CHECK(grid.centre({4 * q + half, 4 * q}) == Point2{5 * q, 4 * q});
  CHECK(grid.meets({{{0, 4 * q - half}, {1, 4 * q - half}}}, centre));
  CHECK_FALSE(grid.meets({{{0, 4 * q + half}, {1, 4 * q + half}}}, centre));
  CHECK(grid.meets({{{4 * q - half, 0}, {4 * q - half, 1}}}, centre));
  CHECK_FALSE(grid.meets({{{4 * q + half, 0}, {4 * q + half, 1}}}, centre));
  // Through single corners: the lower left one, then the lower right and upper left ones.
  CHECK(grid.meets({{{0, 7 * q}, {7 * q, 0}}}, centre));
  CHECK_FALSE(grid.meets({{{4 * q, 4 * q - q}, {5 * q, 4 * q}}}, centre));
  CHECK_FALSE(grid.meets({{{3 * q, 4 * q}, {4 * q, 5 * q}}}, centre));
  CHECK(grid.meets({{{0, 0}, {1, 1}}}, centre));
}

TEST_CASE("Splitting is refused when there are more crossings than the budget allows") {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  const Pslg pslg = loose_segments(300, [&] { return Point2{unit(random), unit(random)}; });
  Budget budget;
  budget.max_vertices = 1000;
  CHECK_THAT(refusal([&] { split_crossings(pslg, Control(budget)); }), ContainsSubstring("more than 1000 places"));
}
