// SPDX-License-Identifier: GPL-3.0-or-later
//
// The facets level of polyhedral meshing: subfacets that are missing or encroached are refined by their circumcentres. After Shewchuk,
// "Tetrahedral mesh generation by Delaunay refinement" (1998). Where facets meet under 90 degrees a subfacet needs only to be
// present, as in Cheng, Dey, Ramos, Ray (2004): empty diametral balls would encroach each other there for ever.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <delref/core/proposal.hpp>
#include <delref/core/queue/fifo_queue.hpp>
#include <delref/core/verdict.hpp>
#include <delref/domain/polyhedral_domain.hpp>
#include <delref/domain/thin_places.hpp>
#include <delref/levels/edges_level_3.hpp>
#include <delref/levels/facet_complex.hpp>
#include <delref/levels/facet_sides.hpp>
#include <delref/levels/region_repair.hpp>
#include <delref/levels/subfacet_counterparts.hpp>
#include <delref/levels/subfacet_encroachment.hpp>
#include <delref/levels/subfacet_set.hpp>
#include <delref/triangulation/spatial_concept.hpp>

namespace delref {

/// Keeps every subfacet a face of the triangulation, and the points of regions out of its diametral ball. `domain` and `repair` must
/// outlive the level.
///
/// An insertion makes faces at the new vertex only, so a subfacet that is missing stays missing until its facet is refined there.
/// All subfacets of the input are to be edges-complete first: the level belongs below an edges level.
template <SpatialTriangulation Tr, class Queue = FifoQueue<std::uint32_t>>
class FacetsLevel3 {
  using Complex = FacetComplex<Tr>;
  using Vertex = typename Tr::Vertex;

 public:
  using Element = typename Complex::Id;

  /// `vertices` are those of the domain, in its order.
  FacetsLevel3(const Tr& tr, const PolyhedralDomain& domain, std::span<const Vertex> vertices, RegionRepair<Tr>& repair,
               ConformingOptions options = {})
      : domain_(&domain), repair_(&repair), options_(options), thin_places_(domain), counterparts_(domain),
        encroachment_(domain, options.gabriel), subfacets_(Complex(tr, domain, vertices)), sides_(repair) {}

  std::string_view name() const { return "facets"; }
  const Complex& complex() const { return subfacets_.complex(); }
  /// The number of subfacets that the triangulation does not have.
  std::size_t missing() const { return subfacets_.missing(); }
  /// To be called when every facet is whole and the cells have their regions.
  void domain_is_labelled(Tr& tr) { sides_.domain_is_labelled(tr, subfacets_); }

  void scan_triangulation(Tr& tr) {
    subfacets_.scan(tr);
    encroachment_.forget_point();
    if (options_.gabriel) complex().for_each([&](Element e) { test_ball(tr, e); });
  }

  bool empty() const { return subfacets_.queued().empty(); }
  std::size_t queued() const { return subfacets_.queued().size(); }
  Element next_element() { return subfacets_.next(); }
  void pop_next_element(Tr&) { subfacets_.pop(); }
  template <class F>
  void for_each_queued(F&& f) const { subfacets_.queued().for_each(f); }

  bool holds(const Tr& tr, std::span<const Vertex> v) const { return complex().find(tr, v[0], v[1], v[2]) != Complex::none; }
  std::array<Vertex, 3> element_vertices(const Tr&, const Element& e) const { return complex()[e].corners; }
  Carrier carrier(const Tr&, const Element& e) const { return {2, complex()[e].facet}; }
  /// The circumcentre; where a vertex of another facet is in the way, its counterpart on this facet if that is not too near to a vertex.
  Point3 refinement_point(const Tr& tr, const Element& e) const {
    if (const auto p = counterparts_.find(tr, complex(), e, subfacets_.cause(e))) return *p;
    return complex().circumcentre(tr, e);
  }
  std::optional<Reason> give_up(const Tr& tr, const Element& e) const {
    const double shortest = subfacets_.shortest_squared(tr, e);
    if (options_.smallest_edge > 0 && shortest <= options_.smallest_edge * options_.smallest_edge) return Reason::size_floor;
    const double rounding = 16 * counterparts_.rounding(tr, complex(), e);
    if (shortest <= rounding * rounding) return Reason::precision;
    return std::nullopt;
  }
  void on_rejected_forever(Tr&, const Element& e, Reason) { subfacets_.give_up(e); }
  std::string_view unmet_criterion(const Tr&, const Element& e) const {
    return complex()[e].is_present ? "encroached subfacet" : "missing subfacet";
  }

