// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a function of one variable changes sign, between two places where its signs differ. Inverse quadratic interpolation where
// the three last values allow it and bisection elsewhere: T. R. Chandrupatla, "A new hybrid quadratic/bisection algorithm for
// finding the zero of a nonlinear function without using derivatives" (1997); here it halves the bracket at least every third
// step, so that no function costs more than a few bisections.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace delref {

/// True for the values inside: below 0. Zero and NaN are not.
inline bool is_inside(double value) { return value < 0; }

/// No call of `bracketed_root` evaluates its function more often.
inline constexpr int most_root_evaluations = 100;

namespace detail {

/// The fraction of the way from `x1`, the newest end of the bracket, to its other end `x2` where the next value is asked for;
/// `x3` is the end before. One half unless interpolation can be trusted there.
inline double root_fraction(double x1, double f1, double x2, double f2, double x3, double f3) {
  const double xi = (x1 - x2) / (x3 - x2);
  const double phi = (f1 - f2) / (f3 - f2);
  const bool trusted = phi * phi < xi && (1 - phi) * (1 - phi) < 1 - xi;
  if (!trusted) return 0.5;
  const double t = f1 / (f2 - f1) * (f3 / (f2 - f3)) + (x3 - x1) / (x2 - x1) * (f1 / (f3 - f1)) * (f2 / (f3 - f2));
  return std::isfinite(t) ? t : 0.5;
}

/// The fraction of the way from `x1` to `x2` where the chord meets zero; one half where there is no chord.
inline double chord_fraction(double f1, double f2) {
  const double t = f1 / (f1 - f2);
  return t >= 0 && t <= 1 ? t : 0.5;
}

}  // namespace detail

/// A place in [a, b], no further than `tolerance` (a length on the axis; not below a few units of the last digit of `a` and `b`)
/// from one where `f` changes between inside (`is_inside`) and not inside. `fa` and `fb` are `f` at `a` and `b`, which may come
/// in any order. Evaluates `f` at most `most_root_evaluations` times, about 5 times for a smooth function and a tolerance of 1e-6
/// (b - a); `f` may be discontinuous, flat, infinite or NaN. When both ends are on one side, as after an unlucky rounding, it
/// gives the end where the value is closer to 0.
template <class F>
double bracketed_root(F&& f, double a, double fa, double b, double fb, double tolerance) {
  if (is_inside(fa) == is_inside(fb)) return std::abs(fb) < std::abs(fa) ? b : a;
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  const double least = std::max(tolerance, 2 * epsilon * std::max(std::abs(a), std::abs(b)));
  double x1 = b, f1 = fb, x2 = a, f2 = fa;
  double fraction = detail::chord_fraction(f1, f2), width_before = std::abs(b - a);
  for (int evaluations = 1; evaluations <= most_root_evaluations; ++evaluations) {
    const double width = std::abs(x2 - x1);
    if (!(width > least)) break;
    const double margin = std::min(0.5, 0.5 * least / width);
    const double x = x1 + std::clamp(fraction, margin, 1 - margin) * (x2 - x1);
    const double value = f(x);
    double x3 = x1, f3 = f1;
    if (is_inside(value) != is_inside(f1)) x3 = x2, f3 = f2, x2 = x1, f2 = f1;
    x1 = x, f1 = value;
    fraction = detail::root_fraction(x1, f1, x2, f2, x3, f3);
    if (evaluations % 3 == 0) {
      if (2 * std::abs(x2 - x1) > width_before) fraction = 0.5;
      width_before = std::abs(x2 - x1);
    }
    if (evaluations >= 40) fraction = 0.5;
  }
  return std::abs(f2) < std::abs(f1) ? x2 : x1;
}

}  // namespace delref
