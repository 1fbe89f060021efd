// SPDX-License-Identifier: GPL-3.0-or-later
//
// The refinement of a smooth domain in the hands of its caller: every component of its surface gets seeds, the surface and the volume
// are refined, and components that this missed are seeded again. `mesh_smooth_domain` is the short way for those who want none of this.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <delref/algorithms/check_smooth_options.hpp>
#include <delref/algorithms/extract_smooth_mesh.hpp>
#include <delref/algorithms/smooth_levels.hpp>
#include <delref/algorithms/smooth_options.hpp>
#include <delref/core/mesher.hpp>
#include <delref/domain/anchor_points.hpp>
#include <delref/domain/describe.hpp>
#include <delref/domain/invalid_input.hpp>
#include <delref/domain/oracle.hpp>
#include <delref/domain/region_points.hpp>
#include <delref/domain/sampled_components.hpp>
#include <delref/triangulation/delaunay_3.hpp>

namespace delref {

/// The label of a region in meshes: what the oracle calls it, where it has names (`region_labels()`), otherwise one more than its number.
template <Oracle O>
std::vector<int> region_labels(const O& oracle, std::size_t count) {
  std::vector<int> labels;
  if constexpr (requires { oracle.region_labels(); })
    for (const int label : oracle.region_labels()) labels.push_back(label);
  while (labels.size() < count) labels.push_back(static_cast<int>(labels.size()) + 1);
  return labels;
}

/// How many components of the surface there are, as far as they were found before meshing, and what became of them.
struct ComponentCounts {
  std::size_t found = 0;
  std::size_t seeded_again = 0;  ///< that the first seeds did not bring into the mesh
  std::size_t missed = 0;        ///< that no seeds brought into it
  std::size_t loose_vertices = 0;  ///< vertices on the surface that are corners of no facet: there the mesh lacks a part of the surface
  std::size_t lost_regions = 0;  ///< of which the mesh has less than about a quarter
  std::string method;            ///< how they were found
  bool is_exact = false;         ///< every one was found, by proof
};

/// The refinement of a smooth domain as an object. Nothing is refined until `refine` is called.
///
/// `Tr` is the triangulation type; leave it away: `SmoothRefinement refinement(oracle, options);`. Observers see the run
/// (`core/observer.hpp`); levels are numbered surface 0, tetrahedra 1. The oracle must outlive the refinement.
template <Oracle O, class Tr = Delaunay3<1, 1>>
class SmoothRefinement {
  using SurfaceOnly = decltype(Mesher(std::declval<Tr&>(), surface_levels<Tr>(std::declval<const O&>(), std::declval<const SmoothOptions&>())));
  using Volume = decltype(Mesher(std::declval<Tr&>(), volume_levels<Tr>(std::declval<const O&>(), std::declval<const SmoothOptions&>())));

 public:
  using Triangulation = Tr;

  /// Finds and seeds the components of the surface. Throws `InvalidInput` when the options cannot be met, the bounds are no box or
  /// there is no surface, and `Interrupted` when the control says stop.
  explicit SmoothRefinement(const O& oracle, SmoothOptions options = {}, const Control& control = Control{})
      : oracle_(&oracle), tr_(std::make_unique<Tr>()) {
    check_smooth_options(options);
    const BoundingBox3 bounds = oracle.bounds();
    check_bounds(bounds);
    components_ = find_components(control);
    counts_.found = components_.components.size();
    counts_.method = components_.method;
    counts_.is_exact = components_.is_exact;
    BoundingBox3 surface;
    for (const auto& component : components_.components)
      for (const Point3 p : component) surface.extend(p);
    options_ = with_default_sizes(std::move(options), surface, notes_);
    anchor_reach_ = std::isfinite(options_.facet_size) ? std::min(options_.facet_size, surface.extent() / 20) : surface.extent() / 20;
    region_points_ = region_points(oracle, bounds.extent() / 64, 16, control);
    insert_corners(bounds);
    for (const auto& component : components_.components) insert_seeds(component, first_seeds);
    if (options_.surface_only) surface_.emplace(*tr_, surface_levels<Tr>(oracle, options_));
    else volume_.emplace(*tr_, volume_levels<Tr>(oracle, options_, control.budget().smallest_edge));
  }

