// SPDX-License-Identifier: GPL-3.0-or-later
//
// Intervals of a function and of its three partial derivatives over a box, by the rules of differentiation (forward mode). Rall,
// "Automatic Differentiation" (1981).
#pragma once

#include <array>
#include <cstddef>

#include <delref/domain/interval.hpp>

namespace delref {

/// The value and the gradient over a box. Where a function has no derivative, or jumps, the gradient is all numbers, and may be
/// undefined.
class IntervalSlope {
  using Gradient = std::array<Interval, 3>;

 public:
  IntervalSlope(double number = 0) : value_(number) {}
  /// The coordinate along an axis.
  IntervalSlope(const Interval& coordinate, std::size_t axis) : value_(coordinate) { gradient_[axis] = 1; }

  const Interval& value() const { return value_; }
  const Gradient& gradient() const { return gradient_; }

  friend IntervalSlope operator-(const IntervalSlope& a) { return chain(-a.value_, a, -1); }
  friend IntervalSlope operator+(const IntervalSlope& a, const IntervalSlope& b) {
    return combine(a.value_ + b.value_, a, 1, b, 1);
  }
  friend IntervalSlope operator-(const IntervalSlope& a, const IntervalSlope& b) {
    return combine(a.value_ - b.value_, a, 1, b, -1);
  }
  friend IntervalSlope operator*(const IntervalSlope& a, const IntervalSlope& b) {
    return combine(a.value_ * b.value_, a, b.value_, b, a.value_);
  }
  friend IntervalSlope operator/(const IntervalSlope& a, const IntervalSlope& b) {
    return combine(a.value_ / b.value_, a, Interval(1) / b.value_, b, -(a.value_ / power(b.value_, 2)));
  }
  friend IntervalSlope power(const IntervalSlope& a, int n) {
    return chain(power(a.value_, n), a, n == 1 ? Interval(1) : Interval(n) * power(a.value_, n - 1));
  }
  friend IntervalSlope power(const IntervalSlope& a, const IntervalSlope& b) {
    if (!(a.value_.low() > 0)) return broken(power(a.value_, b.value_));
    const Interval value = power(a.value_, b.value_);
    return combine(value, a, b.value_ * value / a.value_, b, log(a.value_) * value);
  }
  friend IntervalSlope abs(const IntervalSlope& a) {
    if (a.value_.low() >= 0) return a;
    return a.value_.high() <= 0 ? -a : broken(abs(a.value_));
  }
  friend IntervalSlope sqrt(const IntervalSlope& a) { return chain(sqrt(a.value_), a, Interval(0.5) / sqrt(a.value_)); }
  friend IntervalSlope exp(const IntervalSlope& a) { return chain(exp(a.value_), a, exp(a.value_)); }
  friend IntervalSlope log(const IntervalSlope& a) { return chain(log(a.value_), a, Interval(1) / a.value_); }
  friend IntervalSlope log2(const IntervalSlope& a) {
    return chain(log2(a.value_), a, Interval(1) / (a.value_ * log(Interval(2))));
  }
  friend IntervalSlope log10(const IntervalSlope& a) {
    return chain(log10(a.value_), a, Interval(1) / (a.value_ * log(Interval(10))));
  }
  friend IntervalSlope sin(const IntervalSlope& a) { return chain(sin(a.value_), a, cos(a.value_)); }
  friend IntervalSlope cos(const IntervalSlope& a) { return chain(cos(a.value_), a, -sin(a.value_)); }
  friend IntervalSlope tan(const IntervalSlope& a) { return chain(tan(a.value_), a, Interval(1) + power(tan(a.value_), 2)); }
  friend IntervalSlope asin(const IntervalSlope& a) {
    return chain(asin(a.value_), a, Interval(1) / sqrt(Interval(1) - power(a.value_, 2)));
  }
  friend IntervalSlope acos(const IntervalSlope& a) {
    return chain(acos(a.value_), a, Interval(-1) / sqrt(Interval(1) - power(a.value_, 2)));
  }
  friend IntervalSlope atan(const IntervalSlope& a) {
    return chain(atan(a.value_), a, Interval(1) / (Interval(1) + power(a.value_, 2)));
  }
  friend IntervalSlope sinh(const IntervalSlope& a) { return chain(sinh(a.value_), a, cosh(a.value_)); }
  friend IntervalSlope cosh(const IntervalSlope& a) { return chain(cosh(a.value_), a, sinh(a.value_)); }
  friend IntervalSlope tanh(const IntervalSlope& a) { return chain(tanh(a.value_), a, Interval(1) / power(cosh(a.value_), 2)); }
  friend IntervalSlope asinh(const IntervalSlope& a) {
    return chain(asinh(a.value_), a, Interval(1) / sqrt(power(a.value_, 2) + Interval(1)));
  }
  friend IntervalSlope acosh(const IntervalSlope& a) {
    return chain(acosh(a.value_), a, Interval(1) / sqrt(power(a.value_, 2) - Interval(1)));
  }
  friend IntervalSlope atanh(const IntervalSlope& a) {
    return chain(atanh(a.value_), a, Interval(1) / (Interval(1) - power(a.value_, 2)));
  }
  friend IntervalSlope atan2(const IntervalSlope& y, const IntervalSlope& x) {
    const Interval value = atan2(y.value_, x.value_), square = power(x.value_, 2) + power(y.value_, 2);
    const bool may_jump = x.value_.low() <= 0 && y.value_.low() <= 0 && y.value_.high() >= 0;
    return may_jump ? broken(value) : combine(value, y, x.value_ / square, x, -(y.value_ / square));
  }
  friend IntervalSlope floor(const IntervalSlope& a) { return step(floor(a.value_)); }
  friend IntervalSlope ceil(const IntervalSlope& a) { return step(ceil(a.value_)); }
  friend IntervalSlope rint(const IntervalSlope& a) { return step(rint(a.value_)); }
  friend IntervalSlope sign(const IntervalSlope& a) { return step(sign(a.value_)); }
  friend IntervalSlope smaller(const IntervalSlope& a, const IntervalSlope& b) {
    const bool defined = !a.value_.may_be_undefined() && !b.value_.may_be_undefined();
    if (defined && a.value_.high() < b.value_.low()) return a;
    return defined && b.value_.high() < a.value_.low() ? b : broken(smaller(a.value_, b.value_));
  }
  friend IntervalSlope larger(const IntervalSlope& a, const IntervalSlope& b) { return -smaller(-a, -b); }
  friend IntervalSlope less(const IntervalSlope& a, const IntervalSlope& b) { return step(less(a.value_, b.value_)); }
  friend IntervalSlope not_greater(const IntervalSlope& a, const IntervalSlope& b) {
    return step(not_greater(a.value_, b.value_));
  }
  friend IntervalSlope equal(const IntervalSlope& a, const IntervalSlope& b) { return step(equal(a.value_, b.value_)); }
  friend IntervalSlope both(const IntervalSlope& a, const IntervalSlope& b) { return step(both(a.value_, b.value_)); }
  friend IntervalSlope either(const IntervalSlope& a, const IntervalSlope& b) { return step(either(a.value_, b.value_)); }
  friend IntervalSlope choose(const IntervalSlope& condition, const IntervalSlope& a, const IntervalSlope& b) {
    if (condition.value_.is_never_zero()) return a;
    return condition.value_.is_zero() ? b : broken(choose(condition.value_, a.value_, b.value_));
  }

