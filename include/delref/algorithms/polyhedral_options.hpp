// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a user asks of a tetrahedral mesh of a piecewise linear complex, with defaults.
#pragma once

#include <functional>
#include <limits>

#include <delref/core/point.hpp>
#include <delref/domain/plc_options.hpp>

namespace delref {

/// Options of `mesh_polyhedron`. Lengths are in the unit of the input, volumes in its cube.
struct PolyhedralOptions {
  /// Bound on the circumradius of a tetrahedron over its shortest edge; at least 1. `mesh_polyhedron` says what is known of bounds
  /// that are reached.
  double radius_edge = 2;
  double max_volume = std::numeric_limits<double>::infinity();
  /// Bound on the circumradius.
  double cell_size = std::numeric_limits<double>::infinity();
  /// No circumradius is greater than the size at the circumcentre; empty for no bound.
  std::function<double(Point3)> size;
  /// How the complex is read: what is merged, joined and tolerated.
  PlcOptions input;
};

}  // namespace delref
