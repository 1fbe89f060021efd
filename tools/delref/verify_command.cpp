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
#include <delref/io/report_json.hpp>

#include "commands.hpp"
#include "files.hpp"
#include "input_kind.hpp"
#include "interrupt.hpp"
#include "planar_run.hpp"
#include "polyhedral_run.hpp"
#include "progress.hpp"
#include "size_points.hpp"
#include "smooth_run.hpp"
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

std::string shape_text(const ReportedOptions& o, Smooth) {
  const ReportedSmoothOptions& s = *o.smooth;
  std::string text = s.facet_angle_degrees > 0 ? fmt::format("facet angles of at least {:g} degrees", s.facet_angle_degrees) : "any facet angles";
  if (s.facet_size) text += fmt::format(", facets of at most {:g}", *s.facet_size);
  if (s.facet_distance) text += fmt::format(", at most {:g} from the surface", *s.facet_distance);
  if (s.surface_only) return text;
  text += fmt::format(", radius-edge ratios of at most {:g}", o.radius_edge);
  if (o.cell_size) text += fmt::format(", circumradii of at most {:g}", *o.cell_size);
  for (const auto& [label, size] : s.region_cell_sizes) text += fmt::format(", in region {} at most {:g}", label, size);
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
  if (!arguments.report.empty()) {
    auto promise = read_promise<Point>(arguments.report, control);
    if (promise.options.smooth.has_value() != arguments.options.smooth.has_value())
      throw InvalidInput(fmt::format("{}: is not the report of a run on such an input as {}", arguments.report, arguments.input));
    return promise;
  }
  BasicPromise<Point> promise;
  promise.options = arguments.options;
  promise.complete = true;
  return promise;
}

template <class Domain>
std::string input_text(const std::string& file, const Domain&) {
  return file;
}
std::string input_text(const std::string& file, const SmoothDomain& domain) {
  return file.empty() ? domain.words : fmt::format("{}, {}", file, domain.words);
}

std::string elements_text(const PlanarMesh& mesh) { return counted(mesh.triangles.size(), "triangle", "triangles"); }
std::string elements_text(const TetrahedralMesh& mesh) {
  if (mesh.tetrahedra.empty()) return counted(mesh.triangles.size(), "triangle", "triangles");
  return counted(mesh.tetrahedra.size(), "tetrahedron", "tetrahedra");
}

template <class Kind>
ExitCode verify(const VerifyArguments& arguments, const Control& control, Progress& progress) {
  auto promise = promise_of<typename Kind::Point>(arguments, control);
  const ReportedOptions& options = promise.options;
  progress.begin("reading");
  std::vector<std::string> notes;
  auto input = read_domain<typename Kind::Domain>(arguments.input, options, control, notes);
  const auto mesh = read_mesh<typename Kind::Mesh>(arguments.mesh, control);
  auto criteria = Kind::criteria(options);
  if (!options.size_points_file.empty())
    Kind::promise_sizes(criteria, read_size_points<typename Kind::Point>(find_size_points(options.size_points_file, arguments.report),
                                                                         options.gradation, control));
  criteria.complete = promise.complete;
  criteria.listed = std::move(promise.unmet);
  if constexpr (requires { criteria.missed_components; }) criteria.missed_components = promise.missed_components;
  progress.begin("verifying");
  const std::string input_words = input_text(arguments.input, input);
  std::string chosen;
  if constexpr (requires { settle_sizes(criteria, promise.facet_sizes, input, control); })
    chosen = settle_sizes(criteria, promise.facet_sizes, input, control);
  const VerifyReport report = run_verification(std::move(input), mesh, std::move(criteria), options, control);
  progress.finish();
  fmt::print("mesh      {}: {}, {}\n", arguments.mesh, elements_text(mesh), counted(mesh.points.size(), "vertex", "vertices"));
  fmt::print("input     {}\npromised  {}\n", input_words, promise_text<Kind>(options, promise.complete));
  if (!chosen.empty()) fmt::print("sizes     {}\n", chosen);
  fmt::print("\n{}", verify_table(report));
  return report.ok() ? ExitCode::ok : ExitCode::verification_failed;
}

/// What the report of a run on a smooth domain says, or else the command line.
ReportedSmoothOptions smooth_options_of(const VerifyArguments& arguments, const Control& control) {
  if (arguments.report.empty()) return arguments.smooth;
  return reported_smooth_options(arguments.report, control).value_or(ReportedSmoothOptions{});
}

ExitCode verify(VerifyArguments arguments, const Control& control, Progress& progress) {
  const ReportedSmoothOptions smooth = smooth_options_of(arguments, control);
  const InputKind kind = kind_of_input(arguments.input, smooth, control);
  refuse_options_of_other_kinds(arguments.given, kind, name_of_input(arguments.input, smooth), "verify");
  if (is_smooth(kind)) arguments.options.smooth = smooth;
  if (is_smooth(kind)) return verify<Smooth>(arguments, control, progress);
  if (kind == InputKind::plane) return verify<Plane>(arguments, control, progress);
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
