// SPDX-License-Identifier: GPL-3.0-or-later
//
// A polyhedral run and what it breaks of its promises, behind plain functions: what is behind them is compiled once.
#pragma once

#include <cstddef>
#include <string>

#include <delref/algorithms/polyhedral_options.hpp>
#include <delref/core/outcome.hpp>
#include <delref/domain/plc.hpp>
#include <delref/mesh/tetrahedral_mesh.hpp>

namespace delref::property_3 {

struct Meshed {
  TetrahedralMesh mesh;
  Outcome<Point3> outcome;
  bool conforms = false;
  /// What was not put right, by criterion and reason, without what small input angles force; empty when there is nothing.
  std::string not_excused() const;
};

/// Refines until everything is done or the triangulation has so many vertices.
Meshed meshed(const Plc& input, const PolyhedralOptions& options, std::size_t max_vertices);

/// The failed checks of `verify_polyhedral`, in words; empty when there are none.
std::string broken_promises(const Plc& input, const PolyhedralOptions& options, const Meshed& result);

double volume(const TetrahedralMesh& mesh);
bool same_bytes(const TetrahedralMesh& a, const TetrahedralMesh& b);

}  // namespace delref::property_3
