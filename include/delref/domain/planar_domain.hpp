// SPDX-License-Identifier: GPL-3.0-or-later
//
// The domain of a planar run as the levels see it: the input segments, cut where an input vertex lies on them, with the sharp
// corners at their ends, and the regions. Made by domain/build_planar_domain.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <delref/core/carrier.hpp>
#include <delref/core/point.hpp>
#include <delref/domain/pslg.hpp>

namespace delref {

/// The input elements of a planar run. `Carrier{1, i}` names `segments[i]`, `Carrier{0, i}` the input vertex i.
struct PlanarDomain {
  struct Segment {
    std::array<Pslg::Index, 2> ends{};   ///< input vertices
    Pslg::Index original = 0;            ///< the index of the PSLG's segment that it is a part of
    std::array<bool, 2> sharp{};         ///< per end: another segment meets it there under 60 degrees, with the domain between
    bool bounds_domain = false;          ///< one of its sides is outside the domain
  };

  /// The checked graph, its coordinates times 2^scale.
  Pslg pslg;
  int scale = 0;
  std::vector<Segment> segments;
  /// By the region number of a face; number 0 is what no seed names.
  std::vector<Pslg::Region> regions;

  Point2 point(std::size_t segment, std::size_t end) const { return pslg.points[segments[segment].ends[end]]; }

  /// Whether two Steiner vertices on segments are at the same distance from a sharp corner where their segments meet: the edge
  /// between them is then as short as the input angle makes it, and no refinement near it can help (Shewchuk, Delaunay
  /// Refinement Algorithms for Triangular Mesh Generation, 2002, section 8; Miller, Pav, Walkington 2003). Distances count as
  /// the same up to one part in a thousand.
  bool is_seditious(Carrier a, Point2 p, Carrier b, Point2 q) const {
    if (a.dimension != 1 || b.dimension != 1 || a.index == b.index) return false;
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t j = 0; j < 2; ++j) {
        const Segment &s = segments[a.index], &t = segments[b.index];
        if (s.ends[i] != t.ends[j] || !s.sharp[i] || !t.sharp[j]) continue;
        const Point2 corner = pslg.points[s.ends[i]];
        const double r = squared_distance(corner, p), r2 = squared_distance(corner, q);
        const double d = dot(p - corner, q - corner);
        if (r < 1.002 * r2 && r2 < 1.002 * r && d > 0 && 4 * d * d > r * r2) return true;
      }
    return false;
  }
};

}  // namespace delref
