// SPDX-License-Identifier: GPL-3.0-or-later
//
// Decides about an element that misses its criterion: the run listed it, the run was not complete, or it is a failure.
#pragma once

#include <utility>
#include <vector>

#include <delref/core/outcome.hpp>
#include <delref/core/point.hpp>
#include <delref/mesh/scaling.hpp>
#include <delref/mesh/verify/nearest_point.hpp>
#include <delref/mesh/verify/report.hpp>

namespace delref::verification {

/// `Criteria` has `complete` and `listed`, a vector of `Unmet<Point>`.
template <class Point>
class Shortfalls {
 public:
  template <class Criteria>
  Shortfalls(const Criteria& criteria, const PowerOfTwoScaling& scaling, VerifyReport& report)
      : complete_(criteria.complete), all_(places(criteria.listed, scaling, true)),
        not_for_angles_(places(criteria.listed, scaling, false)), report_(report) {}

  /// Counts an element, given its scaled barycentre and longest edge, as listed or unfinished; false: it is a failure.
  bool settle(Point barycentre, double longest_edge) { return settle(all_, barycentre, longest_edge); }
  /// The same for an angle, which a listed small input angle does not cover.
  bool settle_angle(Point barycentre, double longest_edge) { return settle(not_for_angles_, barycentre, longest_edge); }

 private:
  using Places = NearestPoint<Point>;

  static Places places(const std::vector<Unmet<Point>>& listed, const PowerOfTwoScaling& scaling, bool small_angles_too) {
    std::vector<Point> found;
    for (const Unmet<Point>& u : listed)
      if (is_finite(u.place) && (small_angles_too || u.reason != Reason::small_input_angle)) found.push_back(scaling(u.place));
    return Places(std::move(found));
  }

  bool settle(const Places& listed, Point barycentre, double longest_edge) {
    const double tolerance = 1e-6 * longest_edge + 2e-15;  // scaled coordinates are at most 1: a few roundings of them
    if (listed.squared_distance_from(barycentre) <= tolerance * tolerance) ++report_.listed_unmet;
    else if (!complete_) ++report_.unfinished;
    else return false;
    return true;
  }

  bool complete_;
  Places all_, not_for_angles_;
  VerifyReport& report_;
};

}  // namespace delref::verification
