// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every file that the program reads or writes goes through here, so that the readers and writers are compiled once.
#pragma once

#include <string>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/domain/pslg.hpp>
#include <delref/io/report.hpp>
#include <delref/mesh/planar_mesh.hpp>

namespace delref {
struct ReportedPromise;
}

namespace delref::program {

/// The domain in a file; what its reader has to say is added to `notes`. Throws `InvalidInput` and `Interrupted`.
Pslg read_domain(const std::string& path, const Control& control, std::vector<std::string>& notes);

/// The mesh in a file. Throws `InvalidInput`, also in words for the formats that are only written, and `Interrupted`.
PlanarMesh read_mesh(const std::string& path, const Control& control);

/// The promises of a report. Throws `InvalidInput` and `Interrupted`.
ReportedPromise read_promise(const std::string& path, const Control& control);

/// The files that a run will write, and those that it must leave alone.
struct OutputPlan {
  std::vector<std::string> meshes;
  std::string report;  ///< empty: none
  std::vector<std::string> inputs;
};

/// Throws `UsageError` for a name that says no format or that is used twice, and `OutputError` when a folder cannot be written.
void check_outputs(const OutputPlan& plan);

/// Writes a mesh in the format of the name; `report` has what a picture shows besides. Gives the files written. Throws
/// `OutputError`.
std::vector<std::string> write_mesh(const std::string& path, const PlanarMesh& mesh, const Pslg& input, const RunReport& report,
                                    bool colour_by_region);

/// Throws `OutputError`.
void write_run_report(const std::string& path, const RunReport& report);

}  // namespace delref::program
