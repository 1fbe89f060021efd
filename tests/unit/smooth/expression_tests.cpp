// SPDX-License-Identifier: GPL-3.0-or-later
#include <delref/domain/implicit_domain.hpp>
#include <delref/domain/multi_material_domain.hpp>
#include <delref/expression/expression.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include "functions.hpp"

using namespace delref;
using namespace delref_test;
using Catch::Matchers::ContainsSubstring;

namespace {

static_assert(PointFunction<Expression> && BatchFunction<Expression> && RangedFunction<Expression>);
static_assert(FindsComponents<ImplicitDomain<Expression>> && FindsComponents<MultiMaterialDomain<Expression>>);

constexpr const char* tangle_text = "x^4-5*x^2+y^4-5*y^2+z^4-5*z^2+11.8";

std::string many_spheres_text() {
  std::string text = "min(";
  for (const Sphere& sphere : many_spheres().spheres) {
    if (text.size() > 4) text += ',';
    text += "(x-(" + std::to_string(sphere.centre.x) + "))^2+(y-(" + std::to_string(sphere.centre.y) + "))^2+(z-(" +
            std::to_string(sphere.centre.z) + "))^2-" + std::to_string(sphere.radius * sphere.radius);
  }
  return text + ')';
}

}  // namespace

TEST_CASE("an expression has the value that it is written with", "[expression]") {
  const std::vector<std::pair<const char*, double>> values{{"x", 1},
                                                           {"-x^2", -1},
                                                           {"2^3^2", 512},
                                                           {"x-y-z", -4},
                                                           {"x/y/z", 1.0 / 6},
                                                           {"1-2*3", -5},
                                                           {"3--x", 4},
                                                           {"x*-y", -2},
                                                           {"+x", 1},
                                                           {"2^-1", 0.5},
                                                           {"z^-2", 1.0 / 9},
                                                           {"y^z", 8},
                                                           {"x^0", 1},
                                                           {"z^0.5", std::sqrt(3.0)},
                                                           {"y^2.5", std::pow(2, 2.5)},
                                                           {"pow(z,y)", 9},
                                                           {"if(x<y,3,4)", 3},
                                                           {"if(x>y,3,4)", 4},
                                                           {"x<y && y<z", 1},
                                                           {"x>y || z>=3", 1},
                                                           {"x!=1", 0},
                                                           {"x<=1", 1},
                                                           {"x==1", 1},
                                                           {"min(z,x,y)", 1},
                                                           {"max(x,z,y)", 3},
                                                           {"sum(x,y,z)", 6},
                                                           {"avg(x,y,z)", 2},
                                                           {"atan2(y,x)", std::atan2(2.0, 1.0)},
                                                           {"ln(e)+log(e)+log2(8)+log10(100)", 7},
                                                           {"cbrt(8)", 2},
                                                           {"cbrt(-8)", -2},
                                                           {"sqrt(4)", 2},
                                                           {"abs(-2)+sign(-2)", 1},
                                                           {"floor(-1.5)", -2},
                                                           {"ceil(1.2)", 2},
                                                           {"rint(2.4)", 2},
                                                           {"cos(pi)", -1},
                                                           {" x +\n\ty ", 3},
                                                           {"1e2+.5", 100.5},
                                                           {"((((x))))", 1},
                                                           {"e", 2.718281828459045}};
  for (const auto& [text, value] : values) {
    INFO(text);
    CHECK(std::abs(Expression(text)(Point3{1, 2, 3}) - value) <= 1e-15 * std::abs(value));
  }
}

TEST_CASE("many values at once are those of each point, to the last bit", "[expression]") {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> number(-3, 3);
  const std::string many_registers = many_spheres_text();
  for (const std::string& text : {std::string(tangle_text), std::string("7"), std::string("y"),
                                  std::string("if(x<y, sin(x)/z, sqrt(y)) + x*y"), many_registers}) {
    const Expression expression(text);
    std::vector<Point3> points;
    for (int i = 0; i < 53; ++i) points.push_back({number(random), number(random), number(random)});
    for (const std::size_t count : {0U, 1U, 2U, 3U, 16U, 17U, 53U}) {
      std::vector<double> values(count);
      expression(std::span(points).first(count), values);
      for (std::size_t i = 0; i < count; ++i) {
        const double alone = expression(points[i]);
        CHECK((values[i] == alone || (std::isnan(values[i]) && std::isnan(alone))));
      }
    }
  }
}

TEST_CASE("ranges of expressions hold their values, also in what is left of them within a box", "[expression]") {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> number(-3, 3), part(0, 1);
  std::size_t shorter = 0;
  for (const std::string& text : {std::string(tangle_text), std::string("sin(x)*cos(y)+sin(y)*cos(z)+sin(z)*cos(x)"),
                                  many_spheres_text(), std::string("if(x<0, sqrt(y), max(x, y*z, log(z)))"),
                                  std::string("x^y + atan2(x, z) / (x - y)"), std::string("min(sqrt(x), y) + max(z, sqrt(y))")}) {
    const Expression expression(text);
    for (int i = 0; i < 300; ++i) {
      const Point3 low{number(random), number(random), number(random)};
      const double size = part(random) * part(random);
      const BoundingBox3 box{low, low + Vector3{size, size, size}};
      const ValueRange range = expression.range(box);
      const auto less = expression.narrowed(box);
      shorter += less.has_value();
      for (int k = 0; k < 5; ++k) {
        const Point3 p = low + Vector3{size * part(random), size * part(random), size * part(random)};
        const double value = expression(p);
        INFO(text);
        CHECK((std::isnan(value) ? range.may_be_undefined : range.low <= value && value <= range.high));
        if (less) CHECK(((*less)(p) == value || (std::isnan(value) && std::isnan((*less)(p)))));
      }
    }
  }
  CHECK(shorter > 100);
}

