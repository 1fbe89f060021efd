// SPDX-License-Identifier: GPL-3.0-or-later
//
// The choices of the planar levels: where a subsegment is split, which vertex encroaches it, which point kills a triangle, which
// short edges a small input angle forces.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

#include <delref/criteria/triangle_criteria.hpp>
#include <delref/criteria/triangle_shape.hpp>
#include <delref/domain/build_planar_domain.hpp>
#include <delref/domain/chain_line.hpp>
#include <delref/domain/pslg_check.hpp>
#include <delref/levels/encroachment.hpp>
#include <delref/levels/point_choice.hpp>
#include <delref/levels/split_point.hpp>
#include <delref/triangulation/constrained_delaunay_2.hpp>

#include "../../property/generators.hpp"  // for its random numbers alone
#include "../domain/graphs.hpp"

using namespace delref;
using Catch::Approx;

namespace {

using Tr = ConstrainedDelaunay2<>;

PlanarDomain build(Tr& tr, Pslg pslg) {
  const Control control;
  const CheckedPslg checked = check_pslg(std::move(pslg), {}, control);
  return PlanarDomainBuilder<Tr>(tr, checked, control).domain();
}
/// Two segments from (0, 0) of length 1 that enclose an angle, and a third that closes the triangle.
Pslg wedge(double degrees) {
  const double a = degrees * std::numbers::pi / 180;
  return graphs::graph({{0, 0}, {1, 0}, {std::cos(a), std::sin(a)}}, {{0, 1}, {1, 2}, {2, 0}});
}
Tr::Edge subsegment_of(const Tr& tr, std::size_t segment) {
  const auto all = tr.subsegments();
  return *std::ranges::find_if(all, [&](auto e) { return tr.segment(e) == segment; });
}
Carrier on(std::uint32_t segment) { return {1, segment}; }

}  // namespace

TEST_CASE("The simplest number between two is the one with the fewest binary digits") {
  CHECK(simplest_between(0.3, 0.7) == 0.5);
  CHECK(simplest_between(0.6, 0.9) == 0.75);
  CHECK(simplest_between(3, 5) == 4);
  CHECK(simplest_between(0, 0.4) == 0);
  CHECK(simplest_between(1.0 / 3, 2.0 / 3) == 0.5);
}

TEST_CASE("Split points are strictly between the ends and within one ulp of the segment") {
  property::Random random(1);
  for (int k = 0; k < 2000; ++k) {
    const Point2 shift{random.uniform(-1, 1) * std::pow(10, random.integer(0, 6)), random.uniform(-1, 1)};
    const Point2 p = shift + Vector2{random.uniform(-1, 1), random.uniform(-1, 1)};
    const Point2 q = shift + Vector2{random.uniform(-1, 1), random.uniform(-1, 1)};
    const ChainLine line(p, q);
    Point2 a = p, b = q;
    for (int depth = 0; depth < 60; ++depth) {
      const Point2 m = random.chance(0.5) ? split_point(a, b, p, q) : split_point_near_corner(a, b, p, q);
      if (m == a) break;  // no double is between
      REQUIRE(is_between(m, a, b, q - p));
      REQUIRE(line.distance(m) <= line.ulp());
      (random.chance(0.5) ? a : b) = m;
    }
  }
}

TEST_CASE("Split points in space are strictly between the ends and within 4 ulp of the segment") {
  property::Random random(2);
  const auto coordinate = [&] { return random.uniform(-1, 1); };
  for (int k = 0; k < 2000; ++k) {
    const Vector3 shift{coordinate() * std::pow(10, random.integer(0, 6)), coordinate(), coordinate()};
    const Point3 p = Point3{coordinate(), coordinate(), coordinate()} + shift, q = Point3{coordinate(), coordinate(), coordinate()} + shift;
    const double length = std::sqrt(squared_distance(p, q)), greatest = std::abs(shift.x) + 2, ulp = std::nextafter(greatest, 2 * greatest) - greatest;
    Point3 a = p, b = q;
    for (int depth = 0; depth < 60; ++depth) {
      const Point3 m = random.chance(0.5) ? split_point(a, b, p, q) : split_point_near_corner(a, b, p, q, 1.01);
      if (m == a) break;
      REQUIRE(is_between(m, a, b, q - p));
      REQUIRE(std::sqrt(squared_length(cross(m - p, q - p))) <= 4 * ulp * length);
      (random.chance(0.5) ? a : b) = m;
    }
  }
}

TEST_CASE("A subsegment without a double between its ends is not split") {
  const Point2 a{1, 1}, b{std::nextafter(1.0, 2.0), std::nextafter(1.0, 2.0)};
  CHECK(split_point(a, b, a, b) == a);
  CHECK(split_point_near_corner(a, b, a, b) == a);
}

TEST_CASE("Segments with a common sharp corner are split at the same distances from it, which are round") {
  const Point2 corner{0.3, 0.7};
  for (const double degrees : {0.001, 1.0, 17.0, 59.0}) {
    const double angle = degrees * std::numbers::pi / 180;
    const Point2 q{1.3, 0.7}, r = corner + 0.83 * Vector2{std::cos(angle), std::sin(angle)};
    const Point2 m = split_point_near_corner(corner, q, corner, q), n = split_point_near_corner(corner, r, corner, r);
    CHECK(std::hypot(m.x - corner.x, m.y - corner.y) == Approx(0.5).epsilon(1e-14));
    CHECK(std::hypot(n.x - corner.x, n.y - corner.y) == Approx(0.5).epsilon(1e-14));
  }
}

