// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a subfacet is refined that a vertex of another facet is in the way of: opposite to that vertex, so that facets side by side,
// or at a small angle, have their vertices side by side (`FacetHinges`).
#pragma once

#include <algorithm>
#include <optional>

#include <delref/core/point.hpp>
#include <delref/domain/facet_hinges.hpp>
#include <delref/domain/polyhedral_domain.hpp>
#include <delref/levels/facet_complex.hpp>
#include <delref/triangulation/spatial_concept.hpp>

namespace delref {

/// The counterparts on subfacets of vertices on other facets. The domain must outlive it.
template <SpatialTriangulation Tr>
class SubfacetCounterparts {
  using Complex = FacetComplex<Tr>;
  using Vertex = typename Tr::Vertex;
  using Id = typename Complex::Id;

 public:
  explicit SubfacetCounterparts(const PolyhedralDomain& domain) : hinges_(domain) {}

  /// The counterpart of `cause`, the vertex that is in the way, or of one about the circumcentre when none is known; nothing where it would
  /// be too near to a corner, or not kill the subfacet.
  std::optional<Point3> find(const Tr& tr, const Complex& complex, Id e, Vertex cause) const {
    if (!(cause == Vertex{})) return of(tr, complex, e, cause);
    if (complex[e].is_present) return std::nullopt;
    const Point3 centre = complex.circumcentre(tr, e);
    const auto cell = is_finite(centre) ? tr.locate(centre, typename Tr::Hint(complex[e].corners[0])) : std::nullopt;
    if (!cell) return std::nullopt;
    for (const Vertex v : tr.vertices(*cell))
      if (std::ranges::find(complex[e].corners, v) == complex[e].corners.end())
        if (const auto p = of(tr, complex, e, v)) return p;
    return std::nullopt;
  }

  /// Whether the circumcentre of a subfacet is nearer to a facet that meets its own at a small angle than to its corners. Refining it
  /// would destroy subfacets there, whose refinement destroys others here.
  bool is_cramped(const Tr& tr, const Complex& complex, Id e) const {
    const Point3 centre = complex.circumcentre(tr, e);
    return hinges_.squared_distance_to_sharp(complex[e].facet, centre) < 0.25 * squared_distance(centre, tr.point(complex[e].corners[0]));
  }

  /// How far rounding may put a point from where it should be: the frame of a facet is as far from the origin as its farthest point.
  static double rounding(const Tr& tr, const Complex& complex, Id e) {
    double most = 0;
    for (const Vertex v : complex[e].corners) most = std::max(most, rounding_near(tr.point(v)));
    return most;
  }

 private:
  std::optional<Point3> of(const Tr& tr, const Complex& complex, Id e, Vertex v) const {
    const auto found = hinges_.counterpart(tr.carrier(v), tr.point(v), complex[e].facet);
    if (!found) return std::nullopt;
    const Point3 p = *found;
    const double apart = squared_distance(p, tr.point(v)), noise = 64 * rounding(tr, complex, e);
    if (apart <= noise * noise) return std::nullopt;  // the vertex is on this facet
    if (!(apart < 0.25 * squared_distance(complex.circumcentre(tr, e), tr.point(complex[e].corners[0])))) return std::nullopt;
    if (!complex.in_circumcircle(tr, e, p)) return std::nullopt;
    const auto place = complex.locate(tr, e, p);
    if (place.blocker || place.subfacet == Complex::none) return std::nullopt;
    for (const Vertex w : complex[place.subfacet].corners)
      if (squared_distance(tr.point(w), p) < 0.25 * apart) return std::nullopt;
    return p;
  }

  FacetHinges hinges_;
};

}  // namespace delref
