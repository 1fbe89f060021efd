// SPDX-License-Identifier: GPL-3.0-or-later
//
// Snap rounding (Hobby 1999, "Practical segment intersection with finite precision output"; Guibas and Marimont 1998): every
// vertex and point of intersection moves to the centre of its pixel on a grid, and every segment through such a pixel is bent
// through that centre. Nothing crosses afterwards, proven, however close segments lie; the price is that vertices move.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <CGAL/Exact_rational.h>

#include <delref/core/budget.hpp>
#include <delref/domain/pair_table.hpp>
#include <delref/domain/pslg_crossings.hpp>
#include <delref/domain/pslg_merge.hpp>
#include <delref/domain/segment_contact.hpp>
#include <delref/domain/split_pieces.hpp>

namespace delref {

/// A grid of square pixels, each with its lower and left edges, and centres at multiples of `spacing`.
class SnapGrid {
 public:
  /// The finest grid whose pixel centres and corners are doubles, with a power of two for spacing: 2^-49 or less of the largest
  /// absolute coordinate.
  explicit SnapGrid(const std::vector<Point2>& points) {
    double largest = 0;
    for (const Point2 p : points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
    std::frexp(largest, &exponent_);
    exponent_ -= 50;
  }

  double spacing() const { return std::ldexp(1.0, exponent_); }
  /// The centre of the pixel of a point.
  Point2 centre(Point2 p) const { return {rounded(p.x), rounded(p.y)}; }
  /// The centre of the pixel in which two segments cross.
  Point2 centre_of_crossing(Ends2 a, Ends2 b) const {
    const auto [x, y] = exact_crossing(a, b);
    return {rounded(x), rounded(y)};
  }

  /// True when the segment meets the pixel. Exact.
  bool meets(Ends2 s, Point2 centre) const {
    const double half = std::ldexp(1.0, exponent_ - 1);
    const Point2 low{centre.x - half, centre.y - half}, high{centre.x + half, centre.y + half};
    if (std::max(s[0].x, s[1].x) < low.x || std::min(s[0].x, s[1].x) >= high.x) return false;
    if (std::max(s[0].y, s[1].y) < low.y || std::min(s[0].y, s[1].y) >= high.y) return false;
    const int first = exact_side(s[0], s[1], low);
    if (first == 0) return true;  // the only corner that belongs to the pixel
    // The line cuts the inside when corners lie on both sides.
    return exact_side(s[0], s[1], high) == -first || exact_side(s[0], s[1], {low.x, high.y}) == -first ||
           exact_side(s[0], s[1], {high.x, low.y}) == -first;
  }

 private:
  double rounded(double coordinate) const {
    const double scaled = std::ldexp(coordinate, -exponent_);
    const double below = std::floor(scaled);
    return std::ldexp(scaled - below >= 0.5 ? below + 1 : below, exponent_);
  }
  double rounded(const CGAL::Exact_rational& coordinate) const {
    using Exact = CGAL::Exact_rational;
    const Exact spacing_exact(spacing());
    const Exact shifted = coordinate / spacing_exact + Exact(0.5);
    double below = std::floor(CGAL::to_double(shifted));
    while (Exact(below) > shifted) --below;
    while (Exact(below + 1) <= shifted) ++below;
    return std::ldexp(below, exponent_);
  }

  int exponent_ = 0;
};

/// What snap rounding did beside.
struct SnapRounded {
  CheckedPslg checked;
  double spacing = 0;
  std::size_t moved = 0;   ///< input vertices that moved
  std::size_t merged = 0;  ///< input vertices that became one with an earlier one
  std::size_t shared = 0;  ///< see `SplitPieces`
  std::size_t conflicts = 0;
};

namespace snap_rounding {

/// Finds the segments through each vertex's pixel. `points` are the centres.
inline std::vector<Cut> find_cuts(const Pslg& pslg, const std::vector<Point2>& points, const SnapGrid& grid,
                                  const Control& control) {
  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 2, Pslg::Index>;
  const double half = grid.spacing() / 2;
  const auto box = [](Point2 a, Point2 b, double margin, Pslg::Index info) {
    std::array low{std::min(a.x, b.x) - margin, std::min(a.y, b.y) - margin};
    std::array high{std::max(a.x, b.x) + margin, std::max(a.y, b.y) + margin};
    return Box(low.data(), high.data(), info);
  };
  std::vector<Box> pixels, segments;
  for (Pslg::Index v = 0; v < points.size(); ++v) pixels.push_back(box(points[v], points[v], half, v));
  for (Pslg::Index s = 0; s < pslg.segments.size(); ++s) {
    const auto [a, b] = pslg_crossings::ends(pslg, s);
    segments.push_back(box(a, b, 0, s));
  }
  std::vector<Cut> cuts;
  std::size_t steps = 0;
  CGAL::box_intersection_d(segments.begin(), segments.end(), pixels.begin(), pixels.end(),
                           [&](const Box& segment, const Box& pixel) {
                             if (++steps % 1024 == 0) throw_if_stopped(control);
                             if (grid.meets(pslg_crossings::ends(pslg, segment.info()), points[pixel.info()]))
                               cuts.push_back({segment.info(), pixel.info()});
                           });
  return cuts;
}

/// Moves vertices to the centres of their pixels, merges those of one pixel, and adds vertices for crossings.
inline void snap_points(SnapRounded& result, const Pslg& input, const SnapGrid& grid, const std::vector<SegmentPair>& pairs,
                        const Control& control) {
  std::vector<std::uint32_t> representative(input.points.size());
  PairTable vertex_at(input.points.size() + pairs.size());
  Pslg& pslg = result.checked.pslg;
  for (std::uint32_t v = 0; v < input.points.size(); ++v) {
    pslg.points[v] = grid.centre(input.points[v]);
    if (pslg.points[v] != input.points[v]) ++result.moved;
    std::uint32_t& first = vertex_at[PairTable::key(pslg.points[v])];
    if (first == PairTable::none)
      first = v;
    else
      ++result.merged;
    representative[v] = first;
  }
  pslg_merge::drop_points(result.checked, representative);
  std::size_t steps = 0;
  for (const SegmentPair& pair : pairs) {
    if (++steps % 256 == 0) throw_if_stopped(control);
    if (pair.contact != SegmentContact::crossing) continue;
    const Point2 centre =
        grid.centre_of_crossing(pslg_crossings::ends(input, pair.first), pslg_crossings::ends(input, pair.second));
    std::uint32_t& vertex = vertex_at[PairTable::key(centre)];
    if (vertex != PairTable::none) continue;
    vertex = static_cast<std::uint32_t>(pslg.points.size());
    result.checked.add_made_point(centre, pair.first, pair.second);
  }
}

}  // namespace snap_rounding

/// The graph, snap rounded. `pairs` are all pairs of its segments that cross. Requires what `check_pslg` gives. Vertices move by
/// at most half the grid's spacing in each coordinate, segments by that distance; those that end up in one pixel become one
/// vertex, and pieces with the same ends one piece. O(pairs + boxes of segments that meet pixels). Throws `Interrupted`.
inline SnapRounded snap_rounded(const CheckedPslg& checked, const std::vector<SegmentPair>& pairs, const Control& control) {
  const Pslg& input = checked.pslg;
  const SnapGrid grid(input.points);
  SnapRounded result{.checked = checked, .spacing = grid.spacing()};
  snap_rounding::snap_points(result, input, grid, pairs, control);
  std::vector<Cut> cuts = snap_rounding::find_cuts(input, result.checked.pslg.points, grid, control);
  sort_cuts(input, result.checked.pslg.points, cuts);
  SplitPieces pieces(cuts.size(), !input.segment_markers.empty());
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    const Pslg::Index s = cuts[i].segment;
    if (cuts[i - 1].segment == s)
      pieces.add(cuts[i - 1].vertex, cuts[i].vertex, input.segment_marker(s), checked.original_segment[s]);
  }
  pieces.move_into(result.checked);
  result.shared = pieces.shared();
  result.conflicts = pieces.conflicts();
  return result;
}

}  // namespace delref
