// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a criterion is, of triangles in the plane and of tetrahedra in space alike, and how several are one. Criteria see a shape, such
// as `TriangleShape` or `TetrahedronShape`, whose measures are squares, areas and volumes: no test takes a square root.
#pragma once

#include <concepts>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

namespace delref {

/// A requirement on simplices of the kind that `Shape` describes:
///  1. `is_met(shape)`, for a constant criterion, says whether a simplex meets it;
///  2. `name` is what reports call it;
///  3. `bounds_size`, a constant, says that every small enough simplex meets it. Such a criterion is always enforced; others give
///     way where a small input angle makes them impossible.
/// `TriangleCriterion` and `TetrahedronCriterion` are this for one shape. The smallest model, of triangles: `struct Flat { static
/// constexpr std::string_view name = "flat"; static constexpr bool bounds_size = false; bool is_met(const TriangleShape&) const; };`
template <class C, class Shape>
concept SimplexCriterion = std::copy_constructible<C> && requires(const C& criterion, const Shape& shape) {
  { criterion.is_met(shape) } -> std::same_as<bool>;
  { C::name } -> std::convertible_to<std::string_view>;
  { C::bounds_size } -> std::convertible_to<bool>;
};

/// Fails to compile with a sentence when `C` is no criterion of simplices of this shape.
template <class Shape, class C>
consteval bool explain_criterion() {
  static_assert(SimplexCriterion<C, Shape>,
                "a criterion needs: is_met(shape) const that gives bool for the shape of what it judges, such as "
                "delref::TriangleShape or delref::TetrahedronShape; a static constexpr name, and a static constexpr bool "
                "bounds_size; and to be copy constructible");
  return SimplexCriterion<C, Shape>;
}

/// All of several criteria: `TriangleCriteria` and `TetrahedronCriteria` are this for one shape.
template <class Shape, class... Criteria>
class SimplexCriteria {
  static_assert((explain_criterion<Shape, Criteria>() && ...));

 public:
  explicit SimplexCriteria(Criteria... criteria) : criteria_(std::move(criteria)...) {}

  bool is_met(const Shape& shape) const {
    return std::apply([&](const auto&... c) { return (c.is_met(shape) && ...); }, criteria_);
  }
  /// Whether every criterion that bounds the size is met.
  bool is_small_enough(const Shape& shape) const {
    return std::apply([&](const auto&... c) { return ((!std::remove_cvref_t<decltype(c)>::bounds_size || c.is_met(shape)) && ...); },
                      criteria_);
  }
  /// The name of the first criterion that is not met, those that bound the size first; empty when all are.
  std::string_view unmet(const Shape& shape) const {
    std::string_view of_size, of_shape;
    const auto note = [&]<class C>(const C& criterion) {
      std::string_view& first = C::bounds_size ? of_size : of_shape;
      if (first.empty() && !criterion.is_met(shape)) first = C::name;
    };
    std::apply([&](const auto&... c) { (note(c), ...); }, criteria_);
    return of_size.empty() ? of_shape : of_size;
  }

 private:
  std::tuple<Criteria...> criteria_;
};

}  // namespace delref
