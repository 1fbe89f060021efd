// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a run tells a person at its end, and the exit code that goes with it. The templates are for runs in the plane and in space.
#pragma once

#include <string>
#include <vector>

#include <delref/io/report.hpp>
#include <delref/mesh/planar_mesh.hpp>
#include <delref/mesh/tetrahedral_mesh.hpp>

#include "exit_codes.hpp"

namespace delref::program {

/// `strict`: what small input angles force counts as unmet too.
template <class Report>
ExitCode exit_code(const Report& report, bool strict);

/// One sentence: whether every criterion is met, and if not what stopped the run or what is in the way.
template <class Report>
std::string verdict(const Report& report);

/// What is unmet, a line for each criterion and reason; empty when nothing is.
template <class Report>
std::string unmet_table(const Report& report);

/// The whole summary of a run: counts, quality, notes, what is unmet, files, verdict.
std::string summary(const RunReport& report, const PlanarMesh& mesh, const std::vector<std::string>& files);
std::string summary(const PolyhedralRunReport& report, const TetrahedralMesh& mesh, const std::vector<std::string>& files);

}  // namespace delref::program
