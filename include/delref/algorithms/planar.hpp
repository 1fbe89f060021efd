// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes a planar straight line graph: the function that most users call.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <delref/algorithms/planar_options.hpp>
#include <delref/algorithms/planar_refinement.hpp>
#include <delref/core/budget.hpp>
#include <delref/core/outcome.hpp>
#include <delref/domain/pslg.hpp>
#include <delref/mesh/planar_mesh.hpp>

namespace delref {

/// What `mesh_planar` gives.
struct PlanarResult {
  PlanarMesh mesh;
  Outcome<Point2> outcome;
  /// What a user may want to know about the input: merged vertices, dropped segments, seeds without effect.
  std::vector<std::string> notes;
};

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
  PlanarRefinement<> refinement(std::move(input), options, control);
  PlanarResult result;
  result.outcome = refinement.refine(control, observers...);
  result.mesh = refinement.mesh();
  result.notes = refinement.notes();
  return result;
}

}  // namespace delref
