// SPDX-License-Identifier: GPL-3.0-or-later
//
// The domain of a polyhedral run as the levels see it: a piecewise linear complex that was checked (`check_plc.hpp`). Every segment
// stands once, every facet has a frame of its own in its plane and is triangulated there, and the angles that limit what
// refinement can do are known.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <delref/core/point.hpp>
#include <delref/domain/plc.hpp>

namespace delref {

/// An orthonormal frame of a plane.
struct PlaneFrame {
  Point3 origin;
  Vector3 u{1, 0, 0}, v{0, 1, 0}, normal{0, 0, 1};

  Point2 project(Point3 p) const {
    const Vector3 d = p - origin;
    return {dot(d, u), dot(d, v)};
  }
  Point3 lift(Point2 p) const { return origin + (p.x * u + p.y * v); }
  double height(Point3 p) const { return dot(p - origin, normal); }
};

/// The input elements of a polyhedral run. `Carrier{0, i}` names `points[i]`, `Carrier{1, i}` `segments[i]`, `Carrier{2, i}` `facets[i]`.
struct PolyhedralDomain {
  using Index = Plc::Index;

  /// A segment between two input vertices, with no input vertex inside.
  struct Segment {
    std::array<Index, 2> ends{};
    int marker = 0;
  };

  /// A facet: a connected or unconnected part of a plane, bounded by segments.
  struct Facet {
    PlaneFrame frame;
    int marker = 0;
    /// The facet of the PLC; the first of them when several coplanar ones were joined.
    Index original = 0;
    /// All segments in the facet, those of slits included.
    std::vector<Index> segments;
    /// The constrained Delaunay triangulation of the facet by input vertices, counterclockwise in `frame`; holes are left out.
    std::vector<std::array<Index, 3>> triangles;
    /// No facet meets this one at a common segment under 90 degrees: refinement may demand empty diametral balls of its triangles.
    bool gabriel = true;
  };

  /// Two input elements that meet under less than 90 degrees.
  struct SmallAngle {
    enum class Kind : unsigned char { segments, segment_and_facet, facets };
    Kind kind = Kind::segments;
    std::array<Index, 2> elements{};  ///< segments or facets, in the order of `kind`
    double degrees = 0;
    Point3 place;  ///< the common vertex, or the middle of the common segment
  };

  std::vector<Point3> points;
  std::vector<int> point_markers;       ///< one per point
  std::vector<Index> original_point;    ///< per point: its index in the PLC
  std::vector<Segment> segments;
  std::vector<Facet> facets;
  std::vector<Point3> holes;
  std::vector<Plc::Region> regions;
  /// Angles between input elements under 90 degrees (less a slack of 1e-6), the smallest first, taken after coplanar neighbours are joined.
  std::vector<SmallAngle> small_angles;
  /// For people: merged vertices, joined facets, dropped duplicates.
  std::vector<std::string> notes;
  Index first_index = 0;
  /// Input vertices on no segment and no facet.
  std::vector<Index> isolated;
  /// All coordinates here are those of the input times 2^scale, which is exact, and volume bounds times 8^scale; 0 unless the
  /// coordinates of the input are beyond 2^60 or all below 2^-60.
  int scale = 0;
};

}  // namespace delref
