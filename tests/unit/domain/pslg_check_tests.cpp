// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every kind of bad input is refused or mended in words that name the elements, and input that is valid is left as it is.
#include <cmath>
#include <limits>
#include <random>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <delref/domain/pslg_check.hpp>
#include <delref/domain/pslg_scale.hpp>

#include "graphs.hpp"

using namespace delref;
using namespace graphs;
using Catch::Matchers::ContainsSubstring;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

CheckedPslg checked(Pslg pslg, double tolerance = 0) { return check_pslg(std::move(pslg), {tolerance, false}, Control{}); }
std::string refused(const Pslg& pslg, double tolerance = 0) {
  return refusal([&] { checked(pslg, tolerance); });
}

}  // namespace

TEST_CASE("A valid graph passes the check unchanged and without notes") {
  Pslg pslg = with_points(square(), {{0.5, 0.5}});
  pslg.point_markers = {1, 2, 3, 4, 5};
  pslg.segment_markers = {6, 7, 8, 9};
  pslg.attribute_count = 1;
  pslg.attributes = {0.1, 0.2, 0.3, 0.4, 0.5};
  const CheckedPslg result = checked(pslg);
  CHECK(result.pslg.points == pslg.points);
  CHECK(result.pslg.segments == pslg.segments);
  CHECK(result.pslg.point_markers == pslg.point_markers);
  CHECK(result.pslg.segment_markers == pslg.segment_markers);
  CHECK(result.pslg.attributes == pslg.attributes);
  CHECK(result.original_point == std::vector<Pslg::Index>{0, 1, 2, 3, 4});
  CHECK(result.original_segment == std::vector<Pslg::Index>{0, 1, 2, 3});
  CHECK(result.notes.empty());
}

TEST_CASE("Input without vertices or without segments is refused") {
  CHECK_THAT(refused(graph({}, {})), ContainsSubstring("no vertices"));
  CHECK_THAT(refused(graph({{0, 0}, {1, 0}, {0, 1}}, {})), ContainsSubstring("no segments") && ContainsSubstring("3 vertices"));
}

TEST_CASE("A segment with a bad index is refused with its number, the index and the allowed range") {
  const std::string text = refused(with_segments(square(), {{0, 77}}));
  CHECK(text == "segment 4 refers to vertex 77, which does not exist: vertices are numbered from 0 to 3");
  Pslg from_one = with_segments(square(), {{0, 4}});
  from_one.first_index = 1;
  CHECK(refused(from_one) == "segment 5 refers to vertex 5, which does not exist: vertices are numbered from 1 to 4");
  from_one.segments.back()[1] = static_cast<Pslg::Index>(-1);
  CHECK_THAT(refused(from_one), ContainsSubstring("segment 5 refers to vertex 0, which does not exist"));
}

TEST_CASE("Vertices that are not finite are refused by number") {
  CHECK(refused(with_points(square(), {{not_a_number, 0.5}})) == "vertex 4 at (nan, 0.5): a coordinate is not a number");
  CHECK(refused(with_points(square(), {{infinity, 0.5}})) == "vertex 4 at (inf, 0.5): a coordinate is infinite");
  CHECK_THAT(refused(with_points(square(), {{0, -1e305}})), ContainsSubstring("vertex 4 at (0, -1e+305)"));
}

TEST_CASE("Seeds and area bounds that are not numbers are refused") {
  Pslg pslg = square();
  pslg.holes = {{0.5, 0.5}, {not_a_number, 0}};
  pslg.regions = {{{0.1, infinity}, 3, 0}, {{0.1, 0.1}, 4, -1}, {{0.1, 0.1}, 5, not_a_number}};
  const std::string text = refused(pslg);
  CHECK_THAT(text, ContainsSubstring("seed of hole 1 at (nan, 0): a coordinate is not a number"));
  CHECK_THAT(text, ContainsSubstring("seed of region 0 (label 3) at (0.1, inf): a coordinate is infinite"));
  CHECK_THAT(text, ContainsSubstring("greatest area in region 1 (label 4) is -1"));
  CHECK_THAT(text, ContainsSubstring("greatest area in region 2 (label 5) is nan"));
}

TEST_CASE("Lists of the wrong length are refused") {
  Pslg pslg = square();
  pslg.point_markers = {1};
  pslg.segment_markers = {1, 2};
  pslg.attributes = {1};
  const std::string text = refused(pslg);
  CHECK_THAT(text, ContainsSubstring("1 vertex markers for 4 vertices"));
  CHECK_THAT(text, ContainsSubstring("2 segment markers for 4 segments"));
  CHECK_THAT(text, ContainsSubstring("1 attribute values for 0"));
}

