// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tells, of what was given up, what a small input angle forces (Shewchuk 2002, section 8: no algorithm can avoid small angles at and
// near small input angles).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include <delref/core/outcome.hpp>
#include <delref/criteria/triangle_shape.hpp>
#include <delref/domain/planar_domain.hpp>
#include <delref/triangulation/planar_concept.hpp>

namespace delref {

/// Gives the reason `small_input_angle` to what a corner forces where segments meet under 60 degrees with the domain between:
///  - a triangle that misses the criterion named `shape_criterion` and whose shortest edge joins two segments of such a corner, or
///    which has a vertex within twice its longest edge of one;
///  - a subsegment that could not be split for want of precision, while the vertex that encroaches it is on another segment of
///    such a corner at its end.
template <PlanarTriangulation Tr>
class SmallAngleExcuses {
  using Vertex = typename Tr::Vertex;

 public:
  SmallAngleExcuses(const Tr& tr, const PlanarDomain& domain) : tr_(tr), domain_(domain) {
    for (const Vertex v : tr.finite_vertices()) {
      if (tr.index(v) >= vertices_.size()) vertices_.resize(tr.index(v) + 1);
      vertices_[tr.index(v)] = v;
    }
    for (std::size_t s = 0; s < domain.segments.size(); ++s)
      for (std::size_t end = 0; end < 2; ++end)
        if (domain.segments[s].sharp[end]) corners_.push_back(domain.point(s, end));
    std::ranges::sort(corners_, {}, &Point2::x);
  }

  void apply(Outcome<Point2>& outcome, std::string_view shape_criterion) const {
    std::map<std::pair<std::size_t, std::size_t>, Unmet<Point2>*> edges;
    for (Unmet<Point2>& u : outcome.unmet) {
      if (u.reason == Reason::budget) continue;
      if (u.vertex_count == 2 && u.reason == Reason::precision) edges[std::minmax(u.vertices[0], u.vertices[1])] = &u;
      if (u.vertex_count == 3 && u.criterion == shape_criterion && is_forced(u)) u.reason = Reason::small_input_angle;
    }
    if (edges.empty()) return;
    for (const auto e : tr_.subsegments()) {
      const auto found = edges.find(std::minmax(tr_.index(tr_.source(e)), tr_.index(tr_.target(e))));
      if (found != edges.end() && (is_forced(e) || is_forced(tr_.mirror(e)))) found->second->reason = Reason::small_input_angle;
    }
  }

 private:
  bool is_forced(const Unmet<Point2>& u) const {
    const std::array<Vertex, 3> v{vertices_[u.vertices[0]], vertices_[u.vertices[1]], vertices_[u.vertices[2]]};
    const TriangleShape t(tr_.point(v[0]), tr_.point(v[1]), tr_.point(v[2]));
    const double reach = 2 * std::sqrt(t.longest_squared());
    return std::ranges::any_of(t.corners, [&](Point2 p) { return is_near_corner(p, reach); }) ||
           domain_.meet_at_sharp_corner(tr_.carrier(v[(t.shortest + 1) % 3]), tr_.carrier(v[(t.shortest + 2) % 3]));
  }
  bool is_forced(typename Tr::Edge e) const {
    return tr_.in_domain(tr_.face(e)) &&
           domain_.meet_at_sharp_corner(tr_.carrier(tr_.apex(e)), Carrier{1, static_cast<std::uint32_t>(tr_.segment(e))});
  }
  bool is_near_corner(Point2 p, double distance) const {
    for (auto c = std::ranges::lower_bound(corners_, p.x - distance, {}, &Point2::x); c != corners_.end() && c->x <= p.x + distance; ++c)
      if (squared_distance(*c, p) <= distance * distance) return true;
    return false;
  }

  const Tr& tr_;
  const PlanarDomain& domain_;
  std::vector<Vertex> vertices_;  // by number
  std::vector<Point2> corners_;   // by x
};

}  // namespace delref
