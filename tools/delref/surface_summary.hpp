// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the summary of a run tells of the surface of a smooth domain.
#pragma once

#include <string>

#include <delref/io/report.hpp>

#include "rows.hpp"

namespace delref::program {

/// Triangles, topology, components, sizes, patches and angles. Requires a report that has a surface.
void add_surface(Rows& rows, const PolyhedralRunReport& report);

/// Which parts of the surface are not in the mesh, as the object of a sentence; empty when it has all that was found.
std::string missing_parts(const ReportedSurface& surface);

/// A sentence when the surface of the only region has another number of components in the mesh than were found; empty otherwise.
std::string doubt_about_components(const ReportedSurface& surface);

}  // namespace delref::program
