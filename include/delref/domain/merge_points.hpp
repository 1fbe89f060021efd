// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which points coincide, exactly or within a distance. Points are taken in their order; one that lies close enough to an earlier
// point that was kept is represented by it. A grid of the size of the distance makes it linear.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/core/point.hpp>
#include <delref/domain/bounding_box.hpp>
#include <delref/domain/pair_table.hpp>

namespace delref {

/// For each point the index of the first point with the same coordinates: its own, when there is none before it.
inline std::vector<std::uint32_t> coincident_points(std::span<const Point2> points, const Control& control) {
  std::vector<std::uint32_t> representative(points.size());
  PairTable first(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (i % 8192 == 0) throw_if_stopped(control);
    std::uint32_t& found = first[PairTable::key(points[i])];
    if (found == PairTable::none) found = i;
    representative[i] = found;
  }
  return representative;
}

/// For each point the index of its representative: the first earlier point no farther than `distance` that represents itself,
/// or the point itself. A point is never moved farther than `distance`: chains of close points do not collapse into one.
/// Requires finite points and a finite distance that is not negative.
inline std::vector<std::uint32_t> close_points(std::span<const Point2> points, double distance, const Control& control) {
  if (distance == 0) return coincident_points(points, control);
  const BoundingBox2 box = bounding_box(points);
  // Cells are four search radii wide, so that a search meets four cells at most. The radius allows for the rounding of x - low.x.
  const double radius = distance + box.extent() * 0x1p-51;
  const double width = 4 * radius;
  PairTable head(points.size());
  std::vector<std::uint32_t> next(points.size(), PairTable::none);
  std::vector<std::uint32_t> representative(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (i % 8192 == 0) throw_if_stopped(control);
    const double x = points[i].x - box.low.x, y = points[i].y - box.low.y;
    const std::array columns{std::floor((x - radius) / width), std::floor((x + radius) / width)};
    const std::array rows{std::floor((y - radius) / width), std::floor((y + radius) / width)};
    std::uint32_t best = i;
    for (std::size_t c = 0; c < (columns[0] == columns[1] ? 1u : 2u); ++c)
      for (std::size_t r = 0; r < (rows[0] == rows[1] ? 1u : 2u); ++r)
        for (std::uint32_t j = head.find(PairTable::key(columns[c], rows[r])); j != PairTable::none; j = next[j])
          if (j < best && std::hypot(points[i].x - points[j].x, points[i].y - points[j].y) <= distance) best = j;
    representative[i] = best;
    if (best != i) continue;
    std::uint32_t& first = head[PairTable::key(std::floor(x / width), std::floor(y / width))];
    next[i] = first;
    first = i;
  }
  return representative;
}

}  // namespace delref
