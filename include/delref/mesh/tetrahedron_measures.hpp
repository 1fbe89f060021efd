// SPDX-License-Identifier: GPL-3.0-or-later
//
// The measures of one tetrahedron that quality tables and verification need. Angles are kept as cosines: an arc cosine for each
// of the six would cost more than all the rest.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <delref/core/point.hpp>
#include <delref/mesh/triangle_measures.hpp>

namespace delref {

/// The angle between two vectors in degrees, from 0 to 180; good to about 1e-14 degrees, tiny angles too. 0 when one is zero.
inline double angle_degrees(Vector3 a, Vector3 b) {
  return std::atan2(std::sqrt(squared_length(cross(a, b))), dot(a, b)) * degrees_per_radian;
}

/// Edge lengths, volume, circumradius and dihedral angles of a tetrahedron. Coordinates should be near 1 (`PowerOfTwoScaling`).
class TetrahedronMeasures {
 public:
  /// The corners at the ends of each edge.
  static constexpr std::array<std::array<std::size_t, 2>, 6> edge_corners{{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

  TetrahedronMeasures(Point3 p, Point3 q, Point3 r, Point3 s) : origin_(p), a_(q - p), b_(r - p), c_(s - p) {
    squared_edge_ = {squared_length(a_),      squared_length(b_),      squared_length(c_),
                     squared_length(b_ - a_), squared_length(c_ - a_), squared_length(c_ - b_)};
    normal_[1] = cross(c_, b_);
    normal_[2] = cross(a_, c_);
    normal_[3] = cross(b_, a_);
    normal_[0] = cross(b_ - a_, c_ - a_);
    six_volumes_ = -dot(a_, normal_[1]);
  }

  /// Signed: positive when the fourth corner sees the first three counterclockwise.
  double volume() const { return six_volumes_ / 6; }
  double squared_shortest_edge() const { return std::ranges::min(squared_edge_); }
  double squared_longest_edge() const { return std::ranges::max(squared_edge_); }
  double longest_edge() const { return std::sqrt(squared_longest_edge()); }
  double squared_edge(std::size_t i) const { return squared_edge_[i]; }
  Point3 barycentre() const { return origin_ + 0.25 * (a_ + b_ + c_); }

  /// Infinite for a flat tetrahedron.
  double squared_circumradius() const {
    const Vector3 n = squared_edge_[0] * normal_[1] + squared_edge_[1] * normal_[2] + squared_edge_[2] * normal_[3];
    return six_volumes_ == 0 ? std::numeric_limits<double>::infinity() : 0.25 * squared_length(n) / (six_volumes_ * six_volumes_);
  }
  /// The square of the circumradius over the shortest edge; 0.375 for a regular tetrahedron, infinite for a flat one.
  double squared_radius_edge() const {
    const double shortest = squared_shortest_edge();
    return shortest == 0 ? std::numeric_limits<double>::infinity() : squared_circumradius() / shortest;
  }

  /// The cosines of the dihedral angles at the edges of `edge_corners`; 1 where a face has no area. Good to about 1e-15.
  std::array<double, 6> dihedral_cosines() const {
    std::array<double, 4> inverse_length{};
    for (std::size_t i = 0; i < 4; ++i) {
      const double squared = squared_length(normal_[i]);
      inverse_length[i] = squared > 0 ? 1 / std::sqrt(squared) : 0;
    }
    std::array<double, 6> cosine{};
    for (std::size_t e = 0; e < 6; ++e) {
      const auto [i, j] = edge_corners[5 - e];  // the faces at an edge are those opposite to the two other corners
      const double scale = inverse_length[i] * inverse_length[j];
      cosine[e] = scale == 0 ? 1 : std::clamp(-dot(normal_[i], normal_[j]) * scale, -1.0, 1.0);
    }
    return cosine;
  }
  /// The dihedral angle at an edge in degrees, tiny ones and those near 180 to many digits.
  double dihedral_angle(std::size_t edge) const {
    const auto [i, j] = edge_corners[5 - edge];
    return angle_degrees(normal_[i], Vector3{} - normal_[j]);
  }

 private:
  Point3 origin_;
  Vector3 a_, b_, c_;
  std::array<double, 6> squared_edge_{};
  std::array<Vector3, 4> normal_{};  ///< of the face opposite to each corner, outward, as long as twice its area
  double six_volumes_ = 0;
};

}  // namespace delref
