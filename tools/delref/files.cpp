// SPDX-License-Identifier: GPL-3.0-or-later
#include "files.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include <delref/io/mesh_formats.hpp>
#include <delref/io/planar_formats.hpp>
#include <delref/io/polyhedral_formats.hpp>
#include <delref/io/report_json.hpp>
#include <delref/io/surface_formats.hpp>
#include <delref/io/tetrahedral_formats.hpp>

#include "exit_codes.hpp"

namespace delref::program {

namespace fs = std::filesystem;

template <>
Pslg read_domain(const std::string& path, const ReportedOptions&, const Control& control, std::vector<std::string>& notes) {
  PslgFile file = read_pslg(path, control);
  std::ranges::move(file.notes, std::back_inserter(notes));
  return std::move(file.pslg);
}

template <>
Plc read_domain(const std::string& path, const ReportedOptions&, const Control& control, std::vector<std::string>& notes) {
  PlcFile file = read_plc(path, control);
  std::ranges::move(file.notes, std::back_inserter(notes));
  return std::move(file.plc);
}

template <>
SmoothDomain read_domain(const std::string& path, const ReportedOptions& options, const Control& control, std::vector<std::string>& notes) {
  const ReportedSmoothOptions& smooth = *options.smooth;
  if (!smooth.expressions.empty()) return function_domain(smooth, control, notes);
  if (smooth.iso || smooth.labels) return image_domain(path, smooth, control, notes);
  return point_set_domain(path, smooth, control, notes);
}

namespace {

[[noreturn]] void refuse_mesh(const std::string& path, const char* why) {
  throw InvalidInput(fmt::format("{}: {}; read the .vtu, .msh or .node of the same run instead", path, why));
}

/// For formats that only the planar mesher writes.
void refuse_pictures(const std::string& path, const std::string& extension) {
  if (extension == ".svg") refuse_mesh(path, "an .svg is a picture, with rounded coordinates and without the smallest triangles");
  if (extension == ".off") refuse_mesh(path, "an .off file carries no subsegments, markers or regions, and is written only");
}

}  // namespace

template <>
PlanarMesh read_mesh(const std::string& path, const Control& control) {
  const std::string extension = delref::detail::lower_extension(path);
  refuse_pictures(path, extension);
  if (extension == ".mesh") refuse_mesh(path, "the MEDIT .mesh file of a planar mesh is written only");
  return read_planar_mesh(path, control);
}

template <>
TetrahedralMesh read_mesh(const std::string& path, const Control& control) {
  return read_tetrahedral_mesh(path, control);
}

template <>
AnyMesh read_mesh(const std::string& path, const Control& control) {
  refuse_pictures(path, delref::detail::lower_extension(path));
  return delref::read_mesh(path, control);
}

template <>
ReportedPromise read_promise(const std::string& path, const Control& control) {
  return read_report<Point2>(path, control);
}

template <>
PolyhedralPromise read_promise(const std::string& path, const Control& control) {
  return read_report<Point3>(path, control);
}

std::optional<ReportedSmoothOptions> reported_smooth_options(const std::string& path, const Control& control) {
  try {
    return read_report<Point3>(path, control).options.smooth;
  } catch (const InvalidInput&) {
    return std::nullopt;  // whoever reads it as what it should be tells what is wrong
  }
}

namespace {

/// A name for a file that two spellings of its path share.
fs::path resolved(const fs::path& path) {
  std::error_code error;
  const fs::path result = fs::weakly_canonical(fs::absolute(path), error);
  return error ? path : result;
}

/// Throws `OutputError` unless a file can be made beside `path`, by making one. What is no regular file (a pipe) is left alone.
void check_writable(const fs::path& path) {
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (!fs::exists(folder)) throw OutputError(fmt::format("{}: the folder {} does not exist", path.string(), folder.string()));
  const fs::file_status status = fs::status(path);
  if (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status)) return;
  const OutputFile probe(path);
}

/// The files of the tetrahedral formats or of those of surfaces.
std::vector<fs::path> smooth_mesh_files(const std::string& output) {
  if (is_surface_format(output)) return {output};
  try {
    return tetrahedral_mesh_files(output);
  } catch (const OutputError&) {
    throw OutputError(delref::detail::unknown_extension(
        output, "a mesh of a smooth domain that can be written;",
        fmt::format("{} (tetrahedra), {} (surfaces)", writable_tetrahedral_formats, surface_formats)));
  }
}

std::vector<fs::path> files_of(const std::string& output, InputKind kind) {
  try {
    if (is_smooth(kind)) return smooth_mesh_files(output);
    return kind == InputKind::plane ? planar_mesh_files(output) : tetrahedral_mesh_files(output);
  } catch (const OutputError& error) {
    throw UsageError(error.what());
  }
}

}  // namespace