TEST_CASE("Of many defects twenty are spelled out and the others counted") {
  Pslg pslg = square();
  for (int i = 0; i < 1000; ++i) pslg.segments.push_back({0, 99});
  try {
    checked(pslg);
    FAIL("not refused");
  } catch (const InvalidInput& e) {
    REQUIRE(e.defects().size() == 21);
    CHECK(e.defects().back().message == "and 980 more of this kind");
  }
}

TEST_CASE("Vertices on one line are refused, with the ends of the line") {
  const std::string text = refused(graph({{1, 1}, {0, 0}, {2, 2}}, {{1, 0}, {0, 2}}));
  CHECK_THAT(text, ContainsSubstring("all 3 vertices lie on one straight line, from vertex 1 at (0, 0) to vertex 2 at (2, 2)"));
  CHECK_THAT(refused(graph({{1, 1}, {1, 1}}, {{0, 1}})), ContainsSubstring("all vertices are one point, (1, 1)"));
}

TEST_CASE("Vertices that are almost on one line are not refused") {
  CHECK(refused(graph({{0, 0}, {1, 1}, {2, std::nextafter(2.0, 3.0)}}, {{0, 1}, {1, 2}, {2, 0}})).empty());
  CHECK(refused(graph({{0, 0}, {1, 0}, {1, 1e-7}}, {{0, 1}, {1, 2}, {2, 0}})).empty());
}

TEST_CASE("Coincident vertices are merged, and the note tells which and with what tolerance") {
  Pslg pslg = with_segments(with_points(square(), {{0.5, 0.5}, {0.5, 0.5}, {1, 0}}), {{4, 2}, {5, 6}});
  pslg.point_markers = {1, 0, 3, 4, 0, 8, 9};
  pslg.attribute_count = 1;
  pslg.attributes = {10, 11, 12, 13, 14, 15, 16};
  const CheckedPslg result = checked(pslg);
  CHECK(result.pslg.points.size() == 5);
  CHECK(result.original_point == std::vector<Pslg::Index>{0, 1, 2, 3, 4});
  CHECK(result.pslg.segments.back() == std::array<Pslg::Index, 2>{4, 1});
  CHECK(result.pslg.point_markers == std::vector{1, 9, 3, 4, 8});
  CHECK(result.pslg.attributes == std::vector<double>{10, 11, 12, 13, 14});
  REQUIRE(result.notes.size() == 1);
  CHECK(result.notes[0] ==
        "2 vertices were merged with an earlier one with the same coordinates (merge tolerance 0): vertex 5 with vertex 4 at "
        "(0.5, 0.5); vertex 6 with vertex 1 at (1, 0)");
}

TEST_CASE("Zero and minus zero coincide") { CHECK(checked(with_points(square(), {{-0.0, -0.0}})).pslg.points.size() == 4); }

TEST_CASE("Nearly coincident vertices are told and kept, and a tolerance merges them") {
  const Pslg pslg = with_segments(with_points(square(), {{1, 1e-14}, {0.5, 0.5}}), {{4, 5}});
  const CheckedPslg kept = checked(pslg);
  CHECK(kept.pslg.points.size() == 6);
  REQUIRE(kept.notes.size() == 1);
  CHECK_THAT(kept.notes[0], ContainsSubstring("1 vertex lies nearer than 1e-12") &&
                                ContainsSubstring("vertex 4 at (1, 1e-14) with vertex 1 at (1, 0), 1e-14 apart"));
  const CheckedPslg merged = checked(pslg, 1e-12);
  CHECK(merged.pslg.points.size() == 5);
  CHECK(merged.original_point == std::vector<Pslg::Index>{0, 1, 2, 3, 5});
  CHECK(merged.pslg.segments.back() == std::array<Pslg::Index, 2>{1, 4});
  REQUIRE(merged.notes.size() == 1);
  CHECK_THAT(merged.notes[0], ContainsSubstring("merge tolerance of 1e-12"));
}

