// SPDX-License-Identifier: GPL-3.0-or-later
//
// When a vertex encroaches a subsegment: the policies of the planar edges level.
#pragma once

#include <concepts>

#include <delref/criteria/angle_bound.hpp>
#include <delref/triangulation/planar_concept.hpp>

namespace delref {

/// An encroachment policy for the triangulation `Tr`: `encroaches(tr, subsegment, p)` says whether a vertex at `p` encroaches the
/// subsegment; `deletes_free_vertices` is a constant that says whether the free vertices in the diametral circle of a subsegment
/// are deleted before it is split.
template <class E, class Tr>
concept Encroachment2 = std::copy_constructible<E> && requires(const E& policy, const Tr& tr, typename Tr::Edge e, Point2 p) {
  { policy.encroaches(tr, e, p) } -> std::same_as<bool>;
  { E::deletes_free_vertices } -> std::convertible_to<bool>;
};

/// Fails to compile with a sentence when `E` is no encroachment policy for `Tr`.
template <class E, class Tr>
consteval bool explain_encroachment() {
  static_assert(Encroachment2<E, Tr>,
                "an encroachment policy needs: encroaches(tr, subsegment, point) const that gives bool, and a static constexpr bool "
                "deletes_free_vertices; and to be copy constructible");
  return Encroachment2<E, Tr>;
}

/// A vertex strictly inside the circle that has the subsegment as diameter encroaches it (Ruppert 1995). The result is a
/// conforming Delaunay triangulation; refinement is proven to end for angle bounds up to 20.7 degrees.
struct DiametralCircle {
  static constexpr bool deletes_free_vertices = false;
  template <class Tr>
  bool encroaches(const Tr& tr, typename Tr::Edge e, Point2 p) const { return tr.in_diametral_circle(e, p); }
};

/// A vertex in the diametral lens encroaches it: one that sees the subsegment under at least 180 degrees less twice the angle bound
/// (Chew 1993; Shewchuk 2002, section 3.4). The result is a constrained Delaunay triangulation of fewer triangles; the proof
/// reaches 26.4 degrees.
struct DiametralLens {
  static constexpr bool deletes_free_vertices = true;
  AngleBound bound = AngleBound::degrees(20.7);

  template <class Tr>
  bool encroaches(const Tr& tr, typename Tr::Edge e, Point2 p) const {
    const Vector2 a = tr.point(tr.source(e)) - p, b = tr.point(tr.target(e)) - p;
    const double d = dot(a, b);
    if (d >= 0) return false;
    const double cosine = 1 - 2 * bound.squared_sine();  // of twice the bound
    return cosine <= 0 || d * d >= cosine * cosine * squared_length(a) * squared_length(b);
  }
};

}  // namespace delref
