// SPDX-License-Identifier: GPL-3.0-or-later
//
// The edges level of planar meshing: encroached subsegments are split. After Ruppert, "A Delaunay refinement algorithm for quality
// 2-dimensional mesh generation" (1995), with the concentric shells of his section 6 for small input angles, and Chew's deletion of
// free vertices (1993) where the encroachment policy asks for it.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include <delref/core/proposal.hpp>
#include <delref/core/queue/element_set.hpp>
#include <delref/core/queue/lifo_queue.hpp>
#include <delref/core/verdict.hpp>
#include <delref/domain/planar_domain.hpp>
#include <delref/levels/encroachment.hpp>
#include <delref/levels/split_point.hpp>
#include <delref/triangulation/planar_concept.hpp>

namespace delref {

/// What the edges level may do to segments.
struct EdgesOptions {
  double smallest_edge = 0;      ///< a subsegment that is not longer is not split, in the unit of the input
  bool protect_boundary = false; ///< no segment that bounds the domain is split
};

/// Keeps every subsegment of the domain free of encroaching vertices. `Tr` models `PlanarTriangulation`; `domain` must outlive the
/// level. A subsegment is judged by the apexes of its two triangles, and by the points that levels of lower priority propose.
template <PlanarTriangulation Tr, Encroachment2<Tr> Policy = DiametralCircle, class Queue = LifoQueue<typename Tr::Edge>>
class EdgesLevel2 {
 public:
  using Element = typename Tr::Edge;

  explicit EdgesLevel2(const PlanarDomain& domain, Policy policy = {}, EdgesOptions options = {})
      : domain_(&domain), policy_(policy), options_(options) {}

  std::string_view name() const { return "edges"; }
  void assign_slot(std::size_t k) { set_.assign_slot(k); }

  void scan_triangulation(Tr& tr) {
    set_.clear();
    for (const typename Tr::Face f : tr.domain_faces()) test_edges(tr, f);
  }

  bool empty() const { return set_.empty(); }
  Element next_element() { return set_.front(); }
  void pop_next_element(Tr& tr) { set_.pop(tr); }
  template <class F>
  void for_each_queued(F&& f) const { set_.for_each(f); }
  std::size_t queued() const { return set_.size(); }

  Point2 refinement_point(const Tr& tr, const Element& e) const {
    const std::size_t s = tr.segment(e);
    const Point2 a = tr.point(tr.source(e)), b = tr.point(tr.target(e));
    auto corner = domain_->shell_corner(s, midpoint(a, b));
    if (!corner) corner = sharp_end(tr, e);
    if (corner) return split_point_near_corner(a, b, segment_end(tr, e, *corner), segment_end(tr, e, 1 - *corner));
    return split_point(a, b, segment_end(tr, e, 0), segment_end(tr, e, 1));
  }
  Carrier carrier(const Tr& tr, const Element& e) const { return {1, static_cast<std::uint32_t>(tr.segment(e))}; }

  std::optional<Reason> give_up(const Tr& tr, const Element& e) const {
    if (is_protected(tr, e)) return Reason::protected_segment;
    const double floor = options_.smallest_edge;
    if (floor > 0 && squared_length(tr, e) <= floor * floor) return Reason::size_floor;
    const double rounding = rounding_near(tr.point(tr.source(e)));
    if (squared_length(tr, e) <= 16 * rounding * rounding) return Reason::precision;
    if (is_hopeless(tr, e) || is_hopeless(tr, tr.mirror(e))) return Reason::small_input_angle;
    return std::nullopt;
  }
  void on_rejected_forever(Tr& tr, const Element& e, Reason) { set_.give_up(tr, e); }
  std::string_view unmet_criterion(const Tr&, const Element&) const { return "encroached subsegment"; }

  /// The zone of the split, with the free vertices of the diametral circle as vanishing when the policy deletes them.
  Location<Tr> conflict_zone(Tr& tr, const Element& e, Point2 p, typename Tr::Zone& zone) {
    free_vertices_.clear();
    if constexpr (Policy::deletes_free_vertices) {
      if (!sharp_end(tr, e)) {
        collect_free_vertices(tr, e);
        collect_free_vertices(tr, tr.mirror(e));
      }
    }
    if constexpr (requires { tr.conflict_zone(p, e, free_vertices_, zone); }) return tr.conflict_zone(p, e, free_vertices_, zone);
    else return tr.conflict_zone(p, typename Tr::Hint(e), zone);
  }

  /// Rejects the point of another level when it encroaches subsegments of its zone, which are then to be split.
  Verdict check_refinement_point(Tr& tr, const Proposal<Tr>& proposal) {
    if (proposal.carrier.dimension < 2) return Verdict::permitted;
    encroached_.clear();
    for (const Element outer : proposal.zone->boundary_edges())
      if (tr.is_constrained(outer) && policy_.encroaches(tr, outer, proposal.point)) encroached_.push_back(outer);
    return encroached_.empty() ? Verdict::permitted : split_instead(tr);
  }
  Verdict check_blocked(Tr& tr, const Element& e, const Proposal<Tr>&) {
    encroached_.assign(1, e);
    return split_instead(tr);
  }
  Reason rejection_reason() const { return reason_; }

  void before_insertion(Tr& tr, const Proposal<Tr>& proposal) {
    if (set_.empty()) return;
    for (const Element e : proposal.zone->dying_subsegments()) set_.erase(tr, e);
    for (const Element outer : proposal.zone->boundary_edges())
      if (tr.is_constrained(outer)) set_.rename(tr, outer);
  }
  void after_insertion(Tr& tr, typename Tr::Vertex, const Proposal<Tr>& proposal) {
    for (const typename Tr::Face f : proposal.zone->new_faces()) test_edges(tr, f);
  }

