// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a kind of domain has to say about the refinement of its tetrahedra: a policy of `TetrahedraLevel3`.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include <delref/core/carrier.hpp>
#include <delref/core/proposal.hpp>
#include <delref/core/verdict.hpp>
#include <delref/criteria/tetrahedron_shape.hpp>
#include <delref/domain/small_angle_guard.hpp>
#include <delref/levels/region_repair.hpp>
#include <delref/triangulation/spatial_concept.hpp>

namespace delref {

/// The rules of a domain whose cells are labelled by a level of higher priority (`SurfaceLevel3`): none beyond the criteria.
template <SpatialTriangulation Tr>
struct LabelledCells {
  using Cell = typename Tr::Cell;
  /// Before the first step.
  void scan(const Tr&) {}
  /// The cell is the next whose refinement point is proposed; `for_size` when it is too large.
  void proposes(bool /*for_size*/) {}
  Location<Tr> conflict_zone(Tr& tr, const Cell& c, Point3 p, typename Tr::Zone& zone) const { return tr.conflict_zone(p, typename Tr::Hint(c), zone); }
  /// Why a tetrahedron that is small enough has to stay as it is.
  std::optional<Reason> excuse(const Tr&, const Cell&, const TetrahedronShape&) const { return std::nullopt; }
  /// What must not be inserted, though no level above it is encroached.
  Verdict check(const Tr&, const Proposal<Tr>&) const { return Verdict::permitted; }
  void after_insertion(const Tr&, typename Tr::Vertex, const Proposal<Tr>&) {}
  /// Cells other than new ones that have another region since the last insertion.
  std::span<const Cell> relabelled() const { return {}; }
  /// Whether a cell is in the domain, or may turn out to be.
  bool may_be_inside(const Tr& tr, const Cell& c) const { return tr.region(c) >= 0; }
};

/// The rules of a polyhedral domain: near small input angles, where refinement would go on for ever, a tetrahedron is left alone when
/// its shortest edge is a small part of the local feature size that the conforming triangulation showed; so is a tiny one in a thin place;
/// and no point enters a region that its tetrahedron is not in. `repair` and `guard` must outlive the rules.
template <SpatialTriangulation Tr>
class PolyhedralCells {
  using Cell = typename Tr::Cell;
  using Vertex = typename Tr::Vertex;

 public:
  PolyhedralCells(RegionRepair<Tr>& repair, const SmallAngleGuard& guard) : repair_(&repair), guard_(&guard) {}

  /// The floor of a vertex is a fraction of the local feature size: without small input angles no edge falls below it, and near one
  /// the refinement is to end at it.
  void scan(const Tr& tr) {
    floors_.assign(tr.number_of_vertices(), infinity);
    for (auto& tight : tight_) tight.clear();
    for (const Cell c : tr.finite_cells()) {
      note_tight(tr, c);
      if (tr.region(c) < 0) continue;
      for (int i = 0; i < 3; ++i)
        for (int j = i + 1; j < 4; ++j) {
          const Vertex a = tr.vertex(c, i), b = tr.vertex(c, j);
          const auto part = static_cast<float>(floor_part * std::sqrt(squared_distance(tr.point(a), tr.point(b))));
          floor(tr, a) = std::min(floor(tr, a), part);
          floor(tr, b) = std::min(floor(tr, b), part);
        }
    }
  }
  void proposes(bool for_size) { repair_->set_for_size(for_size); }
  std::optional<Reason> excuse(const Tr& tr, const Cell& c, const TetrahedronShape& t) const {
    const bool is_tiny = t.shortest_squared < guard_->thin_places().squared_floor();
    if ((is_tiny || t.is_flat() || is_below_floor(tr, c, t)) && is_at_small_angle(tr, c)) return Reason::small_input_angle;
    if (is_tiny && is_at_thin_place(tr, c)) return Reason::size_floor;
    return std::nullopt;
  }
  /// Up to the facets, if the triangulation can: a facet that is in the way is to be refined whatever is behind it.
  Location<Tr> conflict_zone(Tr& tr, const Cell& c, Point3 p, typename Tr::Zone& zone) const {
    if constexpr (requires { tr.conflict_zone_up_to_marks(p, typename Tr::Hint(c), zone); })
      return tr.conflict_zone_up_to_marks(p, typename Tr::Hint(c), zone);
    else return tr.conflict_zone(p, typename Tr::Hint(c), zone);
  }
  /// A point whose zone reaches beyond the region of its tetrahedron would be outside the domain or behind a facet.
  Verdict check(const Tr& tr, const Proposal<Tr>& proposal) const {
    if (proposal.carrier.dimension < 3) return Verdict::permitted;
    const int region = tr.region(proposal.zone->dying_cells().front());
    for (const Cell c : proposal.zone->dying_cells())
      if (tr.region(c) != region || region < 0) return Verdict::rejected_forever;
    return Verdict::permitted;
  }
  /// What is inserted to make tetrahedra smaller makes features smaller.
  void after_insertion(const Tr& tr, Vertex v, const Proposal<Tr>& proposal) {
    float lowest = infinity;
    for (const Cell c : proposal.zone->new_cells())
      for (int i = 0; i < 3; ++i) {  // the new vertex is the last one
        const Vertex u = tr.vertex(c, i);
        if (tr.is_infinite(u)) continue;
        const auto length = static_cast<float>(std::sqrt(squared_distance(tr.point(u), tr.point(v))));
        float& at = floor(tr, u);
        if (repair_->is_for_size()) at = std::min(at, static_cast<float>(floor_part) * length);
        lowest = std::min(lowest, at + static_cast<float>(slope) * length);
      }
    floor(tr, v) = lowest;
  }
  std::span<const Cell> relabelled() const { return repair_->settled(); }
  bool may_be_inside(const Tr& tr, const Cell& c) const { return tr.region(c) >= 0 || repair_->is_unsure(tr, c); }

