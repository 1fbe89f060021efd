// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which facets are one plane surface to the eye, though the input cuts it into several: angles are measured between such groups,
// or every triangle of a flat wall would have small ones.
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <vector>

#include <delref/domain/segment_wedges.hpp>
#include <delref/domain/triangulated_plc.hpp>

namespace delref {

/// Groups of facets that go on into each other within `slack`.
class CoplanarGroups {
 public:
  using Index = Plc::Index;
  /// Radians: what real files lose by rounding.
  static constexpr double slack = 1e-6;

  CoplanarGroups(const TriangulatedPlc& plc, const SegmentWedges& wedges) : parent_(plc.size()), flat_(wedges.size(), false) {
    std::iota(parent_.begin(), parent_.end(), Index{0});
    const std::vector<bool> listed = listed_segments(plc);
    for (std::size_t s = 0; s < wedges.size(); ++s) {
      const auto both = wedges[s];
      if (listed[s] || both.size() != 2) continue;
      const Vector3 a = wedges.into(s, both[0]), b = wedges.into(s, both[1]);
      if (dot(a, b) >= 0 || std::sqrt(squared_length(cross(a, b))) > slack) continue;
      flat_[s] = true;
      parent_[root(both[0].facet)] = root(both[1].facet);
    }
    for (Index f = 0; f < parent_.size(); ++f) parent_[f] = root(f);
  }

  /// The same number for facets of one group.
  Index group(Index facet) const { return parent_[facet]; }
  /// True where two facets of a group go on into each other, and nothing else meets them.
  bool is_flat(std::size_t segment) const { return flat_[segment]; }

 private:
  Index root(Index f) {
    while (parent_[f] != f) f = parent_[f] = parent_[parent_[f]];
    return f;
  }

  std::vector<Index> parent_;
  std::vector<bool> flat_;
};

}  // namespace delref
