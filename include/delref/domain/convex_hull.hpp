// SPDX-License-Identifier: GPL-3.0-or-later
//
// The domain of vertices alone: their convex hull, as segments. Andrew's monotone chain (1979) with exact predicates, over the vertices
// that are not strictly inside a quadrangle of extreme ones (Akl and Toussaint 1978): of millions few as a rule.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/domain/exact_side.hpp>
#include <delref/domain/pslg.hpp>

namespace delref {

namespace detail {

/// The indices of the points that may be on the convex hull: all but those strictly inside a quadrangle of four of the points.
inline std::vector<Pslg::Index> hull_candidates(const std::vector<Point2>& points, StopCheck& check) {
  std::array<Point2, 4> corner{};  // counterclockwise
  for (std::size_t k = 0; k < 4; ++k) {
    const double u = k == 1 || k == 2 ? 1 : -1, v = k >= 2 ? 1 : -1;
    corner[k] = *std::ranges::max_element(points, {}, [=](Point2 p) { return u * p.x + v * p.y; });
  }
  std::vector<Pslg::Index> candidates;
  for (std::size_t i = 0; i < points.size(); ++i) {
    check();
    bool inside = true;  // to the left of every side, so that the quadrangle winds around it, whatever rounding made of it
    for (std::size_t k = 0; k < 4 && inside; ++k) inside = exact_side(corner[k], corner[(k + 1) % 4], points[i]) > 0;
    if (!inside) candidates.push_back(static_cast<Pslg::Index>(i));
  }
  return candidates;
}

}  // namespace detail

/// The graph with the edges of the convex hull of its points as segments, counterclockwise. A vertex that lies on such an edge does
/// not divide it. Unchanged when there is no point, or when a coordinate is not finite, for `check_pslg` to refuse. O(n log n). Throws
/// `Interrupted`.
inline Pslg with_convex_hull(Pslg pslg, const Control& control = Control{}) {
  const std::vector<Point2>& points = pslg.points;
  if (points.empty() || !std::ranges::all_of(points, [](Point2 p) { return is_finite(p); })) return pslg;
  StopCheck check(control);
  std::vector<Pslg::Index> order = detail::hull_candidates(points, check);
  std::ranges::sort(order, [&](Pslg::Index i, Pslg::Index j) {
    check();
    return std::pair(points[i].x, points[i].y) < std::pair(points[j].x, points[j].y);
  });

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
