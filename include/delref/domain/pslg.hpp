// SPDX-License-Identifier: GPL-3.0-or-later
//
// A planar straight line graph: what the planar mesher meshes. Plain data; `pslg_check.hpp` says what makes it valid.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <delref/core/point.hpp>

namespace delref {

/// A planar straight line graph: vertices, segments between them, seeds of holes and of labelled regions.
///
/// The domain is every bounded component of the plane minus the segments that no path joins to infinity, less the components
/// that hold a hole seed. Segments may be open, isolated, or touch the boundary at an end; vertices may be isolated.
struct Pslg {
  using Index = std::uint32_t;
  /// The seed of a region: a point strictly inside one component of the domain, which takes its label and area bound.
  struct Region {
    Point2 seed;
    int label = 0;
    /// Upper bound on the area of a triangle of this region; 0 for none.
    double max_area = 0;
  };

  std::vector<Point2> points;
  /// One per point, or empty (all 0).
  std::vector<int> point_markers;
  /// `attribute_count` numbers per point, row after row. Interpolated linearly to Steiner vertices on segments is not attempted:
  /// they are carried for input vertices only.
  std::size_t attribute_count = 0;
  std::vector<double> attributes;
  /// Pairs of indices into `points`.
  std::vector<std::array<Index, 2>> segments;
  /// One per segment, or empty (all 0).
  std::vector<int> segment_markers;
  std::vector<Point2> holes;
  std::vector<Region> regions;
  /// The number that the file gave its first vertex and segment (0 or 1): messages and files written count from it.
  Index first_index = 0;

  int point_marker(std::size_t i) const { return point_markers.empty() ? 0 : point_markers[i]; }
  int segment_marker(std::size_t i) const { return segment_markers.empty() ? 0 : segment_markers[i]; }
};

}  // namespace delref
