// SPDX-License-Identifier: GPL-3.0-or-later
//
// Questions about the box of indices from voxel (0, 0, 0) to the last one of an image.
#pragma once

#include <algorithm>

#include <delref/core/point.hpp>

namespace delref::detail {

/// False for an index that is not a number.
inline bool in_index_box(Point3 p, Vector3 last) {
  return p.x >= 0 && p.x <= last.x && p.y >= 0 && p.y <= last.y && p.z >= 0 && p.z <= last.z;
}

/// The nearest index in the box.
inline Point3 into_index_box(Point3 p, Vector3 last) {
  return {std::clamp(p.x, 0.0, last.x), std::clamp(p.y, 0.0, last.y), std::clamp(p.z, 0.0, last.z)};
}

/// The largest t up to 1 for which `from + t * way` is in the box. Requires that `from` is.
inline double last_fraction_in_index_box(Point3 from, Vector3 way, Vector3 last) {
  const auto along = [](double p, double step, double end) { return step > 0 ? (end - p) / step : step < 0 ? p / -step : 1; };
  return std::min({1.0, along(from.x, way.x, last.x), along(from.y, way.y, last.y), along(from.z, way.z, last.z)});
}

}  // namespace delref::detail
