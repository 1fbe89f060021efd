// SPDX-License-Identifier: GPL-3.0-or-later
//
// The surface level: cells have the label that an oracle gives their circumcentre, and the facets between cells of different labels are
// refined by the centres of their surface balls until they meet the criteria and are a manifold. After Boissonnat and Oudot,
// "Provably good sampling and meshing of surfaces" (2005), and Cheng, Dey, Ramos and Ray (2007) for the topology.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
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
#include <delref/criteria/surface_facet_criteria.hpp>
#include <delref/domain/oracle.hpp>
#include <delref/levels/cell_labels.hpp>
#include <delref/levels/surface_complex.hpp>
#include <delref/levels/umbrella.hpp>
#include <delref/triangulation/spatial_concept.hpp>

namespace delref {

/// What a `SurfaceLevel3` does beside its criteria. Lengths in the unit of the input.
struct SurfaceLevelOptions {
  /// A facet whose surface ball is not larger is left as it is: where the surface has creases nothing else ends the refinement.
  double smallest_radius = 0;
  /// How exactly the surface is found: this part of the shortest edge of a facet, or of `usual_size` where that is less, since facets
  /// become smaller and their vertices stay.
  double tolerance = 1e-6;
  double usual_size = std::numeric_limits<double>::infinity();
  /// Whether the facets at every vertex have to be a topological disk.
  bool manifold = true;
};

/// Refines the facets between the regions of an oracle until they meet `Criteria`, their vertices are on the surface, and the facets at each
/// vertex are a disk, the largest surface ball first. Labels the cells. The oracle must outlive the level.
template <SpatialTriangulation Tr, Oracle O, class Criteria, class Queue = BucketQueue<typename Tr::Facet>>
class SurfaceLevel3 {
  using Vertex = typename Tr::Vertex;
  using Cell = typename Tr::Cell;
  using Facet = typename Tr::Facet;
  using Complex = SurfaceComplex<Tr>;
  using Record = typename Complex::Record;

 public:
  using Element = Facet;

  SurfaceLevel3(const O& oracle, Criteria criteria, SurfaceLevelOptions options = {})
      : labels_(oracle), criteria_(std::move(criteria)), options_(options) {}

  std::string_view name() const { return "surface"; }
  void assign_slot(std::size_t k) { complex_.assign_slot(k); }
  const Criteria& criteria() const { return criteria_; }
  /// The facets of the surface, as they are now.
  const Complex& complex() const { return complex_; }

  void scan_triangulation(Tr& tr) {
    set_.clear();
    complex_.clear();
    suspects_.clear();
    is_suspect_.assign(tr.number_of_vertices() + 1, false);
    labels_.label_all(tr);
    for (const Cell c : tr.finite_cells())
      for (int i = 0; i < 4; ++i) add_if_surface(tr, tr.facet(c, i));
    settle(tr);
  }

  bool empty() const { return set_.empty(); }
  std::size_t queued() const { return set_.size(); }
  Element next_element() { return set_.front(); }
  void pop_next_element(Tr& tr) { set_.pop(places(tr)); }
  template <class F>
  void for_each_queued(F&& f) const { set_.for_each(f); }

  Point3 refinement_point(const Tr& tr, const Element& f) const { return record(tr, f).centre; }
  Carrier carrier(const Tr&, const Element&) const { return {2, 0}; }

  /// The facet itself may stay, with a dual edge that ends before the point.
  bool dies(const Tr& tr, const Element& f, const typename Tr::Zone& zone) const {
    return tr.dies(tr.cell(f), zone) || tr.dies(tr.cell(tr.mirror(f)), zone);
  }

