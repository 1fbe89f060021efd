// SPDX-License-Identifier: GPL-3.0-or-later
//
// The smallest angle that a triangle may have, as a type: the unit is in the name of the function that makes it, and a bound
// that no mesh can meet cannot be made.
#pragma once

#include <cmath>
#include <compare>
#include <numbers>

#include <delref/domain/describe.hpp>
#include <delref/domain/invalid_input.hpp>

namespace delref {

/// A lower bound on the angles of triangles, at least 0 degrees (no bound) and less than 60.
///
/// Delaunay refinement is proven to end, with good grading, for bounds up to 20.7 degrees (Ruppert 1995; Shewchuk 2002); in
/// practice it does so to about 33. Whatever the bound, this library's mesher ends, and lists the triangles that do not meet it.
class AngleBound {
 public:
  /// The bound of so many degrees. Throws `InvalidInput` unless 0 <= degrees < 60.
  static AngleBound degrees(double degrees) {
    if (std::isnan(degrees)) throw InvalidInput("the minimum angle is not a number: give degrees, at least 0 and less than 60");
    if (degrees < 0)
      throw InvalidInput("a minimum angle of " + describe(degrees) + " degrees is negative: give 0 for no bound, or at most 33");
    if (degrees >= 60)
      throw InvalidInput("a minimum angle of " + describe(degrees) +
                         " degrees cannot be met: the angles of a triangle add up to 180, so its smallest is at most 60, and "
                         "only equilateral triangles reach that; give less than 60 (up to 20.7 is proven to be met, up to 33 "
                         "works in practice)");
    return AngleBound(degrees);
  }

  double degrees() const { return degrees_; }
  /// The square of the bound's sine: what a triangle's squared sines are compared with.
  double squared_sine() const { return squared_sine_; }

  friend bool operator==(AngleBound a, AngleBound b) { return a.degrees_ == b.degrees_; }
  friend auto operator<=>(AngleBound a, AngleBound b) { return a.degrees_ <=> b.degrees_; }

 private:
  explicit AngleBound(double degrees) : degrees_(degrees) {
    const double sine = std::sin(degrees * (std::numbers::pi / 180));
    squared_sine_ = sine * sine;
  }

  double degrees_;
  double squared_sine_;
};

}  // namespace delref
