// SPDX-License-Identifier: GPL-3.0-or-later
//
// The faces level of planar meshing: triangles that do not meet the criteria are refined. After Ruppert (1995) and Shewchuk,
// "Delaunay refinement algorithms for triangular mesh generation" (2002).
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

#include <delref/core/proposal.hpp>
#include <delref/core/queue/bucket_queue.hpp>
#include <delref/core/queue/element_set.hpp>
#include <delref/core/verdict.hpp>
#include <delref/criteria/triangle_criteria.hpp>
#include <delref/domain/planar_domain.hpp>
#include <delref/levels/point_choice.hpp>
#include <delref/triangulation/planar_concept.hpp>

namespace delref {

/// Refines every triangle of the domain that does not meet `Criteria`, the one of the shortest edge first if the queue looks at
/// that. A triangle whose shortest edge is as short as a small input angle makes it is left alone, if it is small enough: its
/// point is rejected for ever (section 4.1 of Rineau and Yvinec 2007; Shewchuk 2002). `domain` must outlive the level.
template <PlanarTriangulation Tr, class Criteria, PointChoice2 Points = Circumcentre,
          class Queue = BucketQueue<typename Tr::Face>>
class FacesLevel2 {
 public:
  using Element = typename Tr::Face;

  FacesLevel2(const PlanarDomain& domain, Criteria criteria, Points points = {}, double smallest_edge = 0)
      : domain_(&domain), criteria_(std::move(criteria)), points_(std::move(points)), smallest_edge_(smallest_edge) {}

  std::string_view name() const { return "faces"; }
  void assign_slot(std::size_t k) { set_.assign_slot(k); }
  const Criteria& criteria() const { return criteria_; }

  void scan_triangulation(Tr& tr) {
    set_.clear();
    for (const Element f : tr.domain_faces()) test(tr, f);
  }

  bool empty() const { return set_.empty(); }
  Element next_element() { return set_.front(); }
  void pop_next_element(Tr& tr) { set_.pop(tr); }
  template <class F>
  void for_each_queued(F&& f) const { set_.for_each(f); }
  std::size_t queued() const { return set_.size(); }

  Point2 refinement_point(const Tr& tr, const Element& f) const { return points_.point(shape(tr, f)); }

  std::optional<Reason> give_up(const Tr& tr, const Element& f) const {
    const TriangleShape t = shape(tr, f);
    if (t.shortest_squared() <= square(rounding_floor * rounding_near(t.corners[0]))) return Reason::precision;
    if (smallest_edge_ > 0 && t.shortest_squared() <= smallest_edge_ * smallest_edge_) return Reason::size_floor;
    const auto a = tr.vertex(f, static_cast<int>((t.shortest + 1) % 3)), b = tr.vertex(f, static_cast<int>((t.shortest + 2) % 3));
    if (domain_->is_seditious(tr.carrier(a), tr.point(a), tr.carrier(b), tr.point(b)) && criteria_.is_small_enough(t))
      return Reason::small_input_angle;
    return std::nullopt;
  }
  void on_rejected_forever(Tr& tr, const Element& f, Reason) { set_.give_up(tr, f); }
  std::string_view unmet_criterion(const Tr& tr, const Element& f) const { return criteria_.unmet(shape(tr, f)); }

  Verdict check_refinement_point(Tr&, const Proposal<Tr>&) const { return Verdict::permitted; }
  void before_insertion(Tr& tr, const Proposal<Tr>& proposal) {
    for (const Element f : proposal.zone->dying_faces()) set_.erase(tr, f);
  }
  void after_insertion(Tr& tr, typename Tr::Vertex, const Proposal<Tr>& proposal) {
    for (const Element f : proposal.zone->new_faces())
      if (tr.in_domain(f)) test(tr, f);
  }

 private:
  /// A triangle with an edge of so many roundings of its coordinates is left alone: near it, the computed points are noise.
  static constexpr double rounding_floor = 16;
  static constexpr double square(double x) { return x * x; }

  static TriangleShape shape(const Tr& tr, const Element& f) {
    return {tr.point(tr.vertex(f, 0)), tr.point(tr.vertex(f, 1)), tr.point(tr.vertex(f, 2)), tr.region(f)};
  }
  void test(Tr& tr, const Element& f) {
    const TriangleShape t = shape(tr, f);
    if (!criteria_.is_met(t)) set_.add(tr, f, t.shortest_squared());
  }

  const PlanarDomain* domain_;
  Criteria criteria_;
  Points points_;
  double smallest_edge_;
  ElementSet<Element, Queue> set_;
};

}  // namespace delref