  std::optional<Reason> give_up(const Tr& tr, const Element& f) const {
    const Record& r = record(tr, f);
    const double rounding = 32 * std::numeric_limits<double>::epsilon() *
                            std::max({std::abs(r.centre.x), std::abs(r.centre.y), std::abs(r.centre.z)});
    if (r.squared_radius <= rounding * rounding) return Reason::precision;
    if (r.squared_radius <= options_.smallest_radius * options_.smallest_radius) return Reason::size_floor;
    return std::nullopt;
  }
  void on_rejected_forever(Tr& tr, const Element& f, Reason) {
    set_.give_up(places(tr), f);
    suspect_corners(tr, f);
    settle(tr);
  }
  std::string_view unmet_criterion(const Tr& tr, const Element& f) const {
    if (!has_corners_on_surface(tr, f)) return "vertices on the surface";
    const std::string_view unmet = criteria_.unmet(shape(tr, record(tr, f)));
    return unmet.empty() ? "topological disk" : unmet;
  }

  /// A point of a level below that is in a surface ball refines the surface instead.
  Verdict check_refinement_point(Tr& tr, const Proposal<Tr>& proposal) {
    if (proposal.carrier.dimension < 3) return Verdict::permitted;
    Verdict verdict = Verdict::permitted;
    for (const Cell c : proposal.zone->dying_cells())
      for (int i = 0; i < 4; ++i) {
        const Facet f = tr.facet(c, i);
        if (!complex_.contains(tr, f)) continue;
        const Record& r = record(tr, f);
        if (squared_distance(proposal.point, r.centre) >= r.squared_radius) continue;
        if (set_.is_given_up(places(tr), f)) return Verdict::rejected_forever;
        set_.add(places(tr), f, 0);
        verdict = Verdict::rejected;
      }
    return verdict;
  }
  Reason rejection_reason() const { return Reason::size_floor; }

  void before_insertion(Tr& tr, const Proposal<Tr>& proposal) {
    for (const Cell c : proposal.zone->dying_cells())
      for (int i = 0; i < 4; ++i) {
        const Facet f = tr.facet(c, i);
        if (complex_.contains(tr, f) && tr.dies(f, *proposal.zone)) remove(tr, f);
      }
  }
  void after_insertion(Tr& tr, Vertex v, const Proposal<Tr>& proposal) {
    const std::span<const Cell> cells = proposal.zone->new_cells();
    labels_.label(tr, cells);
    for (const Cell c : cells) {
      const int apex = tr.index(c, v);
      for (int i = 0; i < 4; ++i)
        if (i == apex) update_wall(tr, tr.facet(c, i), proposal.point);
        else add_if_surface(tr, tr.facet(c, i));
    }
    settle(tr);
  }

 private:
  /// Lets the set keep its positions in the complex: the slots of the facets hold their numbers there.
  struct Places {
    const Tr* tr;
    Complex* complex;
    QueuePosition slot(const Facet& f, std::size_t) const { return (*complex)[complex->number(*tr, f)].position; }
    void set_slot(const Facet& f, std::size_t, QueuePosition position) const {
      (*complex)[complex->number(*tr, f)].position = position;
    }
  };
  Places places(const Tr& tr) { return {&tr, &complex_}; }

  const Record& record(const Tr& tr, const Facet& f) const { return complex_[complex_.number(tr, f)]; }
  static SurfaceFacetShape shape(const Tr& tr, const Record& r) {
    const auto v = tr.vertices(r.facet);
    return {{tr.point(v[0]), tr.point(v[1]), tr.point(v[2])}, r.centre, r.regions};
  }
  static bool has_corners_on_surface(const Tr& tr, const Facet& f) {
    for (const Vertex v : tr.vertices(f))
      if (tr.carrier(v).dimension == 3 || tr.carrier(v) == Carrier{}) return false;
    return true;
  }

  /// A facet next to the hole: its dual edge has become shorter, but ends where it did if its surface ball is still empty.
  void update_wall(Tr& tr, const Facet& f, Point3 inserted) {
    const Facet m = tr.mirror(f);
    if (!complex_.contains(tr, f)) {
      add_if_surface(tr, f);
      add_if_surface(tr, m);
      return;
    }
    Record& r = complex_[complex_.number(tr, f)];
    r.facet = m;
    set_.rename(places(tr), m);
    if (sides(tr, f) == r.regions && squared_distance(inserted, r.centre) >= r.squared_radius) return;
    remove(tr, m);
    add_if_surface(tr, f);
    add_if_surface(tr, m);
  }
  static std::array<int, 2> sides(const Tr& tr, const Facet& f) {
    const int a = tr.region(tr.cell(f)), b = tr.region(tr.cell(tr.mirror(f)));
    return {std::max(a, b), std::min(a, b)};
  }

