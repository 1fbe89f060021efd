// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every file that the program reads or writes goes through here, so that the readers and writers are compiled once.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/io/report.hpp>
#include <delref/mesh/planar_mesh.hpp>
#include <delref/mesh/tetrahedral_mesh.hpp>

#include "arguments.hpp"
#include "input_kind.hpp"
#include "planar_run.hpp"
#include "polyhedral_run.hpp"
#include "smooth_run.hpp"

namespace delref {
template <class Point>
struct BasicPromise;
}  // namespace delref

namespace delref::program {

/// The domain in a file, a `Pslg`, a `Plc`, or the `SmoothDomain` that the options say; what its reader has to say is added to `notes`.
/// Throws `InvalidInput` and `Interrupted`.
template <class Domain>
Domain read_domain(const std::string& path, const ReportedOptions& options, const Control& control, std::vector<std::string>& notes);

/// The mesh in a file, a `PlanarMesh`, a `TetrahedralMesh`, or a variant of both. Throws `InvalidInput`, also in words for the formats
/// that are only written, and `Interrupted`.
template <class Mesh>
Mesh read_mesh(const std::string& path, const Control& control);

/// The promises of a report of a run in the plane (`Point2`) or in space. Throws `InvalidInput` and `Interrupted`.
template <class Point>
BasicPromise<Point> read_promise(const std::string& path, const Control& control);

/// What the report of a run on a smooth domain says of it; nothing for any other file. Throws `Interrupted`.
std::optional<ReportedSmoothOptions> reported_smooth_options(const std::string& path, const Control& control);

/// The files that a run will write, and those that it must leave alone.
struct OutputPlan {
  std::vector<std::string> meshes;
  std::string report;  ///< empty: none
  std::vector<std::string> inputs;
};

/// Every file that will be written. Throws `UsageError` for a name that says no format of the kind's meshes or that is used twice, and
/// `OutputError` when a folder cannot be written.
std::vector<std::filesystem::path> check_outputs(const OutputPlan& plan, InputKind kind);

/// Removes what is there of outputs that are being written. For a program that ends in the midst of that.
void remove_partial_files(const std::vector<std::filesystem::path>& files);

/// Writes the mesh of a run in the format of the name; `report` and `arguments` have what a picture shows besides. Gives the files
/// written. Throws `OutputError`.
std::vector<std::string> write_mesh(const std::string& path, const PlanarRun& run, const Pslg& input, const RunReport& report,
                                    const MeshArguments& arguments);
std::vector<std::string> write_mesh(const std::string& path, const PolyhedralRun& run, const Plc& input,
                                    const PolyhedralRunReport& report, const MeshArguments& arguments);

std::vector<std::string> write_mesh(const std::string& path, const SmoothRun& run, const SmoothDomain& input,
                                    const PolyhedralRunReport& report, const MeshArguments& arguments);

/// Throw `OutputError`.
void write_run_report(const std::string& path, const RunReport& report);
void write_run_report(const std::string& path, const PolyhedralRunReport& report);

}  // namespace delref::program
