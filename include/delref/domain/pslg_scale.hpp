// SPDX-License-Identifier: GPL-3.0-or-later
//
// Scaling by powers of two, so that products of coordinates neither overflow nor vanish in any unit of length. It is exact, or
// it is refused: the combinatorics of the mesh do not depend on it.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <delref/domain/bounding_box.hpp>
#include <delref/domain/describe.hpp>
#include <delref/domain/invalid_input.hpp>
#include <delref/domain/pslg.hpp>

namespace delref {

/// The exponent k such that the largest absolute coordinate times 2^k lies in [1/2, 1); 0 when that coordinate is already between
/// 2^-60 and 2^60, or is 0. Requires finite coordinates.
inline int scale_exponent(const Pslg& pslg) {
  double largest = 0;
  for (const Point2 p : pslg.points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  int exponent = 0;
  std::frexp(largest, &exponent);
  return largest == 0 || std::abs(exponent) <= 60 ? 0 : -exponent;
}

/// The point times 2^k. Exact unless a coordinate leaves the range of normal doubles.
inline Point2 scaled(Point2 p, int k) { return {std::ldexp(p.x, k), std::ldexp(p.y, k)}; }

/// The graph with vertices and seeds times 2^k and area bounds times 4^k. Throws `InvalidInput` that names the vertices whose
/// coordinates are too small beside the largest one to be kept exactly (beyond a ratio of some 1e290). A seed is rounded instead.
inline Pslg scaled(Pslg pslg, int k) {
  if (k == 0) return pslg;
  DefectList defects;
  for (std::size_t i = 0; i < pslg.points.size(); ++i) {
    const Point2 before = pslg.points[i];
    const Point2 after = scaled(before, k);
    if (!is_finite(after) || scaled(after, -k) != before)
      defects.add("vertex " + std::to_string(i + pslg.first_index) + " at " + describe(before) +
                      ": a coordinate is so small beside the largest coordinates of the input that doubles cannot hold both at "
                      "one scale; write it as 0, or give the input in one range of magnitudes",
                  {before});
    pslg.points[i] = after;
  }
  if (!defects.empty()) throw InvalidInput(defects.take());
  for (Point2& hole : pslg.holes) hole = scaled(hole, k);
  for (Pslg::Region& region : pslg.regions) {
    region.seed = scaled(region.seed, k);
    if (region.max_area > 0)  // a bound must not become 0, which stands for none
      region.max_area = std::max(std::ldexp(region.max_area, 2 * k), std::numeric_limits<double>::denorm_min());
  }
  return pslg;
}

}  // namespace delref
