// SPDX-License-Identifier: GPL-3.0-or-later
//
// `delref verify`: the promises come from a report or from options.
#include <cstdio>
#include <filesystem>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <delref/core/budget.hpp>
#include <delref/io/report_json.hpp>

#include "commands.hpp"
#include "files.hpp"
#include "interrupt.hpp"
#include "planar_run.hpp"
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

PlanarCriteria planar_criteria(ReportedPromise promise, const std::string& report, const Control& control) {
  const ReportedOptions& o = promise.options;
  PlanarCriteria criteria;
  criteria.min_angle_degrees = o.min_angle_degrees;
  criteria.max_area = o.max_area.value_or(std::numeric_limits<double>::infinity());
  criteria.max_edge = o.max_edge.value_or(std::numeric_limits<double>::infinity());
  if (!o.size_points_file.empty())
    criteria.size = read_size_points(find_size_points(o.size_points_file, report), o.gradation, control);
  criteria.circle = o.encroachment != "lens";
  criteria.complete = promise.complete;
  criteria.listed = std::move(promise.unmet);
  return criteria;
}

/// What the mesh is held against, in one line.
std::string promise_text(const ReportedOptions& o, bool complete) {
  std::string text = o.min_angle_degrees > 0 ? fmt::format("angles of at least {:g} degrees", o.min_angle_degrees) : "any angles";
  if (o.max_area) text += fmt::format(", areas of at most {:g}", *o.max_area);
  if (o.max_edge) text += fmt::format(", edges of at most {:g}", *o.max_edge);
  if (!o.size_points_file.empty()) text += fmt::format(", sizes of {} with gradation {:g}", o.size_points_file, o.gradation);
  text += fmt::format(", encroachment by {}", o.encroachment);
  if (o.keep_boundary) text += ", boundary kept";
  if (o.split_crossings) text += ", input split at crossings";
  if (o.merge_tolerance > 0) text += fmt::format(", input merged within {:g}", o.merge_tolerance);
  return text + (complete ? "" : "; the run was stopped early");
}

ReportedPromise promise_of(const VerifyArguments& arguments, const Control& control) {
  if (!arguments.report.empty()) return read_promise(arguments.report, control);
  ReportedPromise promise;
  promise.options = arguments.options;
  promise.complete = true;
  return promise;
}

ExitCode verify(const VerifyArguments& arguments, const Control& control, Progress& progress) {
  ReportedPromise promise = promise_of(arguments, control);
  const ReportedOptions options = promise.options;
  const std::string promised = promise_text(options, promise.complete);
  progress.begin("reading");
  std::vector<std::string> notes;
  Pslg input = read_domain(arguments.input, control, notes);
  const PlanarMesh mesh = read_mesh(arguments.mesh, control);
  PlanarCriteria criteria = planar_criteria(std::move(promise), arguments.report, control);
  progress.begin("verifying");
  const VerifyReport report = run_verification(std::move(input), mesh, std::move(criteria), options, control);
  progress.finish();
  fmt::print("mesh      {}: {}, {}\n", arguments.mesh, counted(mesh.triangles.size(), "triangle", "triangles"),
             counted(mesh.points.size(), "vertex", "vertices"));
  fmt::print("input     {}\npromised  {}\n\n{}", arguments.input, promised, verify_table(report));
  return report.ok() ? ExitCode::ok : ExitCode::verification_failed;
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
