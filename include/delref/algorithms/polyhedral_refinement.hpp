// SPDX-License-Identifier: GPL-3.0-or-later
//
// Polyhedral refinement in the hands of its caller: first the triangulation is made to conform to the complex, which decides what
// belongs to which region, then the tetrahedra are refined. `mesh_polyhedron` is the short way for those who want none of this.
#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <delref/algorithms/check_polyhedral_options.hpp>
#include <delref/algorithms/extract_tetrahedral_mesh.hpp>
#include <delref/algorithms/polyhedral_levels.hpp>
#include <delref/algorithms/polyhedral_options.hpp>
#include <delref/core/mesher.hpp>
#include <delref/domain/build_polyhedral_domain.hpp>
#include <delref/domain/check_plc.hpp>
#include <delref/domain/label_polyhedral_domain.hpp>
#include <delref/triangulation/delaunay_3.hpp>

namespace delref {

namespace polyhedral_detail {

/// The point in the unit of the input of one that was scaled by 2^scale.
inline Point3 unscaled(Point3 p, int scale) { return {std::ldexp(p.x, -scale), std::ldexp(p.y, -scale), std::ldexp(p.z, -scale)}; }

/// The criteria of the options, for the regions of a domain whose coordinates are scaled by 2^scale.
inline auto criteria(const PolyhedralOptions& options, const std::vector<Plc::Region>& regions, int scale) {
  const auto size = [field = options.size, scale](Point3 p) {
    return field ? std::ldexp(checked_size(field, unscaled(p, scale)), scale) : std::numeric_limits<double>::infinity();
  };
  return TetrahedronCriteria(RadiusEdge{options.radius_edge}, MaximumVolume{std::ldexp(options.max_volume, 3 * scale)},
                             MaximumRegionVolume(regions), MaximumCircumradius{std::ldexp(options.cell_size, scale)},
                             SizeAtCircumcentre{size});
}

}  // namespace polyhedral_detail

/// The refinement of a piecewise linear complex as an object. Nothing is refined until `refine` is called.
///
/// `Tr` is the triangulation type; leave it away: `PolyhedralRefinement refinement(plc, options);`. Observers see the run
/// (`core/observer.hpp`); levels are numbered edges 0, facets 1, tetrahedra 2.
template <class Tr = Delaunay3<>>
class PolyhedralRefinement {
  using Criteria = decltype(polyhedral_detail::criteria(std::declval<const PolyhedralOptions&>(), std::declval<const std::vector<Plc::Region>&>(), 0));
  using Edges = EdgesLevel3<Tr>;
  using Facets = FacetsLevel3<Tr>;
  using Tetrahedra = TetrahedraLevel3<Tr, Criteria>;

 public:
  using Triangulation = Tr;

  /// Checks and triangulates the input. Throws `InvalidInput` when it cannot be meshed, with every defect named, and `Interrupted`
  /// when the control says stop.
  explicit PolyhedralRefinement(Plc input, PolyhedralOptions options = {}, const Control& control = Control{})
      : options_((check_polyhedral_options(options), std::move(options))), state_(std::make_unique<State>(check_plc(std::move(input), options_.input, control))) {
    notes_ = state_->domain.notes;
    const auto vertices = insert_input_points(state_->tr, state_->domain, control);
    conform_.emplace(state_->tr, conforming_levels<Tr>(state_->tr, state_->domain, vertices, state_->repair, ConformingOptions{smallest_edge(control)}));
  }

