// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a user asks of the mesh of a smooth surface, or of the volume that it bounds, with defaults.
#pragma once

#include <functional>
#include <limits>
#include <vector>

#include <delref/core/point.hpp>
#include <delref/criteria/angle_bound.hpp>

namespace delref {

/// Options of `mesh_smooth_domain`. Lengths are in the unit of the domain.
struct SmoothOptions {
  static constexpr double unbounded = std::numeric_limits<double>::infinity();

  /// No angle of a facet of the surface is smaller. 30 degrees end by proof on smooth surfaces.
  AngleBound facet_angle = AngleBound::degrees(30);
  /// Bound on the radius of surface balls: a facet's corners are on such a ball, its centre is on the surface. Where nothing bounds
  /// the size of facets, and no distance does, a 20th of the extent of the surface.
  double facet_size = unbounded;
  /// Bound on the distance between a facet's circumcentre and the centre of its surface ball.
  double facet_distance = unbounded;
  /// The same two from place to place; empty for no bound.
  std::function<double(Point3)> facet_size_field, facet_distance_field;
  /// Whether the facets at each vertex have to be a topological disk.
  bool manifold = true;
  /// How exactly the surface is found, as a part of the shortest edge of each facet, or of the facet size where that is less.
  double surface_tolerance = 1e-6;
  /// Facets with surface balls of no greater radius are left as they are. 0: a thousandth of the facet size (of a 20th of the
  /// extent of the surface where that is less, or where there is none).
  double smallest_facet = 0;

  /// Only the surface is refined, and the mesh has no tetrahedra.
  bool surface_only = false;
  /// Bound on the circumradius of a tetrahedron over its shortest edge; at least 1. 2 ends by proof.
  double radius_edge = 2;
  /// Bound on the circumradius of tetrahedra, everywhere, per region number (0 is none), and from place to place.
  double cell_size = unbounded;
  std::vector<double> region_cell_sizes;
  std::function<double(Point3)> cell_size_field;
};

}  // namespace delref
