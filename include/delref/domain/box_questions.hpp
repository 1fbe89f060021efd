// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the domains given by functions ask about their box: whether it is one, what is in it, where a segment leaves it, and
// points spread over its faces.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <delref/core/point.hpp>
#include <delref/domain/bounding_box_3.hpp>
#include <delref/domain/describe.hpp>
#include <delref/domain/invalid_input.hpp>

namespace delref {

/// True in the box and on its faces.
inline bool contains(const BoundingBox3& box, Point3 p) {
  return p.x >= box.low.x && p.x <= box.high.x && p.y >= box.low.y && p.y <= box.high.y && p.z >= box.low.z && p.z <= box.high.z;
}

/// Throws `InvalidInput` unless the box has finite corners and three positive sides.
inline void require_box(const BoundingBox3& box) {
  const bool good =
      is_finite(box.low) && is_finite(box.high) && box.low.x < box.high.x && box.low.y < box.high.y && box.low.z < box.high.z;
  if (!good || !std::isfinite(box.diagonal()))
    throw InvalidInput("the bounds from " + describe(box.low) + " to " + describe(box.high) +
                       " are no box: the low corner must be less than the high one in x, y and z, and all numbers finite");
}

/// Throws `InvalidInput` unless the distance is finite and not negative.
inline void require_sampling_distance(double distance) {
  if (!(distance >= 0) || !std::isfinite(distance))
    throw InvalidInput("the sampling distance " + describe(distance) + " is no positive length (0 chooses one)");
}

/// The last point of the box on the way from `a`, which is in it, to `b`, which is not.
inline Point3 last_point_in(const BoundingBox3& box, Point3 a, Point3 b) {
  double t = 1;
  const auto clip = [&t](double from, double to, double low, double high) {
    if (to > high) t = std::min(t, (high - from) / (to - from));
    if (to < low) t = std::min(t, (low - from) / (to - from));
  };
  clip(a.x, b.x, box.low.x, box.high.x);
  clip(a.y, b.y, box.low.y, box.high.y);
  clip(a.z, b.z, box.low.z, box.high.z);
  const Point3 p = a + t * (b - a);
  return {std::clamp(p.x, box.low.x, box.high.x), std::clamp(p.y, box.low.y, box.high.y), std::clamp(p.z, box.low.z, box.high.z)};
}

/// A grid of `count` + 1 times `count` + 1 points on each of the six faces.
inline std::vector<Point3> box_face_samples(const BoundingBox3& box, int count) {
  const auto at = [count](double low, double high, int i) { return i == count ? high : low + i * ((high - low) / count); };
  std::vector<Point3> points;
  for (int i = 0; i <= count; ++i)
    for (int j = 0; j <= count; ++j) {
      const double xi = at(box.low.x, box.high.x, i), yi = at(box.low.y, box.high.y, i);
      const double yj = at(box.low.y, box.high.y, j), zj = at(box.low.z, box.high.z, j);
      points.insert(points.end(), {{xi, yj, box.low.z},
                                   {xi, yj, box.high.z},
                                   {xi, box.low.y, zj},
                                   {xi, box.high.y, zj},
                                   {box.low.x, yi, zj},
                                   {box.high.x, yi, zj}});
    }
  return points;
}

}  // namespace delref
