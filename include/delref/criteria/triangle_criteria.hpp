// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a planar criterion is, and the ones that come with delref: smallest angle, area, area per region, edge length, sizing
// field. A criterion of your own is a struct with `is_met(const TriangleShape&) const` and a name.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include <delref/criteria/angle_bound.hpp>
#include <delref/criteria/simplex_criteria.hpp>
#include <delref/criteria/sizing_field.hpp>
#include <delref/criteria/triangle_shape.hpp>
#include <delref/domain/pslg.hpp>

namespace delref {

/// A requirement on triangles; `SimplexCriterion` says what it needs.
template <class C>
concept TriangleCriterion = SimplexCriterion<C, TriangleShape>;

/// Fails to compile with a sentence when `C` is no criterion.
template <class C>
consteval bool explain_triangle_criterion() {
  return explain_criterion<TriangleShape, C>();
}

/// No angle is smaller than the bound.
struct MinimumAngle {
  static constexpr std::string_view name = "minimum angle";
  static constexpr bool bounds_size = false;
  AngleBound bound = AngleBound::degrees(20.7);

  /// The smallest angle is opposite to the shortest edge; its sine is twice the area over the product of the other two edges.
  bool is_met(const TriangleShape& t) const {
    const auto [a, b, c] = t.squared_lengths;
    const double others = t.shortest == 0 ? b * c : t.shortest == 1 ? a * c : a * b;
    return t.doubled_area * t.doubled_area >= bound.squared_sine() * others;
  }
};

/// No triangle is larger, in squared units of the input.
struct MaximumArea {
  static constexpr std::string_view name = "maximum area";
  static constexpr bool bounds_size = true;
  double bound = std::numeric_limits<double>::infinity();
  bool is_met(const TriangleShape& t) const { return t.doubled_area <= 2 * bound; }
};

/// No triangle of a region is larger than that region's own bound; a bound of 0 is none.
struct MaximumRegionArea {
  static constexpr std::string_view name = "maximum area of the region";
  static constexpr bool bounds_size = true;
  /// Twice the area, per region number.
  std::vector<double> doubled_bounds;

  MaximumRegionArea() = default;
  explicit MaximumRegionArea(std::span<const Pslg::Region> regions) {
    for (const Pslg::Region& r : regions)
      doubled_bounds.push_back(r.max_area > 0 ? 2 * r.max_area : std::numeric_limits<double>::infinity());
  }
  bool is_met(const TriangleShape& t) const {
    const auto region = static_cast<std::size_t>(t.region);
    return region >= doubled_bounds.size() || t.doubled_area <= doubled_bounds[region];
  }
};

/// No edge is longer, in the unit of the input.
struct MaximumEdge {
  static constexpr std::string_view name = "maximum edge length";
  static constexpr bool bounds_size = true;
  double bound = std::numeric_limits<double>::infinity();
  bool is_met(const TriangleShape& t) const { return t.longest_squared() <= bound * bound; }
};

/// No edge of a triangle is longer than the field's value at the triangle's centroid.
template <SizingField2 Field>
struct SizeAtCentroid {
  static constexpr std::string_view name = "sizing field";
  static constexpr bool bounds_size = true;
  Field field;
  /// Throws `InvalidInput` where the field is not positive.
  bool is_met(const TriangleShape& t) const {
    const double size = checked_size(field, t.centroid());
    return t.longest_squared() <= size * size;
  }
};
template <class Field>
SizeAtCentroid(Field) -> SizeAtCentroid<Field>;

/// All of several criteria. This is what a faces level takes: `TriangleCriteria criteria(MinimumAngle{}, MaximumArea{0.1});`
template <class... Criteria>
using TriangleCriteria = SimplexCriteria<TriangleShape, Criteria...>;

}  // namespace delref
