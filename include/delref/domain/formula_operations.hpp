// SPDX-License-Identifier: GPL-3.0-or-later
//
// The operations of a formula, on double, Interval and IntervalSlope alike: which they are is written once, for all.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <delref/domain/interval.hpp>

namespace delref::detail {

enum class Operation : std::uint8_t {
  constant, x, y, z,
  negate, abs, sqrt, exp, log, log2, log10, sin, cos, tan, asin, acos, atan, sinh, cosh, tanh, asinh, acosh, atanh,
  floor, ceil, rint, sign,
  power_of_integer,
  add, subtract, multiply, divide, power, smaller, larger, atan2, less, not_greater, equal, both, either,
  choose
};

/// How many operands an operation has.
constexpr int operand_count(Operation operation) {
  if (operation <= Operation::z) return 0;
  if (operation <= Operation::power_of_integer) return 1;
  return operation < Operation::choose ? 2 : 3;
}

inline double smaller(double a, double b) { return b < a ? b : a; }
inline double larger(double a, double b) { return a < b ? b : a; }
inline double sign(double a) { return a < 0 ? -1 : a > 0 ? 1 : 0; }
inline double less(double a, double b) { return a < b ? 1 : 0; }
inline double not_greater(double a, double b) { return a <= b ? 1 : 0; }
inline double equal(double a, double b) { return a == b ? 1 : 0; }
inline double choose(double condition, double a, double b) { return condition != 0 ? a : b; }
inline double both(double a, double b) { return a != 0 && b != 0 ? 1 : 0; }
inline double either(double a, double b) { return a != 0 || b != 0 ? 1 : 0; }
inline double power(double a, double b) { return std::pow(a, b); }
inline double power(double a, int exponent) {
  if (exponent < 0) return 1 / power(a, -exponent);
  double result = exponent % 2 == 1 ? a : 1;
  for (exponent /= 2; exponent > 0; exponent /= 2) {
    a *= a;
    if (exponent % 2 == 1) result *= a;
  }
  return result;
}
/// The same for an exponent that the compiler knows.
template <int exponent>
double power_of(double a) {
  if constexpr (exponent == 1) return a;
  else if constexpr (exponent % 2 == 1) return a * power_of<exponent / 2>(a * a);
  else return power_of<exponent / 2>(a * a);
}
template <int exponent, class Number>
Number power_of(const Number& a) { return power(a, exponent); }

/// Calls `use` with a function of the operation's operands, which are double, Interval or IntervalSlope; `exponent` is that of
/// `power_of_integer`.
template <class Use>
void with_operation(Operation operation, int exponent, Use&& use) {
  using std::abs, std::sqrt, std::exp, std::log, std::log2, std::log10, std::floor, std::ceil, std::rint;
  using std::sin, std::cos, std::tan, std::asin, std::acos, std::atan, std::atan2;
  using std::sinh, std::cosh, std::tanh, std::asinh, std::acosh, std::atanh;
  switch (operation) {
    case Operation::negate: return use([](const auto& a) { return -a; });
    case Operation::abs: return use([](const auto& a) { return abs(a); });
    case Operation::sqrt: return use([](const auto& a) { return sqrt(a); });
    case Operation::exp: return use([](const auto& a) { return exp(a); });
    case Operation::log: return use([](const auto& a) { return log(a); });
    case Operation::log2: return use([](const auto& a) { return log2(a); });
    case Operation::log10: return use([](const auto& a) { return log10(a); });
    case Operation::sin: return use([](const auto& a) { return sin(a); });
    case Operation::cos: return use([](const auto& a) { return cos(a); });
    case Operation::tan: return use([](const auto& a) { return tan(a); });
    case Operation::asin: return use([](const auto& a) { return asin(a); });
    case Operation::acos: return use([](const auto& a) { return acos(a); });
    case Operation::atan: return use([](const auto& a) { return atan(a); });
    case Operation::sinh: return use([](const auto& a) { return sinh(a); });
    case Operation::cosh: return use([](const auto& a) { return cosh(a); });
    case Operation::tanh: return use([](const auto& a) { return tanh(a); });
    case Operation::asinh: return use([](const auto& a) { return asinh(a); });
    case Operation::acosh: return use([](const auto& a) { return acosh(a); });
    case Operation::atanh: return use([](const auto& a) { return atanh(a); });
    case Operation::floor: return use([](const auto& a) { return floor(a); });
    case Operation::ceil: return use([](const auto& a) { return ceil(a); });
    case Operation::rint: return use([](const auto& a) { return rint(a); });
    case Operation::sign: return use([](const auto& a) { return sign(a); });
    case Operation::power_of_integer:
      if (exponent == 2) return use([](const auto& a) { return power_of<2>(a); });
      if (exponent == 3) return use([](const auto& a) { return power_of<3>(a); });
      if (exponent == 4) return use([](const auto& a) { return power_of<4>(a); });
      return use([exponent](const auto& a) { return power(a, exponent); });
    case Operation::add: return use([](const auto& a, const auto& b) { return a + b; });
    case Operation::subtract: return use([](const auto& a, const auto& b) { return a - b; });
    case Operation::multiply: return use([](const auto& a, const auto& b) { return a * b; });
    case Operation::divide: return use([](const auto& a, const auto& b) { return a / b; });
    case Operation::power: return use([](const auto& a, const auto& b) { return power(a, b); });
    case Operation::smaller: return use([](const auto& a, const auto& b) { return smaller(a, b); });
    case Operation::larger: return use([](const auto& a, const auto& b) { return larger(a, b); });
    case Operation::atan2: return use([](const auto& a, const auto& b) { return atan2(a, b); });
    case Operation::less: return use([](const auto& a, const auto& b) { return less(a, b); });
    case Operation::not_greater: return use([](const auto& a, const auto& b) { return not_greater(a, b); });
    case Operation::equal: return use([](const auto& a, const auto& b) { return equal(a, b); });
    case Operation::both: return use([](const auto& a, const auto& b) { return both(a, b); });
    case Operation::either: return use([](const auto& a, const auto& b) { return either(a, b); });
    case Operation::choose: return use([](const auto& c, const auto& a, const auto& b) { return choose(c, a, b); });
    default: return;
  }
}

}  // namespace delref::detail