TEST_CASE("Merging moves no vertex farther than the tolerance, and leaves none closer") {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<Point2> points(3000);
  for (Point2& p : points) p = {unit(random), unit(random)};
  const double tolerance = 0.02;
  const auto representative = close_points(points, tolerance, Control{});
  std::vector<Point2> kept;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    REQUIRE(representative[i] <= i);
    REQUIRE(representative[representative[i]] == representative[i]);
    REQUIRE(std::sqrt(squared_distance(points[i], points[representative[i]])) <= tolerance);
    if (representative[i] == i) kept.push_back(points[i]);
  }
  CHECK(kept.size() < 2500);
  bool apart = true;
  for (std::size_t i = 0; i < kept.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) apart = apart && std::sqrt(squared_distance(kept[i], kept[j])) > tolerance;
  CHECK(apart);
}

TEST_CASE("A tolerance that is no length is refused, and one that merges everything tells so") {
  CHECK_THAT(refused(square(), -1), ContainsSubstring("merge tolerance is -1"));
  CHECK_THAT(refused(square(), not_a_number), ContainsSubstring("merge tolerance is nan"));
  CHECK_THAT(refused(square(), 10), ContainsSubstring("all vertices are one point") && ContainsSubstring("merge tolerance"));
}

TEST_CASE("A segment of no length is dropped with a note") {
  const CheckedPslg result = checked(with_segments(square(), {{0, 0}}));
  CHECK(result.pslg.segments.size() == 4);
  REQUIRE(result.notes.size() == 1);
  CHECK(result.notes[0] == "1 segment of no length was dropped: segment 4 at vertex 0 at (0, 0)");
  CHECK_THAT(refused(graph({{0, 0}, {1, 0}, {0, 1}}, {{1, 1}})), ContainsSubstring("no segment has any length"));
}

TEST_CASE("Repeated segments become one, and differing markers are told") {
  Pslg pslg = with_segments(square(), {{1, 0}, {2, 3}});
  pslg.segment_markers = {0, 2, 3, 4, 7, 8};
  const CheckedPslg result = checked(pslg);
  CHECK(result.pslg.segments.size() == 4);
  CHECK(result.pslg.segment_markers == std::vector{7, 2, 3, 4});
  REQUIRE(result.notes.size() == 1);
  CHECK(result.notes[0] ==
        "2 repeated segments were dropped: segment 4 repeats segment 0 with marker 7 instead of 0, 7 was kept; segment 5 repeats "
        "segment 2 with marker 8 instead of 3, 3 was kept");
}

TEST_CASE("Huge, tiny and offset coordinates pass the check, and powers of two scale them exactly") {
  for (const double size : {1e150, 1e-150, 1e300, 1e-290}) {
    const Pslg pslg = with_segments(with_points(square(size), {{0.3 * size, 0.3 * size}, {0.6 * size, 0.301 * size}}), {{4, 5}});
    CHECK(checked(pslg).notes.empty());
    const int k = scale_exponent(pslg);
    CHECK(k != 0);
    const Pslg near_one = scaled(pslg, k);
    CHECK(near_one.points[2].x >= 0.5);
    CHECK(near_one.points[2].x < 1);
    CHECK(scaled(near_one, -k).points == pslg.points);
  }
  const Pslg offset = graph({{1e9, 1e9}, {1e9 + 1, 1e9}, {1e9, 1e9 + 1}}, {{0, 1}, {1, 2}, {2, 0}});
  CHECK(checked(offset).notes.empty());
  CHECK(scale_exponent(offset) == 0);
  CHECK(scale_exponent(square(0x1p-60)) == 0);
}

TEST_CASE("Scaling refuses a mix of magnitudes that it cannot hold, and scales areas with lengths") {
  const std::string text = refusal([] {
    const Pslg pslg = with_points(square(1e300), {{1e-300, 5}});
    scaled(pslg, scale_exponent(pslg));
  });
  CHECK_THAT(text, ContainsSubstring("vertex 4 at (1e-300, 5)"));
  Pslg held = with_points(square(1e150), {{1e-150, 5}});
  held.holes = {{1, 1}};
  held.regions = {{{0x1p400, 0x1p400}, 1, 0x1p800}, {{0, 0}, 1, 0}};
  const int k = scale_exponent(held);
  const Pslg near_one = scaled(held, k);
  CHECK(near_one.regions[0].seed.x == std::ldexp(1.0, 400 + k));
  CHECK(near_one.regions[0].max_area == std::ldexp(1.0, 800 + 2 * k));
  CHECK(near_one.regions[1].max_area == 0);
}

TEST_CASE("A check that is told to stop stops") {
  std::stop_source source;
  source.request_stop();
  CHECK_THROWS_AS(check_pslg(square(), {}, Control(Budget{}, source.get_token())), Interrupted);
}
