// SPDX-License-Identifier: GPL-3.0-or-later
//
// The topology of a surface, counted without a mesher: from the labels at the nodes of a grid cut into tetrahedra, each of which the
// surface crosses in one polygon or not at all (marching tetrahedra without their coordinates).
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <delref/core/point.hpp>
#include <delref/mesh/tetrahedral_mesh.hpp>

#include "domain.hpp"

namespace delref::property_smooth {

struct Topology {
  std::size_t components = 0;
  long euler_characteristic = 0;
  friend bool operator==(const Topology&, const Topology&) = default;
};

/// The boundary of what has the label `region`, by a grid of so many steps to the longest side. Beyond the bounds is outside.
Topology counted_topology(const Domain& domain, int region, std::size_t steps);
/// The same at `steps` and at half as many, if these agree.
std::optional<Topology> sure_topology(const Domain& domain, int region, std::size_t steps);

/// That of the triangles of a mesh whose patches bound the region: all of a mesh with one patch.
Topology topology_of(const TetrahedralMesh& mesh);

}  // namespace delref::property_smooth
