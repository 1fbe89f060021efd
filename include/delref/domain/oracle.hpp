// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the meshers of smooth domains ask of a domain: the region that points are in, many at a time, and where a segment leaves a
// region. All that they know of a surface comes from these two questions. After the surface oracle of Boissonnat and Oudot, "Provably
// good sampling and meshing of surfaces" (2005), section 5.
#pragma once

#include <concepts>
#include <span>
#include <string>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/core/point.hpp>
#include <delref/core/proposal.hpp>  // with an enumerator `outside`, as the next, which would shadow the constant if they came after it
#include <delref/core/verdict.hpp>
#include <delref/domain/bounding_box_3.hpp>

namespace delref {

/// The label of what is not in the domain. Regions are numbered from 0.
inline constexpr int outside = -1;

/// A domain whose regions are told by an oracle:
///  1. `bounds()`: an upright box; no point outside it is in the domain, and nobody asks about one.
///  2. `label(points, labels)` writes, for each point of a `std::span<const Point3>`, the number of the region that the point is in,
///     or `outside`, into a `std::span<int>` of the same size.
///  3. `crossing(a, b, label_a, tolerance)`, for a segment whose ends have different labels, of which that of `a` is given: a point of
///     the segment, no further than `tolerance` along it from a place where the label changes from `label_a` to another.
/// Laws: the same question gives the same answer; constant calls may be made from several threads. The tests count the questions.
/// A minimal model is `ImplicitDomain`.
template <class O>
concept Oracle = requires(const O& oracle, std::span<const Point3> points, std::span<int> labels, Point3 p, double tolerance) {
  { oracle.bounds() } -> std::convertible_to<BoundingBox3>;
  oracle.label(points, labels);
  { oracle.crossing(p, p, 0, tolerance) } -> std::same_as<Point3>;
};

/// Fails to compile with a sentence when `O` is no oracle.
template <class O>
consteval bool explain_oracle() {
  static_assert(requires(const O& o) { { o.bounds() } -> std::convertible_to<BoundingBox3>; },
                "an oracle needs: bounds() const that gives a delref::BoundingBox3");
  static_assert(requires(const O& o, std::span<const Point3> points, std::span<int> labels) { o.label(points, labels); },
                "an oracle needs: label(std::span<const delref::Point3>, std::span<int>) const that writes a region number, or "
                "delref::outside, for each point");
  static_assert(requires(const O& o, Point3 p) { { o.crossing(p, p, 0, 1.0) } -> std::same_as<Point3>; },
                "an oracle needs: crossing(a, b, label_a, tolerance) const that gives a delref::Point3 of the segment where the label "
                "changes");
  return Oracle<O>;
}

/// The connected components of the surfaces of a domain, as far as they were found before meshing.
struct SurfaceComponents {
  /// Points on one component each, the first ones spread widely (each as far as can be from those before it). Not empty.
  std::vector<std::vector<Point3>> components;
  /// How they were found, such as "from the grid of the image, exactly" or "by samples 0.05 apart": a part of a sentence.
  std::string method;
  /// Every component was found, by proof.
  bool is_exact = false;
};

/// An oracle that finds the connected components of its surfaces: `components(control)`, which may throw `Interrupted`.
template <class O>
concept FindsComponents = Oracle<O> && requires(const O& oracle, const Control& control) {
  { oracle.components(control) } -> std::same_as<SurfaceComponents>;
};

}  // namespace delref