 private:
  static constexpr double floor_part = 0.125, slope = 0.125;
  static constexpr float infinity = std::numeric_limits<float>::infinity();

  float& floor(const Tr& tr, Vertex v) {
    const std::size_t i = tr.index(v);
    if (i >= floors_.size()) floors_.resize(i + i / 2 + 1, infinity);
    return floors_[i];
  }
  bool is_below_floor(const Tr& tr, const Cell& c, const TetrahedronShape& t) const {
    float lowest = infinity;
    for (const Vertex v : tr.vertices(c)) lowest = std::min(lowest, floors_[tr.index(v)]);
    return t.shortest_squared < double{lowest} * double{lowest};
  }
  /// Whether two of its corners are on input elements that meet under a small angle.
  bool is_at_small_angle(const Tr& tr, const Cell& c) const {
    const auto v = tr.vertices(c);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = i + 1; j < 4; ++j)
        if (guard_->meet(tr.carrier(v[i]), tr.carrier(v[j]))) return true;
    return false;
  }
  /// Whether two vertices are on input elements that are nearer to each other than the floor of thin places, though they do not touch,
  /// or because they meet at a small angle.
  bool is_tight(const Tr& tr, Vertex a, Vertex b) const {
    const double length = squared_distance(tr.point(a), tr.point(b));
    if (!(length < guard_->thin_places().squared_floor())) return false;
    const Carrier on_a = tr.carrier(a), on_b = tr.carrier(b);
    return guard_->thin_places().has_edge(on_a, on_b, length) || guard_->meet(on_a, on_b);
  }
  void note_tight(const Tr& tr, const Cell& c) {
    const auto v = tr.vertices(c);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = i + 1; j < 4; ++j)
        if (is_tight(tr, v[i], v[j]))
          for (const Carrier on : {tr.carrier(v[i]), tr.carrier(v[j])}) {
            auto& tight = tight_[on.dimension];
            if (tight.size() <= on.index) tight.resize(on.index + 1);
            tight[on.index] = true;
          }
  }
  /// Whether it has an edge between two such elements, or a corner on an element that another was as near to at the beginning.
  bool is_at_thin_place(const Tr& tr, const Cell& c) const {
    const auto v = tr.vertices(c);
    for (std::size_t i = 0; i < 4; ++i) {
      const Carrier on = tr.carrier(v[i]);
      if (on.dimension < 3 && on.index < tight_[on.dimension].size() && tight_[on.dimension][on.index]) return true;
      for (std::size_t j = i + 1; j < 4; ++j)
        if (is_tight(tr, v[i], v[j])) return true;
    }
    return false;
  }

  RegionRepair<Tr>* repair_;
  const SmallAngleGuard* guard_;
  std::vector<float> floors_;  // by vertex number
  std::array<std::vector<bool>, 3> tight_;  // by dimension and index of the input elements
};

}  // namespace delref
