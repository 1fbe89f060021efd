// SPDX-License-Identifier: GPL-3.0-or-later
//
// The predicates are exact on nearly degenerate input. They would not be if the compiler contracted products and sums to fused
// operations: this is the test that -ffp-contract=off works, under every compiler that is used.
#include <array>
#include <cmath>
#include <limits>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <catch2/catch_test_macros.hpp>

#include <delref/domain/exact_side.hpp>
#include <delref/triangulation/constrained_delaunay_2.hpp>
#include <delref/triangulation/detail/planar_filters.hpp>

using namespace delref;

namespace {

using Rational = CGAL::Exact_rational;

int sign_of(const Rational& r) { return r > 0 ? 1 : r < 0 ? -1 : 0; }

/// Coordinates of q - p, without rounding.
std::array<Rational, 2> difference(Point2 p, Point2 q) {
  return {Rational(q.x) - Rational(p.x), Rational(q.y) - Rational(p.y)};
}

int rational_side(Point2 a, Point2 b, Point2 c) {
  const auto u = difference(a, b), v = difference(a, c);
  return sign_of(u[0] * v[1] - u[1] * v[0]);
}

/// 1 when d is inside the circle through a, b and c, which are counterclockwise.
int rational_in_circle(Point2 a, Point2 b, Point2 c, Point2 d) {
  const auto row = [&](Point2 p) {
    const auto u = difference(d, p);
    return std::array<Rational, 3>{u[0], u[1], u[0] * u[0] + u[1] * u[1]};
  };
  const auto r = row(a), s = row(b), t = row(c);
  return sign_of(r[0] * (s[1] * t[2] - s[2] * t[1]) - r[1] * (s[0] * t[2] - s[2] * t[0]) + r[2] * (s[0] * t[1] - s[1] * t[0]));
}

/// Calls f for the points of a grid of so many ulps to each side of p.
template <class F>
void around(Point2 p, int steps, F&& f) {
  const double dx = std::nextafter(std::abs(p.x), 1e308) - std::abs(p.x), dy = std::nextafter(std::abs(p.y), 1e308) - std::abs(p.y);
  for (int i = -steps; i <= steps; ++i)
    for (int j = -steps; j <= steps; ++j) f(Point2{p.x + i * dx, p.y + j * dy});
}

}  // namespace

TEST_CASE("The side of a point is exact within a few ulps of a line") {
  std::size_t wrong = 0, on_line = 0, naive_wrong = 0;
  const auto compare = [&](Point2 a, Point2 b, Point2 c) {
    const int truth = rational_side(a, b, c);
    wrong += exact_side(a, b, c) != truth;
    on_line += truth == 0;
    const double naive = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    naive_wrong += (naive > 0) - (naive < 0) != truth;
  };
  around({0.5, 0.5}, 60, [&](Point2 c) { compare({12, 12}, {24, 24}, c); });
  around({1.1, 0.3666666666666667}, 60, [&](Point2 c) { compare({0.1, 0.1}, {3.1, 0.9}, c); });
  around({1e9 + 0.25, 1e9 + 0.75}, 60, [&](Point2 c) { compare({1e9, 1e9 + 0.5}, {1e9 + 0.5, 1e9 + 1}, c); });
  CHECK(wrong == 0);
  CHECK(on_line > 100);
  CHECK(naive_wrong > 100);  // otherwise the points above test nothing
}

TEST_CASE("Whether a point is in a circle is exact within a few ulps of it") {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const auto cgal = [](Point2 p) { return Kernel::Point_2(p.x, p.y); };
  std::size_t wrong = 0, on_circle = 0;
  const Point2 a{0.3, 0.1}, b{0.9, 0.1}, c{0.9, 0.7};
  around({0.3, 0.7}, 40, [&](Point2 d) {
    const int truth = rational_in_circle(a, b, c, d);
    const auto side = CGAL::side_of_oriented_circle(cgal(a), cgal(b), cgal(c), cgal(d));
    wrong += static_cast<int>(side) != truth;
    on_circle += truth == 0;
  });
  CHECK(wrong == 0);
  CHECK(on_circle > 0);
}

TEST_CASE("Whether a point is in the diametral circle of an edge is exact within a few ulps of it") {
  ConstrainedDelaunay2<> tr;
  const Point2 a{0.1, 0.7}, b{0.7, 0.1};
  for (const Point2 p : {a, b, Point2{0.9, 0.9}}) tr.cgal().insert({p.x, p.y});
  std::size_t wrong = 0, inside = 0, examined = 0;
  for (const auto f : tr.finite_faces())
    for (int i = 0; i < 3; ++i) {
      const auto e = tr.edge(f, i);
      const Point2 p = tr.point(tr.source(e)), q = tr.point(tr.target(e));
      if (!((p == a && q == b) || (p == b && q == a))) continue;
      around({0.1, 0.1}, 60, [&](Point2 c) {
        const auto u = difference(c, a), v = difference(c, b);
        const bool truth = u[0] * v[0] + u[1] * v[1] < 0;
        wrong += tr.in_diametral_circle(e, c) != truth;
        inside += truth, ++examined;
      });
    }
  CHECK(wrong == 0);
  CHECK(inside > 1000);
  CHECK(inside < examined - 1000);
}

TEST_CASE("What floating-point filters say of sides and circles is true in any unit of length") {
  std::size_t wrong = 0, open = 0, told = 0;
  const auto compare = [&](int answer, int truth) {
    wrong += answer != 0 && answer != truth;
    ++(answer == 0 ? open : told);
  };
  const Point2 a{0.3, 0.1}, b{0.9, 0.1}, c{0.9, 0.7}, on_circle{0.3, 0.7}, on_line{0.5, 0.1};
  for (const int exponent : {0, 1, -37, 60, -60, 130, -130, 250, -250, 300, -300, 511, -511, -530, 1000, -1000}) {
    const auto at = [&](Point2 p) { return Point2{std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)}; };
    const auto compare_at = [&](Point2 d) {
      compare(detail::filtered_side_of_circle(at(a), at(b), at(c), d), rational_in_circle(at(a), at(b), at(c), d));
      compare(detail::filtered_orientation(at(a), at(b), d), rational_side(at(a), at(b), d));
    };
    around(at(on_circle), 8, compare_at);
    around(at(on_line), 8, compare_at);
    for (int k = 0; k < 52; ++k) {
      const double away = std::ldexp(1.0, -k);
      for (const double d : {away, -away}) {
        compare_at(at({on_circle.x + d, on_circle.y}));
        compare_at(at({on_line.x, on_line.y + d}));
      }
    }
  }
  CHECK(wrong == 0);
  CHECK(open > 1000);
  CHECK(told > 1000);
  CHECK(detail::filtered_side_of_circle(a, b, c, {0.6, 0.4}) == 1);
  CHECK(detail::filtered_side_of_circle(a, b, c, {1.6, 0.4}) == -1);
  CHECK(detail::filtered_orientation(a, b, {0.6, 0.4}) == 1);
  CHECK(detail::filtered_orientation(a, b, {0.6, -0.4}) == -1);
}
