// SPDX-License-Identifier: GPL-3.0-or-later
#include <delref/domain/implicit_domain.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include "functions.hpp"

using namespace delref;
using namespace delref_test;
using Catch::Matchers::ContainsSubstring;

namespace {

/// Answers many points only.
struct BatchSphere {
  std::size_t* calls;
  void operator()(std::span<const Point3> points, std::span<double> values) const {
    ++*calls;
    for (std::size_t i = 0; i < points.size(); ++i) values[i] = Sphere{{}, 1}(points[i]);
  }
};

template <class Domain>
int label_of(const Domain& domain, Point3 p) {
  int label = -7;
  domain.label(std::span<const Point3>(&p, 1), std::span(&label, 1));
  return label;
}

static_assert(FindsComponents<ImplicitDomain<Sphere>>);
static_assert(FindsComponents<ImplicitDomain<BatchSphere>>);
static_assert(FindsComponents<ImplicitDomain<double (*)(Point3)>>);
static_assert(!ImplicitFunction<int>);
static_assert(!ImplicitFunction<double (*)(double)>);

}  // namespace

TEST_CASE("a function is negative inside; zero, NaN and what is beyond the bounds are outside", "[implicit_domain]") {
  const auto f = [](Point3 p) { return p.z > 0.9 ? std::numeric_limits<double>::quiet_NaN() : Sphere{{}, 1}(p); };
  const ImplicitDomain domain(f, cube(1.5));
  CHECK(label_of(domain, {0, 0, 0}) == 0);
  CHECK(label_of(domain, {1, 0, 0}) == outside);
  CHECK(label_of(domain, {0, 0, 0.95}) == outside);
  CHECK(label_of(ImplicitDomain([](Point3) { return -1.0; }, cube(1)), {2, 0, 0}) == outside);
}

TEST_CASE("labels of many points are those of each", "[implicit_domain]") {
  const ImplicitDomain domain(tangle, cube(3));
  std::vector<Point3> points;
  for (int i = 0; i < 1000; ++i) points.push_back({3 * std::sin(i * 1.1), 3 * std::sin(i * 1.7), 3 * std::sin(i * 2.3)});
  std::vector<int> labels(points.size());
  domain.label(points, labels);
  for (std::size_t i = 0; i < points.size(); ++i) CHECK(labels[i] == label_of(domain, points[i]));
}

TEST_CASE("a function of many points is asked in large batches", "[implicit_domain]") {
  std::size_t calls = 0;
  const ImplicitDomain domain(BatchSphere{&calls}, cube(1.5));
  calls = 0;
  const std::vector<Point3> points(1000);
  std::vector<int> labels(points.size());
  domain.label(points, labels);
  CHECK(calls <= 4);
  CHECK(std::abs(domain.crossing({0, 0, 0}, {1.4, 0, 0}, 0, 1e-8).x - 1) <= 1e-8);
}

TEST_CASE("a crossing is on the surface within the tolerance, after a few values", "[implicit_domain]") {
  std::size_t count = 0;
  const ImplicitDomain domain(Counted{Sphere{{0.1, 0.2, 0.3}, 1}, &count}, cube(2));
  for (int i = 0; i < 200; ++i) {
    const Point3 a{0.1, 0.2, 0.3},
        b = a + 1.6 * Vector3{std::sin(i * 1.0), std::cos(i * 1.0) * std::sin(i * 0.7), std::cos(i * 1.0) * std::cos(i * 0.7)};
    count = 0;
    const Point3 p = domain.crossing(b, a, outside, 1e-7);
    CHECK(count <= 10);
    CHECK(std::abs(Sphere{{0.1, 0.2, 0.3}, 1}(p)) <= 1e-7);
  }
}

TEST_CASE("a domain that reaches its bounds is closed there, and says so", "[implicit_domain]") {
  const ImplicitDomain domain(gyroid, cube(6));
  CHECK(domain.reaches_bounds());
  REQUIRE(domain.notes().size() == 1);
  CHECK_THAT(domain.notes()[0], ContainsSubstring("closed there"));
  const ImplicitDomain ball(Sphere{{}, 1}, cube(0.9));
  CHECK(ball.crossing({0, 0, 0}, {2, 0, 0}, 0, 1e-9) == Point3{0.9, 0, 0});
  CHECK(ball.crossing({2, 0, 0}, {0, 0, 0}, outside, 1e-9) == Point3{0.9, 0, 0});
  CHECK(ImplicitDomain(Sphere{{}, 1}, cube(2)).notes().empty());
}

TEST_CASE("a domain that reaches its bounds is refused when it may not", "[implicit_domain]") {
  const ImplicitOptions options{.at_bounds = AtBounds::refused};
  CHECK_THROWS_AS(ImplicitDomain(gyroid, cube(6), options), InvalidInput);
  CHECK_NOTHROW(ImplicitDomain(Sphere{{}, 1}, cube(1.1), options));
}

TEST_CASE("a function without a surface is refused in words", "[implicit_domain]") {
  for (const double value : {1.0, 0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    const ImplicitDomain domain([value](Point3) { return value; }, cube(1));
    CHECK_THROWS_AS(domain.components(Control{}), InvalidInput);
  }
  const ImplicitDomain hollow([](Point3 p) { return -Sphere{{}, 0.3}(p); }, cube(1));
  CHECK(hollow.components(Control{}).components.size() == 2);
}

TEST_CASE("bounds that are no box are refused", "[implicit_domain]") {
  const double nan = std::numeric_limits<double>::quiet_NaN(), huge = std::numeric_limits<double>::max();
  for (const BoundingBox3& box : {BoundingBox3{}, BoundingBox3{{0, 0, 0}, {1, 1, 0}}, BoundingBox3{{1, 0, 0}, {0, 1, 1}},
                                  BoundingBox3{{0, 0, nan}, {1, 1, 1}}, cube(huge)})
    CHECK_THROWS_AS(ImplicitDomain(Sphere{{}, 1}, box), InvalidInput);
  CHECK_THROWS_AS(ImplicitDomain(Sphere{{}, 1}, cube(2), {.sampling_distance = -1}), InvalidInput);
  CHECK_THROWS_AS(ImplicitDomain(Sphere{{}, 1}, cube(2), {.sampling_distance = nan}), InvalidInput);
}
