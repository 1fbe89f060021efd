// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a criterion of space is, and the ones that come with delref: radius-edge ratio, volume, volume per region, circumradius,
// sizing field. A criterion of your own is a struct with `is_met(const TetrahedronShape&) const` and a name.
#pragma once

#include <concepts>
#include <cstddef>
#include <limits>
#include <span>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <delref/criteria/sizing_field.hpp>
#include <delref/criteria/tetrahedron_shape.hpp>
#include <delref/domain/plc.hpp>

namespace delref {

/// A requirement on tetrahedra:
///  1. `is_met(shape)`, for a constant criterion, says whether a tetrahedron meets it;
///  2. `name` is what reports call it;
///  3. `bounds_size`, a constant, says that every small enough tetrahedron meets it. Such a criterion is always enforced; others
///     give way where a small input angle makes them impossible.
template <class C>
concept TetrahedronCriterion = std::copy_constructible<C> && requires(const C& criterion, const TetrahedronShape& shape) {
  { criterion.is_met(shape) } -> std::same_as<bool>;
  { C::name } -> std::convertible_to<std::string_view>;
  { C::bounds_size } -> std::convertible_to<bool>;
};

/// Fails to compile with a sentence when `C` is no criterion.
template <class C>
consteval bool explain_tetrahedron_criterion() {
  static_assert(TetrahedronCriterion<C>,
                "a tetrahedron criterion needs: is_met(shape) const that gives bool for a delref::TetrahedronShape, a static constexpr "
                "name, and a static constexpr bool bounds_size; and to be copy constructible");
  return TetrahedronCriterion<C>;
}

/// The circumradius is at most `bound` times the shortest edge.
struct RadiusEdge {
  static constexpr std::string_view name = "radius-edge ratio";
  static constexpr bool bounds_size = false;
  double bound = 2;
  bool is_met(const TetrahedronShape& t) const { return t.squared_circumradius <= bound * bound * t.shortest_squared; }
};

/// No tetrahedron is larger, in cubed units of the input.
struct MaximumVolume {
  static constexpr std::string_view name = "maximum volume";
  static constexpr bool bounds_size = true;
  double bound = std::numeric_limits<double>::infinity();
  bool is_met(const TetrahedronShape& t) const { return t.sixfold_volume <= 6 * bound; }
};

/// No tetrahedron of a region is larger than that region's own bound; a bound of 0 is none.
struct MaximumRegionVolume {
  static constexpr std::string_view name = "maximum volume of the region";
  static constexpr bool bounds_size = true;
  /// Six times the volume, per region number.
  std::vector<double> sixfold_bounds;

  MaximumRegionVolume() = default;
  explicit MaximumRegionVolume(std::span<const Plc::Region> regions) {
    for (const Plc::Region& r : regions)
      sixfold_bounds.push_back(r.max_volume > 0 ? 6 * r.max_volume : std::numeric_limits<double>::infinity());
  }
  bool is_met(const TetrahedronShape& t) const {
    const auto region = static_cast<std::size_t>(t.region);
    return region >= sixfold_bounds.size() || t.sixfold_volume <= sixfold_bounds[region];
  }
};

/// No circumradius is greater, in the unit of the input.
struct MaximumCircumradius {
  static constexpr std::string_view name = "cell size";
  static constexpr bool bounds_size = true;
  double bound = std::numeric_limits<double>::infinity();
  bool is_met(const TetrahedronShape& t) const { return t.squared_circumradius <= bound * bound; }
};

/// No circumradius is greater than the field's value at the circumcentre.
template <class Field>
struct SizeAtCircumcentre {
  static constexpr std::string_view name = "sizing field";
  static constexpr bool bounds_size = true;
  Field field;
  /// Throws `InvalidInput` where the field is not positive.
  bool is_met(const TetrahedronShape& t) const {
    const double size = checked_size(field, t.circumcentre);
    return t.squared_circumradius <= size * size;
  }
};
template <class Field>
SizeAtCircumcentre(Field) -> SizeAtCircumcentre<Field>;

/// All of several criteria. This is what a tetrahedra level takes.
template <class... Criteria>
class TetrahedronCriteria {
  static_assert((explain_tetrahedron_criterion<Criteria>() && ...));

 public:
  explicit TetrahedronCriteria(Criteria... criteria) : criteria_(std::move(criteria)...) {}

  bool is_met(const TetrahedronShape& t) const {
    return std::apply([&](const auto&... c) { return (c.is_met(t) && ...); }, criteria_);
  }
  /// Whether every criterion that bounds the size is met.
  bool is_small_enough(const TetrahedronShape& t) const {
    return std::apply([&](const auto&... c) { return ((!std::remove_cvref_t<decltype(c)>::bounds_size || c.is_met(t)) && ...); },
                      criteria_);
  }
  /// The name of the first criterion that is not met, those that bound the size first; empty when all are.
  std::string_view unmet(const TetrahedronShape& t) const {
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
