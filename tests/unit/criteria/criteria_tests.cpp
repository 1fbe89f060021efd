// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bounds that cannot be met cannot be made; sizes are checked where they are given and where they are asked for.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/generators/catch_generators_range.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <delref/criteria/angle_bound.hpp>
#include <delref/criteria/circumcentre.hpp>
#include <delref/criteria/point_sizing.hpp>
#include <delref/criteria/sizing_field.hpp>
#include <delref/criteria/tetrahedron_criteria.hpp>
#include <delref/criteria/triangle_criteria.hpp>

using namespace delref;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

struct NotConst {
  double operator()(Point2) { return 1; }
};
struct NotANumber {
  std::string operator()(Point2) const { return {}; }
};

static_assert(SizingField2<double (*)(Point2)>);
static_assert(SizingField2<std::function<double(Point2)>>);
static_assert(SizingField2<PointSizing2>);
static_assert(!SizingField2<NotConst>);
static_assert(!SizingField2<NotANumber>);
static_assert(!SizingField2<double>);

}  // namespace

TEST_CASE("An angle bound keeps its degrees and knows its squared sine") {
  CHECK(AngleBound::degrees(30).degrees() == 30);
  CHECK(AngleBound::degrees(30).squared_sine() == Catch::Approx(0.25));
  CHECK(AngleBound::degrees(0).squared_sine() == 0);
  CHECK(AngleBound::degrees(20) < AngleBound::degrees(20.7));
}

TEST_CASE("An angle bound that no mesh can meet is refused in words") {
  CHECK_THROWS_MATCHES(AngleBound::degrees(60), InvalidInput, MessageMatches(ContainsSubstring("60 degrees cannot be met")));
  CHECK_THROWS_MATCHES(AngleBound::degrees(infinity), InvalidInput, MessageMatches(ContainsSubstring("cannot be met")));
  CHECK_THROWS_MATCHES(AngleBound::degrees(-1), InvalidInput, MessageMatches(ContainsSubstring("-1 degrees is negative")));
  CHECK_THROWS_MATCHES(AngleBound::degrees(not_a_number), InvalidInput, MessageMatches(ContainsSubstring("not a number")));
  CHECK_NOTHROW(AngleBound::degrees(std::nextafter(60.0, 0.0)));
}

TEST_CASE("A size that is not positive is refused with its point") {
  const auto field = [](Point2 p) { return p.x; };
  CHECK(checked_size(field, Point2{2, 5}) == 2);
  CHECK(checked_size(field, Point2{infinity, 5}) == infinity);
  CHECK_THROWS_MATCHES(checked_size(field, Point2{0, 5}), InvalidInput,
                       MessageMatches(ContainsSubstring("gives 0 at the point (0, 5)")));
  CHECK_THROWS_MATCHES(checked_size(field, Point2{-0.5, 5}), InvalidInput,
                       MessageMatches(ContainsSubstring("gives -0.5 at the point")));
  CHECK_THROWS_MATCHES(checked_size(field, Point2{not_a_number, 5}), InvalidInput,
                       MessageMatches(ContainsSubstring("gives not a number at the point (nan, 5)")));
}

TEST_CASE("Sizes at points grow away from them with the gradation") {
  const std::vector<Point2> points{{0, 0}, {10, 0}};
  const std::vector<double> sizes{1, 5};
  const PointSizing2 field(points, sizes, 0.5);
  CHECK(field({0, 0}) == 1);
  CHECK(field({2, 0}) == 2);
  CHECK(field({10, 0}) == 5);
  CHECK(field({11, 0}) == 5.5);
  CHECK(PointSizing2(points, sizes, 0)({10, 0}) == 1);
  CHECK(PointSizing2(points, std::vector{infinity, infinity}, 0.5)({0, 0}) == infinity);
}

TEST_CASE("Sizes at points are exactly the least over all points") {
  const auto seed = static_cast<unsigned>(GENERATE(range(0, 12)));
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  const std::size_t count = std::size_t{1} << seed;
  std::vector<Point2> points(count);
  std::vector<double> sizes(count);
  for (Point2& p : points) p = seed % 3 == 0 ? Point2{std::floor(4 * unit(random)), 1} : Point2{unit(random), unit(random)};
  for (double& size : sizes) size = 0.01 + unit(random) * unit(random);
  const double gradation = seed % 2 == 0 ? 0.2 : 3;
  const PointSizing2 field(points, sizes, gradation);
  bool exact = true;
  for (int i = 0; i < 200; ++i) {
    const Point2 p{3 * unit(random) - 1, 3 * unit(random) - 1};
    double least = infinity;
    for (std::size_t j = 0; j < count; ++j)
      least = std::min(least, sizes[j] + gradation * std::sqrt(squared_distance(points[j], p)));
    exact = exact && field(p) == least;
  }
  CHECK(exact);
}