  /// Refines until nothing is left to do or the control says stop; may be called again to go on.
  template <class... Observers>
  Outcome<Point3> refine(const Control& control = Control{}, Observers&... observers) {
    for (int round = 0;; ++round) {
      Outcome<Point3> outcome = surface_ ? surface_->refine(control, observers...) : volume_->refine(control, observers...);
      const Coverage coverage = look_at_coverage();
      if (round == 0) counts_.seeded_again = outcome.stopped ? 0 : coverage.missed.size();
      counts_.missed = coverage.missed.size();
      counts_.loose_vertices = coverage.loose.size();
      counts_.lost_regions = coverage.lost_regions.size();
      const bool is_enough = round >= (coverage.missed.empty() && coverage.lost_regions.empty() ? rounds_for_loose_vertices : rounds_for_components);
      if (outcome.stopped || is_enough || !seed_again(coverage, control)) return outcome;
      if (surface_) surface_->scan(observers...);
      else volume_->scan(observers...);
    }
  }

  bool done() const { return surface_ ? surface_->done() : volume_->done(); }
  Outcome<Point3> outcome() const { return surface_ ? surface_->outcome() : volume_->outcome(); }

  /// The mesh as it is now. Linear time.
  TetrahedralMesh mesh() const {
    const auto patches = this->patches();
    std::size_t regions = 0;
    for (const SurfacePatch& p : patches) regions = std::max(regions, static_cast<std::size_t>(p.regions[0] + 1));
    std::vector<std::string> names{"surface"};
    if (volume_) names.emplace_back("tetrahedra");
    return extract_smooth_mesh(*tr_, complex(), patches, region_labels(*oracle_, regions), surface_.has_value(), std::move(names));
  }
  /// Between which regions the triangles of the mesh are: the marker of a triangle is one more than its number here.
  std::vector<SurfacePatch> patches() const { return surface_patches(complex()); }

  const Tr& triangulation() const { return *tr_; }
  const SurfaceComplex<Tr>& complex() const { return surface_ ? surface_->template level<0>().complex() : volume_->template level<0>().complex(); }
  /// The options with the defaults that were chosen.
  const SmoothOptions& options() const { return options_; }
  const ComponentCounts& components() const { return counts_; }
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  /// The first seeds of a component; where they do not bring it into the mesh all of them are inserted, and more around them, and the
  /// surface is scanned anew, so many times at most.
  static constexpr std::size_t first_seeds = 5;
  static constexpr int rounds_for_components = 12, rounds_for_loose_vertices = 3;

