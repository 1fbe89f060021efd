// SPDX-License-Identifier: GPL-3.0-or-later
//
// Intervals that hold every value that a function has over a box: Boost.Interval with bounds rounded outward, whatever the
// rounding mode of the processor and the flags of the compiler. Each bound is computed to the nearest and moved on by more than
// the error of the operation; the C library's functions are trusted to 4 units of the last digit (glibc states at most 4). Moore,
// "Interval Analysis" (1966).
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <boost/numeric/interval.hpp>

namespace delref {

namespace detail {

/// The rounding policy of Boost.Interval: every operation a little further down, or up.
struct OutwardRounding {
  using unprotected_rounding = OutwardRounding;

  /// At least so many units of the last digit. What is added for results that underflow is a normal number: sums with denormal ones
  /// take processors some 30 times as long.
  static double widening(double value, double units) {
    return std::abs(value) * (units * std::numeric_limits<double>::epsilon()) + std::numeric_limits<double>::min();
  }
  static double down(double value, double units = 1) { return value - widening(value, units); }
  static double up(double value, double units = 1) { return value + widening(value, units); }
  static constexpr double library = 8;

  static double conv_down(double a) { return a; }
  static double conv_up(double a) { return a; }
  static double opp_down(double a) { return -a; }
  static double opp_up(double a) { return -a; }
  /// A sum of 0, a product with 0 and what is 0 are exact: what cannot be negative stays so.
  static double add_down(double a, double b) { return a + b == 0 ? 0 : down(a + b); }
  static double add_up(double a, double b) { return a + b == 0 ? 0 : up(a + b); }
  static double sub_down(double a, double b) { return a == b ? 0 : down(a - b); }
  static double sub_up(double a, double b) { return a == b ? 0 : up(a - b); }
  static double mul_down(double a, double b) { return a == 0 || b == 0 ? 0 : down(a * b); }
  static double mul_up(double a, double b) { return a == 0 || b == 0 ? 0 : up(a * b); }
  static double div_down(double a, double b) { return a == 0 ? 0 : down(a / b); }
  static double div_up(double a, double b) { return a == 0 ? 0 : up(a / b); }
  static double sqrt_down(double a) { return std::max(0.0, down(std::sqrt(a))); }
  static double sqrt_up(double a) { return up(std::sqrt(a)); }
  static double median(double a, double b) { return 0.5 * a + 0.5 * b; }
  static double int_down(double a) { return std::floor(a); }
  static double int_up(double a) { return std::ceil(a); }
  static double exp_down(double a) { return std::max(0.0, down(std::exp(a), library)); }
  static double exp_up(double a) { return up(std::exp(a), library); }
  static double log_down(double a) { return down(std::log(a), library); }
  static double log_up(double a) { return up(std::log(a), library); }
  static double sin_down(double a) { return down(std::sin(a), library); }
  static double sin_up(double a) { return up(std::sin(a), library); }
  static double cos_down(double a) { return down(std::cos(a), library); }
  static double cos_up(double a) { return up(std::cos(a), library); }
  static double tan_down(double a) { return down(std::tan(a), library); }
  static double tan_up(double a) { return up(std::tan(a), library); }
  static double asin_down(double a) { return down(std::asin(a), library); }
  static double asin_up(double a) { return up(std::asin(a), library); }
  static double acos_down(double a) { return down(std::acos(a), library); }
  static double acos_up(double a) { return up(std::acos(a), library); }
  static double atan_down(double a) { return down(std::atan(a), library); }
  static double atan_up(double a) { return up(std::atan(a), library); }
  static double sinh_down(double a) { return down(std::sinh(a), library); }
  static double sinh_up(double a) { return up(std::sinh(a), library); }
  static double cosh_down(double a) { return down(std::cosh(a), library); }
  static double cosh_up(double a) { return up(std::cosh(a), library); }
  static double tanh_down(double a) { return down(std::tanh(a), library); }
  static double tanh_up(double a) { return up(std::tanh(a), library); }
  static double asinh_down(double a) { return down(std::asinh(a), library); }
  static double asinh_up(double a) { return up(std::asinh(a), library); }
  static double acosh_down(double a) { return down(std::acosh(a), library); }
  static double acosh_up(double a) { return up(std::acosh(a), library); }
  static double atanh_down(double a) { return down(std::atanh(a), library); }
  static double atanh_up(double a) { return up(std::atanh(a), library); }
};

using BoostInterval = boost::numeric::interval<
    double, boost::numeric::interval_lib::policies<OutwardRounding, boost::numeric::interval_lib::checking_base<double>>>;

}  // namespace detail

/// The values of an expression over a box: every defined one is between `low()` and `high()`; where `may_be_undefined`, some may
/// be NaN as well. Operations on intervals hold every result of the operation on members. Where nothing can be said the interval
/// is all numbers.
class Interval {
  using Bounds = detail::BoostInterval;
  static constexpr double infinity = std::numeric_limits<double>::infinity();

