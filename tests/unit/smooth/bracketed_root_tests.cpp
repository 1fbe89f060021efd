// SPDX-License-Identifier: GPL-3.0-or-later
#include <delref/domain/bracketed_root.hpp>

#include <cmath>
#include <limits>
#include <random>

#include <catch2/catch_test_macros.hpp>

using delref::bracketed_root;
using delref::is_inside;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// The root, and how many values it took.
struct Found {
  double root = 0;
  int evaluations = 0;
};
template <class F>
Found search(const F& f, double a, double b, double tolerance) {
  Found found;
  const auto counted = [&](double t) {
    ++found.evaluations;
    return f(t);
  };
  found.root = bracketed_root(counted, a, f(a), b, f(b), tolerance);
  return found;
}

/// True when `f` is inside and not inside within the tolerance of the place.
template <class F>
bool changes_near(const F& f, double place, double tolerance) {
  const double step = 1.0001 * tolerance;
  const bool here = is_inside(f(place));
  return is_inside(f(place - step)) != here || is_inside(f(place + step)) != here;
}

}  // namespace

TEST_CASE("a smooth function takes a handful of values", "[bracketed_root]") {
  int all = 0, most = 0;
  for (int i = 1; i < 1000; ++i) {
    const double root = i * 1e-3;
    const auto f = [root](double t) { return std::exp(t) - std::exp(root); };
    const Found found = search(f, 0, 1, 1e-6);
    CHECK(std::abs(found.root - root) <= 1e-6);
    all += found.evaluations, most = std::max(most, found.evaluations);
  }
  CHECK(all <= 6000);
  CHECK(most <= 8);
}

TEST_CASE("the ends may come in any order and of any sign", "[bracketed_root]") {
  const auto f = [](double t) { return t * t * t - 0.2; };
  for (const double sign : {-1.0, 1.0}) {
    const auto g = [&](double t) { return sign * f(t); };
    CHECK(std::abs(search(g, 0, 1, 1e-9).root - std::cbrt(0.2)) <= 1e-9);
    CHECK(std::abs(search(g, 1, 0, 1e-9).root - std::cbrt(0.2)) <= 1e-9);
  }
}

TEST_CASE("flat, steep, broken and infinite functions stay within the bound of evaluations", "[bracketed_root]") {
  const auto check = [](const auto& f, double a, double b) {
    for (const double tolerance : {1e-3, 1e-6, 1e-12, 0.0}) {
      const Found found = search(f, a, b, tolerance);
      CHECK(found.evaluations <= delref::most_root_evaluations);
      CHECK(found.root >= std::min(a, b));
      CHECK(found.root <= std::max(a, b));
      CHECK(changes_near(f, found.root, std::max(tolerance, 1e-15 * std::max(std::abs(a), std::abs(b)))));
    }
  };
  check([](double t) { return std::pow(t - 0.3, 21); }, 0, 1);
  check([](double t) { return std::cbrt(t - 0.3); }, 0, 1);
  check([](double t) { return t < 0.3 ? -1.0 : 1.0; }, 0, 1);
  check([](double t) { return t < 0.7 ? -1e-300 : 1e300; }, 0, 1);
  check([](double t) { return t < 0.3 ? -infinity : infinity; }, 0, 1);
  check([](double t) { return t < 0.3 ? -1.0 : not_a_number; }, 0, 1);
  check([](double t) { return t < 0.3 ? not_a_number : -1.0; }, 0, 1);
  check([](double t) { return t < 0.3 ? -1.0 : 0.0; }, 0, 1);
  check([](double t) { return 1 / (t - 0.3); }, 0, 1);
  check([](double t) { return std::exp(50 * t) - 2; }, -1, 1);
  check([](double t) { return t - 1e-9; }, 0, 1);
  check([](double t) { return t - 1e9; }, -1e10, 2e10);
}

TEST_CASE("of several roots it finds one", "[bracketed_root]") {
  const auto f = [](double t) { return std::sin(40 * t) - 0.3; };
  const Found found = search(f, 0, 1, 1e-8);
  CHECK(changes_near(f, found.root, 1e-8));
}

TEST_CASE("with ends on one side it gives the end nearer to zero, without a question", "[bracketed_root]") {
  const auto never = [](double) -> double { throw 1; };
  CHECK(bracketed_root(never, 0, 1e-17, 1, 3, 1e-6) == 0);
  CHECK(bracketed_root(never, 0, -2, 1, -1e-17, 1e-6) == 1);
  CHECK(bracketed_root(never, 0, 0, 1, 1, 1e-6) == 0);
}

TEST_CASE("random functions keep the promises", "[bracketed_root]") {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int i = 0; i < 2000; ++i) {
    const double a = number(random), b = number(random), c = number(random), jump = i % 3 == 0 ? number(random) : 0;
    const auto f = [=](double t) { return a + b * t + c * std::sin(20 * t) + (t > 0.4 ? jump : 0); };
    if (is_inside(f(0)) == is_inside(f(1))) continue;
    const Found found = search(f, 0, 1, 1e-7);
    CHECK(changes_near(f, found.root, 1e-7));
    CHECK(found.evaluations <= 60);
  }
}
