// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a planar criterion is, and the ones that come with delref: smallest angle, area, area per region, edge length, sizing
// field. A criterion of your own is a struct with `is_met(const TriangleShape&) const` and a name.
#pragma once

#include <concepts>
#include <limits>
#include <span>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include <delref/criteria/angle_bound.hpp>
#include <delref/criteria/sizing_field.hpp>
#include <delref/criteria/triangle_shape.hpp>
#include <delref/domain/pslg.hpp>

namespace delref {

/// A requirement on triangles:
///  1. `is_met(shape)`, for a constant criterion, says whether a triangle meets it;
///  2. `name` is what reports call it;
///  3. `bounds_size`, a constant, says that every small enough triangle meets it. Such a criterion is always enforced; others
///     give way where a small input angle makes them impossible.
/// The smallest model: `struct Flat { static constexpr std::string_view name = "flat"; static constexpr bool bounds_size = false;
/// bool is_met(const TriangleShape&) const; };`
template <class C>
concept TriangleCriterion = std::copy_constructible<C> && requires(const C& criterion, const TriangleShape& shape) {
  { criterion.is_met(shape) } -> std::same_as<bool>;
  { C::name } -> std::convertible_to<std::string_view>;
  { C::bounds_size } -> std::convertible_to<bool>;
};

/// Fails to compile with a sentence when `C` is no criterion.
template <class C>
consteval bool explain_triangle_criterion() {
  static_assert(TriangleCriterion<C>,
                "a triangle criterion needs: is_met(shape) const that gives bool for a delref::TriangleShape, a static constexpr "
                "name, and a static constexpr bool bounds_size; and to be copy constructible");
  return TriangleCriterion<C>;
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

/// All of several criteria. This is what a faces level takes.
template <class... Criteria>
class TriangleCriteria {
  static_assert((explain_triangle_criterion<Criteria>() && ...));

 public:
  explicit TriangleCriteria(Criteria... criteria) : criteria_(std::move(criteria)...) {}

  bool is_met(const TriangleShape& t) const {
    return std::apply([&](const auto&... c) { return (c.is_met(t) && ...); }, criteria_);
  }
  /// Whether every criterion that bounds the size is met.
  bool is_small_enough(const TriangleShape& t) const {
    return std::apply([&](const auto&... c) { return ((!std::remove_cvref_t<decltype(c)>::bounds_size || c.is_met(t)) && ...); },
                      criteria_);
  }
  /// The name of the first criterion that is not met, those that bound the size first; empty when all are.
  std::string_view unmet(const TriangleShape& t) const {
    std::string_view size, shape;
    std::apply(
        [&](const auto&... c) {
          ((c.is_met(t) ? void() : void((std::remove_cvref_t<decltype(c)>::bounds_size ? size : shape) =
                                            std::remove_cvref_t<decltype(c)>::name)),
           ...);
        },
        criteria_);
    return size.empty() ? shape : size;
  }

 private:
  std::tuple<Criteria...> criteria_;
};

}  // namespace delref
