// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where small input angles force small angles of triangles (Shewchuk 2002; Miller, Pav, Walkington 2003): near a corner at which
// two segments meet under 60 degrees, and at edges that bridge two such segments.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <delref/mesh/verify/chains.hpp>
#include <delref/mesh/verify/nearest_point.hpp>

namespace delref::verification {

/// Two segments with the domain between them meet at a small angle when it is less than this.
inline constexpr double small_angle_degrees = 60 - 1e-9;

class SmallAngles {
 public:
  SmallAngles(const Subject& subject, const InputDomain& domain, const Chains& chains)
      : subject_(subject), domain_(domain), chains_(chains), corners_(find_corners()) {}

  /// Whether a small input angle forces the small angle of a triangle.
  bool excuse(std::size_t triangle) const {
    const TriangleMeasures shape = subject_.shape(triangle);
    const auto& corners = subject_.mesh.triangles[triangle];
    const double reach = 2 * shape.longest_edge();
    for (const Index v : corners)
      if (corners_.squared_distance_from(subject_.points[v]) <= reach * reach) return true;
    const std::size_t k = shape.shortest();
    return bridges(corners[(k + 1) % 3], corners[(k + 2) % 3]);
  }

  /// Whether the encroachment of a vertex on the subsegment from a to b is no more than rounding where two segments meet at a tiny
  /// angle: it is next to an end of the subsegment, on another segment that meets this one at a small angle, nearer than a ten
  /// thousandth of the subsegment's length, or beside that end (along the subsegment within 4 ulp of it) nearer than a tenth.
  bool excuse_encroachment(Index a, Index b, Index vertex) const {
    const Vector2 along = subject_.points[b] - subject_.points[a];
    const double length = std::sqrt(squared_length(along)), reach = 1e-4 * length;
    for (const Index end : {a, b}) {
      const Vector2 off = subject_.points[vertex] - subject_.points[end];
      const double largest = std::max(std::abs(subject_.points[end].x), std::abs(subject_.points[end].y));
      const bool is_beside = std::abs(dot(along, off)) <= 4 * ulp(largest) * length && squared_length(off) <= 1e-2 * length * length;
      if ((is_beside || squared_length(off) <= reach * reach) && bridges(vertex, end)) return true;
    }
    return false;
  }

 private:
  Index other_end(const Piece& piece, Index vertex) const { return piece.from == vertex ? piece.to : piece.from; }

  NearestPoint<Point2> find_corners() const {
    std::vector<Point2> corners;
    struct Spoke {
      double direction;
      bool domain_follows;  ///< counterclockwise
    };
    std::vector<Spoke> spokes;
    for (Index v = 0; v < subject_.input_points.size(); ++v) {
      if (domain_.canonical(v) != v || chains_.vertex_of_input(v) == none) continue;
      spokes.clear();
      for (const Index p : domain_.pieces_at(v)) {
        const Piece& piece = domain_.pieces()[p];
        const Vector2 d = subject_.input_points[other_end(piece, v)] - subject_.input_points[v];
        spokes.push_back({std::atan2(d.y, d.x) * degrees_per_radian, domain_.inside(piece.from == v ? piece.left : piece.right)});
      }
      std::ranges::sort(spokes, {}, &Spoke::direction);
      for (std::size_t i = 0; i < spokes.size() && spokes.size() > 1; ++i) {
        const bool last = i + 1 == spokes.size();
        const double angle = last ? spokes[0].direction + 360 - spokes[i].direction : spokes[i + 1].direction - spokes[i].direction;
        if (!spokes[i].domain_follows || !(angle < small_angle_degrees)) continue;
        corners.push_back(subject_.input_points[v]);
        break;
      }
    }
    return NearestPoint(std::move(corners));
  }

  /// The input segments that a mesh vertex lies on.
  std::set<Index> segments_of(Index vertex) const {
    const Index input = chains_.input_of_vertex(vertex), piece = chains_.piece_of_vertex(vertex);
    if (input != none) return segments_through(input);
    if (piece == none) return {};
    const auto& segments = domain_.pieces()[piece].segments;
    return {segments.begin(), segments.end()};
  }
  std::set<Index> segments_through(Index input) const {
    std::set<Index> found;
    for (const Index p : domain_.pieces_at(input)) found.insert(domain_.pieces()[p].segments.begin(), domain_.pieces()[p].segments.end());
    return found;
  }

  bool bridges(Index v, Index w) const {
    const std::set<Index> at_v = segments_of(v), at_w = segments_of(w);
    for (const Index s : at_v)
      for (const Index t : at_w)
        if (s != t && meet_at_small_angle(s, v, t, w)) return true;
    return false;
  }

  /// Segments s, which v lies on, and t, which w lies on, have a vertex in common, and seen from it v and w are on rays that
  /// make a small angle in the domain.
  bool meet_at_small_angle(Index s, Index v, Index t, Index w) const {
    const auto ends = [&](Index i) {
      return std::array{domain_.canonical(subject_.input.segments[i][0]), domain_.canonical(subject_.input.segments[i][1])};
    };
    if (overlap(ends(s), ends(t))) return false;
    const auto small_at = [&](Index c) {
      const Vector2 along_s = towards(ends(s), c, v), along_t = towards(ends(t), c, w);
      return squared_length(along_s) > 0 && squared_length(along_t) > 0 && angle_degrees(along_s, along_t) < small_angle_degrees &&
             domain_beside(c, s, along_s, along_t);
    };
    for (const Index c : ends(s))
      if (segments_through(c).contains(t) && small_at(c)) return true;
    for (const Index c : ends(t))
      if (segments_through(c).contains(s) && small_at(c)) return true;
    return false;
  }

  /// Whether the domain is beside segment s where it leaves the input vertex c in a direction, on the side that t is on.
  bool domain_beside(Index c, Index s, Vector2 along_s, Vector2 along_t) const {
    for (const Index p : domain_.pieces_at(c)) {
      const Piece& piece = domain_.pieces()[p];
      const Vector2 outward = subject_.input_points[other_end(piece, c)] - subject_.input_points[c];
      if (dot(outward, along_s) <= 0 || !std::ranges::binary_search(piece.segments, s)) continue;
      const bool leftwards = cross(along_s, along_t) > 0;
      return domain_.inside((piece.from == c) == leftwards ? piece.left : piece.right);
    }
    return false;
  }

  bool overlap(std::array<Index, 2> s, std::array<Index, 2> t) const {
    const auto at = [&](Index v) { return exact(subject_.input_points[v]); };
    return CGAL::collinear(at(s[0]), at(s[1]), at(t[0])) && CGAL::collinear(at(s[0]), at(s[1]), at(t[1]));
  }

  /// The direction of a segment, from c on it towards the side on which the mesh vertex v is; zero when v is at c.
  Vector2 towards(std::array<Index, 2> ends, Index c, Index v) const {
    const Point2 apex = subject_.input_points[c], p = subject_.points[v];
    if (p == apex) return {};
    const Vector2 along = subject_.input_points[ends[1]] - subject_.input_points[ends[0]];
    return dot(along, p - apex) < 0 ? Vector2{-along.x, -along.y} : along;
  }

  const Subject& subject_;
  const InputDomain& domain_;
  const Chains& chains_;
  NearestPoint<Point2> corners_;
};

}  // namespace delref::verification