  /// Refines until nothing is left to do or the control says stop; may be called again to go on. Where the outcome lists a missing
  /// subsegment or subfacet, the facets do not separate the regions, and nothing is known of tetrahedra: `conforms` tells.
  template <class... Observers>
  Outcome<Point3> refine(const Control& control = Control{}, Observers&... observers) {
    if (conform_) {
      Outcome<Point3> outcome = conform_->refine(control, observers...);
      if (outcome.stopped || facets().missing() > 0) return told(std::move(outcome));
      conforming_counts_ = outcome.levels;
      enter_domain(control);
    }
    Outcome<Point3> outcome = full_->refine(control, observers...);
    if (outcome.stopped && facets().missing() > 0) {
      // A facet has a gap at this moment. Edges and facets come first, so a few steps more close it.
      for (std::size_t steps = 0; facets().missing() > 0 && steps < steps_to_close; ++steps) full_->step(observers...);
      const auto stopped = outcome.stopped;
      outcome = full_->outcome();
      outcome.stopped = stopped;
    }
    return told(std::move(outcome));
  }

  /// Whether every facet is whole and regions are known: before that there is no mesh.
  bool conforms() const { return full_ && facets().missing() == 0; }
  bool done() const { return full_ && full_->done(); }
  Outcome<Point3> outcome() const { return told(full_ ? full_->outcome() : conform_->outcome()); }

  /// The mesh as it is now; it has no tetrahedra unless it `conforms`. Linear time.
  TetrahedralMesh mesh() const {
    TetrahedralMesh mesh = extract_tetrahedral_mesh(state_->tr, state_->domain, state_->regions, edges().subsegments(), facets().complex(),
                                                    {"edges", "facets", "tetrahedra"});
    if (scale() != 0)
      for (Point3& p : mesh.points) p = polyhedral_detail::unscaled(p, scale());
    return mesh;
  }

  const Tr& triangulation() const { return state_->tr; }
  const PolyhedralDomain& domain() const { return state_->domain; }
  /// What a user may want to know about the input: merged vertices, joined facets, seeds without effect.
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  struct State {
    explicit State(PolyhedralDomain d) : domain(std::move(d)), guard(domain) {}
    PolyhedralDomain domain;
    SmallAngleGuard guard;
    Tr tr;
    RegionRepair<Tr> repair;
    PolyhedralRegions regions;
  };

  const Edges& edges() const { return full_ ? full_->template level<0>() : conform_->template level<0>(); }
  const Facets& facets() const { return full_ ? full_->template level<1>() : conform_->template level<1>(); }

  static constexpr std::size_t steps_to_close = 20'000;
  int scale() const { return state_->domain.scale; }
  double smallest_edge(const Control& control) const { return std::ldexp(control.budget().smallest_edge, scale()); }

  /// An outcome in the unit of the input, with what the levels did before the triangulation conformed.
  Outcome<Point3> told(Outcome<Point3> outcome) const {
    if (scale() != 0)
      for (auto& unmet : outcome.unmet) unmet.place = polyhedral_detail::unscaled(unmet.place, scale());
    for (std::size_t i = 0; i < conforming_counts_.size(); ++i) {
      outcome.levels[i].inserted += conforming_counts_[i].inserted;
      outcome.levels[i].rejected += conforming_counts_[i].rejected;
      outcome.levels[i].rejected_forever += conforming_counts_[i].rejected_forever;
    }
    return outcome;
  }

  /// The triangulation conforms: labels the regions and puts the tetrahedra level behind the others.
  void enter_domain(const Control& control) {
    state_->regions = PolyhedralDomainLabeller<Tr>(state_->tr, state_->domain, control).take();
    for (const std::string& note : state_->regions.notes) notes_.push_back(note);
    full_.emplace(state_->tr,
                  polyhedral_levels(state_->tr, conform_->template release<0>(), conform_->template release<1>(),
                                    Tetrahedra(polyhedral_detail::criteria(options_, state_->regions.regions, scale()), state_->repair, state_->guard,
                                               smallest_edge(control))));
    conform_.reset();
  }

  PolyhedralOptions options_;
  std::unique_ptr<State> state_;
  std::optional<Mesher<Tr, Edges, Facets>> conform_;
  std::optional<Mesher<Tr, Edges, Facets, Tetrahedra>> full_;
  std::vector<LevelCounts> conforming_counts_;
  std::vector<std::string> notes_;
};

}  // namespace delref
