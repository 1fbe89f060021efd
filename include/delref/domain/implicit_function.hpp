// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a function may be whose negative values are the inside of a domain: any callable of a point; better one that answers many
// points in one call; best one that also bounds its values over a box.
#pragma once

#include <concepts>
#include <cstddef>
#include <optional>
#include <span>

#include <delref/core/point.hpp>
#include <delref/domain/bounding_box_3.hpp>

namespace delref {

/// A function of one point: `function(p)` of a constant `function` gives a number. A minimal model is
/// `[](delref::Point3 p) { return p.x * p.x + p.y * p.y + p.z * p.z - 1; }`. Laws: the same point gives the same number; constant
/// calls may be made from several threads.
template <class F>
concept PointFunction = requires(const F& function, Point3 p) {
  { function(p) } -> std::convertible_to<double>;
};

/// A function of many points: `function(points, values)` writes the value at each point. Its values are those of single calls to
/// the last bit.
template <class F>
concept BatchFunction = requires(const F& function, std::span<const Point3> points, std::span<double> values) {
  function(points, values);
};

/// What is known of the values of a function over a box.
struct ValueRange {
  /// No value in the box is less, or greater. Infinities where nothing is known.
  double low, high;
  /// The function may be NaN somewhere in the box.
  bool may_be_undefined = false;
};

/// A function that bounds its values: `function.range(box)` gives a `ValueRange` of a `BoundingBox3`, by interval arithmetic or
/// from a Lipschitz constant. With it, components of the surface are found by proof.
template <class F>
concept RangedFunction = requires(const F& function, const BoundingBox3& box) {
  { function.range(box) } -> std::convertible_to<ValueRange>;
};

/// A ranged function that also proves that its surface is simple in a box: `function.is_regular(box)` is true only when the
/// function is smooth there and no two of its gradients, as bounded by intervals, are a right angle or more apart (condition C1
/// of Plantinga and Vegter 2007). With it the search for components ends as soon as it is complete.
template <class F>
concept RegularFunction = RangedFunction<F> && requires(const F& function, const BoundingBox3& box) {
  { function.is_regular(box) } -> std::convertible_to<bool>;
};

/// Whether all points of a box of such values are inside, or all are not; nothing when that is not proved.
inline std::optional<bool> proved_inside(const ValueRange& range) {
  if (range.low >= 0) return false;
  if (range.high < 0 && !range.may_be_undefined) return true;
  return std::nullopt;
}

/// What an `ImplicitDomain` can be made of.
template <class F>
concept ImplicitFunction = PointFunction<F> || BatchFunction<F>;

/// Fails to compile with a sentence when `F` is no function of a point.
template <class F>
consteval bool explain_implicit_function() {
  static_assert(
      ImplicitFunction<F>,
      "An implicit function must be callable while it is const, with a delref::Point3, and give a number: give it the member "
      "`double operator()(delref::Point3) const`, or use a lambda that is not mutable. It may have the member `void "
      "operator()(std::span<const delref::Point3>, std::span<double>) const` for many points besides, or instead.");
  return ImplicitFunction<F>;
}

/// The value at one point.
template <ImplicitFunction F>
double function_value(const F& function, Point3 p) {
  if constexpr (PointFunction<F>) {
    return static_cast<double>(function(p));
  } else {
    double value = 0;
    function(std::span<const Point3>(&p, 1), std::span<double>(&value, 1));
    return value;
  }
}

/// The values at many points, in one call where the function can.
template <ImplicitFunction F>
void function_values(const F& function, std::span<const Point3> points, std::span<double> values) {
  if constexpr (BatchFunction<F>) {
    function(points, values);
  } else {
    for (std::size_t i = 0; i < points.size(); ++i) values[i] = static_cast<double>(function(points[i]));
  }
}

}  // namespace delref
