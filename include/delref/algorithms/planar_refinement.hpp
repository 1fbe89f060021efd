// SPDX-License-Identifier: GPL-3.0-or-later
//
// Planar refinement in the hands of its caller: step by step, with a look at the mesh at any time, stopped and gone on with, and
// with vertices and segments added later. `mesh_planar` is the short way for those who want none of this.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <delref/algorithms/excuse_small_angles.hpp>
#include <delref/algorithms/extract_planar_mesh.hpp>
#include <delref/algorithms/planar_levels.hpp>
#include <delref/algorithms/planar_options.hpp>
#include <delref/core/mesher.hpp>
#include <delref/domain/build_planar_domain.hpp>
#include <delref/domain/extend_planar_domain.hpp>
#include <delref/domain/pslg_check.hpp>
#include <delref/domain/pslg_scale.hpp>
#include <delref/triangulation/constrained_delaunay_2.hpp>

namespace delref {

namespace planar_detail {

/// The criteria of the options, on the coordinates of the domain.
inline auto criteria(const PlanarOptions& options, const PlanarDomain& domain) {
  const int k = domain.scale;
  const auto size = [field = options.size, k](Point2 p) {
    if (!field) return std::numeric_limits<double>::infinity();
    return k == 0 ? field(p) : std::ldexp(field(scaled(p, -k)), k);
  };
  return TriangleCriteria(MinimumAngle{options.min_angle}, MaximumArea{std::ldexp(options.max_area, 2 * k)},
                          MaximumRegionArea(domain.regions), MaximumEdge{std::ldexp(options.max_edge, k)}, SizeAtCentroid{size});
}

/// A mesher for each choice that the options offer at run time.
template <class Tr>
class AnyMesher {
  using Criteria = decltype(criteria(std::declval<const PlanarOptions&>(), std::declval<const PlanarDomain&>()));
  template <class Encroachment, class Points>
  using With = Mesher<Tr, EdgesLevel2<Tr, Encroachment>, FacesLevel2<Tr, Criteria, Points>>;

 public:
  using Variant = std::variant<With<DiametralCircle, Circumcentre>, With<DiametralCircle, OffCentre>,
                               With<DiametralLens, Circumcentre>, With<DiametralLens, OffCentre>>;

  static Variant make(Tr& tr, const PlanarDomain& domain, const PlanarOptions& options, double smallest_edge) {
    const EdgesOptions edges{std::ldexp(smallest_edge, domain.scale), options.keep_boundary};
    const auto with = [&](auto encroachment, auto points) -> Variant {
      return Mesher(tr, planar_levels<Tr>(domain, criteria(options, domain), encroachment, points, edges));
    };
    const auto with_points = [&](auto encroachment) {
      return options.points == PointChoice::off_centre ? with(encroachment, OffCentre(options.min_angle)) : with(encroachment, Circumcentre{});
    };
    return options.encroachment == Encroachment::lens ? with_points(DiametralLens{options.min_angle}) : with_points(DiametralCircle{});
  }
};

/// Puts a mesh back into the coordinates and the numbering of the input.
inline void restore(PlanarMesh& mesh, const CheckedPslg& checked, int k) {
  for (Carrier& c : mesh.carriers)
    if (c.dimension < 2) c.index = c.dimension == 0 ? checked.original_point[c.index] : checked.original_segment[c.index];
  for (Pslg::Index& s : mesh.edge_segments) s = checked.original_segment[s];
  if (k == 0) return;
  for (Point2& p : mesh.points) p = scaled(p, -k);
}

}  // namespace planar_detail

/// The refinement of a planar straight line graph as an object. Nothing is refined until `step` or `refine` is called.
///
/// `Tr` is the triangulation type; leave it away: `PlanarRefinement refinement(pslg, options);`. Observers see the run
/// (`core/observer.hpp`), in the coordinates of `triangulation()`: those of the input, but for extreme ones, which are scaled by
/// 2^`domain().scale`.
template <class Tr = ConstrainedDelaunay2<>>
class PlanarRefinement {
  using AnyMesher = planar_detail::AnyMesher<Tr>;

 public:
  using Triangulation = Tr;

  /// Checks and triangulates the input. Throws `InvalidInput` when it cannot be meshed, with every defect named, and `Interrupted`
  /// when the control says stop.
  explicit PlanarRefinement(Pslg input, PlanarOptions options = {}, const Control& control = Control{})
      : options_(std::move(options)), given_{input.points.size(), input.segments.size()}, state_(std::make_unique<State>()) {
    state_->checked = check_pslg(std::move(input), check_options(), control);
    PlanarDomainBuilder builder(state_->tr, state_->checked, control);
    notes_ = state_->checked.notes;
    append(notes_, std::move(builder).notes());
    state_->domain = std::move(builder).domain();
    renew_mesher(control.budget().smallest_edge);
  }

  /// Does one step (`Mesher::step`). The first one after construction and after `add` looks at the whole triangulation first.
  template <class... Observers>
  Step step(Observers&... observers) {
    stopped_.reset();
    return std::visit([&](auto& mesher) { return mesher.step(observers...); }, *mesher_);
  }