 public:
  Interval(double value = 0) : Interval(value, value) {}
  Interval(double low, double high) : Interval(Bounds(low, high), false) {}
  static Interval all(bool may_be_undefined = true) { return {Bounds(-infinity, infinity), may_be_undefined}; }

  /// What is in both. Requires that they meet.
  friend Interval common(const Interval& a, const Interval& b) {
    return {Bounds(std::max(a.low(), b.low()), std::min(a.high(), b.high())), a.may_be_undefined_ && b.may_be_undefined_};
  }

  double low() const { return bounds_.lower(); }
  double high() const { return bounds_.upper(); }
  bool may_be_undefined() const { return may_be_undefined_; }
  bool is_zero() const { return low() == 0 && high() == 0 && !may_be_undefined_; }
  bool is_never_zero() const { return (low() > 0 || high() < 0) && !may_be_undefined_; }

  friend Interval operator-(const Interval& a) { return {-a.bounds_, a.may_be_undefined_}; }
  friend Interval operator+(const Interval& a, const Interval& b) {
    return {a.bounds_ + b.bounds_, either_undefined(a, b) || infinite(a, b)};
  }
  friend Interval operator-(const Interval& a, const Interval& b) {
    return {a.bounds_ - b.bounds_, either_undefined(a, b) || infinite(a, b)};
  }
  friend Interval operator*(const Interval& a, const Interval& b) {
    return {a.bounds_ * b.bounds_, either_undefined(a, b) || infinite(a, b)};
  }
  friend Interval operator/(const Interval& a, const Interval& b) {
    if (b.holds(0)) return all(either_undefined(a, b) || a.holds(0) || infinite(a, b));
    return {a.bounds_ / b.bounds_, either_undefined(a, b) || infinite(a, b)};
  }
  friend Interval power(const Interval& a, int exponent) {
    if (exponent < 0) return Interval(1) / power(a, -exponent);
    return {boost::numeric::pow(a.bounds_, exponent), a.may_be_undefined_};
  }
  friend Interval abs(const Interval& a) { return {boost::numeric::abs(a.bounds_), a.may_be_undefined_}; }
  friend Interval sqrt(const Interval& a) {
    return a.within(0, infinity, [](const Bounds& b) { return boost::numeric::sqrt(b); });
  }
  friend Interval exp(const Interval& a) { return {boost::numeric::exp(a.bounds_), a.may_be_undefined_}; }
  friend Interval log(const Interval& a) {
    return a.within(0, infinity, [](const Bounds& b) {
      if (b.upper() <= 0) return Bounds(-infinity, -std::numeric_limits<double>::max());
      return Bounds(b.lower() > 0 ? detail::OutwardRounding::log_down(b.lower()) : -infinity,
                    detail::OutwardRounding::log_up(b.upper()));
    });
  }
  friend Interval log2(const Interval& a) { return log(a) / about(std::log(2.0)); }
  friend Interval log10(const Interval& a) { return log(a) / about(std::log(10.0)); }
  /// Of a negative base, a power is defined for whole numbers only.
  friend Interval power(const Interval& a, const Interval& b) {
    if (a.low() > 0) return exp(b * log(a));
    if (!(a.low() >= 0 && b.low() > 0)) return all();
    return {Bounds(0, exp(b * log(a)).high()), either_undefined(a, b)};
  }
  friend Interval sin(const Interval& a) {
    return a.periodic([](const Bounds& b) { return boost::numeric::sin(b); });
  }
  friend Interval cos(const Interval& a) {
    return a.periodic([](const Bounds& b) { return boost::numeric::cos(b); });
  }
  friend Interval tan(const Interval& a) {
    if (!(a.high() - a.low() < 3) || a.far()) return all();
    return {boost::numeric::tan(a.bounds_), a.may_be_undefined_};
  }
  friend Interval asin(const Interval& a) {
    return a.within(-1, 1, [](const Bounds& b) { return boost::numeric::asin(b); });
  }
  friend Interval acos(const Interval& a) {
    return a.within(-1, 1, [](const Bounds& b) { return boost::numeric::acos(b); });
  }
  friend Interval atan(const Interval& a) { return {boost::numeric::atan(a.bounds_), a.may_be_undefined_}; }
  friend Interval sinh(const Interval& a) { return {boost::numeric::sinh(a.bounds_), a.may_be_undefined_}; }
  friend Interval cosh(const Interval& a) { return {boost::numeric::cosh(a.bounds_), a.may_be_undefined_}; }
  friend Interval tanh(const Interval& a) { return {boost::numeric::tanh(a.bounds_), a.may_be_undefined_}; }
  friend Interval asinh(const Interval& a) { return {boost::numeric::asinh(a.bounds_), a.may_be_undefined_}; }
  friend Interval acosh(const Interval& a) {
    return a.within(1, infinity, [](const Bounds& b) { return boost::numeric::acosh(b); });
  }
  friend Interval atanh(const Interval& a) {
    if (a.low() <= -1 || a.high() >= 1) return all();
    return {boost::numeric::atanh(a.bounds_), a.may_be_undefined_};
  }
  friend Interval atan2(const Interval& y, const Interval& x) {
    const Bounds pi = boost::numeric::interval_lib::pi<Bounds>();
    const bool on_cut = y.holds(0) && x.low() <= 0;
    if (on_cut || infinite(y, x)) return {Bounds(-pi.upper(), pi.upper()), either_undefined(y, x)};
    const auto [low, high] = std::minmax({std::atan2(y.low(), x.low()), std::atan2(y.low(), x.high()),
                                          std::atan2(y.high(), x.low()), std::atan2(y.high(), x.high())});
    return {Bounds(detail::OutwardRounding::down(low, detail::OutwardRounding::library),
                   detail::OutwardRounding::up(high, detail::OutwardRounding::library)),
            either_undefined(y, x)};
  }
  friend Interval floor(const Interval& a) { return {Bounds(std::floor(a.low()), std::floor(a.high())), a.may_be_undefined_}; }
  friend Interval ceil(const Interval& a) { return {Bounds(std::ceil(a.low()), std::ceil(a.high())), a.may_be_undefined_}; }
  friend Interval rint(const Interval& a) { return {Bounds(std::floor(a.low()), std::ceil(a.high())), a.may_be_undefined_}; }
  friend Interval sign(const Interval& a) {
    const auto of = [](double value) { return value < 0 ? -1.0 : value > 0 ? 1.0 : 0.0; };
    return a.may_be_undefined_ ? Interval(-1, 1) : Interval(of(a.low()), of(a.high()));
  }
  /// What `b < a ? b : a` gives, which drops NaN on one side.
  friend Interval smaller(const Interval& a, const Interval& b) {
    if (either_undefined(a, b)) return {boost::numeric::hull(a.bounds_, b.bounds_), true};
    return {boost::numeric::min(a.bounds_, b.bounds_), false};
  }
  friend Interval larger(const Interval& a, const Interval& b) { return -smaller(-a, -b); }
  /// 1 where it is true, 0 where it is false.
  friend Interval less(const Interval& a, const Interval& b) { return truth(a, b, a.high() < b.low(), a.low() >= b.high()); }
  friend Interval not_greater(const Interval& a, const Interval& b) {
    return truth(a, b, a.high() <= b.low(), a.low() > b.high());
  }
  friend Interval equal(const Interval& a, const Interval& b) {
    const bool apart = a.high() < b.low() || b.high() < a.low();
    return truth(a, b, a.low() == a.high() && b.low() == b.high() && a.low() == b.low(), apart);
  }
  friend Interval both(const Interval& a, const Interval& b) {
    return truth(a, b, !a.holds(0) && !b.holds(0), a.is_zero() || b.is_zero());
  }
  friend Interval either(const Interval& a, const Interval& b) {
    return truth(a, b, !a.holds(0) || !b.holds(0), a.is_zero() && b.is_zero());
  }
  friend Interval choose(const Interval& condition, const Interval& a, const Interval& b) {
    if (condition.is_never_zero()) return a;
    if (condition.is_zero()) return b;
    return {boost::numeric::hull(a.bounds_, b.bounds_), either_undefined(a, b)};
  }

