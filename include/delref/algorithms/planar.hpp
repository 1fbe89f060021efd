// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes a planar straight line graph: the function that most users call.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <delref/algorithms/excuse_small_angles.hpp>
#include <delref/algorithms/extract_planar_mesh.hpp>
#include <delref/algorithms/planar_levels.hpp>
#include <delref/algorithms/planar_options.hpp>
#include <delref/core/mesher.hpp>
#include <delref/domain/build_planar_domain.hpp>
#include <delref/domain/pslg_check.hpp>
#include <delref/domain/pslg_scale.hpp>
#include <delref/triangulation/constrained_delaunay_2.hpp>

namespace delref {

/// What `mesh_planar` gives.
struct PlanarResult {
  PlanarMesh mesh;
  Outcome<Point2> outcome;
  /// What a user may want to know about the input: merged vertices, dropped segments, seeds without effect.
  std::vector<std::string> notes;
};

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

/// Puts mesh and outcome back into the coordinates and the numbering of the input.
inline void restore(PlanarResult& result, const CheckedPslg& checked, int k) {
  for (Carrier& c : result.mesh.carriers)
    if (c.dimension < 2) c.index = c.dimension == 0 ? checked.original_point[c.index] : checked.original_segment[c.index];
  for (Pslg::Index& s : result.mesh.edge_segments) s = checked.original_segment[s];
  if (k == 0) return;
  for (Point2& p : result.mesh.points) p = scaled(p, -k);
  for (Unmet<Point2>& u : result.outcome.unmet) u.place = scaled(u.place, -k);
}

template <class Levels, class Tr, class... Observers>
Outcome<Point2> refine(Tr& tr, Levels levels, const Control& control, Observers&... observers) {
  Mesher mesher(tr, std::move(levels));
  return mesher.refine(control, observers...);
}

}  // namespace planar_detail

/// Meshes the domain of a planar straight line graph so that every criterion of the options is met, or says of every triangle that
/// does not meet them why. Observers see the run (`core/observer.hpp`).
///
/// Ends for every input: bounds up to 20.7 degrees by proof, others by the budget of the control at the latest. When the control
/// stops the refinement, the mesh is the valid constrained Delaunay triangulation reached so far. Coordinates of extreme size are
/// scaled by a power of two meanwhile, exactly.
///
/// Throws `InvalidInput` when the input cannot be meshed, with every defect named, and `Interrupted` when the control says stop
/// before there is a mesh.
template <class... Observers>
PlanarResult mesh_planar(Pslg input, const PlanarOptions& options, const Control& control = Control{}, Observers&... observers) {
  using Tr = ConstrainedDelaunay2<>;
  const CheckedPslg checked = check_pslg(std::move(input), {options.merge_tolerance, options.split_crossings}, control);
  Tr tr;
  PlanarDomainBuilder builder(tr, checked, control);
  PlanarResult result;
  result.notes = checked.notes;
  for (std::string& note : std::move(builder).notes()) result.notes.push_back(std::move(note));
  const PlanarDomain domain = std::move(builder).domain();

  const auto run = [&](auto encroachment, auto points) {
    const EdgesOptions edges{std::ldexp(control.budget().smallest_edge, domain.scale), options.keep_boundary};
    return planar_detail::refine(
        tr, planar_levels<Tr>(domain, planar_detail::criteria(options, domain), encroachment, points, edges), control, observers...);
  };
  const auto with_points = [&](auto encroachment) {
    return options.points == PointChoice::off_centre ? run(encroachment, OffCentre(options.min_angle)) : run(encroachment, Circumcentre{});
  };
  result.outcome = options.encroachment == Encroachment::lens ? with_points(DiametralLens{options.min_angle}) : with_points(DiametralCircle{});

  if (!result.outcome.unmet.empty()) SmallAngleExcuses(tr, domain).apply(result.outcome, MinimumAngle::name);
  std::vector<std::string> names;
  for (const LevelCounts& level : result.outcome.levels) names.push_back(level.name);
  result.mesh = extract_planar_mesh(tr, domain, std::move(names));
  planar_detail::restore(result, checked, domain.scale);
  return result;
}

}  // namespace delref
