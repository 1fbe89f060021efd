// SPDX-License-Identifier: GPL-3.0-or-later
//
// The criteria that come with delref for facets of smooth surfaces: smallest angle, size, distance to the surface. A criterion of
// your own is a struct with `is_met(const SurfaceFacetShape&) const` and a name.
#pragma once

#include <limits>
#include <string_view>

#include <delref/criteria/angle_bound.hpp>
#include <delref/criteria/simplex_criteria.hpp>
#include <delref/criteria/sizing_field.hpp>
#include <delref/criteria/surface_facet_shape.hpp>

namespace delref {

/// A requirement on facets of a surface; `SimplexCriterion` says what it needs.
template <class C>
concept SurfaceFacetCriterion = SimplexCriterion<C, SurfaceFacetShape>;

/// Fails to compile with a sentence when `C` is no criterion.
template <class C>
consteval bool explain_surface_facet_criterion() {
  return explain_criterion<SurfaceFacetShape, C>();
}

/// No angle of a facet is smaller than the bound. Ends by proof up to 30 degrees (Boissonnat and Oudot 2005, theorem 5.1).
struct MinimumFacetAngle {
  static constexpr std::string_view name = "minimum facet angle";
  static constexpr bool bounds_size = false;
  AngleBound bound = AngleBound::degrees(30);
  bool is_met(const SurfaceFacetShape& f) const { return f.squared_sine() >= bound.squared_sine(); }
};

/// No surface ball has a greater radius, in the unit of the input.
struct MaximumFacetSize {
  static constexpr std::string_view name = "facet size";
  static constexpr bool bounds_size = true;
  double bound = std::numeric_limits<double>::infinity();
  bool is_met(const SurfaceFacetShape& f) const { return f.squared_radius <= bound * bound; }
};

/// No facet is further from the surface than this, between its circumcentre and the centre of its surface ball, in the unit of the input.
struct MaximumFacetDistance {
  static constexpr std::string_view name = "facet distance";
  static constexpr bool bounds_size = true;
  double bound = std::numeric_limits<double>::infinity();
  bool is_met(const SurfaceFacetShape& f) const { return f.squared_distance_to_surface() <= bound * bound; }
};

/// No surface ball has a greater radius than the field's value at its centre.
template <class Field>
struct FacetSizeAtCentre {
  static constexpr std::string_view name = "facet sizing field";
  static constexpr bool bounds_size = true;
  Field field;
  /// Throws `InvalidInput` where the field is not positive.
  bool is_met(const SurfaceFacetShape& f) const {
    const double size = checked_size(field, f.centre);
    return f.squared_radius <= size * size;
  }
};
template <class Field>
FacetSizeAtCentre(Field) -> FacetSizeAtCentre<Field>;

/// No facet is further from the surface than the field's value at the centre of its surface ball.
template <class Field>
struct FacetDistanceAtCentre {
  static constexpr std::string_view name = "facet distance field";
  static constexpr bool bounds_size = true;
  Field field;
  /// Throws `InvalidInput` where the field is not positive.
  bool is_met(const SurfaceFacetShape& f) const {
    const double distance = checked_size(field, f.centre);
    return f.squared_distance_to_surface() <= distance * distance;
  }
};
template <class Field>
FacetDistanceAtCentre(Field) -> FacetDistanceAtCentre<Field>;

/// All of several criteria. This is what a surface level takes.
template <class... Criteria>
using SurfaceFacetCriteria = SimplexCriteria<SurfaceFacetShape, Criteria...>;

}  // namespace delref
