// SPDX-License-Identifier: GPL-3.0-or-later
//
// What comes out of the planar mesher: an indexed triangle mesh with the labels of the input. Plain data, which every writer
// takes and every reader gives.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <delref/core/carrier.hpp>
#include <delref/core/point.hpp>

namespace delref {

/// An indexed triangle mesh of a planar straight line graph.
///
/// Vertices of the input come first, in the order of the input (those that no triangle uses are left out), then the Steiner
/// vertices in the order of their insertion. Vectors named "per ..." have exactly that length, or are empty when a file that the
/// mesh was read from did not carry them.
struct PlanarMesh {
  using Index = std::uint32_t;

  std::vector<Point2> points;
  std::vector<int> point_markers;         ///< per point; a Steiner vertex on a segment has that segment's marker, one inside 0
  std::vector<Carrier> carriers;          ///< per point
  std::vector<LevelIndex> provenance;     ///< per point: index into `level_names`, or `input_level`
  std::vector<std::string> level_names;   ///< the mesher's levels, highest priority first
  std::vector<std::array<Index, 3>> triangles;  ///< counterclockwise
  std::vector<int> regions;                     ///< per triangle: the region's label
  std::vector<std::array<Index, 2>> edges;      ///< the subsegments: every edge that lies on an input segment
  std::vector<int> edge_markers;                ///< per edge: the segment's marker
  std::vector<Index> edge_segments;             ///< per edge: the index of the input segment
};

}  // namespace delref