  /// Called with a facet as seen from both of its sides; that of the greater region counts.
  void add_if_surface(Tr& tr, const Facet& f) {
    const Facet m = tr.mirror(f);
    const int region = tr.region(tr.cell(f)), other = tr.region(tr.cell(m));
    if (region <= other || complex_.contains(tr, f)) return;
    const auto v = tr.vertices(f);
    Record r{f, v, {}, 0, {region, other}, -1, {}};
    const std::array<Point3, 3> corners{tr.point(v[0]), tr.point(v[1]), tr.point(v[2])};
    const double shortest = std::min({squared_distance(corners[0], corners[1]), squared_distance(corners[0], corners[2]),
                                      squared_distance(corners[1], corners[2])});
    r.centre = labels_.surface_centre(tr, f, options_.tolerance * std::min(std::sqrt(shortest), options_.usual_size));
    const SurfaceFacetShape s(corners, r.centre, r.regions);
    r.squared_radius = s.squared_radius;
    complex_.add(tr, r);
    suspect_corners(tr, f);
    if (!has_corners_on_surface(tr, f) || !criteria_.is_met(s)) set_.add(places(tr), f, 1 / s.squared_radius);
  }
  void remove(Tr& tr, const Facet& f) {
    suspect_corners(tr, f);
    set_.erase(places(tr), f);
    complex_.remove(tr, f);
  }

  // -- topology: looked at when everything else is met, and only from then on kept
  void suspect_corners(const Tr& tr, const Facet& f) {
    if (!options_.manifold || !complex_.is_linked()) return;
    for (const Vertex v : tr.vertices(f)) {
      const std::size_t i = tr.index(v);
      if (i >= is_suspect_.size()) is_suspect_.resize(i + i / 2 + 1, false);
      if (is_suspect_[i]) continue;
      is_suspect_[i] = true;
      suspects_.push_back(v);
    }
  }
  /// With an empty set, looks for a vertex whose facets are no disk, and puts the largest of these into the set.
  void settle(Tr& tr) {
    if (!set_.empty()) return;
    if (!complex_.is_linked()) {
      complex_.link(tr);
      complex_.for_each([&](const Record& r) { suspect_corners(tr, r.facet); });
    }
    while (set_.empty() && !suspects_.empty()) {
      const Vertex v = suspects_.back();
      suspects_.pop_back();
      is_suspect_[tr.index(v)] = false;
      if (const auto f = largest_facet_of_no_disk(tr, v)) set_.add(places(tr), *f, 1);
    }
  }
  std::optional<Facet> largest_facet_of_no_disk(const Tr& tr, Vertex v) {
    umbrella_.clear();
    std::optional<Facet> largest;
    double squared_radius = 0;
    complex_.for_each_at(tr, v, [&](QueuePosition i) {
      const Record& r = complex_[i];
      const std::size_t k = r.corners[0] == v ? 0 : r.corners[1] == v ? 1 : 2;
      umbrella_.add(r.regions, tr.index(r.corners[(k + 1) % 3]), tr.index(r.corners[(k + 2) % 3]));
      if (r.position == ElementSet<Facet, Queue>::given_up || r.squared_radius <= squared_radius) return;
      squared_radius = r.squared_radius;
      largest = r.facet;
    });
    return umbrella_.is_disk() ? std::nullopt : largest;
  }

  CellLabels<Tr, O> labels_;
  Criteria criteria_;
  SurfaceLevelOptions options_;
  Complex complex_;
  ElementSet<Facet, Queue> set_;
  std::vector<Vertex> suspects_;
  std::vector<bool> is_suspect_;  // by vertex number
  Umbrella umbrella_;
};

}  // namespace delref
