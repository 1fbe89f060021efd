// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points strictly inside faces that polygons bound. A horizontal line is cut by the segments into intervals, each within one
// face; the middle of the widest suitable interval on a few lines between vertices is the point. This needs no convexity, and
// other polygons inside the face do not disturb it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include <delref/domain/pslg.hpp>

namespace delref {

/// The segments of a set of polygons, found by height.
class PolygonRows {
 public:
  using Index = std::uint32_t;

  /// An interval between two neighbouring segments on a horizontal line.
  struct Interval {
    double left, right;
    Index left_half_edge, right_half_edge;  ///< of the bounding segments, those that have the interval on their left
    std::size_t cover;                      ///< how many polygons it is inside of
  };

  /// `sides` are pairs of a segment and a polygon that it bounds, sorted; a pair may be there more than once.
  PolygonRows(const std::vector<Point2>& points, const std::vector<std::array<Pslg::Index, 2>>& segments,
              const std::vector<std::pair<Index, Index>>& sides, std::size_t polygon_count)
      : points_(points), segments_(segments), sides_(sides), inside_(polygon_count, false), first_side_(segments.size() + 1, 0) {
    for (const auto& [segment, polygon] : sides_) ++first_side_[segment + 1];
    std::partial_sum(first_side_.begin(), first_side_.end(), first_side_.begin());
    for (const Point2& p : points_) {
      low_ = std::min(low_, p.y);
      high_ = std::max(high_, p.y);
    }
    rows_.resize(1 + static_cast<std::size_t>(std::sqrt(static_cast<double>(segments.size()))));
    for (Index s = 0; s != segments.size(); ++s) {
      const auto [bottom, top] = std::minmax(points[segments[s][0]].y, points[segments[s][1]].y);
      for (std::size_t row = row_of(bottom); row <= row_of(top); ++row) rows_[row].push_back(s);
    }
  }

  /// The middle of the best interval for which `accept(interval, inside)` gives true, on up to 11 lines between the heights
  /// `ys`. `inside(polygon)` tells whether the interval is inside a polygon. Nothing when there is none of positive width.
  template <class Accept>
  std::optional<Point2> seed(std::vector<double> ys, Accept&& accept) {
    std::optional<Point2> best;
    double best_score = 0;
    for (const auto& [gap, y] : lines_between(ys)) {
      scan(y, [&](const Interval& interval, const auto& inside) {
        // The place of a crossing is the less certain the lower the segments are that make it.
        const double score = std::min(interval.right - interval.left, 1e6 * gap), middle = std::midpoint(interval.left, interval.right);
        if (!(score > best_score) || middle <= interval.left || middle >= interval.right || !accept(interval, inside)) return;
        best_score = score;
        best = {middle, y};
      });
    }
    return best;
  }

 private:
  struct Crossing {
    double x;
    Index segment;
  };

  std::size_t row_of(double y) const {
    const double part = (y - low_) / (high_ - low_);
    return part > 0 ? std::min(rows_.size() - 1, static_cast<std::size_t>(part * static_cast<double>(rows_.size()))) : 0;
  }
  /// The lines in the middle of the widest gaps and of those at the quarters of the range, with the width of the gap.
  static std::vector<std::pair<double, double>> lines_between(std::vector<double>& ys) {
    std::ranges::sort(ys);
    std::vector<std::pair<double, double>> gaps;
    for (std::size_t i = 1; i < ys.size(); ++i) {
      const double y = std::midpoint(ys[i - 1], ys[i]);
      if (y > ys[i - 1] && y < ys[i]) gaps.emplace_back(ys[i] - ys[i - 1], y);
    }
    std::vector<std::pair<double, double>> lines;
    for (const double quarter : {0.25, 0.5, 0.75}) {
      const auto at = std::ranges::lower_bound(gaps, std::lerp(ys.front(), ys.back(), quarter), {}, &std::pair<double, double>::second);
      if (at != gaps.end()) lines.push_back(*at);
    }
    const std::size_t widest = std::min<std::size_t>(8, gaps.size());
    std::ranges::partial_sort(gaps, gaps.begin() + static_cast<std::ptrdiff_t>(widest), std::ranges::greater{});
    lines.insert(lines.end(), gaps.begin(), gaps.begin() + static_cast<std::ptrdiff_t>(widest));
    return lines;
  }
  /// Calls `visit(interval, inside)` for the bounded intervals at a height, from left to right.
  template <class Visit>
  void scan(double y, Visit&& visit) {
    crossings_.clear();
    for (const Index s : rows_[row_of(y)]) {
      const Point2 a = points_[segments_[s][0]], b = points_[segments_[s][1]];
      if ((a.y <= y) == (b.y <= y)) continue;
      const double t = (y - a.y) / (b.y - a.y);
      crossings_.push_back({a.x + t * (b.x - a.x), s});
    }
    std::ranges::sort(crossings_, [](const Crossing& c, const Crossing& d) { return c.x != d.x ? c.x < d.x : c.segment < d.segment; });
    std::size_t cover = 0;
    const auto inside = [&](Index polygon) { return inside_[polygon]; };
    for (std::size_t i = 0; i < crossings_.size(); ++i) {
      for (std::size_t side = first_side_[crossings_[i].segment]; side != first_side_[crossings_[i].segment + 1]; ++side) {
        const Index polygon = sides_[side].second;
        inside_[polygon] = !inside_[polygon];
        cover = inside_[polygon] ? cover + 1 : cover - 1;
      }
      if (i + 1 == crossings_.size()) break;
      visit(Interval{crossings_[i].x, crossings_[i + 1].x, half_edge(crossings_[i].segment, false), half_edge(crossings_[i + 1].segment, true), cover},
            inside);
    }
    for (const Crossing& c : crossings_) {
      for (std::size_t side = first_side_[c.segment]; side != first_side_[c.segment + 1]; ++side) inside_[sides_[side].second] = false;
    }
  }
  Index half_edge(Index segment, bool upwards) const {
    const bool rises = points_[segments_[segment][0]].y < points_[segments_[segment][1]].y;
    return 2 * segment + (rises == upwards ? 0 : 1);
  }

  const std::vector<Point2>& points_;
  const std::vector<std::array<Pslg::Index, 2>>& segments_;
  const std::vector<std::pair<Index, Index>>& sides_;
  std::vector<bool> inside_;
  std::vector<std::size_t> first_side_;  ///< per segment, in sides_
  std::vector<std::vector<Index>> rows_;
  std::vector<Crossing> crossings_;
  double low_ = std::numeric_limits<double>::infinity(), high_ = -std::numeric_limits<double>::infinity();
};

}  // namespace delref
