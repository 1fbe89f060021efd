// SPDX-License-Identifier: GPL-3.0-or-later
//
// A piecewise linear complex: what the polyhedral mesher meshes (Miller, Talmor, Teng, Walkington, Wang 1996). Plain data, as files
// give it; `check_plc.hpp` says what makes it valid and brings it into the form that is meshed (`polyhedral_domain.hpp`).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <delref/core/point.hpp>

namespace delref {

/// A piecewise linear complex: vertices, segments, polygonal facets, seeds of cavities and of labelled regions.
///
/// The domain is every bounded component of space minus the facets that no path joins to infinity, less the components that hold a
/// hole seed. Facets may be shared by two regions, hang into the domain or lie free in it; segments and vertices may be isolated.
struct Plc {
  using Index = std::uint32_t;

  /// A facet: a planar straight line graph in one plane. Its part of that plane is what the polygons enclose, less the components
  /// that hold a point of `holes`.
  struct Facet {
    /// Indices into `points`: a closed polygon of three or more, or a segment in the facet (2), or a vertex in it (1).
    std::vector<std::vector<Index>> polygons;
    std::vector<Point3> holes;
    int marker = 0;
  };
  /// The seed of a region: a point strictly inside one component of the domain, which takes its label and volume bound.
  struct Region {
    Point3 seed;
    int label = 0;
    /// Upper bound on the volume of a tetrahedron of this region; 0 for none.
    double max_volume = 0;
  };

  std::vector<Point3> points;
  /// One per point, or empty (all 0).
  std::vector<int> point_markers;
  /// `attribute_count` numbers per point, row after row; carried for input vertices only.
  std::size_t attribute_count = 0;
  std::vector<double> attributes;
  /// Segments that are no side of a facet, or that give one a marker: pairs of indices into `points`.
  std::vector<std::array<Index, 2>> segments;
  /// One per segment, or empty (all 0).
  std::vector<int> segment_markers;
  std::vector<Facet> facets;
  std::vector<Point3> holes;
  std::vector<Region> regions;
  /// The number that the file gave its first vertex and facet (0 or 1): messages and files written count from it.
  Index first_index = 0;

  int point_marker(std::size_t i) const { return point_markers.empty() ? 0 : point_markers[i]; }
  int segment_marker(std::size_t i) const { return segment_markers.empty() ? 0 : segment_markers[i]; }
};

}  // namespace delref
