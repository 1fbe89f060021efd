// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes a piecewise linear complex: the function that most users call for a domain of space.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <delref/algorithms/check_polyhedral_options.hpp>
#include <delref/algorithms/polyhedral_options.hpp>
#include <delref/algorithms/polyhedral_refinement.hpp>
#include <delref/core/budget.hpp>
#include <delref/core/outcome.hpp>
#include <delref/domain/plc.hpp>
#include <delref/mesh/tetrahedral_mesh.hpp>

namespace delref {

/// What `mesh_polyhedron` gives.
struct PolyhedralResult {
  /// Without tetrahedra when the control stopped the run before a domain could be told from its outside.
  TetrahedralMesh mesh;
  Outcome<Point3> outcome;
  /// What a user may want to know about the input: merged vertices, joined facets, seeds without effect.
  std::vector<std::string> notes;
};

/// Meshes the domain of a piecewise linear complex so that every criterion of the options is met, or says of every tetrahedron that
/// does not meet them why. Observers see the run (`core/observer.hpp`).
///
/// The mesh is Delaunay; every segment of the input is a chain of its edges and every facet a disk of its triangles. Ends for
/// every input, by the budget of the control at the latest. When that comes before all segments and facets are in the triangulation,
/// the outcome lists what is missing.
///
/// That a radius-edge bound of 2 is reached where no two input elements meet under 90 degrees is experience here. Shewchuk (1998)
/// proves it for diametral balls of subsegments and subfacets that are empty of every vertex; this function only keeps subsegments and
/// subfacets present, and the points inside regions out of their balls (`ConformingOptions::gabriel` asks for the rest).
///
/// Throws `InvalidInput` when the input cannot be meshed, with every defect named, or when no mesh can meet the options; and
/// `Interrupted` when the control says stop before there is a triangulation.
template <class... Observers>
PolyhedralResult mesh_polyhedron(Plc input, const PolyhedralOptions& options = {}, const Control& control = Control{},
                                 Observers&... observers) {
  check_polyhedral_options(options);
  PolyhedralRefinement<> refinement(std::move(input), options, control);
  PolyhedralResult result;
  result.outcome = refinement.refine(control, observers...);
  result.mesh = refinement.mesh();
  result.notes = refinement.notes();
  return result;
}

}  // namespace delref
