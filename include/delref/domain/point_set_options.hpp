// SPDX-License-Identifier: GPL-3.0-or-later
//
// How the surface through a set of points is reconstructed.
#pragma once

#include <cstddef>

namespace delref {

/// Options of `PointSetDomain`.
struct PointSetOptions {
  /// From how many of the nearest points the normal at each point is estimated and turned, where the set has none, and a point is moved when
  /// they are smoothed. More where the points are noisy; fewer where sheets of the surface are near each other. At least 6.
  std::size_t neighbours = 18;
  /// Points further than this from their six nearest ones, on the average and in multiples of what is usual in the set (the median), are
  /// left out. 0: none is left out, and those further than 10 times are told.
  double outlier_distance = 0;
  /// How often each point is moved along its normal to where its neighbours suggest that the surface is, edges being kept; for noisy sets.
  /// One to three are often enough.
  std::size_t smoothing_passes = 0;
};

}  // namespace delref