 private:
  /// So many faces are searched for free vertices on one side of a subsegment. A circle holds a few dozen vertices at most where
  /// angles are good; a star of thousands of needles is not searched through again for every split. What is missed stays a vertex of
  /// the mesh and costs triangles only.
  static constexpr std::size_t most_faces_searched = 64;

  /// Whether the apex of `e` is on another segment of a sharp corner of the segment of `e`, and so near that it is beside `e` only by
  /// rounding: both would split each other for ever.
  bool is_hopeless(const Tr& tr, const Element& e) const {
    if (!tr.in_domain(tr.face(e))) return false;
    const typename Tr::Vertex v = tr.apex(e);
    const Point2 p = tr.point(v), a = tr.point(tr.source(e)), b = tr.point(tr.target(e));
    const double reach = 16 * rounding_near(p), area = cross(b - a, p - a);
    return area * area <= reach * reach * squared_length(tr, e) && policy_.encroaches(tr, e, p) &&
           domain_->meet_at_sharp_corner(tr.carrier(v), Carrier{1, static_cast<std::uint32_t>(tr.segment(e))});
  }

  /// Queues those edges of `f` that its own vertices encroach.
  void test_edges(Tr& tr, typename Tr::Face f) {
    if constexpr (requires { tr.is_constrained(f); })
      if (!tr.is_constrained(f)) return;
    for (int i = 0; i < 3; ++i)
      if (const Element e = tr.edge(f, i); tr.is_constrained(e)) test(tr, e);
  }
  /// Queues `e` when the apex on its side encroaches it.
  void test(Tr& tr, const Element& e) {
    if (!tr.in_domain(tr.face(e))) return;
    const typename Tr::Vertex v = tr.apex(e);
    if (!policy_.encroaches(tr, e, tr.point(v))) return;
    const std::size_t s = tr.segment(e);
    for (const auto end : tr.vertices(e))
      if (domain_->are_on_one_shell(tr.carrier(v), tr.point(v), s, tr.point(end))) return;
    set_.add(tr, e, squared_length(tr, e));
  }
  static double squared_length(const Tr& tr, const Element& e) { return squared_distance(tr.point(tr.source(e)), tr.point(tr.target(e))); }

  bool is_protected(const Tr& tr, const Element& e) const {
    return options_.protect_boundary && domain_->segments[tr.segment(e)].bounds_domain;
  }
  /// Why `e` cannot be split, if it cannot.
  std::optional<Reason> obstacle(const Tr& tr, const Element& e) const {
    if (const auto reason = give_up(tr, e)) return reason;
    if (set_.is_given_up(tr, e)) return Reason::precision;
    return std::nullopt;
  }
  /// A point that may not be inserted encroaches `encroached_`: these are to be split. If one of them cannot be, the point must
  /// never be inserted.
  Verdict split_instead(Tr& tr) {
    for (const Element& e : encroached_)
      if (const auto obstacle = this->obstacle(tr, e)) return reason_ = *obstacle, Verdict::rejected_forever;
    for (const Element& e : encroached_) set_.add(tr, e, squared_length(tr, e));
    return Verdict::rejected;
  }

  /// An end of the segment of `e`: taken from a vertex of `e` where it is one, since the domain's own copy is far away in memory.
  Point2 segment_end(const Tr& tr, const Element& e, std::size_t end) const {
    const Carrier carrier{0, domain_->segments[tr.segment(e)].ends[end]};
    for (const auto v : tr.vertices(e))
      if (tr.carrier(v) == carrier) return tr.point(v);
    return domain_->point(tr.segment(e), end);
  }
  /// The sharp end of its segment at which the subsegment ends, if it does.
  std::optional<std::size_t> sharp_end(const Tr& tr, const Element& e) const {
    const PlanarDomain::Segment& s = domain_->segments[tr.segment(e)];
    for (const auto v : tr.vertices(e))
      for (std::size_t end = 0; end < 2; ++end)
        if (s.sharp[end] && tr.carrier(v) == Carrier{0, s.ends[end]}) return end;
    return std::nullopt;
  }

  /// The free vertices in the diametral circle of `e`, on the side of its face: those that are reached from `e` through edges that
  /// meet the circle, and no constraint.
  void collect_free_vertices(const Tr& tr, const Element& e) {
    if (!tr.in_domain(tr.face(e))) return;
    visited_.assign(1, e);
    for (std::size_t k = 0; k < visited_.size() && k < most_faces_searched; ++k) {
      const typename Tr::Vertex v = tr.apex(visited_[k]);
      if (!tr.in_diametral_circle(e, tr.point(v))) continue;
      if (tr.carrier(v).dimension == 2 && !is_listed(v)) free_vertices_.push_back(v);
      for (int i = 0; i < 3; ++i) {
        const Element side = tr.edge(tr.face(visited_[k]), i);
        if (!(side == visited_[k]) && !tr.is_constrained(side)) visited_.push_back(tr.mirror(side));
      }
    }
  }
  bool is_listed(typename Tr::Vertex v) const {
    for (const auto w : free_vertices_)
      if (w == v) return true;
    return false;
  }

  const PlanarDomain* domain_;
  Policy policy_;
  EdgesOptions options_;
  ElementSet<Element, Queue> set_;
  Reason reason_ = Reason::size_floor;
  std::vector<Element> encroached_;
  std::vector<typename Tr::Vertex> free_vertices_;
  std::vector<Element> visited_;
};

}  // namespace delref
