// SPDX-License-Identifier: GPL-3.0-or-later
#include <delref/domain/multi_material_domain.hpp>

#include <cmath>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include <catch2/catch_test_macros.hpp>

#include "functions.hpp"

using namespace delref;
using namespace delref_test;

namespace {

template <class Domain>
int label_of(const Domain& domain, Point3 p) {
  int label = -7;
  domain.label(std::span<const Point3>(&p, 1), std::span(&label, 1));
  return label;
}

const Sphere left{{-0.5, 0, 0}, 1}, right{{0.5, 0, 0}, 1};

}  // namespace

TEST_CASE("two overlapping spheres make three regions", "[multi_material]") {
  const MultiMaterialDomain<Sphere> domain({left, right}, cube(2));
  CHECK(label_of(domain, {-1.2, 0, 0}) == 0);
  CHECK(label_of(domain, {1.2, 0, 0}) == 1);
  CHECK(label_of(domain, {0, 0, 0}) == 2);
  CHECK(label_of(domain, {0, 1.5, 0}) == outside);
}

TEST_CASE("a list of sign vectors numbers its regions and drops the others", "[multi_material]") {
  const MultiMaterialDomain<Sphere> domain({left, right}, cube(2), {0b11, 0b10});
  CHECK(label_of(domain, {0, 0, 0}) == 0);
  CHECK(label_of(domain, {1.2, 0, 0}) == 1);
  CHECK(label_of(domain, {-1.2, 0, 0}) == outside);
}

TEST_CASE("lists and functions that cannot be used are refused", "[multi_material]") {
  using Domain = MultiMaterialDomain<Sphere>;
  CHECK_THROWS_AS(Domain({}, cube(2)), InvalidInput);
  CHECK_THROWS_AS(Domain(std::vector<Sphere>(17, left), cube(2)), InvalidInput);
  CHECK_THROWS_AS(Domain({left, right}, cube(2), {0}), InvalidInput);
  CHECK_THROWS_AS(Domain({left, right}, cube(2), {4}), InvalidInput);
  CHECK_THROWS_AS(Domain({left, right}, cube(2), {1, 2, 1}), InvalidInput);
  CHECK_THROWS_AS(Domain({left, right}, BoundingBox3{}), InvalidInput);
}

TEST_CASE("a crossing is where the label of its first end ends", "[multi_material]") {
  const MultiMaterialDomain<Sphere> domain({left, right}, cube(2));
  CHECK(std::abs(domain.crossing({-1.2, 0, 0}, {1.2, 0, 0}, 0, 1e-8).x - -0.5) <= 1e-8);
  CHECK(std::abs(domain.crossing({1.2, 0, 0}, {-1.2, 0, 0}, 1, 1e-8).x - 0.5) <= 1e-8);
  CHECK(std::abs(domain.crossing({0, 0, 0}, {2, 0, 0}, 2, 1e-8).x - 0.5) <= 1e-8);
  CHECK(std::abs(domain.crossing({2, 0, 0}, {0, 0, 0}, outside, 1e-8).x - 1.5) <= 1e-8);
}

TEST_CASE("a crossing past signs that do not matter is found by label", "[multi_material]") {
  const MultiMaterialDomain<Sphere> domain({left, right}, cube(2), {0b01, 0b11});
  const std::vector<Point3> ends{{-1.4, 0, 0}, {0, 0, 0}, {1.4, 0, 0}, {0, 1.9, 0.2}, {-0.3, -0.8, 0.1}};
  for (const Point3 a : ends)
    for (const Point3 b : ends) {
      const int label_a = label_of(domain, a);
      if (label_of(domain, b) == label_a) continue;
      const Point3 p = domain.crossing(a, b, label_a, 1e-7);
      const Vector3 step = 1.01e-7 / std::sqrt(squared_distance(a, b)) * (b - a);
      const bool before = label_of(domain, p + -1.0 * step) == label_a, after = label_of(domain, p + step) == label_a;
      CHECK((before || label_of(domain, p) == label_a));
      CHECK((!after || label_of(domain, p) != label_a));
    }
}

TEST_CASE("the domain ends at its bounds", "[multi_material]") {
  const MultiMaterialDomain<Sphere> domain({left, right}, cube(1));
  CHECK(domain.crossing({0.9, 0, 0}, {3, 0, 0}, 1, 1e-8) == Point3{1, 0, 0});
  CHECK(domain.crossing({3, 0, 0}, {0.9, 0, 0}, outside, 1e-8) == Point3{1, 0, 0});
}

TEST_CASE("functions of different kinds and NaN go together", "[multi_material]") {
  using Function = std::function<double(Point3)>;
  const MultiMaterialDomain<Function> domain({Function(left), Function([](Point3 p) { return std::sqrt(p.x) - 0.2; })}, cube(2));
  CHECK(label_of(domain, {-1.2, 0, 0}) == 0);
  CHECK(label_of(domain, {0.01, 0, 0}) == 2);
  CHECK(label_of(domain, {0.01, 0, 1.9}) == 1);
}

TEST_CASE("surfaces that meet are one component, others are found alone", "[multi_material]") {
  CHECK(MultiMaterialDomain<Sphere>({left, right}, cube(2)).components(Control{}).components.size() == 1);
  const Sphere small{{0, 0, 1.5}, 0.2};
  const MultiMaterialDomain<Sphere> three({left, right, small}, cube(2));
  CHECK(three.components(Control{}).components.size() == 2);
  const MultiMaterialDomain<Spheres> proved({Spheres{{left, right}}, Spheres{{small}}}, cube(2));
  CHECK(proved.components(Control{}).components.size() == 2);
}

TEST_CASE("functions without a region are refused in words", "[multi_material]") {
  const MultiMaterialDomain<Sphere> domain({left, right}, BoundingBox3{{5, 5, 5}, {6, 6, 6}});
  CHECK_THROWS_AS(domain.components(Control{}), InvalidInput);
}
