// SPDX-License-Identifier: GPL-3.0-or-later
//
// The smallest oracle, the smallest one that finds components, the smallest criterion of facets and the smallest functions, each with the
// members that its concept requires and no other; the argument of `...Without` takes one of them away.
#pragma once

#include <algorithm>
#include <span>

#include <delref/core/budget.hpp>
#include <delref/core/point.hpp>
#include <delref/criteria/surface_facet_shape.hpp>
#include <delref/domain/bounding_box_3.hpp>
#include <delref/domain/oracle.hpp>

#include "archetype_criteria.hpp"

namespace archetypes {

/// What is left out of an archetype oracle.
enum class OraclePart { none, bounds, label, constant_label, crossing, point };

/// Its domain is empty. `without` is the part that it lacks.
template <OraclePart without>
struct NothingWithout {
  delref::BoundingBox3 bounds() const requires (without != OraclePart::bounds) { return {{0, 0, 0}, {1, 1, 1}}; }
  void label(std::span<const delref::Point3>, std::span<int> labels) const
    requires (without != OraclePart::label && without != OraclePart::constant_label) {
    std::ranges::fill(labels, delref::outside);
  }
  void label(std::span<const delref::Point3>, std::span<int>) requires (without == OraclePart::constant_label) {}
  delref::Point3 crossing(delref::Point3 a, delref::Point3, int, double) const
    requires (without != OraclePart::crossing && without != OraclePart::point) {
    return a;
  }
  /// No point, but how far it is on the way to it.
  double crossing(delref::Point3, delref::Point3, int, double) const requires (without == OraclePart::point) { return 0; }
};

/// What is left out of an archetype that finds the components of its surfaces.
enum class ComponentsPart { none, components, constant_components, result };

/// Finds none. `without` is the part that it lacks.
template <ComponentsPart without>
struct NoneFoundWithout : NothingWithout<OraclePart::none> {
  delref::SurfaceComponents components(const delref::Control&) const requires (without == ComponentsPart::none) { return {}; }
  delref::SurfaceComponents components(const delref::Control&) requires (without == ComponentsPart::constant_components) { return {}; }
  int components(const delref::Control&) const requires (without == ComponentsPart::result) { return 0; }
};

/// A criterion that every facet of a surface meets. `without` is the part that it lacks.
template <CriterionPart without>
struct AnyFacetWithout : HasName<without>, BoundsSize<without> {
  AnyFacetWithout() = default;
  AnyFacetWithout(const AnyFacetWithout&) requires (without != CriterionPart::copy) = default;
  AnyFacetWithout(AnyFacetWithout&&) requires (without == CriterionPart::copy) = default;
  bool is_met(const delref::SurfaceFacetShape&) const requires (without != CriterionPart::is_met) { return true; }
};

/// What is left out of an archetype function.
enum class FunctionPart { none, call, constant_call, number };

/// Is 0 everywhere. `without` is the part that it lacks.
template <FunctionPart without>
struct ZeroWithout {
  double operator()(delref::Point3) const requires (without == FunctionPart::none) { return 0; }
  double operator()(delref::Point3) requires (without == FunctionPart::constant_call) { return 0; }
  delref::Point3 operator()(delref::Point3 p) const requires (without == FunctionPart::number) { return p; }
};

/// The same for many points in one call.
struct ZerosInBatches {
  void operator()(std::span<const delref::Point3>, std::span<double> values) const { std::ranges::fill(values, 0); }
};

}  // namespace archetypes
