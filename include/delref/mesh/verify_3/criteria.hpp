// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a tetrahedral mesh is verified against, besides its input.
#pragma once

#include <functional>
#include <limits>
#include <vector>

#include <delref/core/outcome.hpp>
#include <delref/core/point.hpp>
#include <delref/domain/plc_options.hpp>

namespace delref {

/// The promises of the run that made a mesh. The volume bounds of regions are taken from the input.
struct PolyhedralCriteria {
  /// Bound on the circumradius of a tetrahedron over its shortest edge.
  double radius_edge = std::numeric_limits<double>::infinity();
  double max_volume = std::numeric_limits<double>::infinity();
  /// Bound on the circumradius.
  double cell_size = std::numeric_limits<double>::infinity();
  /// No circumradius is greater than the size at the circumcentre, in the coordinates of the input; empty for no bound.
  std::function<double(Point3)> size;
  /// How the run understood the input: what was merged, joined and tolerated.
  PlcOptions input;
  /// The run came to its end. When false, elements that miss a criterion are counted as unfinished and are no failure.
  bool complete = true;
  /// Small input angles excuse nothing, nor does `listed`.
  bool strict = false;
  /// What the run says it could not meet. An element that misses a criterion is covered by an entry whose place is its barycentre
  /// (to 1e-6 of its longest edge). An entry whose reason is a small input angle covers no radius-edge ratio: that excuse is
  /// verified.
  std::vector<Unmet<Point3>> listed;
};

}  // namespace delref
