// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a run tells a person at its end, and the exit code that goes with it.
#pragma once

#include <string>
#include <vector>

#include <delref/core/outcome.hpp>
#include <delref/io/report.hpp>
#include <delref/mesh/planar_mesh.hpp>

#include "exit_codes.hpp"

namespace delref::program {

/// `strict`: what small input angles force counts as unmet too.
ExitCode exit_code(const Outcome<Point2>& outcome, bool strict);

/// One sentence: whether every criterion is met, and if not what stopped the run or what is in the way.
std::string verdict(const RunReport& report);

/// What is unmet, a line for each criterion and reason; empty when nothing is.
std::string unmet_table(const Outcome<Point2>& outcome);

/// The whole summary of a run: counts, smallest angle, notes, what is unmet, files, verdict.
std::string summary(const RunReport& report, const PlanarMesh& mesh, const std::vector<std::string>& files);

}  // namespace delref::program