 private:
  static IntervalSlope broken(const Interval& value) {
    IntervalSlope result;
    result.value_ = value;
    result.gradient_.fill(Interval::all());
    return result;
  }
  /// Of a function that is constant between its jumps.
  static IntervalSlope step(const Interval& value) {
    if (value.low() < value.high() || value.may_be_undefined()) return broken(value);
    return IntervalSlope(value.low());
  }
  static IntervalSlope chain(const Interval& value, const IntervalSlope& a, const Interval& derivative) {
    IntervalSlope result;
    result.value_ = value;
    for (std::size_t i = 0; i < 3; ++i) result.gradient_[i] = product(derivative, a.gradient_[i]);
    return result;
  }
  static IntervalSlope combine(const Interval& value, const IntervalSlope& a, const Interval& by_a, const IntervalSlope& b,
                               const Interval& by_b) {
    IntervalSlope result;
    result.value_ = value;
    for (std::size_t i = 0; i < 3; ++i) result.gradient_[i] = product(by_a, a.gradient_[i]) + product(by_b, b.gradient_[i]);
    return result;
  }
  /// 0 times what is defined stays exactly 0.
  static Interval product(const Interval& a, const Interval& b) {
    return (a.is_zero() && !b.may_be_undefined()) || (b.is_zero() && !a.may_be_undefined()) ? Interval(0) : a * b;
  }

  Interval value_;
  Gradient gradient_;
};

}  // namespace delref
