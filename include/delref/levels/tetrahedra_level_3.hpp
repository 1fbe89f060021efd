// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tetrahedra level: tetrahedra of the domain that do not meet the criteria are refined by their circumcentres. After Shewchuk,
// "Tetrahedral mesh generation by Delaunay refinement" (1998), of polyhedra, and Oudot, Rineau and Yvinec, "Meshing volumes bounded by
// smooth surfaces" (2005), of smooth domains.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include <delref/core/proposal.hpp>
#include <delref/core/queue/bucket_queue.hpp>
#include <delref/core/queue/element_set.hpp>
#include <delref/core/verdict.hpp>
#include <delref/criteria/tetrahedron_criteria.hpp>
#include <delref/levels/cell_rules.hpp>
#include <delref/triangulation/spatial_concept.hpp>

namespace delref {

/// Refines every tetrahedron of the domain that does not meet `Criteria`, the largest ones and the worst radius-edge ratios first. `Rules` is what the
/// domain adds to that: `PolyhedralCells` near small input angles, `LabelledCells` nothing. A tetrahedron whose shortest edge is not
/// longer than `smallest_edge` is left alone.
template <SpatialTriangulation Tr, class Criteria, class Rules = PolyhedralCells<Tr>, class Queue = BucketQueue<typename Tr::Cell>>
class TetrahedraLevel3 {
  using Cell = typename Tr::Cell;

 public:
  using Element = Cell;

  TetrahedraLevel3(Criteria criteria, Rules rules, double smallest_edge = 0)
      : criteria_(std::move(criteria)), rules_(std::move(rules)), smallest_edge_(smallest_edge) {}
  /// Of a polyhedral domain.
  TetrahedraLevel3(Criteria criteria, RegionRepair<Tr>& repair, const SmallAngleGuard& guard, double smallest_edge = 0)
      : TetrahedraLevel3(std::move(criteria), Rules(repair, guard), smallest_edge) {}

  std::string_view name() const { return "tetrahedra"; }
  void assign_slot(std::size_t k) { set_.assign_slot(k); }
  const Criteria& criteria() const { return criteria_; }

  void scan_triangulation(Tr& tr) {
    set_.clear();
    rules_.scan(tr);
    for (const Cell c : tr.finite_cells()) test(tr, c);
  }

  bool empty() const { return set_.empty(); }
  std::size_t queued() const { return set_.size(); }
  Element next_element() { return set_.front(); }
  void pop_next_element(Tr& tr) { set_.pop(tr); }
  template <class F>
  void for_each_queued(F&& f) const { set_.for_each(f); }

  /// The circumcentre; for a flat tetrahedron, whose own is noise, the centre of the circle that its corners are on.
  Point3 refinement_point(const Tr& tr, const Element& c) {
    const TetrahedronShape t = shape(tr, c);
    rules_.proposes(!criteria_.is_small_enough(t));
    return t.is_flat() ? t.centre_of_largest_face() : t.circumcentre;
  }

  Location<Tr> conflict_zone(Tr& tr, const Element& c, Point3 p, typename Tr::Zone& zone) const { return rules_.conflict_zone(tr, c, p, zone); }

  /// A cell may turn out to be outside the domain: it is no element any more.
  bool holds(const Tr& tr, std::span<const typename Tr::Vertex> v) const {
    const auto f = tr.find_facet(v[0], v[1], v[2]);
    if (!f) return false;
    for (const auto& side : {*f, tr.mirror(*f)})
      if (tr.apex(side) == v[3]) return rules_.may_be_inside(tr, tr.cell(side));
    return false;
  }
  std::optional<Reason> give_up(const Tr& tr, const Element& c) const {
    const TetrahedronShape t = shape(tr, c);
    const double rounding = 16 * rounding_near(t.corners[0]);
    if (t.shortest_squared <= rounding * rounding) return Reason::precision;
    if (smallest_edge_ > 0 && t.shortest_squared <= smallest_edge_ * smallest_edge_) return Reason::size_floor;
    return criteria_.is_small_enough(t) ? rules_.excuse(tr, c, t) : std::nullopt;
  }
  void on_rejected_forever(Tr& tr, const Element& c, Reason) { set_.give_up(tr, c); }
  std::string_view unmet_criterion(const Tr& tr, const Element& c) const {
    const std::string_view unmet = criteria_.unmet(shape(tr, c));
    return unmet.empty() ? "flat tetrahedron" : unmet;
  }

  Verdict check_refinement_point(Tr& tr, const Proposal<Tr>& proposal) { return rules_.check(tr, proposal); }
  Reason rejection_reason() const { return Reason::outside; }

  void before_insertion(Tr& tr, const Proposal<Tr>& proposal) {
    for (const Cell c : proposal.zone->dying_cells()) set_.erase(tr, c);
  }
  void after_insertion(Tr& tr, typename Tr::Vertex v, const Proposal<Tr>& proposal) {
    rules_.after_insertion(tr, v, proposal);
    for (const Cell c : proposal.zone->new_cells()) test(tr, c);
    for (const Cell c : rules_.relabelled()) test(tr, c);
  }

 private:
  static TetrahedronShape shape(const Tr& tr, const Element& c) {
    const auto v = tr.vertices(c);
    return TetrahedronShape({tr.point(v[0]), tr.point(v[1]), tr.point(v[2]), tr.point(v[3])}, tr.region(c));
  }
  void test(Tr& tr, const Element& c) {
    if (tr.region(c) < 0) return set_.erase(tr, c);
    const TetrahedronShape t = shape(tr, c);
    if (t.is_flat() || !criteria_.is_met(t)) set_.add(tr, c, priority(t));
  }
  /// Flat ones first, then those that are too large, the largest first; then the worst ratio, of equal ones the largest. All this gives
  /// fewer vertices than one order by ratio.
  double priority(const TetrahedronShape& t) const {
    if (t.is_flat()) return 0;
    constexpr double before_ratios = 1e-200;
    return criteria_.is_small_enough(t) ? t.shortest_squared / (t.squared_circumradius * t.squared_circumradius) : before_ratios / t.squared_circumradius;
  }

  Criteria criteria_;
  Rules rules_;
  double smallest_edge_;
  ElementSet<Element, Queue> set_;
};

template <SpatialTriangulation Tr, class Criteria>
TetrahedraLevel3(Criteria, RegionRepair<Tr>&, const SmallAngleGuard&) -> TetrahedraLevel3<Tr, Criteria>;
template <SpatialTriangulation Tr, class Criteria>
TetrahedraLevel3(Criteria, RegionRepair<Tr>&, const SmallAngleGuard&, double) -> TetrahedraLevel3<Tr, Criteria>;

}  // namespace delref
