// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a criterion of space is, and the ones that come with delref: radius-edge ratio, volume, volume per region, circumradius,
// sizing field. A criterion of your own is a struct with `is_met(const TetrahedronShape&) const` and a name.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include <delref/criteria/simplex_criteria.hpp>
#include <delref/criteria/sizing_field.hpp>
#include <delref/criteria/tetrahedron_shape.hpp>
#include <delref/domain/plc.hpp>

namespace delref {

/// A requirement on tetrahedra; `SimplexCriterion` says what it needs.
template <class C>
concept TetrahedronCriterion = SimplexCriterion<C, TetrahedronShape>;

/// Fails to compile with a sentence when `C` is no criterion.
template <class C>
consteval bool explain_tetrahedron_criterion() {
  return explain_criterion<TetrahedronShape, C>();
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

/// No tetrahedron of a region has a greater circumradius than that region's own bound; a bound of 0 is none.
struct MaximumRegionCircumradius {
  static constexpr std::string_view name = "cell size of the region";
  static constexpr bool bounds_size = true;
  std::vector<double> bounds;
  bool is_met(const TetrahedronShape& t) const {
    const auto region = static_cast<std::size_t>(t.region);
    return region >= bounds.size() || !(bounds[region] > 0) || t.squared_circumradius <= bounds[region] * bounds[region];
  }
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

/// All of several criteria. This is what a tetrahedra level takes: `TetrahedronCriteria criteria(RadiusEdge{2}, MaximumVolume{0.1});`
template <class... Criteria>
using TetrahedronCriteria = SimplexCriteria<TetrahedronShape, Criteria...>;

}  // namespace delref
