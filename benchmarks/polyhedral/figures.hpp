// SPDX-License-Identifier: GPL-3.0-or-later
//
// The line of figures that benchmarks/polyhedral/run.py reads, the same for every mesher: pairs of a name and a number.
#pragma once

#include <cmath>
#include <cstddef>

#include <fmt/format.h>

#include <delref/core/point.hpp>
#include <delref/mesh/tetrahedral_mesh.hpp>
#include <delref/mesh/tetrahedral_quality.hpp>
#include <delref/mesh/tetrahedron_measures.hpp>

#include "../processor.hpp"

namespace benchmark {

/// The tetrahedra of a mesh whose circumradius is over `bound` times their shortest edge, with a slack of 1e-9 for rounding.
inline std::size_t count_over(const delref::TetrahedralMesh& mesh, double bound) {
  const double limit = bound * bound * (1 + 2e-9);
  std::size_t over = 0;
  for (const auto& [a, b, c, d] : mesh.tetrahedra)
    over += delref::TetrahedronMeasures(mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]).squared_radius_edge() > limit;
  return over;
}

/// Counts and quality of a mesh; `bound` is the bound on the radius-edge ratio that was asked for.
inline void print_figures(const delref::TetrahedralMesh& mesh, double bound) {
  const delref::TetrahedralQuality q = delref::tetrahedral_quality(mesh);
  fmt::print("vertices {} tetrahedra {} over_bound {} over_2 {} worst_radius_edge {:.6g} smallest_dihedral {:.4g} ", q.vertex_count,
             q.tetrahedron_count, count_over(mesh, bound), count_over(mesh, 2), q.worst_radius_edge, q.smallest_dihedral);
  fmt::print("largest_dihedral {:.6g} slivers {} volume {:.15g}\n", q.largest_dihedral, q.under_5_degrees, q.total_volume);
}

}  // namespace benchmark
