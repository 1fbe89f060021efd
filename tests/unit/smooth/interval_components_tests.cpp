// SPDX-License-Identifier: GPL-3.0-or-later
#include <delref/domain/implicit_domain.hpp>
#include <delref/domain/interval.hpp>
#include <delref/domain/interval_components.hpp>

#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <stop_token>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include "functions.hpp"

using namespace delref;
using namespace delref_test;
using Catch::Matchers::ContainsSubstring;

namespace {

/// The result of an operation on members of intervals is a member of the result on the intervals.
void check_holds(const char* operation, const Interval& range, double value) {
  INFO(operation << " in [" << range.low() << ", " << range.high() << "]: " << value);
  CHECK((std::isnan(value) ? range.may_be_undefined() : range.low() <= value && value <= range.high()));
}

SurfaceComponents components(const Spheres& spheres, double size) {
  return ImplicitDomain(spheres, cube(3), {.sampling_distance = size}).components(Control{});
}

}  // namespace

TEST_CASE("intervals hold the results of every operation", "[interval]") {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> number(-3, 3), part(0, 1);
  for (int i = 0; i < 5000; ++i) {
    const double scale = std::exp(2 * number(random));
    const double a = scale * number(random), b = a + scale * std::abs(number(random)), c = scale * number(random),
                 d = c + 0.3 * scale * part(random);
    const Interval xs(a, b), ys(c, d);
    const double x = a + part(random) * (b - a), y = i % 2 == 0 ? d : c;
    check_holds("+", xs + ys, x + y);
    check_holds("-", xs - ys, x - y);
    check_holds("*", xs * ys, x * y);
    check_holds("/", xs / ys, x / y);
    check_holds("power 3", power(xs, 3), x * x * x);
    check_holds("power 4", power(xs, 4), x * x * x * x);
    check_holds("power -2", power(xs, -2), 1 / (x * x));
    check_holds("power", power(xs, ys), std::pow(x, y));
    check_holds("abs", abs(xs), std::abs(x));
    check_holds("sqrt", sqrt(xs), std::sqrt(x));
    check_holds("exp", exp(xs), std::exp(x));
    check_holds("log", log(xs), std::log(x));
    check_holds("log2", log2(xs), std::log2(x));
    check_holds("log10", log10(xs), std::log10(x));
    check_holds("sin", sin(xs), std::sin(x));
    check_holds("cos", cos(xs), std::cos(x));
    check_holds("tan", tan(xs), std::tan(x));
    check_holds("asin", asin(xs), std::asin(x));
    check_holds("acos", acos(xs), std::acos(x));
    check_holds("atan", atan(xs), std::atan(x));
    check_holds("sinh", sinh(xs), std::sinh(x));
    check_holds("cosh", cosh(xs), std::cosh(x));
    check_holds("tanh", tanh(xs), std::tanh(x));
    check_holds("asinh", asinh(xs), std::asinh(x));
    check_holds("acosh", acosh(xs), std::acosh(x));
    check_holds("atanh", atanh(xs), std::atanh(x));
    check_holds("atan2", atan2(xs, ys), std::atan2(x, y));
    check_holds("floor", floor(xs), std::floor(x));
    check_holds("ceil", ceil(xs), std::ceil(x));
    check_holds("rint", rint(xs), std::rint(x));
    check_holds("min", smaller(xs, ys), std::min(x, y));
    check_holds("max", larger(xs, ys), std::max(x, y));
    check_holds("<", less(xs, ys), x < y);
    check_holds("<=", not_greater(xs, ys), x <= y);
    check_holds("==", equal(xs, ys), x == y);
    check_holds("&&", both(xs, ys), x != 0 && y != 0);
    check_holds("if", choose(xs, ys, -ys), x != 0 ? y : -y);
  }
}

TEST_CASE("intervals round outward and pass over infinities", "[interval]") {
  const Interval third = Interval(1) / Interval(3), largest(std::numeric_limits<double>::max());
  CHECK(third.low() < third.high());
  CHECK((Interval(0.1) + Interval(0.2)).high() > 0.3);
  CHECK((largest * largest).high() == std::numeric_limits<double>::infinity());
  CHECK((largest * largest - largest * largest).may_be_undefined());
  CHECK(!proved_inside({-2, -1, true}).has_value());
  CHECK(proved_inside({1, 2, true}) == false);
}

TEST_CASE("all of 300 spheres of a C++ function are found by its range", "[interval_components]") {
  const SurfaceComponents found = components(many_spheres(), 0);
  CHECK(found.components.size() == 300);
  CHECK_THAT(found.method, ContainsSubstring("interval"));
}

TEST_CASE("boxes without a change of sign are told of", "[interval_components]") {
  const Spheres tiny{{{{0.01, 0.013, 0.017}, 0.005}, {{1, 1, 1}, 1}}};
  const SurfaceComponents found = components(tiny, 0.2);
  CHECK(found.components.size() == 1);
  CHECK(!found.is_exact);
  CHECK_THAT(found.method, ContainsSubstring("may hold"));
  CHECK(components(tiny, 0.008).components.size() == 2);
}

TEST_CASE("seeds of boxes are on the surface and spread", "[interval_components]") {
  const Spheres one{{{{0.1, 0.2, 0.3}, 1}}};
  const SurfaceComponents found = components(one, 0.1);
  REQUIRE(found.components.size() == 1);
  REQUIRE(found.components[0].size() == most_seeds);
  for (const Point3 p : found.components[0]) CHECK(std::abs(one(p)) <= 1e-6);
  CHECK(squared_distance(found.components[0][0], found.components[0][1]) > 3);
}

TEST_CASE("a surface that ends at the bounds goes on along them", "[interval_components]") {
  const Spheres at_corner{{{{3, 3, 3}, 1}, {{0, 0, 0}, 1}, {{0, 0, -3}, 0.5}}};
  const SurfaceComponents found = components(at_corner, 0.1);
  CHECK(found.components.size() == 3);
  for (const auto& seeds : found.components)
    for (const Point3 p : seeds) CHECK((std::abs(at_corner(p)) <= 1e-6 || p.x == 3 || p.y == 3 || p.z == 3 || p.z == -3));
}

TEST_CASE("boxes of any shape are halved to cubes", "[interval_components]") {
  const Spheres row{{{{0, 0, 0}, 0.4}, {{5, 0, 0}, 0.4}, {{10, 0, 0}, 0.4}}};
  const ImplicitDomain domain(row, BoundingBox3{{-0.7, -0.5, -0.45}, {10.6, 0.5, 0.6}}, {.sampling_distance = 0.09});
  CHECK(domain.components(Control{}).components.size() == 3);
}

TEST_CASE("the search ends when it must, and refuses sizes that cannot be", "[interval_components]") {
  std::stop_source source;
  source.request_stop();
  const ImplicitDomain domain(many_spheres(), cube(3));
  CHECK_THROWS_AS(domain.components(Control({}, source.get_token())), Interrupted);
  CHECK_THROWS_AS(components(many_spheres(), 1e-6), InvalidInput);
}
