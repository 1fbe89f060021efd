// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes a smooth surface, or the volume that it bounds: the function that most users call for a domain that an oracle knows, such as
// an implicit function or an image.
#pragma once

#include <string>
#include <vector>

#include <delref/algorithms/smooth_options.hpp>
#include <delref/algorithms/smooth_refinement.hpp>
#include <delref/core/budget.hpp>
#include <delref/core/outcome.hpp>
#include <delref/domain/oracle.hpp>
#include <delref/mesh/tetrahedral_mesh.hpp>

namespace delref {

/// What `mesh_smooth_domain` gives.
struct SmoothResult {
  /// Tetrahedra, unless only the surface was asked for, and the triangles between regions, with the marker 1 + the number of their patch.
  TetrahedralMesh mesh;
  Outcome<Point3> outcome;
  std::vector<SurfacePatch> patches;
  ComponentCounts components;
  /// Those that were given, with the sizes that were chosen for what was left open.
  SmoothOptions options;
  /// What was chosen for the user, and what is to be known of the domain.
  std::vector<std::string> notes;
};

/// Meshes the surfaces between the regions of a domain, and unless told otherwise the regions themselves, so that every criterion of the
/// options is met, or says of every element that does not meet them why. Observers see the run (`core/observer.hpp`).
///
/// The mesh is Delaunay and the surface closed by construction. Where facets are smaller than a small part of the local feature size the
/// surface has the topology of the true one (Boissonnat and Oudot 2005; Cheng, Dey, Ramos, Ray 2007). Ends by proof for smooth surfaces,
/// a facet angle of 30 degrees and a radius-edge bound of 2 (Oudot, Rineau, Yvinec 2005); at creases, junctions and closed borders by
/// the size floor (`SmoothOptions::smallest_facet`), and for every input by the budget of the control at the latest.
///
/// Throws `InvalidInput` when the options cannot be met, the bounds are no box or there is no surface in them; and `Interrupted` when
/// the control says stop before the components of the surface are found.
template <Oracle O, class... Observers>
SmoothResult mesh_smooth_domain(const O& oracle, const SmoothOptions& options = {}, const Control& control = Control{},
                                Observers&... observers) {
  SmoothRefinement<O> refinement(oracle, options, control);
  SmoothResult result;
  result.outcome = refinement.refine(control, observers...);
  result.mesh = refinement.mesh();
  result.patches = refinement.patches();
  result.components = refinement.components();
  result.options = refinement.options();
  result.notes = refinement.notes();
  if constexpr (requires { oracle.notes(); })
    for (const auto& note : oracle.notes()) result.notes.push_back(note);
  return result;
}

}  // namespace delref