 private:
  Interval(const Bounds& bounds, bool may_be_undefined) : bounds_(bounds), may_be_undefined_(may_be_undefined) {
    if (!(bounds.lower() <= bounds.upper())) bounds_ = Bounds(-infinity, infinity), may_be_undefined_ = true;
  }
  static bool either_undefined(const Interval& a, const Interval& b) { return a.may_be_undefined_ || b.may_be_undefined_; }
  /// With an infinite bound, infinity minus infinity or 0 times infinity may come up in floating-point numbers.
  static bool infinite(const Interval& a, const Interval& b) {
    return std::isinf(a.low()) || std::isinf(a.high()) || std::isinf(b.low()) || std::isinf(b.high());
  }
  static Interval truth(const Interval& a, const Interval& b, bool always, bool never) {
    if (either_undefined(a, b)) return {0, 1};
    return always ? Interval(1) : never ? Interval(0) : Interval(0, 1);
  }
  static Interval about(double value) {
    return {Bounds(detail::OutwardRounding::down(value, detail::OutwardRounding::library),
                   detail::OutwardRounding::up(value, detail::OutwardRounding::library)),
            false};
  }
  bool holds(double value) const { return low() <= value && value <= high(); }
  bool far() const { return !(std::max(-low(), high()) < 1e6); }
  /// A function that is defined from `from` to `to` only.
  template <class F>
  Interval within(double from, double to, const F& function) const {
    if (high() < from || low() > to) return all();
    const bool cut = low() < from || high() > to;
    return {function(Bounds(std::max(low(), from), std::min(high(), to))), may_be_undefined_ || cut};
  }
  template <class F>
  Interval periodic(const F& function) const {
    if (far()) return {Bounds(-1, 1), may_be_undefined_ || std::isinf(low()) || std::isinf(high())};
    return {function(bounds_), may_be_undefined_};
  }

  Bounds bounds_;
  bool may_be_undefined_ = false;
};

}  // namespace delref
