// SPDX-License-Identifier: GPL-3.0-or-later
//
// The checks of shape and size of the tetrahedra. Shapes may be excused by small input angles; sizes never are.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <fmt/format.h>

#include <delref/mesh/verify/report.hpp>
#include <delref/mesh/verify/shortfall.hpp>
#include <delref/mesh/verify_3/check_tiling.hpp>
#include <delref/mesh/verify_3/small_angles.hpp>

namespace delref::verification_3 {

inline constexpr double size_slack = 1 + 1e-9;
using Shortfalls = verification::Shortfalls<Point3>;

inline void check_radius_edge(const Subject& s, SmallAngles& small_angles, Shortfalls& shortfalls, VerifyReport& report,
                              Finding& finding) {
  finding.examined = s.mesh.tetrahedra.size();
  const double bound = s.criteria.radius_edge * size_slack;
  for (std::size_t t = 0; t < s.mesh.tetrahedra.size(); ++t) {
    s.breathe(t);
    const TetrahedronMeasures shape = s.shape(t);
    const double ratio = std::sqrt(shape.squared_radius_edge());
    report.worst_radius_edge = std::max(report.worst_radius_edge, ratio);
    if (ratio > bound) {
      if (!s.criteria.strict && small_angles.excuse(t)) {
        ++report.excused_angles;
        continue;
      }
      if (!s.criteria.strict && shortfalls.settle_angle(shape.barycentre(), shape.longest_edge())) continue;
      finding.fail([&] { return fmt::format("{} has a radius-edge ratio of {}", s.tetrahedron(t), ratio); });
    }
    report.worst_radius_edge_in_force = std::max(report.worst_radius_edge_in_force, ratio);
  }
}

/// The bound on the volume of a tetrahedron: the domain's and, where there is one, that of the region with its label (of any seed
/// in the room when the mesh has no labels).
inline double volume_bound(const Subject& s, const Room& room, std::size_t t) {
  double of_region = 0;
  for (const Index r : room.regions) {
    const Plc::Region& region = s.input.regions[r];
    if (region.max_volume > 0 && (s.mesh.regions.empty() || s.mesh.regions[t] == region.label))
      of_region = std::max(of_region, region.max_volume);
  }
  return of_region > 0 ? std::min(of_region, s.criteria.max_volume) : s.criteria.max_volume;
}

/// Counts a tetrahedron that misses a bound on its size as listed or unfinished; false: it is a failure.
inline bool settle(const Subject& s, const TetrahedronMeasures& shape, Shortfalls& shortfalls) {
  return !s.criteria.strict && shortfalls.settle(shape.barycentre(), shape.longest_edge());
}

inline void check_volume_bounds(const Subject& s, const Rooms& rooms, const TetrahedronRooms& room_of, Shortfalls& shortfalls,
                                Finding& finding) {
  finding.examined = s.mesh.tetrahedra.size();
  for (std::size_t t = 0; t < s.mesh.tetrahedra.size(); ++t) {
    s.breathe(t);
    const TetrahedronMeasures shape = s.shape(t);
    const double bound = volume_bound(s, rooms.rooms()[room_of[t]], t);
    if (shape.volume() <= s.scaling.volume(bound) * size_slack || settle(s, shape, shortfalls)) continue;
    finding.fail([&] {
      return fmt::format("{} has a volume of {}, the bound is {}", s.tetrahedron(t), s.scaling.original_volume(shape.volume()),
                         bound);
    });
  }
}

inline void check_cell_sizes(const Subject& s, Shortfalls& shortfalls, Finding& finding) {
  finding.examined = s.mesh.tetrahedra.size();
  const double bound = s.scaling.length(s.criteria.cell_size) * size_slack;
  for (std::size_t t = 0; t < s.mesh.tetrahedra.size(); ++t) {
    s.breathe(t);
    const TetrahedronMeasures shape = s.shape(t);
    if (shape.squared_circumradius() <= bound * bound || settle(s, shape, shortfalls)) continue;
    finding.fail([&] {
      return fmt::format("{} has a circumradius of {}", s.tetrahedron(t),
                         s.scaling.original_length(std::sqrt(shape.squared_circumradius())));
    });
  }
}

/// A size that is not positive is met by nothing.
inline void check_sizes(const Subject& s, Shortfalls& shortfalls, Finding& finding) {
  finding.examined = s.mesh.tetrahedra.size();
  for (std::size_t t = 0; t < s.mesh.tetrahedra.size(); ++t) {
    s.breathe(t);
    const auto& [a, b, c, d] = s.mesh.tetrahedra[t];
    const auto centre = CGAL::circumcenter(exact(s.points[a]), exact(s.points[b]), exact(s.points[c]), exact(s.points[d]));
    const double size = s.criteria.size(s.original({centre.x(), centre.y(), centre.z()}));
    const TetrahedronMeasures shape = s.shape(t);
    const double radius = std::sqrt(shape.squared_circumradius());
    if (radius <= s.scaling.length(size) * size_slack || settle(s, shape, shortfalls)) continue;
    finding.fail([&] {
      return fmt::format("{} has a circumradius of {}, the size at its centre is {}", s.tetrahedron(t),
                         s.scaling.original_length(radius), size);
    });
  }
}

}  // namespace delref::verification_3