TEST_CASE("Bad sizes at points are refused with the point") {
  const std::vector<Point2> points{{0, 0}, {10, 0.5}};
  const auto make = [&](std::vector<double> sizes, double gradation) { return PointSizing2(points, sizes, gradation, 1); };
  CHECK_THROWS_MATCHES(make({1, 0}, 0.2), InvalidInput,
                       MessageMatches(ContainsSubstring("size point 2 at (10, 0.5): its size is 0")));
  CHECK_THROWS_MATCHES(make({not_a_number, 1}, 0.2), InvalidInput,
                       MessageMatches(ContainsSubstring("size point 1 at (0, 0): its size is nan")));
  CHECK_THROWS_MATCHES(make({1, -2}, 0.2), InvalidInput, MessageMatches(ContainsSubstring("its size is -2")));
  CHECK_THROWS_MATCHES(make({1}, 0.2), InvalidInput, MessageMatches(ContainsSubstring("2 size points but 1 sizes")));
  CHECK_THROWS_MATCHES(make({1, 1}, -0.2), InvalidInput, MessageMatches(ContainsSubstring("gradation is -0.2")));
  CHECK_THROWS_MATCHES(make({1, 1}, infinity), InvalidInput, MessageMatches(ContainsSubstring("gradation is inf")));
  CHECK_THROWS_MATCHES(PointSizing2({}, {}, 0.2), InvalidInput, MessageMatches(ContainsSubstring("no size points")));
  const std::vector<Point2> far{{1e200, 0}};
  CHECK_THROWS_MATCHES(PointSizing2(far, std::vector{1.0}, 0.2), InvalidInput,
                       MessageMatches(ContainsSubstring("size point 0 at (1e+200, 0)")));
}

TEST_CASE("Sizes at points of space are what the formula gives") {
  const std::vector<Point3> points{{0, 0, 0}, {10, 0, 0}, {0, 0, 6}};
  const std::vector<double> sizes{1, 5, 0.5};
  const delref::PointSizing3 field(points, sizes, 0.5);
  static_assert(delref::SizingField3<delref::PointSizing3>);
  CHECK(field({0, 0, 0}) == 1);
  CHECK(field({0, 0, 5}) == 1);
  CHECK(field({0, 3, 4}) == std::min(3.5, 0.5 + 0.5 * std::sqrt(13.0)));
  CHECK_THROWS_MATCHES(delref::PointSizing3(points, std::vector{1.0, -1.0, 1.0}, 0.5), InvalidInput,
                       MessageMatches(ContainsSubstring("size point 1 at (10, 0, 0)")));
}

TEST_CASE("Of several criteria that a simplex misses the first that bounds the size is told, or else the first") {
  const TriangleShape needle({0, 0}, {4, 0}, {4, 0.1});
  CHECK(TriangleCriteria(MinimumAngle{}, MaximumEdge{1}, MaximumArea{0.1}).unmet(needle) == "maximum edge length");
  CHECK(TriangleCriteria(MinimumAngle{}, MaximumEdge{5}, MaximumArea{0.1}).unmet(needle) == "maximum area");
  CHECK(TriangleCriteria(MaximumEdge{5}, MinimumAngle{}).unmet(needle) == "minimum angle");
  CHECK(TriangleCriteria(MaximumEdge{5}).unmet(needle).empty());
  CHECK(!TriangleCriteria(MinimumAngle{}, MaximumEdge{5}).is_met(needle));
  CHECK(TriangleCriteria(MinimumAngle{}, MaximumEdge{5}).is_small_enough(needle));

  const TetrahedronShape corner({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}});
  CHECK(TetrahedronCriteria(RadiusEdge{0.7}, MaximumVolume{0.1}, MaximumCircumradius{0.1}).unmet(corner) == "maximum volume");
  CHECK(TetrahedronCriteria(RadiusEdge{0.7}, MaximumVolume{0.2}).unmet(corner) == "radius-edge ratio");
  CHECK(TetrahedronCriteria(RadiusEdge{2}, MaximumVolume{0.2}).is_met(corner));
}

TEST_CASE("A circumcentre is as far from each corner, and in the plane of a triangle in space") {
  std::mt19937_64 generator(3);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const auto random = [&] { return coordinate(generator); };
  for (int k = 0; k < 100; ++k) {
    const Vector2 u{random(), random()}, v{random(), random()}, c = to_circumcentre(u, v, cross(u, v));
    CHECK(squared_length(c) == Catch::Approx(squared_length(c - u)).epsilon(1e-6));
    CHECK(squared_length(c) == Catch::Approx(squared_length(c - v)).epsilon(1e-6));
    const Vector3 a{random(), random(), random()}, b{random(), random(), random()}, d = to_circumcentre(a, b);
    CHECK(squared_length(d) == Catch::Approx(squared_length(d - a)).epsilon(1e-6));
    CHECK(squared_length(d) == Catch::Approx(squared_length(d - b)).epsilon(1e-6));
    CHECK(std::abs(dot(d, cross(a, b))) <= 1e-12 * std::sqrt(squared_length(d)));
  }
}
