// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points sampled on a surface, as scanners and point set files give them. Plain data.
#pragma once

#include <vector>

#include <delref/core/point.hpp>

namespace delref {

/// Points of space, and at each the direction out of the surface when that is known.
struct PointSet {
  std::vector<Point3> points;
  /// One per point, of any length, or empty when the file has none.
  std::vector<Vector3> normals;
};

}  // namespace delref
