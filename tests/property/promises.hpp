// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a run promises, as `verify_planar` takes it, and the sets of options that the property tests run with.
#pragma once

#include <array>
#include <cstdlib>
#include <span>
#include <string>

#include <delref/algorithms/planar.hpp>
#include <delref/domain/bounding_box.hpp>
#include <delref/mesh/verify_planar.hpp>

namespace delref::property {

struct Mode {
  const char* name;
  double min_angle;
  Encroachment encroachment;
  PointChoice points;
  double relative_area = 0;  ///< of the square on the input's extent; 0 for no bound

  PlanarOptions options(const Pslg& pslg) const {
    PlanarOptions o;
    o.min_angle = AngleBound::degrees(min_angle);
    o.encroachment = encroachment;
    o.points = points;
    const double extent = bounding_box(pslg.points).extent();
    if (relative_area > 0) o.max_area = relative_area * extent * extent;
    return o;
  }
};

inline constexpr std::array modes{
    Mode{"20.7 degrees, circles", 20.7, Encroachment::circle, PointChoice::off_centre},
    Mode{"20.7 degrees, lenses", 20.7, Encroachment::lens, PointChoice::off_centre},
    Mode{"30 degrees, lenses, off-centres", 30, Encroachment::lens, PointChoice::off_centre},
    Mode{"26 degrees, circumcentres, area", 26, Encroachment::circle, PointChoice::circumcentre, 1e-3}};

/// How many seeds each property is tried on: the environment variable DELREF_SEEDS, or `usual`.
inline std::uint64_t seed_count(std::uint64_t usual) {
  const char* given = std::getenv("DELREF_SEEDS");
  return given ? std::strtoull(given, nullptr, 10) : usual;
}

inline PlanarCriteria promises(const PlanarOptions& options, const Outcome<Point2>& outcome) {
  PlanarCriteria criteria;
  criteria.min_angle_degrees = options.min_angle.degrees();
  criteria.max_area = options.max_area;
  criteria.max_edge = options.max_edge;
  criteria.size = options.size;
  criteria.circle = options.encroachment == Encroachment::circle;
  criteria.complete = outcome.complete();
  criteria.listed = outcome.unmet;
  return criteria;
}

/// The failed checks of a mesh against its input, in words; empty when there are none.
inline std::string broken_promises(const Pslg& input, const PlanarMesh& mesh, const PlanarCriteria& criteria) {
  std::string text;
  for (const Finding& f : verify_planar(input, mesh, criteria).findings)
    if (f.status == CheckStatus::failed)
      text += f.name + ": " + std::to_string(f.failures) + " of " + std::to_string(f.examined) + " are not: " +
              (f.places.empty() ? "" : f.places.front()) + "\n";
  return text;
}
/// The same for all that was given to a refinement; without a look at encroachment where segments are within rounding of each other.
inline std::string broken_promises(const PlanarRefinement<>& refinement, const PlanarOptions& options, bool is_at_the_limits = false) {
  PlanarCriteria criteria = promises(options, refinement.outcome());
  if (is_at_the_limits) criteria.circle = false;
  criteria.point_names = refinement.united_input().original_point;
  criteria.segment_names = refinement.united_input().original_segment;
  return broken_promises(refinement.united_input().pslg, refinement.mesh(), criteria);
}

}  // namespace delref::property