std::vector<fs::path> check_outputs(const OutputPlan& plan, InputKind kind) {
  std::map<fs::path, std::string> taken;
  for (const std::string& input : plan.inputs) taken.emplace(resolved(input), "is read as input");
  std::vector<fs::path> files;
  const auto take = [&](const fs::path& file, const std::string& use) {
    const auto [entry, is_new] = taken.emplace(resolved(file), use);
    if (!is_new) throw UsageError(fmt::format("{}: {} already; choose another name", file.string(), entry->second));
    files.push_back(file);
  };
  for (const std::string& output : plan.meshes)
    for (const fs::path& file : files_of(output, kind)) take(file, "would be written for -o " + output);
  if (!plan.report.empty()) take(plan.report, "would be written for --report");
  for (const fs::path& file : files) check_writable(file);
  return files;
}

void remove_partial_files(const std::vector<fs::path>& files) {
  std::error_code ignored;
  for (const fs::path& file : files) fs::remove(partial_path(file), ignored);
}

namespace {

/// Writing is not stopped by the limit of the run, which kept time back for it.
Control unlimited() { return Control({.time_limit = std::chrono::hours(24 * 365)}); }

std::vector<std::string> names(const std::vector<fs::path>& files) {
  std::vector<std::string> names;
  for (const fs::path& file : files) names.push_back(file.string());
  return names;
}

}  // namespace

std::vector<std::string> write_mesh(const std::string& path, const PlanarRun& run, const Pslg& input, const RunReport& report,
                                    const MeshArguments& arguments) {
  PlanarFileContext context;
  context.input = &input;
  context.input_file = report.input_file;
  context.picture.colouring = arguments.svg_by_region ? SvgColouring::region : SvgColouring::smallest_angle;
  context.picture.title = fs::path(report.input_file).filename().string();
  if (report.options.min_angle_degrees > 0)
    context.picture.title += fmt::format(", angle bound {:g} degrees", report.options.min_angle_degrees);
  context.picture.unmet = report.outcome.unmet;
  write_planar_mesh(path, run.mesh, context, unlimited());
  return names(planar_mesh_files(path));
}

std::vector<std::string> write_mesh(const std::string& path, const PolyhedralRun& run, const Plc& input,
                                    const PolyhedralRunReport& report, const MeshArguments&) {
  TetrahedralFileContext context;
  context.input = &input;
  context.original_point = run.original_point;
  context.input_file = report.input_file;
  write_tetrahedral_mesh(path, run.mesh, context, unlimited());
  return names(tetrahedral_mesh_files(path));
}

std::vector<std::string> write_mesh(const std::string& path, const SmoothRun& run, const SmoothDomain&, const PolyhedralRunReport& report,
                                    const MeshArguments&) {
  if (is_surface_format(path)) {
    write_surface(path, run.mesh, unlimited());
    return {path};
  }
  TetrahedralFileContext context;
  context.input_file = report.input_file;
  write_tetrahedral_mesh(path, run.mesh, context, unlimited());
  return names(tetrahedral_mesh_files(path));
}

void write_run_report(const std::string& path, const RunReport& report) { write_report(path, report); }
void write_run_report(const std::string& path, const PolyhedralRunReport& report) { write_report(path, report); }

}  // namespace delref::program