  static void check_bounds(const BoundingBox3& b) {
    const double extent = b.extent();
    if (is_finite(b.low) && is_finite(b.high) && b.low.x < b.high.x && b.low.y < b.high.y && b.low.z < b.high.z && extent > 1e-60 && extent < 1e60) return;
    throw InvalidInput("the bounds from " + describe(b.low) + " to " + describe(b.high) +
                       " are no box that can be meshed: each coordinate of the first corner must be less than that of the second, and the longest "
                       "side between 1e-60 and 1e60");
  }
  SurfaceComponents find_components(const Control& control) const {
    SurfaceComponents found;
    if constexpr (FindsComponents<O>) found = oracle_->components(control);
    else found = sample_components(*oracle_, oracle_->bounds().extent() / 64, control);
    if (found.components.empty())
      throw InvalidInput("the domain has no surface in its bounds from " + describe(oracle_->bounds().low) + " to " + describe(oracle_->bounds().high) +
                         " (looked for " + found.method + "): there is nothing to mesh");
    return found;
  }
  /// The triangulation reaches far beyond the bounds, so that every cell at the surface is finite.
  void insert_corners(const BoundingBox3& b) {
    const Vector3 side = b.high - b.low;
    const Point3 low = b.low + -1.0 * side, high = b.high + side;
    for (std::uint32_t i = 0; i < 8; ++i) {
      const auto v = tr_->cgal().insert(typename Tr::Cgal::Point((i & 1) ? high.x : low.x, (i & 2) ? high.y : low.y, (i & 4) ? high.z : low.z));
      v->index = i;
    }
    tr_->number_from(8);
    seeds_.resize(components_.components.size());
  }
  void insert_seeds(const std::vector<Point3>& component, std::size_t count) {
    auto& seeds = seeds_[static_cast<std::size_t>(&component - components_.components.data())];
    typename Tr::Hint hint(tr_->infinite_cell());
    for (std::size_t i = seeds.size(); i < std::min(count, component.size()); ++i) {
      seeds.push_back({});
      if (tr_->conflict_zone(component[i], hint, zone_).kind != Location<Tr>::Kind::zone) continue;
      seeds.back() = tr_->insert(component[i], zone_);
      tr_->set_origin(seeds.back(), {2, 0}, input_level);
      hint = typename Tr::Hint(seeds.back());
    }
  }
  /// What the mesh does not show of the surface.
  struct Coverage {
    std::vector<std::size_t> missed;                ///< components of which no seed is a corner of a facet
    std::vector<std::size_t> lost_regions;          ///< of which most points are in cells of other regions
    std::vector<typename Tr::Vertex> loose;         ///< vertices that were put on the surface and are corners of no facet
  };
  Coverage look_at_coverage() const {
    Coverage coverage;
    std::vector<bool> is_corner;
    complex().for_each([&](const auto& r) {
      for (const auto v : r.corners) {
        const std::size_t i = tr_->index(v);
        if (i >= is_corner.size()) is_corner.resize(i + i / 2 + 1, false);
        is_corner[i] = true;
      }
    });
    const auto has_facets = [&](typename Tr::Vertex v) { return tr_->index(v) < is_corner.size() && is_corner[tr_->index(v)]; };
    for (const auto v : tr_->finite_vertices())
      if (tr_->carrier(v).dimension == 2 && !has_facets(v)) coverage.loose.push_back(v);
    for (std::size_t k = 0; k < seeds_.size(); ++k)
      if (std::ranges::none_of(seeds_[k], [&](typename Tr::Vertex v) { return v != typename Tr::Vertex{} && has_facets(v); }))
        coverage.missed.push_back(k);
    for (std::size_t r = 0; r < region_points_.size(); ++r) {
      const auto is_in_place = [&](Point3 q) {
        const auto cell = tr_->locate(q);
        return cell && tr_->region(*cell) == static_cast<int>(r);
      };
      const auto in_place = static_cast<std::size_t>(std::ranges::count_if(region_points_[r], is_in_place));
      if (4 * in_place < region_points_[r].size()) coverage.lost_regions.push_back(r);
    }
    return coverage;
  }
  /// Inserts all seeds of components that were missed, and points around loose vertices where the surface is thinner than its facets.
  /// Stays within the budget. False when nothing was inserted.
  bool seed_again(const Coverage& coverage, const Control& control) {
    const std::size_t before = tr_->number_of_vertices();
    tr_->clear_slots();  // the mesher may have left a zone that it did not use
    const auto is_enough = [&] { return tr_->number_of_vertices() >= control.budget().max_vertices || control.stop(); };
    for (const std::size_t i : coverage.missed) {
      if (is_enough()) break;
      insert_seeds(components_.components[i], components_.components[i].size());
    }
    const AnchorFinder<O> anchors(*oracle_, options_.smallest_facet, anchor_reach_ / 32, anchor_reach_);
    for (const std::size_t r : coverage.lost_regions)
      for (const Point3 q : region_points_[r]) {
        if (is_enough()) break;
        insert_anchors(anchors.inside(q), typename Tr::Hint(tr_->infinite_cell()));
      }
    for (const auto v : coverage.loose) {
      if (is_enough()) break;
      insert_anchors(anchors.around(tr_->point(v)), typename Tr::Hint(v));
    }
    return tr_->number_of_vertices() > before;
  }
  void insert_anchors(const AnchorPoints& anchors, typename Tr::Hint hint) {
    for (const Point3 p : anchors.points) {
      if (tr_->conflict_zone(p, hint, zone_).kind != Location<Tr>::Kind::zone || is_crowded(p, anchors.distance)) continue;
      const auto inserted = tr_->insert(p, zone_);
      tr_->set_origin(inserted, {2, 0}, input_level);
      hint = typename Tr::Hint(inserted);
    }
  }

  /// Whether a vertex is near `p`, whose conflict zone was found: the nearest one is a corner of the zone.
  bool is_crowded(Point3 p, double distance) const {
    for (const auto c : zone_.dying_cells())
      for (const auto v : tr_->vertices(c))
        if (!tr_->is_infinite(v) && squared_distance(tr_->point(v), p) < distance * distance) return true;
    return false;
  }

  const O* oracle_;
  SmoothOptions options_;
  std::unique_ptr<Tr> tr_;
  SurfaceComponents components_;
  std::vector<std::vector<typename Tr::Vertex>> seeds_;  // per component
  typename Tr::Zone zone_;
  double anchor_reach_ = 0;
  std::vector<std::vector<Point3>> region_points_;  // per region
  std::optional<SurfaceOnly> surface_;
  std::optional<Volume> volume_;
  ComponentCounts counts_;
  std::vector<std::string> notes_;
};

}  // namespace delref
