// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a planar mesh is verified against, besides its input.
#pragma once

#include <functional>
#include <limits>
#include <vector>

#include <delref/core/outcome.hpp>
#include <delref/core/point.hpp>
#include <delref/domain/pslg.hpp>

namespace delref {

/// The promises of the run that made a mesh. The area bounds of regions are taken from the input.
struct PlanarCriteria {
  /// 0 for none.
  double min_angle_degrees = 0;
  double max_area = std::numeric_limits<double>::infinity();
  double max_edge = std::numeric_limits<double>::infinity();
  /// An upper bound on the longest edge of a triangle, asked at its barycentre in the coordinates of the input; empty for none.
  std::function<double(Point2)> size;
  /// Encroachment was by diametral circles: every edge is Delaunay, and no subsegment is encroached.
  bool circle = false;
  /// The run came to its end. When false, elements that miss a criterion are counted as unfinished and are no failure.
  bool complete = true;
  /// What the run says it could not meet. An element that misses a criterion is covered by an entry whose place is its barycentre
  /// (to 1e-6 of its longest edge). An entry whose reason is a small input angle covers no angle: that excuse is verified.
  std::vector<Unmet<Point2>> listed;
  /// For input that was derived from another one (split at crossings): by which index the mesh names each of its points and
  /// segments, as in `CheckedPslg`. Empty: by its own.
  std::vector<Pslg::Index> point_names, segment_names;
};

}  // namespace delref