  /// Steps until nothing is left to do or the control says stop; may be called again to go on. A budget with another
  /// `smallest_edge` than the one before makes everything be looked at again.
  template <class... Observers>
  Outcome<Point2> refine(const Control& control = Control{}, Observers&... observers) {
    if (control.budget().smallest_edge != smallest_edge_) renew_mesher(control.budget().smallest_edge);
    Outcome<Point2> result = std::visit([&](auto& mesher) { return mesher.refine(control, observers...); }, *mesher_);
    stopped_ = result.stopped;
    return completed(std::move(result));
  }

  /// True when nothing is left to do: every criterion is met, or its elements were given up, for reasons that `outcome` tells.
  bool done() const {
    return std::visit([](const auto& mesher) { return mesher.done(); }, *mesher_);
  }

  /// What was done so far, over all runs, and what is unmet. A refinement that is not done and was not stopped by a control counts
  /// as stopped by its caller (`Stop::token`). Elements are listed once the triangulation was looked at by a first step.
  Outcome<Point2> outcome() const {
    Outcome<Point2> result = std::visit([](const auto& mesher) { return mesher.outcome(); }, *mesher_);
    if (!done()) result.stopped = stopped_.value_or(Stop::token);
    return completed(std::move(result));
  }

  /// The mesh as it is now: at any time a valid constrained Delaunay triangulation of the domain. Linear time.
  PlanarMesh mesh() const {
    std::vector<std::string> names;
    std::visit(
        [&](const auto& mesher) {
          names.push_back(level_options::name(mesher.template level<0>(), 0));
          names.push_back(level_options::name(mesher.template level<1>(), 1));
        },
        *mesher_);
    PlanarMesh result = extract_planar_mesh(state_->tr, state_->domain, std::move(names));
    planar_detail::restore(result, state_->checked, state_->domain.scale);
    return result;
  }

  /// Adds vertices, segments, and seeds of holes and regions. Refine again afterwards: regions, corners and clusters are worked out
  /// anew, and what was given up is considered again.
  ///
  /// The segments of `extra` name its own points; a point with the coordinates of a vertex of the mesh, of the input or Steiner, is
  /// that vertex. Segments use the vertices on their way; they may meet what is there only in vertices, unless the options ask
  /// for a split at crossings. Elements are numbered on from those given before. How Steiner vertices fare: `PlanarDomainExtension`.
  ///
  /// All handles into the triangulation become invalid, and vertices are numbered anew. Throws `InvalidInput`, `Interrupted`;
  /// nothing has changed then. Costs about as much as building the triangulation did.
  void add(const Pslg& extra, const Control& control = Control{}) {
    UnitedPslg united = unite_pslg(state_->checked, extra, given_, check_options(), control);
    std::vector<std::string> notes = united.checked.notes;
    auto next = std::make_unique<State>();
    PlanarDomainExtension<Tr> extension(state_->tr, state_->domain, std::move(united), next->tr, control);
    append(notes, std::move(extension).notes());
    next->domain = std::move(extension).domain();
    next->checked = std::move(extension).united();
    std::swap(state_, next);  // the old one lives until its mesher is gone
    renew_mesher(smallest_edge_);
    append(notes_, std::move(notes));
    given_.points += extra.points.size();
    given_.segments += extra.segments.size();
  }

  const Tr& triangulation() const { return state_->tr; }
  const PlanarDomain& domain() const { return state_->domain; }
  /// All that was given, checked: what `mesh()` verifies against (`verify_planar`, with `original_point` and `original_segment`
  /// as the names). A segment is cut where it runs over an added vertex that was within rounding of it.
  const CheckedPslg& united_input() const { return state_->checked; }
  /// What a user may want to know about the input: merged vertices, dropped segments, seeds without effect.
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  struct State {
    CheckedPslg checked;
    Tr tr;
    PlanarDomain domain;
  };

  static void append(std::vector<std::string>& notes, std::vector<std::string> more) {
    notes.insert(notes.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  }
  PslgCheckOptions check_options() const { return {options_.merge_tolerance, options_.split_crossings}; }

  /// A mesher that has looked at nothing yet. What the one before did is remembered.
  void renew_mesher(double smallest_edge) {
    if (mesher_) earlier_ = std::visit([&](const auto& mesher) { return with_earlier(mesher.outcome().levels); }, *mesher_);
    smallest_edge_ = smallest_edge;
    stopped_.reset();
    mesher_.emplace(AnyMesher::make(state_->tr, state_->domain, options_, smallest_edge));
  }
  std::vector<LevelCounts> with_earlier(std::vector<LevelCounts> levels) const {
    for (std::size_t i = 0; i < earlier_.size(); ++i) {
      levels[i].inserted += earlier_[i].inserted;
      levels[i].rejected += earlier_[i].rejected;
      levels[i].rejected_forever += earlier_[i].rejected_forever;
    }
    return levels;
  }
  Outcome<Point2> completed(Outcome<Point2> outcome) const {
    outcome.levels = with_earlier(std::move(outcome.levels));
    if (!outcome.unmet.empty()) SmallAngleExcuses(state_->tr, state_->domain).apply(outcome, MinimumAngle::name);
    if (const int k = state_->domain.scale; k != 0)
      for (Unmet<Point2>& u : outcome.unmet) u.place = scaled(u.place, -k);
    return outcome;
  }

  PlanarOptions options_;
  GivenCounts given_;
  std::unique_ptr<State> state_;
  std::optional<typename AnyMesher::Variant> mesher_;
  double smallest_edge_ = 0;
  std::optional<Stop> stopped_;
  std::vector<LevelCounts> earlier_;
  std::vector<std::string> notes_;
};

}  // namespace delref
