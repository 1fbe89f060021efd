// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where input elements that do not touch come so near to each other that tetrahedra between them are not refined for their shape: a
// wall of thickness t takes some 0.05 / t^2 vertices for each square of its extent, 5 million for t = 1e-4.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include <delref/core/carrier.hpp>
#include <delref/domain/bounding_box_3.hpp>
#include <delref/domain/polyhedral_domain.hpp>

namespace delref {

/// Tells edges of a mesh that are short because the domain is thin. The domain must outlive it.
class ThinPlaces {
 public:
  using Index = PolyhedralDomain::Index;

  /// Nearer to each other than this part of the extent of the input (the longest side of its box), elements make a thin place.
  static constexpr double floor_part = 1e-5;

  explicit ThinPlaces(const PolyhedralDomain& domain) : domain_(&domain) {
    const double floor = floor_part * bounding_box_3(domain.points).extent();
    squared_floor_ = floor * floor;
    first_corner_.assign(1, 0);
    for (const PolyhedralDomain::Facet& facet : domain.facets) {
      const auto first = static_cast<std::ptrdiff_t>(corners_.size());
      for (const auto& triangle : facet.triangles) corners_.insert(corners_.end(), triangle.begin(), triangle.end());
      std::sort(corners_.begin() + first, corners_.end());
      corners_.erase(std::unique(corners_.begin() + first, corners_.end()), corners_.end());
      first_corner_.push_back(corners_.size());
    }
  }

  /// The square of the distance below which a place is thin.
  double squared_floor() const { return squared_floor_; }
  /// Whether an edge is shorter than the floor and joins vertices on two input elements that have no input vertex in common.
  bool has_edge(Carrier a, Carrier b, double squared_length) const {
    if (!(squared_length < squared_floor_) || std::max(a.dimension, b.dimension) == 3 || a == b) return false;
    const std::span<const Index> of_a = corners(a), of_b = corners(b);
    const auto &fewer = of_a.size() < of_b.size() ? of_a : of_b, &more = of_a.size() < of_b.size() ? of_b : of_a;
    return std::ranges::none_of(fewer, [&](Index v) {
      return more.size() <= 2 ? std::ranges::find(more, v) != more.end() : std::ranges::binary_search(more, v);
    });
  }

 private:
  std::span<const Index> corners(const Carrier& c) const {
    if (c.dimension == 0) return {&c.index, 1};
    if (c.dimension == 1) return domain_->segments[c.index].ends;
    return std::span(corners_).subspan(first_corner_[c.index], first_corner_[c.index + 1] - first_corner_[c.index]);
  }

  const PolyhedralDomain* domain_;
  double squared_floor_ = 0;
  std::vector<Index> corners_;  // of the facets, sorted
  std::vector<std::size_t> first_corner_;
};

}  // namespace delref
