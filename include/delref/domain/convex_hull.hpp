// SPDX-License-Identifier: GPL-3.0-or-later
//
// The domain of vertices alone: their convex hull, as segments. Andrew's monotone chain (1979) with exact predicates.
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

#include <delref/domain/exact_side.hpp>
#include <delref/domain/pslg.hpp>

namespace delref {

/// The graph with the edges of the convex hull of its points as segments, counterclockwise. A vertex that lies on such an edge does not divide it.
/// Unchanged when a coordinate is not finite, for `check_pslg` to refuse. O(n log n).
inline Pslg with_convex_hull(Pslg pslg) {
  const std::vector<Point2>& points = pslg.points;
  if (!std::ranges::all_of(points, [](Point2 p) { return is_finite(p); })) return pslg;
  std::vector<Pslg::Index> order(points.size());
  std::iota(order.begin(), order.end(), Pslg::Index{0});
  std::ranges::sort(order, {}, [&](Pslg::Index i) { return std::pair(points[i].x, points[i].y); });

  const auto add_chain = [&](auto from, auto to) {  // the half of the hull below the line from the first to the last
    std::vector<Pslg::Index> chain;
    for (auto i = from; i != to; ++i) {
      while (chain.size() > 1 && exact_side(points[chain[chain.size() - 2]], points[chain.back()], points[*i]) <= 0) chain.pop_back();
      chain.push_back(*i);
    }
    for (std::size_t k = 1; k < chain.size(); ++k) pslg.segments.push_back({chain[k - 1], chain[k]});
  };
  add_chain(order.begin(), order.end());
  add_chain(order.rbegin(), order.rend());
  if (!pslg.segment_markers.empty()) pslg.segment_markers.resize(pslg.segments.size());
  return pslg;
}

}  // namespace delref
