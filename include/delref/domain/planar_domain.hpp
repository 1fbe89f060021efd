// SPDX-License-Identifier: GPL-3.0-or-later
//
// The domain of a planar run as the levels see it: the input segments, cut where an input vertex lies on them, with the sharp
// corners at their ends, and the regions. Made by domain/build_planar_domain.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <span>
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
    std::array<double, 2> reach{};       ///< per end: the longest segment that meets it there under `tiny_angle_cosine`; 0 for none
    bool bounds_domain = false;          ///< one of its sides is outside the domain
  };

  /// The checked graph, its coordinates times 2^scale.
  Pslg pslg;
  int scale = 0;
  std::vector<Segment> segments;
  /// By the region number of a face; number 0 is what no seed names.
  std::vector<Pslg::Region> regions;

  Point2 point(std::size_t segment, std::size_t end) const { return pslg.points[segments[segment].ends[end]]; }

  /// Segments that meet under this angle (2 degrees) are split at the same distances from their corner all along, not only next to
  /// it: otherwise their vertices would encroach each other's subsegments down to the width of the wedge.
  static constexpr double tiny_angle_cosine = 0.99939;

  /// To be called when `segments` is filled.
  void index_segments() {
    first_incident_.assign(pslg.points.size() + 1, 0);
    for (const Segment& s : segments)
      for (const Pslg::Index end : s.ends) ++first_incident_[end + 1];
    std::partial_sum(first_incident_.begin(), first_incident_.end(), first_incident_.begin());
    incident_.resize(2 * segments.size());
    std::vector<std::uint32_t> next(first_incident_.begin(), first_incident_.end() - 1);
    for (std::uint32_t s = 0; s < segments.size(); ++s)
      for (const Pslg::Index end : segments[s].ends) incident_[next[end]++] = s;
  }

  /// The end of segment `s` from which its split points near `p` are measured, if it meets others at a tiny angle: the end whose
  /// neighbours reach as far as `p`, and of two such the nearer.
  std::optional<std::size_t> shell_corner(std::size_t s, Point2 p) const {
    const auto& reach = segments[s].reach;
    if (reach[0] == 0 && reach[1] == 0) return std::nullopt;
    if (reach[0] == 0 || reach[1] == 0) return reach[0] != 0 ? 0 : 1;
    const double d0 = squared_distance(p, point(s, 0)), d1 = squared_distance(p, point(s, 1));
    const bool reached0 = d0 < reach[0] * reach[0], reached1 = d1 < reach[1] * reach[1];
    return reached0 != reached1 ? (reached0 ? 0 : 1) : (d0 <= d1 ? 0 : 1);
  }

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
        const Vector2 u = p - point(a.index, i), v = q - point(a.index, i);
        const double d = dot(u, v);
        if (are_about_equal(squared_length(u), squared_length(v), 1e-3) && d > 0 &&
            4 * d * d > squared_length(u) * squared_length(v))
          return true;
      }
    return false;
  }


  /// Whether a vertex at `p` is on a circle around a sharp corner of segment `s` together with `q`, a point of `s`, as far as
  /// rounding lets one tell. On segments that meet under 1e-7 degrees such vertices would encroach each other's subsegments by
  /// nothing but rounding, for ever.
  bool are_on_one_shell(Carrier a, Point2 p, std::size_t s, Point2 q) const {
    for (std::size_t i = 0; i < 2; ++i) {
      if (!segments[s].sharp[i]) continue;
      const Point2 corner = point(s, i);
      const double d = std::sqrt(squared_distance(corner, p)), difference = std::abs(d - std::sqrt(squared_distance(corner, q)));
      if (difference <= 1e-12 * d + rounding_near(p) && is_on_segment_of(a, segments[s].ends[i])) return true;
    }
    return false;
  }

  /// Whether two vertices lie on different segments that share a sharp corner.
  bool meet_at_sharp_corner(Carrier a, Carrier b) const {
    if (a.dimension > 1 || b.dimension > 1) return false;
    const auto segments_of = [&](const Carrier& c) { return c.dimension == 1 ? std::span(&c.index, 1) : segments_at(c.index); };
    for (const std::uint32_t s : segments_of(a))
      for (const std::uint32_t t : segments_of(b))
        for (std::size_t i = 0; i < 2 && s != t; ++i)
          for (std::size_t j = 0; j < 2; ++j)
            if (segments[s].sharp[i] && segments[t].sharp[j] && segments[s].ends[i] == segments[t].ends[j]) return true;
    return false;
  }

 private:
  /// Of two squared lengths, whether the lengths differ by less than this part.
  static bool are_about_equal(double a, double b, double part) { return a <= (1 + 2 * part) * b && b <= (1 + 2 * part) * a; }
  /// Whether a vertex lies on a segment that is sharp at the input vertex `corner`.
  bool is_on_segment_of(Carrier a, Pslg::Index corner) const {
    const auto joins = [&](const Segment& t) { return (t.sharp[0] && t.ends[0] == corner) || (t.sharp[1] && t.ends[1] == corner); };
    if (a.dimension == 1) return joins(segments[a.index]);
    return a.dimension == 0 && std::ranges::any_of(segments_at(a.index), [&](std::size_t t) { return joins(segments[t]); });
  }

  std::span<const std::uint32_t> segments_at(std::size_t vertex) const {
    return {incident_.data() + first_incident_[vertex], incident_.data() + first_incident_[vertex + 1]};
  }
  std::vector<std::uint32_t> incident_, first_incident_;  // the segments at each input vertex
};

}  // namespace delref
