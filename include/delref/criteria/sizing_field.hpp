// SPDX-License-Identifier: GPL-3.0-or-later
//
// How long edges may be, from place to place: any callable of a point.
#pragma once

#include <concepts>

#include <delref/core/point.hpp>
#include <delref/domain/describe.hpp>
#include <delref/domain/invalid_input.hpp>

namespace delref {

/// A sizing field of the plane: a function, lambda or object such that
///
///  1. `field(p)` compiles for a constant `field` and a `Point2 p`;
///  2. its result converts to `double`: the greatest length that an edge of a triangle with its centroid at `p` may have, in
///     the unit of the input. Infinity means no bound there.
///
/// A minimal model is `[](delref::Point2 p) { return 0.1 + 0.05 * p.x; }`. What the compiler cannot check: the same point gives
/// the same size each time; the size is positive wherever the domain is (`checked_size` throws where it is not); and the field
/// has a positive lower bound over the domain, without which only the budget ends the refinement.
template <class Field>
concept SizingField2 = requires(const Field& field, Point2 p) {
  { field(p) } -> std::convertible_to<double>;
};

/// Compiles when `Field` models `SizingField2`; otherwise the compiler's first error is a sentence that says what is missing.
template <class Field>
consteval void explain_sizing_field() {
  constexpr bool is_called = requires(const Field& field, Point2 p) { field(p); };
  static_assert(is_called,
                "A sizing field must be callable with a delref::Point2 while it is const: give it the member "
                "`double operator()(delref::Point2) const`, or use a lambda that is not mutable.");
  if constexpr (is_called)
    static_assert(SizingField2<Field>,
                  "A sizing field must return the size as a number: what yours returns for a "
                  "delref::Point2 does not convert to double.");
}

/// A sizing field of space: the same for a `Point3`. What the number bounds is said where a field is used.
template <class Field>
concept SizingField3 = requires(const Field& field, Point3 p) {
  { field(p) } -> std::convertible_to<double>;
};

/// Compiles when `Field` models `SizingField3`; otherwise the compiler's first error is a sentence that says what is missing.
template <class Field>
consteval void explain_sizing_field_3() {
  static_assert(SizingField3<Field>,
                "A sizing field of space must be callable with a delref::Point3 while it is const, and give a number: give it the "
                "member `double operator()(delref::Point3) const`, or use a lambda that is not mutable.");
}

/// `size`, which a field gave at `p`. Throws `InvalidInput` that names the point when it is NaN, zero or negative.
template <class Point>
double checked_size_at(double size, Point p) {
  if (size > 0) return size;
  throw InvalidInput("the sizing field gives " + (size <= 0 ? describe(size) : std::string("not a number")) + " at the point " +
                     describe(p) + ": a size must be positive everywhere in the domain; return infinity where there is no bound");
}

/// The size of the field at `p`, greater than 0 (perhaps infinity). Throws `InvalidInput` that names the point when the field
/// gives NaN, zero or a negative number there.
template <class Field>
double checked_size(const Field& field, Point2 p) {
  explain_sizing_field<Field>();
  if constexpr (SizingField2<Field>) return checked_size_at(static_cast<double>(field(p)), p);
  else return 0;
}
template <class Field>
double checked_size(const Field& field, Point3 p) {
  explain_sizing_field_3<Field>();
  if constexpr (SizingField3<Field>) return checked_size_at(static_cast<double>(field(p)), p);
  else return 0;
}

}  // namespace delref
