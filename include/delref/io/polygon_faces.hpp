// SPDX-License-Identifier: GPL-3.0-or-later
//
// The faces of the plane that a set of segments bounds, found by walking along the segments with the face on the left. Segments
// must meet in shared vertices; where they cross unseen, the walk passes the crossing, and nothing worse happens.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <delref/domain/pslg.hpp>

namespace delref {

/// The walks around faces. Half-edge 2 s goes along segment s, half-edge 2 s + 1 back.
class PolygonFaces {
 public:
  using Index = std::uint32_t;

  /// Requires valid indices, no segment of length zero and no segment twice. O(n log n).
  PolygonFaces(const std::vector<Point2>& points, const std::vector<std::array<Pslg::Index, 2>>& segments)
      : points_(points), segments_(segments), walk_of_(2 * segments.size(), none) {
    const std::vector<Index> next = successors();
    for (Index h = 0; h != walk_of_.size(); ++h) {
      if (walk_of_[h] != none) continue;
      const auto walk = static_cast<Index>(walks_.size());
      walks_.emplace_back();
      for (Index at = h; walk_of_[at] == none; at = next[at]) {
        walk_of_[at] = walk;
        walks_.back().push_back(at);
      }
    }
  }

  /// The half-edges of every walk, each with the same face on its left.
  const std::vector<std::vector<Index>>& walks() const { return walks_; }
  /// The walk that a half-edge is part of.
  Index walk_of(Index half_edge) const { return walk_of_[half_edge]; }
  Pslg::Index origin(Index half_edge) const { return segments_[half_edge / 2][half_edge % 2]; }
  Pslg::Index target(Index half_edge) const { return segments_[half_edge / 2][1 - half_edge % 2]; }
  /// Twice the area inside a walk: positive when it is the outer boundary of a bounded face.
  double doubled_area(const std::vector<Index>& walk) const {
    const Point2 base = points_[origin(walk.front())];
    double sum = 0;
    for (const Index h : walk) sum += cross(points_[origin(h)] - base, points_[target(h)] - base);
    return sum;
  }

 private:
  static constexpr Index none = static_cast<Index>(-1);

  /// After a half-edge comes the one that leaves its target next in clockwise order from where it came.
  std::vector<Index> successors() const {
    std::vector<Index> leaving(walk_of_.size());
    for (Index h = 0; h != leaving.size(); ++h) leaving[h] = h;
    const auto direction = [&](Index h) { return points_[target(h)] - points_[origin(h)]; };
    const auto lower = [](Vector2 v) { return v.y < 0 || (v.y == 0 && v.x < 0); };
    std::ranges::sort(leaving, [&](Index g, Index h) {
      if (origin(g) != origin(h)) return origin(g) < origin(h);
      const Vector2 a = direction(g), b = direction(h);
      if (lower(a) != lower(b)) return lower(b);
      const double left = a.x * b.y, right = a.y * b.x;
      return left != right ? left > right : g < h;
    });
    std::vector<Index> next(leaving.size());
    for (std::size_t begin = 0, end = 0; begin != leaving.size(); begin = end) {
      while (end != leaving.size() && origin(leaving[end]) == origin(leaving[begin])) ++end;
      for (std::size_t i = begin; i != end; ++i) next[leaving[i] ^ 1U] = leaving[i == begin ? end - 1 : i - 1];
    }
    return next;
  }

  const std::vector<Point2>& points_;
  const std::vector<std::array<Pslg::Index, 2>>& segments_;
  std::vector<Index> walk_of_;
  std::vector<std::vector<Index>> walks_;
};

}  // namespace delref
