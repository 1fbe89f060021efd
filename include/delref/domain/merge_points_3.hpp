// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which points of space coincide, exactly or within a distance: as `merge_points.hpp` in the plane.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <tuple>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/core/point.hpp>
#include <delref/domain/bounding_box_3.hpp>
#include <delref/domain/pair_table.hpp>

namespace delref {

/// For each point the index of the first point with the same coordinates: its own, when there is none before it.
inline std::vector<std::uint32_t> coincident_points(std::span<const Point3> points, const Control& control) {
  std::vector<std::uint32_t> order(points.size()), representative(points.size());
  std::iota(order.begin(), order.end(), 0u);
  throw_if_stopped(control);
  std::ranges::sort(order, {}, [&](std::uint32_t i) { return std::tuple(points[i].x, points[i].y, points[i].z, i); });
  throw_if_stopped(control);
  for (std::size_t k = 0; k < order.size(); ++k)
    representative[order[k]] = k > 0 && points[order[k]] == points[order[k - 1]] ? representative[order[k - 1]] : order[k];
  return representative;
}

namespace merge_points_3 {

/// The cells that a ball around a point meets, at most two in each direction.
struct CellRange {
  std::array<std::array<std::uint64_t, 2>, 3> columns{};

  CellRange(Point3 p, const BoundingBox3& box, double radius, double width) {
    const std::array from{p.x - box.low.x, p.y - box.low.y, p.z - box.low.z};
    for (std::size_t k = 0; k < 3; ++k)
      columns[k] = {static_cast<std::uint64_t>(std::max(0.0, (from[k] - radius) / width)),
                    static_cast<std::uint64_t>((from[k] + radius) / width)};
  }
  /// Three numbers of 42 bits.
  static PairTable::Key key(std::uint64_t x, std::uint64_t y, std::uint64_t z) { return {x | (y << 42), (y >> 22) | (z << 20)}; }

  template <class Visit>
  void visit(const Visit& each) const {
    for (std::uint64_t x = columns[0][0]; x <= columns[0][1]; ++x)
      for (std::uint64_t y = columns[1][0]; y <= columns[1][1]; ++y)
        for (std::uint64_t z = columns[2][0]; z <= columns[2][1]; ++z) each(key(x, y, z));
  }
};

}  // namespace merge_points_3

/// For each point the index of its representative: the first earlier point no farther than `distance` that represents itself,
/// or the point itself. A point is never moved farther than `distance`: chains of close points do not collapse into one.
/// Requires finite points and a finite distance that is not negative.
inline std::vector<std::uint32_t> close_points(std::span<const Point3> points, double distance, const Control& control) {
  using merge_points_3::CellRange;
  if (distance == 0) return coincident_points(points, control);
  const BoundingBox3 box = bounding_box_3(points);
  // Cells are four search radii wide, so that a search meets eight at most; their numbers have at most 42 bits.
  const double radius = std::max(distance * (1 + 0x1p-40), box.extent() * 0x1p-40);
  const double width = 4 * radius;
  PairTable head(points.size());
  std::vector<std::uint32_t> next(points.size(), PairTable::none), representative(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (i % 8192 == 0) throw_if_stopped(control);
    std::uint32_t best = i;
    CellRange(points[i], box, radius, width).visit([&](PairTable::Key key) {
      for (std::uint32_t j = head.find(key); j != PairTable::none; j = next[j])
        if (j < best && squared_distance(points[i], points[j]) <= distance * distance) best = j;
    });
    representative[i] = best;
    if (best != i) continue;
    CellRange(points[i], box, 0, width).visit([&](PairTable::Key key) {
      std::uint32_t& first = head[key];
      next[i] = first;
      first = i;
    });
  }
  return representative;
}

}  // namespace delref
