// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a report tells of the surface of a smooth domain that is seen from the mesh alone: its patches, and the topology of the surface
// of each region.
#pragma once

#include <vector>

#include <delref/io/report.hpp>
#include <delref/mesh/tetrahedral_mesh.hpp>

namespace delref::program {

/// Fills in vertices, smallest angle, the triangles of each patch, and the boundaries of the regions that patches have. Requires the
/// patches in the order of their markers, and a mesh of `mesh_smooth_domain`. O(n log n), some 2 microseconds per vertex.
void add_surface_facts(ReportedSurface& surface, const TetrahedralMesh& mesh);

}  // namespace delref::program
