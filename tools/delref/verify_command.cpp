// SPDX-License-Identifier: GPL-3.0-or-later
//
// `delref verify`: the promises come from a report or from options.
#include <cstdio>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <delref/core/budget.hpp>
#include <delref/io/polyhedral_formats.hpp>
#include <delref/io/report_json.hpp>

#include "commands.hpp"
#include "files.hpp"
#include "interrupt.hpp"
#include "option_dimension.hpp"
#include "planar_run.hpp"
#include "polyhedral_run.hpp"
#include "progress.hpp"
#include "size_points.hpp"
#include "words.hpp"

namespace delref::program {
namespace {

/// The file of size points that a report names: from here, or else beside the report.
std::string find_size_points(const std::string& name, const std::string& report) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  if (report.empty() || fs::exists(name, ignored)) return name;
  const fs::path beside = fs::path(report).parent_path() / fs::path(name).filename();
  return fs::exists(beside, ignored) ? beside.string() : name;
}

std::string shape_text(const ReportedOptions& o, Plane) {
  std::string text = o.min_angle_degrees > 0 ? fmt::format("angles of at least {:g} degrees", o.min_angle_degrees) : "any angles";
  if (o.max_area) text += fmt::format(", areas of at most {:g}", *o.max_area);
  if (o.max_edge) text += fmt::format(", edges of at most {:g}", *o.max_edge);
  text += fmt::format(", encroachment by {}", o.encroachment);
  if (o.keep_boundary) text += ", boundary kept";
  if (o.split_crossings) text += ", input split at crossings";
  return text;
}

std::string shape_text(const ReportedOptions& o, Space) {
  std::string text = fmt::format("radius-edge ratios of at most {:g}", o.radius_edge);
  if (o.max_volume) text += fmt::format(", volumes of at most {:g}", *o.max_volume);
  if (o.cell_size) text += fmt::format(", circumradii of at most {:g}", *o.cell_size);
  if (o.join_coplanar_degrees) text += fmt::format(", facets joined within {:g} degrees", *o.join_coplanar_degrees);
  if (o.planarity_tolerance != ReportedOptions{}.planarity_tolerance)
    text += fmt::format(", facets flat within {:g}", o.planarity_tolerance);
  return text;
}

/// What the mesh is held against, in one line.
template <class Kind>
std::string promise_text(const ReportedOptions& o, bool complete) {
  std::string text = shape_text(o, Kind{});
  if (!o.size_points_file.empty()) text += fmt::format(", sizes of {} with gradation {:g}", o.size_points_file, o.gradation);
  if (o.merge_tolerance > 0) text += fmt::format(", input merged within {:g}", o.merge_tolerance);
  return text + (complete ? "" : "; the run was stopped early");
}

template <class Point>
BasicPromise<Point> promise_of(const VerifyArguments& arguments, const Control& control) {
  if (!arguments.report.empty()) return read_promise<Point>(arguments.report, control);
  BasicPromise<Point> promise;
  promise.options = arguments.options;
  promise.complete = true;
  return promise;
}

std::string elements_text(const PlanarMesh& mesh) { return counted(mesh.triangles.size(), "triangle", "triangles"); }
std::string elements_text(const TetrahedralMesh& mesh) { return counted(mesh.tetrahedra.size(), "tetrahedron", "tetrahedra"); }

template <class Kind>
ExitCode verify(const VerifyArguments& arguments, const Control& control, Progress& progress) {
  auto promise = promise_of<typename Kind::Point>(arguments, control);
  const ReportedOptions& options = promise.options;
  progress.begin("reading");
  std::vector<std::string> notes;
  auto input = read_domain<typename Kind::Domain>(arguments.input, control, notes);
  const auto mesh = read_mesh<typename Kind::Mesh>(arguments.mesh, control);
  auto criteria = Kind::criteria(options);
  if (!options.size_points_file.empty())
    criteria.size = read_size_points<typename Kind::Point>(find_size_points(options.size_points_file, arguments.report),
                                                           options.gradation, control);
  criteria.complete = promise.complete;
  criteria.listed = std::move(promise.unmet);
  progress.begin("verifying");
  const VerifyReport report = run_verification(std::move(input), mesh, std::move(criteria), options, control);
  progress.finish();
  fmt::print("mesh      {}: {}, {}\n", arguments.mesh, elements_text(mesh), counted(mesh.points.size(), "vertex", "vertices"));
  fmt::print("input     {}\npromised  {}\n\n{}", arguments.input, promise_text<Kind>(options, promise.complete), verify_table(report));
  return report.ok() ? ExitCode::ok : ExitCode::verification_failed;
}

ExitCode verify(const VerifyArguments& arguments, const Control& control, Progress& progress) {
  const Dimension dimension = dimension_of(arguments.input, control);
  refuse_options_of_the_other_dimension(arguments.given, dimension, arguments.input, "verify");
  if (dimension == Dimension::plane) return verify<Plane>(arguments, control, progress);
  return verify<Space>(arguments, control, progress);
}

}  // namespace

ExitCode run(const VerifyArguments& arguments) {
  const StopOnSignal signals;
  const Control control({.time_limit = std::chrono::hours(24 * 365)}, signals.token());
  Progress progress(true, signals.token());
  try {
    return verify(arguments, control, progress);
  } catch (const Interrupted&) {
    progress.finish();
    fmt::print(stderr, "delref: interrupted while {}; the mesh was not checked to the end\n", progress.stage());
    return ExitCode::interrupted;
  }
}

}  // namespace delref::program
