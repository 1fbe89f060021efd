// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which facets come together at a segment, and in which directions: a facet has one wedge there for each side on which it lies.
// What is open, which neighbours are coplanar and which angles are small is read from them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <tuple>
#include <vector>

#include <delref/core/point.hpp>
#include <delref/domain/facet_frame.hpp>
#include <delref/domain/triangulated_plc.hpp>

namespace delref {

/// The wedges at every segment of a complex, which must outlive them.
class SegmentWedges {
 public:
  using Index = Plc::Index;

  /// A facet, and whether it lies to the left of the segment from its lower to its higher vertex, seen against the facet's
  /// normal.
  struct Wedge {
    Index facet = 0;
    bool left = false;
  };
  /// A wedge at an angle in [0, 2 pi) around the segment from the first of them.
  struct Turned {
    Wedge wedge;
    double angle = 0;
  };

  explicit SegmentWedges(const TriangulatedPlc& plc) : plc_(plc), begin_(plc.segments.size() + 1, 0) {
    visit([&](Index segment, Wedge) { ++begin_[segment + 1]; });
    for (std::size_t s = 0; s < plc.segments.size(); ++s) begin_[s + 1] += begin_[s];
    std::vector<Index> place(begin_.begin(), begin_.end() - 1);
    wedges_.resize(begin_.back());
    visit([&](Index segment, Wedge wedge) { wedges_[place[segment]++] = wedge; });
  }

  std::span<const Wedge> operator[](std::size_t segment) const {
    return std::span(wedges_).subspan(begin_[segment], begin_[segment + 1] - begin_[segment]);
  }
  std::size_t size() const { return begin_.size() - 1; }

  /// A vector of length 1 along the segment, from its lower to its higher vertex.
  Vector3 direction(std::size_t segment) const {
    const auto [a, b] = plc_.segments[segment];
    return unit(plc_.points[b] - plc_.points[a]);
  }
  /// The direction from the segment into the facet, at a right angle to the segment, of length 1 up to rounding.
  Vector3 into(std::size_t segment, Wedge wedge) const {
    const Vector3 w = cross(plc_.frames[wedge.facet].normal, direction(segment));
    return wedge.left ? w : -1.0 * w;
  }

  /// The wedges at a segment in their order around it.
  std::vector<Turned> around(std::size_t segment) const {
    std::vector<Turned> turned;
    const auto all = (*this)[segment];
    if (all.empty()) return turned;
    const Vector3 axis = direction(segment), zero = into(segment, all.front());
    for (const Wedge wedge : all) {
      const Vector3 w = into(segment, wedge);
      double angle = wedge.facet == all.front().facet && wedge.left == all.front().left
                         ? 0
                         : std::atan2(dot(cross(zero, w), axis), dot(zero, w));
      if (angle < 0) angle += 2 * std::numbers::pi;
      turned.push_back({wedge, angle});
    }
    std::ranges::sort(turned, {}, [](const Turned& t) { return std::tuple(t.angle, t.wedge.facet, t.wedge.left); });
    return turned;
  }

 private:
  template <class Each>
  void visit(const Each& each) const {
    for (std::size_t f = 0; f < plc_.size(); ++f)
      for (const auto& t : plc_.triangles_of(f))
        for (std::size_t i = 0; i < 3; ++i) {
          const Index a = t[i], b = t[(i + 1) % 3], s = plc_.segments.find(a, b);
          if (s != SegmentTable::none) each(s, Wedge{static_cast<Index>(f), a < b});
        }
  }

  const TriangulatedPlc& plc_;
  std::vector<Index> begin_;
  std::vector<Wedge> wedges_;
};

/// Per segment of the complex: whether the input lists it, or a facet has it inside.
inline std::vector<bool> listed_segments(const TriangulatedPlc& plc) {
  std::vector<bool> listed(plc.segments.size(), false);
  for (const auto& [a, b] : plc.listed) listed[plc.segments.find(a, b)] = true;
  return listed;
}

}  // namespace delref
