// SPDX-License-Identifier: GPL-3.0-or-later
//
// `delref info`: the quality table, and how many elements carry each label.
#include <chrono>
#include <cstdio>
#include <string>
#include <variant>

#include <fmt/format.h>

#include <delref/core/budget.hpp>
#include <delref/io/mesh_formats.hpp>
#include <delref/mesh/quality.hpp>
#include <delref/mesh/quality_table.hpp>
#include <delref/mesh/surface_quality.hpp>
#include <delref/mesh/tetrahedral_quality.hpp>
#include <delref/mesh/tetrahedral_quality_table.hpp>

#include "commands.hpp"
#include "files.hpp"
#include "interrupt.hpp"
#include "label_tables.hpp"
#include "progress.hpp"

namespace delref::program {
namespace {

std::string description(const PlanarMesh& mesh, const Control&) { return quality_table(planar_quality(mesh)) + label_tables(mesh); }
std::string description(const TetrahedralMesh& mesh, const Control& control) {
  if (!mesh.tetrahedra.empty() || mesh.triangles.empty()) return quality_table(tetrahedral_quality(mesh, control)) + label_tables(mesh);
  SurfaceQuality quality = surface_quality(mesh, control);
  quality.areas.clear();  // the tables of labels have them
  return quality_table(quality) + label_tables(mesh);
}

}  // namespace

ExitCode run(const InfoArguments& arguments) {
  const StopOnSignal signals;
  const Control control({.time_limit = std::chrono::hours(24 * 365)}, signals.token());
  Progress progress(true, signals.token());
  try {
    progress.begin("reading");
    const auto mesh = read_mesh<AnyMesh>(arguments.mesh, control);
    progress.begin("measuring");
    const std::string text = std::visit([&](const auto& its) { return description(its, control); }, mesh);
    progress.finish();
    fmt::print("{}\n\n{}", arguments.mesh, text);
    return ExitCode::ok;
  } catch (const Interrupted&) {
    progress.finish();
    fmt::print(stderr, "delref: interrupted while {} {}\n", progress.stage(), arguments.mesh);
    return ExitCode::interrupted;
  }
}

}  // namespace delref::program
