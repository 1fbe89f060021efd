// SPDX-License-Identifier: GPL-3.0-or-later
//
// `delref info`: the quality table, and how many elements carry each label.
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <map>
#include <string>

#include <fmt/format.h>

#include <delref/core/budget.hpp>
#include <delref/mesh/planar_mesh.hpp>
#include <delref/mesh/quality.hpp>
#include <delref/mesh/quality_table.hpp>

#include "commands.hpp"
#include "files.hpp"
#include "interrupt.hpp"
#include "progress.hpp"
#include "words.hpp"

namespace delref::program {
namespace {

struct Tally {
  std::size_t count = 0;
  double measure = 0;
};
using Tallies = std::map<int, Tally>;

double area(const PlanarMesh& mesh, std::size_t t) {
  const auto& [a, b, c] = mesh.triangles[t];
  return 0.5 * cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]);
}

double length(const PlanarMesh& mesh, std::size_t e) {
  const Vector2 v = mesh.points[mesh.edges[e][1]] - mesh.points[mesh.edges[e][0]];
  return std::hypot(v.x, v.y);
}

/// Rows by label, at most so many that they fit on a screen.
std::string table(const char* title, const char* label, const char* count, const char* measure, const Tallies& tallies) {
  constexpr std::size_t most_rows = 30;
  std::string text = fmt::format("\n{}\n  {:>10} {:>12}", title, label, count);
  if (*measure != '\0') text += fmt::format(" {:>14}", measure);
  text += '\n';
  std::size_t rows = 0;
  for (const auto& [key, tally] : tallies) {
    if (rows++ == most_rows) {
      text += fmt::format("  {:>10}\n", fmt::format("... and {} more", grouped(tallies.size() - most_rows)));
      break;
    }
    text += fmt::format("  {:>10} {:>12}", key, grouped(tally.count));
    if (*measure != '\0') text += fmt::format(" {:>14.6g}", tally.measure);
    text += '\n';
  }
  return text;
}

std::string regions(const PlanarMesh& mesh) {
  if (mesh.regions.empty()) return "\nThe file carries no regions.\n";
  Tallies tallies;
  for (std::size_t t = 0; t < mesh.regions.size(); ++t) {
    Tally& tally = tallies[mesh.regions[t]];
    ++tally.count;
    tally.measure += area(mesh, t);
  }
  return table("Regions:", "label", "triangles", "area", tallies);
}

std::string subsegments(const PlanarMesh& mesh) {
  if (mesh.edges.empty()) return "\nThe file carries no subsegments.\n";
  Tallies tallies;
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    Tally& tally = tallies[mesh.edge_markers.empty() ? 0 : mesh.edge_markers[e]];
    ++tally.count;
    tally.measure += length(mesh, e);
  }
  return table("Subsegments (edges on segments of the input):", "marker", "edges", "length", tallies);
}

std::string vertices(const PlanarMesh& mesh) {
  std::string text;
  if (!mesh.point_markers.empty()) {
    Tallies tallies;
    for (const int marker : mesh.point_markers) ++tallies[marker].count;
    text += table("Vertices:", "marker", "vertices", "", tallies);
  }
  if (mesh.provenance.empty()) return text;
  std::map<LevelIndex, std::size_t> inserted;
  for (const LevelIndex level : mesh.provenance) ++inserted[level];
  text += "\nWho made the vertices:\n";
  for (const auto& [level, count] : inserted) {
    const std::string name = level < mesh.level_names.size() ? mesh.level_names[level]
                             : level == input_level          ? "input"
                                                             : fmt::format("level {}", level);
    text += fmt::format("  {:>10} {:>12}\n", name, grouped(count));
  }
  return text;
}

}  // namespace

ExitCode run(const InfoArguments& arguments) {
  const StopOnSignal signals;
  const Control control({.time_limit = std::chrono::hours(24 * 365)}, signals.token());
  Progress progress(true, signals.token());
  try {
    progress.begin("reading");
    const PlanarMesh mesh = read_mesh(arguments.mesh, control);
    progress.begin("measuring");
    const std::string text = quality_table(planar_quality(mesh)) + regions(mesh) + subsegments(mesh) + vertices(mesh);
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
