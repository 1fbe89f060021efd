// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cross and scalar products of differences of points to about 100 bits: the area of a needle or the distance of a point from a
// long segment is lost in the rounding of ordinary products. Error-free sums and products are Knuth's and Dekker's; see
// Shewchuk, Adaptive precision floating-point arithmetic and fast robust geometric predicates (1997), section 2.
#pragma once

#include <cmath>

#include <delref/core/point.hpp>

namespace delref {

/// An unevaluated sum of two doubles; `low` is the rounding error of `high`.
struct Twofold {
  double high = 0, low = 0;
  double value() const { return high + low; }
};

/// a - b without error.
inline Twofold exact_difference(double a, double b) {
  const double difference = a - b;
  const double b_part = a - difference;
  const double a_part = difference + b_part;
  return {difference, (a - a_part) + (b_part - b)};
}

/// a * b with a relative error of about 2^-104.
inline Twofold product(Twofold a, Twofold b) {
  const double high = a.high * b.high;
  return {high, std::fma(a.high, b.high, -high) + (a.high * b.low + a.low * b.high)};
}

/// Twice the signed area of the triangle a, b, c; the error is about 2^-103 of the largest product of two of its extents.
inline double precise_cross(Point2 a, Point2 b, Point2 c) {
  const Twofold p = product(exact_difference(b.x, a.x), exact_difference(c.y, a.y));
  const Twofold q = product(exact_difference(b.y, a.y), exact_difference(c.x, a.x));
  const Twofold d = exact_difference(p.high, q.high);
  return d.high + (d.low + (p.low - q.low));
}

/// The scalar product of b - a and c - a, with the same error.
inline double precise_dot(Point2 a, Point2 b, Point2 c) {
  const Twofold p = product(exact_difference(b.x, a.x), exact_difference(c.x, a.x));
  const Twofold q = product(exact_difference(b.y, a.y), exact_difference(c.y, a.y));
  const Twofold d = exact_difference(p.high, -q.high);
  return d.high + (d.low + (p.low + q.low));
}

/// A sum of many doubles whose rounding errors are kept (Neumaier 1974).
class PreciseSum {
 public:
  PreciseSum& operator+=(double term) {
    const double sum = sum_ + term;
    error_ += std::abs(sum_) >= std::abs(term) ? (sum_ - sum) + term : (term - sum) + sum_;
    sum_ = sum;
    return *this;
  }
  double value() const { return sum_ + error_; }

 private:
  double sum_ = 0, error_ = 0;
};

}  // namespace delref