TEST_CASE("The lens is inside the circle, and both do without the ends") {
  Tr tr;
  build(tr, graphs::square(2));
  const Tr::Edge e = subsegment_of(tr, 0);
  const DiametralCircle circle;
  const DiametralLens lens{AngleBound::degrees(20)};
  CHECK(circle.encroaches(tr, e, {1, 0.9}));
  CHECK(!circle.encroaches(tr, e, {1, 1}));
  CHECK(!circle.encroaches(tr, e, {1, 1.1}));
  CHECK(!circle.encroaches(tr, e, {0, 0}));
  // The lens holds the points that see the segment under more than 140 degrees: up to a height of tan 20 over its middle.
  const double height = std::tan(20 * std::numbers::pi / 180);
  CHECK(lens.encroaches(tr, e, {1, 0.99 * height}));
  CHECK(!lens.encroaches(tr, e, {1, 1.01 * height}));
  CHECK(!lens.encroaches(tr, e, {2.1, 0}));
  property::Random random(2);
  for (int k = 0; k < 1000; ++k) {
    const Point2 p{random.uniform(0, 2), random.uniform(-1, 1)};
    if (lens.encroaches(tr, e, p)) CHECK(circle.encroaches(tr, e, p));
  }
}

TEST_CASE("The lens of a bound of 45 degrees or more holds the whole circle") {
  Tr tr;
  build(tr, graphs::square(2));
  const Tr::Edge e = subsegment_of(tr, 0);
  CHECK(DiametralLens{AngleBound::degrees(46)}.encroaches(tr, e, {1, 0.999}));
  CHECK(!DiametralLens{AngleBound::degrees(46)}.encroaches(tr, e, {1, 1.001}));
}

TEST_CASE("The circumcentre is equally far from the corners, and the off-centre is in the circumcircle, no farther from the shortest edge") {
  property::Random random(3);
  const auto point = [&] { return Point2{random.uniform(-1, 1), random.uniform(-1, 1)}; };
  const AngleBound bound = AngleBound::degrees(25);
  for (int k = 0; k < 2000; ++k) {
    std::array<Point2, 3> c{point(), point(), point()};
    if (cross(c[1] - c[0], c[2] - c[0]) < 0) std::swap(c[1], c[2]);
    const TriangleShape t(c[0], c[1], c[2]);
    if (MinimumAngle{bound}.is_met(t) || t.doubled_area < 1e-4) continue;
    const Point2 centre = Circumcentre{}.point(t), off = OffCentre(bound).point(t);
    const double radius = squared_distance(centre, c[0]);
    CHECK(squared_distance(centre, c[1]) == Approx(radius).epsilon(1e-6));
    CHECK(squared_distance(off, centre) < radius);
    const Point2 p = c[(t.shortest + 1) % 3], q = c[(t.shortest + 2) % 3];
    CHECK(squared_distance(off, p) <= Approx(squared_distance(centre, p)));
    if (off != centre) CHECK(MinimumAngle{bound}.is_met(TriangleShape(p, q, off)));
  }
}

TEST_CASE("An edge between two segments of a sharp corner is seditious when its ends are equally far from that corner") {
  Tr tr;
  const PlanarDomain domain = build(tr, wedge(30));
  const Point2 p{0.5, 0}, q{0.5 * std::cos(std::numbers::pi / 6), 0.25};
  CHECK(domain.is_seditious(on(0), p, on(2), q));
  CHECK(!domain.is_seditious(on(0), {0.51, 0}, on(2), q));
  CHECK(!domain.is_seditious(on(0), p, on(1), q));
  CHECK(!domain.is_seditious(on(0), p, {0, 0}, q));
  CHECK(domain.meet_at_sharp_corner(on(0), on(2)));
  CHECK(!domain.meet_at_sharp_corner(on(0), on(1)));
}

TEST_CASE("A corner of 60 degrees or more, or with the outside between its segments, is not sharp") {
  Tr tr, outside;
  const PlanarDomain wide = build(tr, wedge(61));
  CHECK(!wide.is_seditious(on(0), {0.5, 0}, on(2), {0.25, 0.43}));
  // A square with a notch of 20 degrees cut out of it.
  const PlanarDomain notched =
      build(outside, graphs::graph({{0, 0}, {4, 0}, {4, 4}, {2.3, 4}, {2, 2}, {1.7, 4}, {0, 4}}, {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 6}, {6, 0}}));
  for (const auto& s : notched.segments) CHECK((!s.sharp[0] && !s.sharp[1]));
}

TEST_CASE("Segments that meet at a tiny angle are split on shells as far as the other reaches") {
  Tr tr;
  const PlanarDomain domain = build(tr, graphs::graph({{0, 0}, {4, 0}, {1, 0.001}}, {{0, 1}, {1, 2}, {2, 0}}));
  CHECK(domain.shell_corner(0, {0.5, 0}) == std::optional<std::size_t>(0));
  CHECK(domain.shell_corner(2, {0.5, 0.0005}) == std::optional<std::size_t>(1));
  Tr other;
  CHECK(!build(other, wedge(30)).shell_corner(0, {0.5, 0}));
}
