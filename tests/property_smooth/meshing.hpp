// SPDX-License-Identifier: GPL-3.0-or-later
//
// A run on a smooth domain and what it breaks of its promises, behind plain functions: what is behind them is compiled once.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <delref/algorithms/smooth_options.hpp>
#include <delref/core/outcome.hpp>
#include <delref/mesh/tetrahedral_mesh.hpp>

#include "domain.hpp"

namespace delref::property_smooth {

struct Meshed {
  TetrahedralMesh mesh;
  Outcome<Point3> outcome;
  SmoothOptions options;  ///< with the defaults that were chosen
  std::size_t patches = 0;
  std::size_t components = 0, missed_components = 0, loose_vertices = 0;
  std::size_t vertices = 0;  ///< of the triangulation
  Domain::Counts asked;      ///< while refining

  /// What was not met, by criterion and reason; empty when there is nothing.
  std::string unmet() const;
  bool lists(std::string_view criterion) const;
};

/// Refines until everything is done or the triangulation has so many vertices.
Meshed meshed(const Domain& domain, const SmoothOptions& options, std::size_t max_vertices);

/// The failed checks of `verify_smooth`, in words; empty when there are none.
std::string broken_promises(const Domain& domain, const Meshed& result);

/// What the mesh itself is, without a question to the domain and without the library's verification: closed, manifold, with angles and ratios
/// within their bounds but where the outcome says otherwise, with positive tetrahedra that fill what the triangles enclose. In words; empty
/// when all is well.
std::string defects(const Meshed& result);

bool same_bytes(const TetrahedralMesh& a, const TetrahedralMesh& b);

}  // namespace delref::property_smooth
