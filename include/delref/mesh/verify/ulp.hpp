// SPDX-License-Identifier: GPL-3.0-or-later
//
// The unit in which distances from input elements are judged: what rounding of one coordinate can do.
#pragma once

#include <cmath>
#include <limits>

namespace delref::verification {

/// The distance from 2^k to the next double, for the binade of a coordinate.
inline double ulp(double coordinate) {
  return coordinate == 0 ? 0 : std::ldexp(std::numeric_limits<double>::epsilon(), std::ilogb(coordinate));
}

}  // namespace delref::verification