TEST_CASE("an expression that cannot be read is refused with the place and what is allowed", "[expression]") {
  for (const char* text :
       {"",    " ",   "x+",  "x=3", "x=y",  "a",      "x+q",     "sin()", "sin(x,y)", "sin x",   "min()", "(x",
        "x)",  "x,y", "x y", "2x",  "x^^2", "foo(x)", "\"abc\"", "x?y:z", "x?1:2",    "1e999",   "0x10",  "nan",
        "inf", "x!y", "x&y", "x|y", "x;y",  "x{2}",   "x==",     ",",     "()",       "if(x,y)", "#"})
    CHECK_THROWS_AS(Expression(text), InvalidInput);
  CHECK_THROWS_AS(Expression(std::string(30000, '-') + "x"), InvalidInput);
  CHECK_THROWS_AS(Expression(std::string("x\0y", 3)), InvalidInput);
  try {
    Expression("x^2 + q*3");
    FAIL();
  } catch (const InvalidInput& error) {
    CHECK_THAT(error.what(), ContainsSubstring("character 7"));
    CHECK_THAT(error.what(), ContainsSubstring("variables x y z"));
  }
  try {
    Expression("x < 0 ? 1 : 2");
    FAIL();
  } catch (const InvalidInput& error) {
    CHECK_THAT(error.what(), ContainsSubstring("if(condition"));
  }
}

TEST_CASE("one expression answers several threads", "[expression]") {
  const Expression expression(tangle_text);
  std::vector<double> sums(4);
  std::vector<std::thread> threads;
  for (double& sum : sums)
    threads.emplace_back([&] {
      for (int i = 0; i < 10000; ++i) sum += expression({std::sin(i * 1.0), std::cos(i * 2.0), std::sin(i * 3.0)});
    });
  for (std::thread& thread : threads) thread.join();
  for (const double sum : sums) CHECK(sum == sums[0]);
}

TEST_CASE("equal parts of an expression are computed once", "[expression]") {
  CHECK(Expression("(x+y)^2 + (x+y)^2").formula().instructions().size() == 3);
  CHECK(Expression("2*3+4").formula().instructions().empty());
  CHECK(Expression(many_spheres_text()).formula().registers() < 120);
}

TEST_CASE("components are proved complete where the gradient shows it, and only there", "[expression]") {
  const auto found = [](const char* text, double distance) {
    return ImplicitDomain(Expression(text), cube(3), {.sampling_distance = distance}).components(Control{});
  };
  CHECK(found("sqrt(x^2+y^2+z^2)-1", 0.1).is_exact);
  CHECK(found("(sqrt(x^2+y^2)-1)^2+z^2-0.09", 0.1).is_exact);
  CHECK(found(tangle_text, 3.0 / 64).is_exact);
  CHECK(!found("x^2+y^2-z^2", 0.1).is_exact);
  CHECK(!found("sin(x)*cos(y)+sin(y)*cos(z)+sin(z)*cos(x)", 0.1).is_exact);
  CHECK(!found("min(x^2+y^2+z^2-1, (x-0.02)^2+(y-2)^2+z^2-1)", 0.1).is_exact);
}

TEST_CASE("gradients over boxes hold the gradients in them", "[expression]") {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> number(0.1, 0.9);
  for (const char* text : {"x*y/z", "x^3*y^-2", "x^y", "sqrt(x*y)", "exp(x-y)*log(z)", "sin(x)+cos(y)*tan(z)",
                           "asin(x)+acos(y)+atan(z)", "sinh(x)*cosh(y)-tanh(z)", "asinh(x)+acosh(1+y)+atanh(z)", "atan2(y,x)",
                           "log2(x)+log10(y)", "abs(x-0.5)*z", "min(x,y,z)", "if(x<y,x*z,y*z)", "max(x*y,z)-floor(4*x)"}) {
    const Expression expression(text);
    for (int i = 0; i < 100; ++i) {
      const Point3 low{number(random), number(random), number(random)};
      const double size = 0.05 * number(random);
      const BoundingBox3 box{low, low + Vector3{size, size, size}};
      const Point3 p = low + Vector3{0.5 * size, 0.3 * size, 0.6 * size};
      const double step = 1e-6;
      const std::array<Vector3, 3> steps{Vector3{step, 0, 0}, {0, step, 0}, {0, 0, step}};
      const auto gradient = expression.formula().slope(box).gradient();
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double change = (expression(p + steps[axis]) - expression(p + -1.0 * steps[axis])) / (2 * step);
        INFO(text << ", axis " << axis);
        CHECK((change >= gradient[axis].low() - 1e-6 * (1 + std::abs(change)) &&
               change <= gradient[axis].high() + 1e-6 * (1 + std::abs(change))));
      }
    }
  }
}

TEST_CASE("components of expressions: tangle, gyroid, nested and 300 spheres", "[expression]") {
  const auto count = [](const std::string& text, double half) {
    return ImplicitDomain(Expression(text), cube(half)).components(Control{}).components.size();
  };
  CHECK(count(tangle_text, 3) == 1);
  CHECK(count("max(0.5^2 - (x^2+y^2+z^2), x^2+y^2+z^2 - 1)", 1.5) == 2);
  CHECK(count("(sqrt(x^2+y^2)-1)^2+z^2-0.09", 1.5) == 1);
  CHECK(count(many_spheres_text(), 3) == 300);
  CHECK_THROWS_AS(count("1", 1), InvalidInput);
  CHECK_THROWS_AS(count("-1", 1), InvalidInput);
  CHECK_THROWS_AS(count("sqrt(-1-x^2)", 1), InvalidInput);
}