  /// Locates the point in its facet first: where a subsegment is before it, that is to be split. It kills the subfacet when it is in the
  /// circumcircle, be the subfacet a face of the triangulation or missing, and is not inserted else.
  Location<Tr> conflict_zone(Tr& tr, const Element& e, Point3 p, typename Tr::Zone& zone) {
    const auto place = complex().locate(tr, e, p);
    if (place.blocker) {
      const auto [a, b] = complex().ends(*place.blocker);
      return {Location<Tr>::Kind::blocked, {a, b}};
    }
    if (place.subfacet == Complex::none || (place.subfacet != e && !complex().in_circumcircle(tr, e, p)))
      return {Location<Tr>::Kind::degenerate, {}};
    located_ = place.subfacet;
    return tr.conflict_zone(p, typename Tr::Hint(complex()[located_].corners[0]), zone);
  }

  /// Rejects a point inside a region when it would destroy a subfacet or encroaches one: of several, the one that contains its
  /// projection is to be refined.
  Verdict check_refinement_point(Tr& tr, const Proposal<Tr>& proposal) {
    if (proposal.carrier.dimension < 3) return Verdict::permitted;
    const auto& encroached = encroachment_.find(tr, complex(), proposal);
    if (encroached.empty()) return Verdict::permitted;
    for (const auto& [e, is_destroyed] : encroached)
      if (const auto obstacle = this->obstacle(tr, e)) return reason_ = *obstacle, Verdict::rejected_forever;
    bool found_one = false;
    for (const auto& [e, is_destroyed] : encroached)
      if (contains_projection(tr, e, proposal.point)) {
        subfacets_.queue(tr, e, cause(tr, e, proposal));
        found_one = true;
      }
    if (!found_one)
      for (const auto& [e, is_destroyed] : encroached) subfacets_.queue(tr, e, cause(tr, e, proposal));
    return Verdict::rejected;
  }
  Reason rejection_reason() const { return reason_; }

  void before_insertion(Tr& tr, const Proposal<Tr>& proposal) {
    for (const auto& [e, is_destroyed] : encroachment_.find(tr, complex(), proposal))
      if (is_destroyed) subfacets_.lose(e);
    encroachment_.forget_point();
    sides_.before_insertion(tr, proposal.zone->dying_cells());
  }

  void after_insertion(Tr& tr, Vertex v, const Proposal<Tr>& proposal) {
    if (proposal.carrier.dimension == 1)
      subfacets_.retriangulate(tr, v, proposal.zone->new_cells(), [&](auto&& removed, auto& created) {
        subfacets_.complex().split_subsegment(tr, proposal.vertices[0], proposal.vertices[1], v, removed, created);
      });
    else if (proposal.carrier.dimension == 2)
      subfacets_.retriangulate(tr, v, proposal.zone->new_cells(), [&](auto&& removed, auto& created) {
        subfacets_.complex().insert(tr, located_, v, removed, created);
      });
    else subfacets_.begin_insertion();
    const auto& created = subfacets_.created();
    bool tore = false;
    for (const auto& [e, is_destroyed] : encroachment_.found()) {
      if (complex()[e].facet == Complex::none || std::ranges::find(created, e) != created.end()) continue;
      if (!is_destroyed || !complex()[e].is_present) subfacets_.queue(tr, e, v);
      tore = tore || !complex()[e].is_present;
    }
    for (const Element e : created) tore = tore || !complex()[e].is_present;
    sides_.after_insertion(tr, subfacets_, proposal, tore);
    if (options_.gabriel)
      for (const Element e : created) test_ball(tr, e);
  }

