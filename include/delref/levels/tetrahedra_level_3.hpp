// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tetrahedra level: tetrahedra of the domain that do not meet the criteria are refined by their circumcentres. After Shewchuk,
// "Tetrahedral mesh generation by Delaunay refinement" (1998).
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <delref/core/proposal.hpp>
#include <delref/core/queue/bucket_queue.hpp>
#include <delref/core/queue/element_set.hpp>
#include <delref/core/verdict.hpp>
#include <delref/criteria/tetrahedron_criteria.hpp>
#include <delref/domain/small_angle_guard.hpp>
#include <delref/levels/region_repair.hpp>
#include <delref/triangulation/spatial_concept.hpp>

namespace delref {

/// Refines every tetrahedron of the domain that does not meet `Criteria`, the one of the worst radius-edge ratio first. `repair` and `guard`
/// must outlive the level. A tetrahedron whose shortest edge is as short as a small input angle makes it is left alone, if it is
/// small enough.
template <SpatialTriangulation Tr, class Criteria, class Queue = BucketQueue<typename Tr::Cell>>
class TetrahedraLevel3 {
  using Cell = typename Tr::Cell;

 public:
  using Element = Cell;

  TetrahedraLevel3(Criteria criteria, RegionRepair<Tr>& repair, const SmallAngleGuard& guard, double smallest_edge = 0)
      : criteria_(std::move(criteria)), repair_(&repair), guard_(&guard), smallest_edge_(smallest_edge) {}

  std::string_view name() const { return "tetrahedra"; }
  void assign_slot(std::size_t k) { set_.assign_slot(k); }
  const Criteria& criteria() const { return criteria_; }

  void scan_triangulation(Tr& tr) {
    set_.clear();
    find_floors(tr);
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
    repair_->set_for_size(!criteria_.is_small_enough(t));
    return t.is_flat() ? t.centre_of_largest_face() : t.circumcentre;
  }

  std::optional<Reason> give_up(const Tr& tr, const Element& c) const {
    const TetrahedronShape t = shape(tr, c);
    const double rounding = 16 * PolyhedralDomain::rounding_near(t.corners[0]);
    if (t.shortest_squared <= rounding * rounding) return Reason::precision;
    if (smallest_edge_ > 0 && t.shortest_squared <= smallest_edge_ * smallest_edge_) return Reason::size_floor;
    if ((t.is_flat() || is_below_floor(tr, c, t)) && criteria_.is_small_enough(t) && is_at_small_angle(tr, c))
      return Reason::small_input_angle;
    return std::nullopt;
  }
  void on_rejected_forever(Tr& tr, const Element& c, Reason) { set_.give_up(tr, c); }
  std::string_view unmet_criterion(const Tr& tr, const Element& c) const {
    const std::string_view unmet = criteria_.unmet(shape(tr, c));
    return unmet.empty() ? "flat tetrahedron" : unmet;
  }

  /// A point whose zone reaches beyond the region of its tetrahedron would be outside the domain or behind a facet.
  Verdict check_refinement_point(Tr& tr, const Proposal<Tr>& proposal) {
    if (proposal.carrier.dimension < 3) return Verdict::permitted;
    const int region = tr.region(proposal.zone->dying_cells().front());
    for (const Cell c : proposal.zone->dying_cells())
      if (tr.region(c) != region || region < 0) return Verdict::rejected_forever;
    return Verdict::permitted;
  }
  Reason rejection_reason() const { return Reason::outside; }

  void before_insertion(Tr& tr, const Proposal<Tr>& proposal) {
    for (const Cell c : proposal.zone->dying_cells()) set_.erase(tr, c);
  }
  void after_insertion(Tr& tr, typename Tr::Vertex v, const Proposal<Tr>& proposal) {
    set_floor(tr, v, proposal.zone->new_cells());
    for (const Cell c : proposal.zone->new_cells()) test(tr, c);
    for (const Cell c : repair_->settled()) test(tr, c);
  }

 private:
  static TetrahedronShape shape(const Tr& tr, const Element& c) {
    const auto v = tr.vertices(c);
    return TetrahedronShape({tr.point(v[0]), tr.point(v[1]), tr.point(v[2]), tr.point(v[3])}, tr.region(c));
  }
  void test(Tr& tr, const Element& c) {
    if (tr.region(c) < 0) return set_.erase(tr, c);
    const TetrahedronShape t = shape(tr, c);
    if (t.is_flat() || !criteria_.is_met(t)) set_.add(tr, c, t.is_flat() ? 0 : t.shortest_squared / t.squared_circumradius);
  }
  /// The floor of a vertex is a fraction of the local feature size that the conforming triangulation shows there: without small
  /// input angles no edge falls below it, and near one the refinement is to end at it.
  static constexpr double floor_part = 0.125, slope = 0.125;
  void find_floors(const Tr& tr) {
    floors_.assign(tr.number_of_vertices(), std::numeric_limits<float>::infinity());
    for (const Cell c : tr.finite_cells()) {
      if (tr.region(c) < 0) continue;
      for (int i = 0; i < 3; ++i)
        for (int j = i + 1; j < 4; ++j) {
          const auto a = tr.vertex(c, i), b = tr.vertex(c, j);
          const auto part = static_cast<float>(floor_part * std::sqrt(squared_distance(tr.point(a), tr.point(b))));
          floor(tr, a) = std::min(floor(tr, a), part);
          floor(tr, b) = std::min(floor(tr, b), part);
        }
    }
  }
  float& floor(const Tr& tr, typename Tr::Vertex v) {
    const std::size_t i = tr.index(v);
    if (i >= floors_.size()) floors_.resize(i + i / 2 + 1, std::numeric_limits<float>::infinity());
    return floors_[i];
  }
  /// What is inserted to make tetrahedra smaller makes features smaller.
  void set_floor(const Tr& tr, typename Tr::Vertex v, std::span<const Cell> cells) {
    float lowest = std::numeric_limits<float>::infinity();
    for (const Cell c : cells)
      for (int i = 0; i < 3; ++i) {  // the new vertex is the last one
        const auto u = tr.vertex(c, i);
        if (tr.is_infinite(u)) continue;
        const auto length = static_cast<float>(std::sqrt(squared_distance(tr.point(u), tr.point(v))));
        float& at = floor(tr, u);
        if (repair_->is_for_size()) at = std::min(at, static_cast<float>(floor_part) * length);
        lowest = std::min(lowest, at + static_cast<float>(slope) * length);
      }
    floor(tr, v) = lowest;
  }
  bool is_below_floor(const Tr& tr, const Element& c, const TetrahedronShape& t) const {
    float lowest = std::numeric_limits<float>::infinity();
    for (const auto v : tr.vertices(c)) lowest = std::min(lowest, floors_[tr.index(v)]);
    return t.shortest_squared < double{lowest} * double{lowest};
  }
  /// Whether two of its corners are on input elements that meet under a small angle.
  bool is_at_small_angle(const Tr& tr, const Element& c) const {
    const auto v = tr.vertices(c);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = i + 1; j < 4; ++j)
        if (guard_->meet(tr.carrier(v[i]), tr.carrier(v[j]))) return true;
    return false;
  }

  Criteria criteria_;
  RegionRepair<Tr>* repair_;
  const SmallAngleGuard* guard_;
  double smallest_edge_;
  ElementSet<Element, Queue> set_;
  std::vector<float> floors_;  // by vertex number
};

}  // namespace delref
