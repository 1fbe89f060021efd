// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which subfacets a new point would destroy, and which have it in their diametral ball. After Shewchuk, "Tetrahedral mesh generation
// by Delaunay refinement" (1998).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <delref/core/carrier.hpp>
#include <delref/core/point.hpp>
#include <delref/core/proposal.hpp>
#include <delref/criteria/circumcentre.hpp>
#include <delref/domain/polyhedral_domain.hpp>
#include <delref/levels/facet_complex.hpp>
#include <delref/triangulation/spatial_concept.hpp>

namespace delref {

/// The subfacets that a proposed point encroaches. The domain must outlive it.
template <SpatialTriangulation Tr>
class SubfacetEncroachment {
  using Complex = FacetComplex<Tr>;
  using Vertex = typename Tr::Vertex;
  using Id = typename Complex::Id;

 public:
  struct Encroached {
    Id subfacet = Complex::none;
    bool is_destroyed = false;  ///< a face of the triangulation that dies; else the point is only in its ball
  };

  /// With `gabriel`, points on facets and segments encroach subfacets that no facet meets under 90 degrees by being in their balls.
  SubfacetEncroachment(const PolyhedralDomain& domain, bool gabriel) : domain_(&domain), gabriel_(gabriel) {}

  /// No facet meets that of the subfacet under 90 degrees.
  bool has_wide_angles(const Complex& complex, Id e) const { return domain_->facets[complex[e].facet].gabriel; }
  /// Whether vertices on other facets may encroach the subfacet.
  bool is_gabriel(const Complex& complex, Id e) const { return gabriel_ && has_wide_angles(complex, e); }
  /// Whether a point is in the smallest ball through the corners of a subfacet: strictly inside, by more than rounding.
  static bool is_in_ball(const Tr& tr, const Complex& complex, Id e, Point3 p) {
    const auto [a, b, c] = complex[e].corners;
    const Point3 o = tr.point(a);
    const Vector3 r = to_circumcentre(tr.point(b) - o, tr.point(c) - o);
    return squared_distance(p, o + r) < squared_length(r) * (1 - 1e-9);
  }

  /// The subfacets of the zone that the proposed point destroys or encroaches, each once. A point inside a region encroaches those of
  /// all facets: it may not come too near to any. Asked again for the same point, before anything is inserted, it looks for nothing.
  const std::vector<Encroached>& find(const Tr& tr, const Complex& complex, const Proposal<Tr>& proposal) {
    if (is_known_ && proposal.point == point_ && proposal.carrier == carrier_) return found_;
    found_.clear();
    ++time_;
    for (const auto cell : proposal.zone->dying_cells()) {
      if (!tr.has_marked_facets(cell)) continue;
      for (int i = 0; i < 4; ++i) {
        const auto f = tr.facet(cell, i);
        if (tr.is_marked(f)) look_at(tr, complex, f, proposal);
      }
    }
    is_known_ = true;
    point_ = proposal.point;
    carrier_ = proposal.carrier;
    return found_;
  }
  const std::vector<Encroached>& found() const { return found_; }
  /// The triangulation changed.
  void forget_point() { is_known_ = false; }

 private:
  void look_at(const Tr& tr, const Complex& complex, const typename Tr::Facet& f, const Proposal<Tr>& proposal) {
    const auto [a, b, c] = tr.vertices(f);
    const Id e = complex.find(tr, a, b, c);
    if (e == Complex::none || !is_first_look(e)) return;
    const bool is_destroyed = tr.dies(f, *proposal.zone);
    const bool keeps_off = proposal.carrier.dimension == 3 || is_gabriel(complex, e);
    if (is_destroyed || (keeps_off && is_in_ball(tr, complex, e, proposal.point))) found_.push_back({e, is_destroyed});
  }
  bool is_first_look(Id e) {
    if (looked_at_.size() <= e) looked_at_.resize(e + e / 2 + 16, 0);
    if (looked_at_[e] == time_) return false;
    looked_at_[e] = time_;
    return true;
  }

  const PolyhedralDomain* domain_;
  bool gabriel_, is_known_ = false;
  Point3 point_;
  Carrier carrier_;
  std::vector<Encroached> found_;
  std::uint64_t time_ = 0;
  std::vector<std::uint64_t> looked_at_;  // by subfacet
};

}  // namespace delref
