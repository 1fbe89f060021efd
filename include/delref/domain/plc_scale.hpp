// SPDX-License-Identifier: GPL-3.0-or-later
//
// Scaling of piecewise linear complexes by powers of two, so that products of coordinates neither overflow nor vanish in any unit
// of length. As in the plane (`pslg_scale.hpp`) it is exact, or it is refused.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>

#include <delref/domain/describe.hpp>
#include <delref/domain/invalid_input.hpp>
#include <delref/domain/plc.hpp>

namespace delref {

/// The exponent k such that the largest absolute coordinate times 2^k lies in [1/2, 1); 0 when that coordinate is already between
/// 2^-60 and 2^60, or is 0. Requires finite coordinates.
inline int scale_exponent(std::span<const Point3> points) {
  double largest = 0;
  for (const Point3 p : points) largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  int exponent = 0;
  std::frexp(largest, &exponent);
  return largest == 0 || std::abs(exponent) <= 60 ? 0 : -exponent;
}

/// The point times 2^k. Exact unless a coordinate leaves the range of normal doubles.
inline Point3 scaled(Point3 p, int k) { return k == 0 ? p : Point3{std::ldexp(p.x, k), std::ldexp(p.y, k), std::ldexp(p.z, k)}; }

/// Scales vertices and seeds by 2^k and volume bounds by 8^k. Throws `InvalidInput` that names the vertices whose coordinates are
/// too small beside the largest one to be kept exactly (beyond a ratio of some 1e290). A seed is rounded instead.
inline void scale_plc(Plc& plc, int k) {
  if (k == 0) return;
  DefectList defects;
  for (std::size_t i = 0; i < plc.points.size(); ++i) {
    const Point3 before = plc.points[i];
    plc.points[i] = scaled(before, k);
    if (scaled(plc.points[i], -k) != before)
      defects.add("vertex " + std::to_string(i + plc.first_index) + " at " + describe(before) +
                  ": a coordinate is so small beside the largest coordinates of the input that doubles cannot hold both at "
                  "one scale; write it as 0, or give the input in one range of magnitudes");
  }
  if (!defects.empty()) throw InvalidInput(defects.take());
  for (Point3& hole : plc.holes) hole = scaled(hole, k);
  for (Plc::Facet& facet : plc.facets)
    for (Point3& hole : facet.holes) hole = scaled(hole, k);
  for (Plc::Region& region : plc.regions) {
    region.seed = scaled(region.seed, k);
    if (region.max_volume > 0)  // a bound must not become 0, which stands for none
      region.max_volume = std::max(std::ldexp(region.max_volume, 3 * k), std::numeric_limits<double>::denorm_min());
  }
}

}  // namespace delref