 private:
  /// Queues a subfacet that encloses the vertex behind it in its ball.
  void test_ball(Tr& tr, Element e) {
    if (!complex()[e].is_present || !encroachment_.is_gabriel(complex(), e)) return;
    const auto [a, b, c] = complex()[e].corners;
    const auto f = tr.find_facet(a, b, c);
    if (!f) return;
    for (const auto& side : {*f, tr.mirror(*f)})
      if (const Vertex w = tr.apex(side); !tr.is_infinite(w) && encroachment_.is_in_ball(tr, complex(), e, tr.point(w))) subfacets_.queue(tr, e, w);
  }
  bool contains_projection(const Tr& tr, Element e, Point3 p) const {
    const PlaneFrame& frame = domain_->facets[complex()[e].facet].frame;
    const Point2 q = frame.project(p);
    std::array<Point2, 3> c;
    for (std::size_t i = 0; i < 3; ++i) c[i] = frame.project(tr.point(complex()[e].corners[i]));
    for (std::size_t i = 0; i < 3; ++i)
      if (cross(c[(i + 1) % 3] - c[i], q - c[i]) < 0) return false;
    return true;
  }
  /// Why a subfacet is not refined for the sake of a tetrahedron. What is too large is refined nonetheless where angles are small.
  std::optional<Reason> obstacle(const Tr& tr, Element e) const {
    if (const auto reason = give_up(tr, e)) return reason;
    if (subfacets_.is_given_up(e)) return Reason::precision;
    if (repair_->is_for_size()) return std::nullopt;
    if (is_narrow(tr, e)) return Reason::size_floor;
    if (!encroachment_.has_wide_angles(complex(), e) && counterparts_.is_cramped(tr, complex(), e)) return Reason::small_input_angle;
    return std::nullopt;
  }
  /// Whether a subfacet reaches from one segment to another that is nearer than the floor (`ThinPlaces`).
  bool is_narrow(const Tr& tr, Element e) const {
    const auto& corners = complex()[e].corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vertex a = corners[i], b = corners[(i + 1) % 3];
      const Carrier s = tr.carrier(a), t = tr.carrier(b);
      if (s.dimension == 1 && t.dimension == 1 && s.index != t.index && squared_distance(tr.point(a), tr.point(b)) < thin_places_.squared_floor()) return true;
    }
    return false;
  }
  /// In a thin place, the corner of the tetrahedron that is on another facet beside this one: refined opposite to it, the tetrahedron is
  /// left with edges across, and ends there.
  Vertex cause(const Tr& tr, Element e, const Proposal<Tr>& proposal) const {
    const auto& facet = domain_->facets[complex()[e].facet];
    const double noise = 64 * counterparts_.rounding(tr, complex(), e);
    for (const Vertex v : proposal.element_vertices()) {
      const double height = facet.frame.height(tr.point(v));
      if (height * height > noise * noise && thin_places_.has_edge(tr.carrier(v), Carrier{2, complex()[e].facet}, height * height)) return v;
    }
    return {};
  }

  const PolyhedralDomain* domain_;
  RegionRepair<Tr>* repair_;
  ConformingOptions options_;
  ThinPlaces thin_places_;
  SubfacetCounterparts<Tr> counterparts_;
  SubfacetEncroachment<Tr> encroachment_;
  SubfacetSet<Tr, Queue> subfacets_;
  FacetSides<Tr, Queue> sides_;
  Reason reason_ = Reason::size_floor;
  Element located_ = Complex::none;  // the subfacet that contains the point proposed last
};

}  // namespace delref
