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
#include <delref/core/queue/element_set.hpp>
#include <delref/core/queue/fifo_queue.hpp>
#include <delref/core/verdict.hpp>
#include <delref/domain/facet_hinges.hpp>
#include <delref/domain/polyhedral_domain.hpp>
#include <delref/levels/edges_level_3.hpp>
#include <delref/levels/facet_complex.hpp>
#include <delref/levels/region_repair.hpp>
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
  using Cell = typename Tr::Cell;
  using Facet = typename Tr::Facet;

 public:
  using Element = typename Complex::Id;

  /// `vertices` are those of the domain, in its order.
  FacetsLevel3(const Tr& tr, const PolyhedralDomain& domain, std::span<const Vertex> vertices, RegionRepair<Tr>& repair,
               ConformingOptions options = {})
      : domain_(&domain), hinges_(domain), repair_(&repair), options_(options), complex_(tr, domain, vertices) {}

  std::string_view name() const { return "facets"; }
  const Complex& complex() const { return complex_; }
  /// The number of subfacets that the triangulation does not have.
  std::size_t missing() const { return missing_; }

  void scan_triangulation(Tr& tr) {
    set_.clear();
    complex_.clear_slots();
    missing_ = 0;
    complex_.for_each([&](Element e) {
      complex_.set_present(e, false);
      ++missing_;
      const auto [a, b, c] = complex_[e].corners;
      if (const auto f = tr.find_facet(a, b, c)) found(tr, e, *f);
      if (!complex_[e].is_present) queue(tr, e);
    });
  }

  bool empty() const { return set_.empty(); }
  std::size_t queued() const { return set_.size(); }
  Element next_element() { return set_.front(); }
  void pop_next_element(Tr&) { set_.pop(complex_); }
  template <class F>
  void for_each_queued(F&& f) const { set_.for_each(f); }

  bool holds(const Tr& tr, std::span<const Vertex> v) const { return complex_.find(tr, v[0], v[1], v[2]) != Complex::none; }
  std::array<Vertex, 3> element_vertices(const Tr&, const Element& e) const { return complex_[e].corners; }
  Carrier carrier(const Tr&, const Element& e) const { return {2, complex_[e].facet}; }
  /// The circumcentre; where a vertex of another facet is in the way, its counterpart on this facet if that is not too near to a vertex.
  Point3 refinement_point(const Tr& tr, const Element& e) const {
    if (const auto p = counterpart(tr, e)) return *p;
    return complex_.circumcentre(tr, e);
  }
  std::optional<Reason> give_up(const Tr& tr, const Element& e) const {
    const double shortest = shortest_squared(tr, e);
    if (options_.smallest_edge > 0 && shortest <= options_.smallest_edge * options_.smallest_edge) return Reason::size_floor;
    const double rounding = PolyhedralDomain::rounding_near(tr.point(complex_[e].corners[0]));
    if (shortest <= 256 * rounding * rounding) return Reason::precision;
    return std::nullopt;
  }
  void on_rejected_forever(Tr&, const Element& e, Reason) { set_.give_up(complex_, e); }
  std::string_view unmet_criterion(const Tr&, const Element& e) const {
    return complex_[e].is_present ? "encroached subfacet" : "missing subfacet";
  }

  /// Locates the point in its facet first: where a subsegment is before it, that is to be split.
  Location<Tr> conflict_zone(Tr& tr, const Element& e, Point3 p, typename Tr::Zone& zone) {
    const auto place = complex_.locate(tr, e, p);
    if (place.blocker) {
      const auto [a, b] = complex_.ends(*place.blocker);
      return {Location<Tr>::Kind::blocked, {a, b}};
    }
    if (place.subfacet == Complex::none) return {Location<Tr>::Kind::degenerate, {}};
    located_ = place.subfacet;
    point_ = p;
    return tr.conflict_zone(p, typename Tr::Hint(complex_[located_].corners[0]), zone);
  }
  bool dies(const Tr& tr, const Element& e, const typename Tr::Zone&) const {
    return located_ == e || complex_.in_circumcircle(tr, e, point_);
  }

  /// Rejects a point inside a region when it would destroy a subfacet or encroaches one: of several, the one that contains its
  /// projection is to be refined.
  Verdict check_refinement_point(Tr& tr, const Proposal<Tr>& proposal) {
    if (proposal.carrier.dimension < 3) return Verdict::permitted;
    collect_encroached(tr, proposal);
    if (encroached_.empty()) return Verdict::permitted;
    for (const Element e : encroached_)
      if (const auto obstacle = this->obstacle(tr, e)) return reason_ = *obstacle, Verdict::rejected_forever;
    if (!repair_->is_for_size() && std::ranges::any_of(encroached_, [&](Element e) { return is_cramped(tr, e); }))
      return reason_ = Reason::small_input_angle, Verdict::rejected_forever;
    bool found_one = false;
    for (const Element e : encroached_)
      if (contains_projection(tr, e, proposal.point)) {
        queue(tr, e);
        found_one = true;
      }
    if (!found_one)
      for (const Element e : encroached_) queue(tr, e);
    return Verdict::rejected;
  }
  Reason rejection_reason() const { return reason_; }

  void before_insertion(Tr& tr, const Proposal<Tr>& proposal) {
    encroached_.clear();
    collect_encroached(tr, proposal);
    for (const Element e : encroached_)
      if (is_destroyed_[e] && complex_[e].is_present) {
        complex_.set_present(e, false);
        ++missing_;
      }
    is_unsure_ = repair_->remove(tr, proposal.zone->dying_cells());
  }

  void after_insertion(Tr& tr, Vertex v, const Proposal<Tr>& proposal) {
    repair_->forget();
    created_.clear();
    surviving_.clear();
    const auto removed = [&](Element e) {
      set_.erase(complex_, e);
      complex_.set_slot(e, 0, -1);
      if (complex_[e].is_present) surviving_.push_back(complex_[e].corners);
      else --missing_;
    };
    if (proposal.carrier.dimension == 1)
      complex_.split_subsegment(tr, proposal.vertices[0], proposal.vertices[1], v, removed, created_);
    else if (proposal.carrier.dimension == 2)
      complex_.insert(tr, located_, v, removed, created_);
    changed_.clear();
    for (const auto& [a, b, c] : surviving_)
      if (const auto f = tr.find_facet(a, b, c)) unmark(tr, *f);
    missing_ += created_.size();
    mark_created(tr, v, proposal);
    settle_ties(tr);
    for (const Element e : created_)
      if (!complex_[e].is_present) queue(tr, e);
    bool tore = false;
    for (const Element e : encroached_) {
      if (complex_[e].facet == Complex::none || std::ranges::find(created_, e) != created_.end()) continue;
      if (!is_destroyed_[e] || !complex_[e].is_present) queue(tr, e, v);
      tore = tore || !complex_[e].is_present;
    }
    for (const Element e : created_) tore = tore || !complex_[e].is_present;
    repair_regions(tr, proposal, tore);
  }

 private:
  double shortest_squared(const Tr& tr, const Element& e) const {
    const auto [a, b, c] = complex_[e].corners;
    return std::min({squared_distance(tr.point(a), tr.point(b)), squared_distance(tr.point(b), tr.point(c)),
                     squared_distance(tr.point(c), tr.point(a))});
  }
  /// `cause` is the vertex on another facet that is in the way, if one is.
  void queue(Tr& tr, const Element& e, Vertex cause = {}) {
    if (!set_.add(complex_, e, shortest_squared(tr, e))) return;
    if (causes_.size() <= e) causes_.resize(e + e / 2 + 16);
    causes_[e] = cause;
  }
  /// The counterpart on a subfacet of the vertex that is in its way, known or found about its circumcentre.
  std::optional<Point3> counterpart(const Tr& tr, const Element& e) const {
    if (!(causes_[e] == Vertex{})) return counterpart(tr, e, causes_[e]);
    if (complex_[e].is_present) return std::nullopt;
    const Point3 centre = complex_.circumcentre(tr, e);
    const auto cell = is_finite(centre) ? tr.locate(centre, typename Tr::Hint(complex_[e].corners[0])) : std::nullopt;
    if (!cell) return std::nullopt;
    for (const Vertex v : tr.vertices(*cell))
      if (std::ranges::find(complex_[e].corners, v) == complex_[e].corners.end())
        if (const auto p = counterpart(tr, e, v)) return p;
    return std::nullopt;
  }
  std::optional<Point3> counterpart(const Tr& tr, const Element& e, Vertex v) const {
    const auto found = hinges_.counterpart(tr.carrier(v), tr.point(v), complex_[e].facet);
    if (!found) return std::nullopt;
    const Point3 p = *found;
    const double apart = squared_distance(p, tr.point(v)), rounding = 64 * PolyhedralDomain::rounding_near(p);
    if (apart <= rounding * rounding) return std::nullopt;  // the vertex is on this facet
    if (!(apart < 0.25 * squared_distance(complex_.circumcentre(tr, e), tr.point(complex_[e].corners[0])))) return std::nullopt;
    if (!complex_.in_circumcircle(tr, e, p)) return std::nullopt;
    const auto place = complex_.locate(tr, e, p);
    if (place.blocker || place.subfacet == Complex::none) return std::nullopt;
    for (const Vertex w : complex_[place.subfacet].corners)
      if (squared_distance(tr.point(w), p) < 0.25 * apart) return std::nullopt;
    return p;
  }

  /// The smallest ball through the corners of a subfacet: strictly inside, by more than rounding.
  static bool in_diametral_ball(Point3 p, Point3 a, Point3 b, Point3 c) {
    const Vector3 u = b - a, v = c - a, n = cross(u, v);
    const double uu = squared_length(u), vv = squared_length(v), nn = squared_length(n);
    const Vector3 r = (0.5 / nn) * (vv * cross(n, u) + uu * cross(v, n));
    const double rr = squared_length(r);
    return squared_distance(p, a + r) < rr * (1 - 1e-9);
  }
  bool encroaches(const Tr& tr, Point3 p, const Element& e) const {
    const auto [a, b, c] = complex_[e].corners;
    return in_diametral_ball(p, tr.point(a), tr.point(b), tr.point(c));
  }
  /// Whether vertices on other facets may encroach the subfacet.
  bool is_gabriel(const Element& e) const { return options_.gabriel && has_wide_angles(e); }
  bool has_wide_angles(const Element& e) const { return domain_->facets[complex_[e].facet].gabriel; }

  /// The subfacets of the zone that the point destroys (`is_destroyed_`) or encroaches. A point inside a region encroaches those of all
  /// facets: it may not come too near to any.
  void collect_encroached(Tr& tr, const Proposal<Tr>& proposal) {
    encroached_.clear();
    for (const Cell cell : proposal.zone->dying_cells()) {
      if (!tr.has_marked_facets(cell)) continue;
      for (int i = 0; i < 4; ++i) {
        const Facet f = tr.facet(cell, i);
        if (!tr.is_marked(f)) continue;
        const auto [a, b, c] = tr.vertices(f);
        const Element e = complex_.find(tr, a, b, c);
        if (e == Complex::none || std::ranges::find(encroached_, e) != encroached_.end()) continue;
        const bool is_destroyed = tr.dies(f, *proposal.zone);
        if (!is_destroyed && !((proposal.carrier.dimension == 3 || is_gabriel(e)) && encroaches(tr, proposal.point, e))) continue;
        if (is_destroyed_.size() <= e) is_destroyed_.resize(e + e / 2 + 16);
        is_destroyed_[e] = is_destroyed;
        encroached_.push_back(e);
      }
    }
  }
  /// Whether the circumcentre of a subfacet is nearer to a facet that meets its own at a small angle than to its corners. Refining it
  /// would destroy subfacets there, whose refinement destroys others here.
  bool is_cramped(const Tr& tr, const Element& e) const {
    if (has_wide_angles(e)) return false;
    const Point3 centre = complex_.circumcentre(tr, e);
    return hinges_.squared_distance_to_sharp(complex_[e].facet, centre) < 0.25 * squared_distance(centre, tr.point(complex_[e].corners[0]));
  }
  bool contains_projection(const Tr& tr, const Element& e, Point3 p) const {
    const PlaneFrame& frame = domain_->facets[complex_[e].facet].frame;
    const Point2 q = frame.project(p);
    std::array<Point2, 3> c;
    for (std::size_t i = 0; i < 3; ++i) c[i] = frame.project(tr.point(complex_[e].corners[i]));
    for (std::size_t i = 0; i < 3; ++i)
      if (cross(c[(i + 1) % 3] - c[i], q - c[i]) < 0) return false;
    return true;
  }
  std::optional<Reason> obstacle(const Tr& tr, const Element& e) const {
    if (const auto reason = give_up(tr, e)) return reason;
    if (set_.is_given_up(complex_, e)) return Reason::precision;
    return std::nullopt;
  }

  /// A face that is no subfacet any more, though the insertion left it in place.
  void unmark(Tr& tr, const Facet& f) {
    tr.mark(f, false);
    changed_.push_back(f);
  }
  /// The triangulation has the subfacet, as `f`.
  void found(Tr& tr, const Element& e, const Facet& f) {
    tr.mark(f, true);
    if (!complex_[e].is_present) {
      complex_.set_present(e, true);
      --missing_;
    }
    for (const Facet& side : {f, tr.mirror(f)})
      if (const Vertex w = tr.apex(side); is_gabriel(e) && !tr.is_infinite(w) && encroaches(tr, tr.point(w), e)) queue(tr, e, w);
  }
  /// Finds which of the new subfacets, all of which have the new vertex, are faces of the new cells.
  void mark_created(Tr& tr, Vertex v, const Proposal<Tr>& proposal) {
    if (created_.empty()) return;
    for (const Cell c : proposal.zone->new_cells()) {
      for (int i = 0; i < 4; ++i) {
        if (tr.vertex(c, i) == v) continue;
        std::array<Vertex, 2> others;
        std::size_t n = 0;
        for (int k = 0; k < 4; ++k)
          if (k != i && !(tr.vertex(c, k) == v)) others[n++] = tr.vertex(c, k);
        for (const Element e : created_)
          if (has_corners(e, v, others[0], others[1])) {
            if (!complex_[e].is_present) found(tr, e, tr.facet(c, i));
            break;
          }
      }
    }
  }
  bool has_corners(const Element& e, Vertex a, Vertex b, Vertex c) const {
    const auto& corners = complex_[e].corners;
    const auto has = [&](Vertex v) { return corners[0] == v || corners[1] == v || corners[2] == v; };
    return has(b) && has(c) && has(a);
  }

  /// Cocircular corners have two triangulations; where the triangulation of space has the other one, that is taken.
  void settle_ties(Tr& tr) {
    for (std::size_t rounds = 0; rounds < 4; ++rounds) {
      bool changed = false;
      for (std::size_t k = 0; k < created_.size(); ++k)
        if (!complex_[created_[k]].is_present) changed = settle_tie(tr, created_[k]) || changed;
      if (!changed) return;
    }
  }
  bool settle_tie(Tr& tr, Element e) {
    for (int side = 0; side < 3; ++side) {
      const auto pair = complex_.tie(tr, {e, side});
      if (!pair) continue;
      const auto others = complex_.other_triangles({e, side});
      std::array<std::optional<Facet>, 2> facets;
      for (std::size_t i = 0; i < 2; ++i) facets[i] = tr.find_facet(others[i][0], others[i][1], others[i][2]);
      const int now = int{complex_[(*pair)[0]].is_present} + int{complex_[(*pair)[1]].is_present};
      if (int{facets[0].has_value()} + int{facets[1].has_value()} <= now) continue;
      complex_.flip(tr, {e, side}, [&](Element removed) {
        set_.erase(complex_, removed);
        complex_.set_slot(removed, 0, -1);
        if (!complex_[removed].is_present) return;
        const auto [a, b, c] = complex_[removed].corners;
        if (const auto f = tr.find_facet(a, b, c)) unmark(tr, *f);
        ++missing_;
      });
      for (std::size_t i = 0; i < 2; ++i) {
        if (std::ranges::find(created_, (*pair)[i]) == created_.end()) created_.push_back((*pair)[i]);
        if (facets[i]) {
          changed_.push_back(*facets[i]);
          found(tr, (*pair)[i], *facets[i]);
        }
      }
      return true;
    }
    return false;
  }

  void repair_regions(Tr& tr, const Proposal<Tr>& proposal, bool tore) {
    if (!domain_is_labelled_) return;
    if (tore || is_unsure_ || !changed_.empty() || (proposal.carrier.dimension < 3 && !are_consistent(tr, proposal.zone->new_cells())))
      for (const Cell c : proposal.zone->new_cells()) repair_->add(tr, c);
    for (const Facet& f : changed_)
      for (const Facet& side : {f, tr.mirror(f)})
        if (repair_->is_flat(tr, tr.cell(side))) repair_->add(tr, tr.cell(side));
    if (missing_ > 0 || repair_->empty()) return;
    repair_->settle(tr);
    const std::vector<Cell> settled = repair_->settled();
    for (const Cell c : settled) push_out(tr, c);
  }

  /// Whether the regions of cells are those of their neighbours, but for the other side of a facet.
  static bool are_consistent(const Tr& tr, std::span<const Cell> cells) {
    return std::ranges::all_of(cells, [&](Cell c) {
      for (int i = 0; i < 4; ++i)
        if (const Facet f = tr.facet(c, i); !tr.is_marked(f) && tr.region(tr.cell(tr.mirror(f))) != tr.region(c)) return false;
      return true;
    });
  }

  /// A cell with all of its corners on one facet: rounding makes such of cocircular points, with both diagonals of their quadrilateral
  /// as edges. Gives the two faces that are subfacets.
  std::optional<std::array<int, 2>> flat_pair(const Tr& tr, Cell c) const {
    if (!tr.has_marked_facets(c)) return std::nullopt;
    std::array<int, 2> pair{};
    std::array<Element, 2> elements{};
    std::size_t n = 0;
    for (int i = 0; i < 4; ++i) {
      if (!tr.is_marked(tr.facet(c, i))) continue;
      const auto [u, v, w] = tr.vertices(tr.facet(c, i));
      const Element e = complex_.find(tr, u, v, w);
      if (e == Complex::none) continue;
      for (std::size_t k = 0; k < n && k < 2; ++k)
        if (complex_[elements[k]].facet == complex_[e].facet) return std::array{pair[k], i};
      if (n < 2) pair[n] = i, elements[n] = e;
      ++n;
    }
    return std::nullopt;
  }
  /// Puts a flat cell on the other side of its facet when that is outside the domain, by giving the facet the other diagonal; and then
  /// those behind it, for more than four cocircular points make layers of flat cells.
  void push_out(Tr& tr, Cell first) {
    layers_.assign(1, first);
    while (!layers_.empty()) {
      const Cell c = layers_.back();
      layers_.pop_back();
      if (tr.region(c) < 0 || !push_out_one(tr, c)) continue;
      for (int i = 0; i < 4; ++i)
        if (const Facet f = tr.facet(c, i); tr.is_marked(f)) layers_.push_back(tr.cell(tr.mirror(f)));
    }
  }
  bool push_out_one(Tr& tr, Cell c) {
    const auto pair = flat_pair(tr, c);
    if (!pair) return false;
    std::array<Element, 2> elements{};
    for (std::size_t i = 0; i < 2; ++i) {
      const Facet f = tr.facet(c, (*pair)[i]);
      if (tr.region(tr.cell(tr.mirror(f))) >= 0) return false;
      const auto [u, v, w] = tr.vertices(f);
      elements[i] = complex_.find(tr, u, v, w);
    }
    const auto side = complex_.side_between(elements[0], elements[1]);
    if (!side || !complex_.is_convex(tr, *side)) return false;
    for (const int i : *pair) tr.mark(tr.facet(c, i), false);
    complex_.flip(tr, *side, [&](Element e) {
      set_.erase(complex_, e);
      complex_.set_slot(e, 0, -1);
    });
    missing_ += 2;
    tr.set_region(c, -1);
    repair_->add_settled(c);
    for (int i = 0; i < 4; ++i) {
      const auto [u, v, w] = tr.vertices(tr.facet(c, i));
      if (const Element e = complex_.find(tr, u, v, w); e == elements[0] || e == elements[1]) found(tr, e, tr.facet(c, i));
    }
    return true;
  }

 public:
  /// To be called when every facet is whole and the cells have their regions.
  void domain_is_labelled(Tr& tr) {
    domain_is_labelled_ = true;
    for (const Cell c : tr.finite_cells()) push_out(tr, c);
  }

 private:
  const PolyhedralDomain* domain_;
  FacetHinges hinges_;
  RegionRepair<Tr>* repair_;
  ConformingOptions options_;
  Complex complex_;
  std::vector<Vertex> causes_;  // by subfacet that is queued
  ElementSet<Element, Queue> set_;
  Reason reason_ = Reason::size_floor;
  std::size_t missing_ = 0;
  Element located_ = Complex::none;  // the subfacet that contains the point proposed last, `point_`
  Point3 point_;
  bool domain_is_labelled_ = false, is_unsure_ = false;
  std::vector<Element> encroached_, created_;
  std::vector<bool> is_destroyed_;  // by subfacet, where it is in `encroached_`
  std::vector<std::array<Vertex, 3>> surviving_;
  std::vector<Facet> changed_;  // faces that were there before and are subfacets only now, or no longer
  std::vector<Cell> layers_;
};

}  // namespace delref
