// SPDX-License-Identifier: GPL-3.0-or-later
//
// What comes out of the meshers of space: an indexed tetrahedral mesh with the labels of the input. Plain data, which every writer
// takes and every reader gives.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <delref/core/carrier.hpp>
#include <delref/core/point.hpp>

namespace delref {

/// An indexed tetrahedral mesh with the triangles and edges that lie on input facets and segments.
///
/// Vertices of the input come first, in the order of the input (those that nothing uses are left out), then the Steiner vertices in
/// the order of their insertion. Vectors named "per ..." have exactly that length, or are empty when a file that the mesh was read
/// from did not carry them.
struct TetrahedralMesh {
  using Index = std::uint32_t;

  std::vector<Point3> points;
  std::vector<int> point_markers;        ///< per point; a Steiner vertex has the marker of the segment or facet it lies on, one inside 0
  std::vector<Carrier> carriers;         ///< per point: what it lies on, by the index in the polyhedral domain
  std::vector<LevelIndex> provenance;    ///< per point: index into `level_names`, or `input_level`
  std::vector<std::string> level_names;  ///< the mesher's levels, highest priority first
  std::vector<std::array<Index, 4>> tetrahedra;  ///< positively oriented: the fourth sees the first three counterclockwise
  std::vector<int> regions;                      ///< per tetrahedron: the region's label
  std::vector<std::array<Index, 3>> triangles;   ///< every triangle that lies on an input facet, once
  std::vector<int> triangle_markers;             ///< per triangle: the facet's marker
  std::vector<Index> triangle_facets;            ///< per triangle: the index of the input facet (the first of those that were joined)
  std::vector<std::array<Index, 2>> edges;       ///< every edge that lies on an input segment
  std::vector<int> edge_markers;                 ///< per edge: the segment's marker
  std::vector<Index> edge_segments;              ///< per edge: the number of the segment in the polyhedral domain
};

}  // namespace delref
