// SPDX-License-Identifier: GPL-3.0-or-later
#include "files.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include <delref/io/planar_formats.hpp>
#include <delref/io/report_json.hpp>

#include "exit_codes.hpp"

namespace delref::program {

namespace fs = std::filesystem;

Pslg read_domain(const std::string& path, const Control& control, std::vector<std::string>& notes) {
  PslgFile file = read_pslg(path, control);
  std::ranges::move(file.notes, std::back_inserter(notes));
  return std::move(file.pslg);
}

PlanarMesh read_mesh(const std::string& path, const Control& control) {
  const std::string extension = delref::detail::lower_extension(path);
  const auto refuse = [&](const char* why) {
    throw InvalidInput(fmt::format("{}: {}; read the .vtu, .msh or .node of the same run instead", path, why));
  };
  if (extension == ".svg") refuse("an .svg is a picture, with rounded coordinates and without the smallest triangles");
  if (extension == ".off") refuse("an .off file carries no subsegments, markers or regions, and is written only");
  if (extension == ".mesh") refuse("a MEDIT .mesh file is written only");
  return read_planar_mesh(path, control);
}

ReportedPromise read_promise(const std::string& path, const Control& control) { return read_report(path, control); }

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

std::vector<fs::path> files_of(const std::string& output) {
  try {
    return planar_mesh_files(output);
  } catch (const OutputError& error) {
    throw UsageError(error.what());
  }
}

}  // namespace

void check_outputs(const OutputPlan& plan) {
  std::map<fs::path, std::string> taken;
  for (const std::string& input : plan.inputs) taken.emplace(resolved(input), "is read as input");
  const auto take = [&](const fs::path& file, const std::string& use) {
    const auto [entry, is_new] = taken.emplace(resolved(file), use);
    if (!is_new) throw UsageError(fmt::format("{}: {} already; choose another name", file.string(), entry->second));
  };
  std::vector<fs::path> files;
  for (const std::string& output : plan.meshes)
    for (const fs::path& file : files_of(output)) {
      take(file, "would be written for -o " + output);
      files.push_back(file);
    }
  if (!plan.report.empty()) {
    take(plan.report, "would be written for --report");
    files.emplace_back(plan.report);
  }
  for (const fs::path& file : files) check_writable(file);
}

std::vector<std::string> write_mesh(const std::string& path, const PlanarMesh& mesh, const Pslg& input, const RunReport& report,
                                    bool colour_by_region) {
  PlanarFileContext context;
  context.input = &input;
  context.input_file = report.input_file;
  context.picture.colouring = colour_by_region ? SvgColouring::region : SvgColouring::smallest_angle;
  context.picture.title = fs::path(report.input_file).filename().string();
  if (report.options.min_angle_degrees > 0)
    context.picture.title += fmt::format(", angle bound {:g} degrees", report.options.min_angle_degrees);
  context.picture.unmet = report.outcome.unmet;
  write_planar_mesh(path, mesh, context);
  std::vector<std::string> names;
  for (const fs::path& file : planar_mesh_files(path)) names.push_back(file.string());
  return names;
}

void write_run_report(const std::string& path, const RunReport& report) { write_report(path, report); }

}  // namespace delref::program
