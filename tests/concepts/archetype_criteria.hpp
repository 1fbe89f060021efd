// SPDX-License-Identifier: GPL-3.0-or-later
//
// The smallest criterion of triangles, encroachment policy, point policy and sizing field, each with the members that its concept
// requires and no other; the argument of `...Without` takes one of them away.
#pragma once

#include <string_view>

#include <delref/core/point.hpp>
#include <delref/criteria/triangle_shape.hpp>

namespace archetypes {

/// What is left out of an archetype criterion.
enum class CriterionPart { none, copy, is_met, name, bounds_size };

template <CriterionPart> struct HasName { static constexpr std::string_view name = "anything"; };
template <> struct HasName<CriterionPart::name> {};
template <CriterionPart> struct BoundsSize { static constexpr bool bounds_size = false; };
template <> struct BoundsSize<CriterionPart::bounds_size> {};

/// A criterion that every triangle meets. `without` is the part that it lacks.
template <CriterionPart without>
struct AnythingWithout : HasName<without>, BoundsSize<without> {
  AnythingWithout() = default;
  AnythingWithout(const AnythingWithout&) requires (without != CriterionPart::copy) = default;
  AnythingWithout(AnythingWithout&&) requires (without == CriterionPart::copy) = default;
  bool is_met(const delref::TriangleShape&) const requires (without != CriterionPart::is_met) { return true; }
};

/// What is left out of an archetype encroachment policy.
enum class EncroachmentPart { none, copy, encroaches, deletes_free_vertices };

template <EncroachmentPart> struct DeletesFreeVertices { static constexpr bool deletes_free_vertices = false; };
template <> struct DeletesFreeVertices<EncroachmentPart::deletes_free_vertices> {};

/// Nothing encroaches anything. `without` is the part that it lacks.
template <class Tr, EncroachmentPart without>
struct NeverWithout : DeletesFreeVertices<without> {
  NeverWithout() = default;
  NeverWithout(const NeverWithout&) requires (without != EncroachmentPart::copy) = default;
  NeverWithout(NeverWithout&&) requires (without == EncroachmentPart::copy) = default;
  bool encroaches(const Tr&, typename Tr::Edge, delref::Point2) const requires (without != EncroachmentPart::encroaches) {
    return false;
  }
};

/// What is left out of an archetype point policy.
enum class PointPart { none, copy, point };

/// The centroid. `without` is the part that it lacks.
template <PointPart without>
struct CentroidWithout {
  CentroidWithout() = default;
  CentroidWithout(const CentroidWithout&) requires (without != PointPart::copy) = default;
  CentroidWithout(CentroidWithout&&) requires (without == PointPart::copy) = default;
  delref::Point2 point(const delref::TriangleShape& t) const requires (without != PointPart::point) { return t.centroid(); }
};

/// What is wrong with an archetype sizing field.
enum class FieldPart { none, call, constant_call, number };

/// No bound anywhere.
template <FieldPart without>
struct UnboundedWithout {
  double operator()(delref::Point2) const requires (without == FieldPart::none) { return 1; }
  double operator()(delref::Point2) requires (without == FieldPart::constant_call) { return 1; }
  const char* operator()(delref::Point2) const requires (without == FieldPart::number) { return "one"; }
};

}  // namespace archetypes
