// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a user asks of a planar mesh, with defaults.
#pragma once

#include <functional>
#include <limits>

#include <delref/core/point.hpp>
#include <delref/criteria/angle_bound.hpp>

namespace delref {

/// How a vertex encroaches a segment: by its diametral circle (conforming Delaunay) or lens (constrained Delaunay, fewer triangles).
enum class Encroachment : unsigned char { circle, lens };
/// Which point kills a triangle.
enum class PointChoice : unsigned char { circumcentre, off_centre };

/// Options of `mesh_planar`. Lengths are in the unit of the input, areas in its square.
struct PlanarOptions {
  AngleBound min_angle = AngleBound::degrees(20.7);
  double max_area = std::numeric_limits<double>::infinity();
  double max_edge = std::numeric_limits<double>::infinity();
  /// No edge of a triangle is longer than the size at its centroid; empty for no bound.
  std::function<double(Point2)> size;
  Encroachment encroachment = Encroachment::circle;
  PointChoice points = PointChoice::off_centre;
  /// Do not split the segments that bound the domain. What this costs is in the outcome.
  bool keep_boundary = false;
  /// Split segments where they cross or overlap, instead of refusing them.
  bool split_crossings = false;
  /// Input vertices at most so far apart are merged; 0 merges equal ones only.
  double merge_tolerance = 0;
};

}  // namespace delref
