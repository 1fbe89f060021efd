// SPDX-License-Identifier: GPL-3.0-or-later
//
// The checks of shape and size of the triangles. Angles may be excused by small input angles; sizes never are.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <fmt/format.h>

#include <delref/mesh/verify/check_tiling.hpp>
#include <delref/mesh/verify/criteria.hpp>
#include <delref/mesh/verify/report.hpp>
#include <delref/mesh/verify/shortfall.hpp>
#include <delref/mesh/verify/small_angles.hpp>

namespace delref::verification {

inline constexpr double angle_slack_degrees = 1e-6;
inline constexpr double size_slack = 1 + 1e-9;

inline void check_angles(const Subject& s, const PlanarCriteria& criteria, const SmallAngles& small_angles, Shortfalls<Point2>& shortfalls,
                         VerifyReport& report, Finding& finding) {
  finding.examined = s.mesh.triangles.size();
  for (std::size_t t = 0; t < s.mesh.triangles.size(); ++t) {
    s.breathe(t);
    const TriangleMeasures shape = s.shape(t);
    const double angle = shape.smallest_angle();
    report.smallest_angle = std::min(report.smallest_angle, angle);
    if (angle < criteria.min_angle_degrees - angle_slack_degrees) {
      if (small_angles.excuse(t)) {
        ++report.excused_angles;
        continue;
      }
      if (shortfalls.settle_angle(shape.barycentre(), shape.longest_edge())) continue;
      finding.fail([&] { return fmt::format("{} has an angle of {} degrees", s.triangle(t), angle); });
    }
    report.smallest_angle_in_force = std::min(report.smallest_angle_in_force, angle);
  }
}

/// The bound on the area in a component: the domain's and, where there is one, that of the region with the triangle's label (of
/// any seed in the component when the mesh has no labels).
inline double area_bound(const Subject& s, const PlanarCriteria& criteria, const Component& component, std::size_t t) {
  double of_region = 0;
  for (const Index r : component.regions) {
    const Pslg::Region& region = s.input.regions[r];
    if (region.max_area > 0 && (s.mesh.regions.empty() || s.mesh.regions[t] == region.label))
      of_region = std::max(of_region, region.max_area);
  }
  return of_region > 0 ? std::min(of_region, criteria.max_area) : criteria.max_area;
}

inline void check_areas(const Subject& s, const PlanarCriteria& criteria, const InputDomain& domain,
                        const TriangleComponents& components, Shortfalls<Point2>& shortfalls, Finding& finding) {
  finding.examined = s.mesh.triangles.size();
  for (std::size_t t = 0; t < s.mesh.triangles.size(); ++t) {
    s.breathe(t);
    const TriangleMeasures shape = s.shape(t);
    const double bound = area_bound(s, criteria, domain.components()[components[t]], t);
    if (shape.area() <= s.scaling.area(bound) * size_slack || shortfalls.settle(shape.barycentre(), shape.longest_edge())) continue;
    finding.fail([&] {
      return fmt::format("{} has an area of {}, the bound is {}", s.triangle(t), s.scaling.original_area(shape.area()), bound);
    });
  }
}

inline void check_edge_lengths(const Subject& s, const PlanarCriteria& criteria, Shortfalls<Point2>& shortfalls, Finding& finding) {
  finding.examined = s.mesh.triangles.size();
  const double bound = s.scaling.length(criteria.max_edge) * size_slack;
  for (std::size_t t = 0; t < s.mesh.triangles.size(); ++t) {
    s.breathe(t);
    const TriangleMeasures shape = s.shape(t);
    if (shape.longest_edge() <= bound || shortfalls.settle(shape.barycentre(), shape.longest_edge())) continue;
    finding.fail([&] { return fmt::format("{} has an edge of length {}", s.triangle(t), s.scaling.original_length(shape.longest_edge())); });
  }
}

/// A size that is not positive is met by nothing.
inline void check_sizes(const Subject& s, const PlanarCriteria& criteria, Shortfalls<Point2>& shortfalls, Finding& finding) {
  finding.examined = s.mesh.triangles.size();
  for (std::size_t t = 0; t < s.mesh.triangles.size(); ++t) {
    s.breathe(t);
    const TriangleMeasures shape = s.shape(t);
    const double size = criteria.size(s.barycentre(t));
    if (shape.longest_edge() <= s.scaling.length(size) * size_slack || shortfalls.settle(shape.barycentre(), shape.longest_edge()))
      continue;
    finding.fail([&] {
      return fmt::format("{} has an edge of length {}, the size there is {}", s.triangle(t),
                         s.scaling.original_length(shape.longest_edge()), size);
    });
  }
}

}  // namespace delref::verification
