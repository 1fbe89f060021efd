// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which coplanar neighbours make one facet. Facets grow from the largest one: a neighbour joins when it goes on in the plane of
// the first within the angle asked for, and the whole stays planar within the tolerance; long chains of small bends do not add
// up.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/domain/bounding_box_3.hpp>
#include <delref/domain/plc_cuts.hpp>
#include <delref/domain/plc_options.hpp>
#include <delref/domain/segment_wedges.hpp>
#include <delref/domain/triangulated_plc.hpp>

namespace delref {

/// Twice the area vector of a facet.
inline Vector3 twice_area(const TriangulatedPlc& plc, std::size_t f) {
  Vector3 sum{0, 0, 0};
  for (const auto& [a, b, c] : plc.triangles_of(f))
    sum = sum + cross(plc.points[b] - plc.points[a], plc.points[c] - plc.points[a]);
  return sum;
}

/// Facets that grow together.
class CoplanarGrowth {
 public:
  using Index = Plc::Index;
  static constexpr Index none = static_cast<Index>(-1);

  struct Group {
    std::vector<Index> facets;
    PlaneFrame frame;
  };

  CoplanarGrowth(const TriangulatedPlc& plc, const SegmentWedges& wedges, const PlcOptions& options)
      : plc_(plc),
        wedges_(wedges),
        least_cosine_(std::cos(options.join_coplanar_degrees * std::numbers::pi / 180)),
        tolerance_(options.planarity_tolerance),
        rounding_(rounding_of(plc.points)),
        group_(plc.size(), none),
        reversed_(plc.size(), false) {}

  /// Groups of two or more facets.
  std::vector<Group> run(const Control& control) {
    std::vector<double> area(plc_.size());
    for (std::size_t f = 0; f < plc_.size(); ++f) area[f] = squared_length(twice_area(plc_, f));
    std::vector<Index> order(plc_.size());
    std::iota(order.begin(), order.end(), Index{0});
    std::ranges::sort(order, [&](Index f, Index g) { return area[f] != area[g] ? area[f] > area[g] : f < g; });
    std::vector<Group> groups;
    std::size_t steps = 0;
    for (const Index f : order) {
      if (++steps % 1024 == 0) throw_if_stopped(control);
      if (group_[f] != none) continue;
      Group group = grow(f);
      if (group.facets.size() > 1) groups.push_back(std::move(group));
    }
    return groups;
  }

  Index group_of(Index facet) const { return group_[facet]; }
  /// True when the facet's normal is opposite to that of its group.
  bool is_reversed(Index facet) const { return reversed_[facet]; }

 private:
  Group grow(Index first) {
    Group group{{first}, plc_.frames[first]};
    group_[first] = first;
    box_ = {};
    extend(first);
    for (std::size_t k = 0; k < group.facets.size(); ++k) {
      const Index f = group.facets[k];
      for (const auto& [a, b] : plc_.outlines.sides(f)) {
        const auto both = wedges_[plc_.segments.find(a, b)];
        if (both.size() != 2 || both[0].facet == both[1].facet) continue;
        const std::size_t other = both[0].facet == f ? 1 : 0;
        if (!joins(first, group.frame, f, both[1 - other], both[other])) continue;
        group_[both[other].facet] = first;
        group.facets.push_back(both[other].facet);
        extend(both[other].facet);
      }
    }
    std::ranges::sort(group.facets);
    return group;
  }

  template <class Each>
  void visit_vertices(Index f, const Each& each) const {
    for (const auto& triangle : plc_.triangles_of(f))
      for (const Index v : triangle) each(plc_.points[v]);
  }
  void extend(Index f) {
    visit_vertices(f, [this](Point3 p) { box_.extend(p); });
  }

  bool joins(Index first, const PlaneFrame& frame, Index from, SegmentWedges::Wedge wedge, SegmentWedges::Wedge onward) {
    const Index f = onward.facet;
    if (group_[f] != none || plc_.outlines.facets[f].marker != plc_.outlines.facets[first].marker) return false;
    const bool reversed = reversed_[from] != (wedge.left == onward.left);
    const double cosine = dot(plc_.frames[f].normal, frame.normal) * (reversed ? -1 : 1);
    if (cosine < 0.5) return false;
    double off = 0;
    BoundingBox3 box = box_;
    visit_vertices(f, [&](Point3 p) {
      off = std::max(off, std::abs(frame.height(p)));
      box.extend(p);
    });
    // The normal of a sliver means little: its vertices decide.
    const bool bends = cosine < least_cosine_ - 1e-15 && off > rounding_;
    if (bends || off > std::max(rounding_, tolerance_ * box.diagonal())) return false;
    reversed_[f] = reversed;
    return true;
  }

  const TriangulatedPlc& plc_;
  const SegmentWedges& wedges_;
  double least_cosine_, tolerance_, rounding_;
  std::vector<Index> group_;
  std::vector<bool> reversed_;
  BoundingBox3 box_;
};

}  // namespace delref
