// SPDX-License-Identifier: GPL-3.0-or-later
#include "summary.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include <delref/domain/describe.hpp>

#include "words.hpp"

namespace delref::program {
namespace {

/// Why an element was left, as a clause after its number.
const char* because(Reason reason) {
  switch (reason) {
    case Reason::small_input_angle:
      return "forced by a small angle of the input";
    case Reason::precision:
      return "at the limit of floating-point numbers";
    case Reason::size_floor:
      return "already as small as --smallest-edge allows";
    case Reason::protected_segment:
      return "would need the split of a boundary that --keep-boundary protects";
    case Reason::outside:
      return "the refinement point lies outside the domain";
    case Reason::blocked:
      return "a segment hides the refinement point";
    case Reason::level_contract:
      return "a level rejected the point without work of its own";
    case Reason::rejected_by_level:
      return "a level rejected the point for good";
    case Reason::budget:
      return "not reached before the run was stopped";
  }
  return "for an unknown reason";
}

std::string sentence(const RunReport& report, Stop stop) {
  switch (stop) {
    case Stop::token:
      return "Interrupted";
    case Stop::time:
      return report.options.time_limit_seconds
                 ? fmt::format("Stopped at the time limit of {:g} s", *report.options.time_limit_seconds)
                 : "Stopped at the time limit (--time-limit gives more)";
    case Stop::vertices:
      return report.options.max_vertices
                 ? fmt::format("Stopped at the limit of {} vertices", grouped(*report.options.max_vertices))
                 : "Stopped at the limit of vertices (--max-vertices gives more)";
  }
  return "Stopped";
}

/// "1 triangle misses", "12 edges miss": what the unmet elements are, by their number of vertices.
std::string unmet_elements(const Outcome<Point2>& outcome, const char* one_verb, const char* many_verb) {
  const auto all_have = [&](std::size_t vertices) {
    return std::ranges::all_of(outcome.unmet, [=](const auto& u) { return u.vertex_count == vertices; });
  };
  const std::string text = all_have(3)   ? counted(outcome.unmet.size(), "triangle", "triangles")
                           : all_have(2) ? counted(outcome.unmet.size(), "edge", "edges")
                                         : counted(outcome.unmet.size(), "element", "elements");
  return text + (outcome.unmet.size() == 1 ? one_verb : many_verb);
}

std::size_t forced(const Outcome<Point2>& outcome) { return outcome.unmet_count(Reason::small_input_angle); }

/// "5,984 of the input, 819 added on segments, 2,527 added inside".
std::string origins(const PlanarMesh& mesh) {
  std::size_t of_input = 0, on_segments = 0;
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    if (mesh.provenance[v] == input_level)
      ++of_input;
    else if (mesh.carriers[v].dimension == 1)
      ++on_segments;
  }
  return fmt::format("{} of the input, {} added on segments, {} added inside", grouped(of_input), grouped(on_segments),
                     grouped(mesh.points.size() - of_input - on_segments));
}

std::string angles(const RunReport& report) {
  const double bound = report.options.min_angle_degrees;
  std::string text = fmt::format("{:.4g} degrees", report.quality ? report.quality->smallest_angle : 0.0);
  if (bound > 0) text += fmt::format(" ({:g} asked for)", bound);
  return text;
}

std::string times(const RunReport& report) {
  double total = 0;
  std::string parts;
  for (const auto& [stage, seconds] : report.seconds) {
    total += seconds;
    parts += fmt::format("{}{} {}", parts.empty() ? "" : ", ", stage, seconds_text(seconds));
  }
  return fmt::format("{} ({})", seconds_text(total), parts);
}

}  // namespace

ExitCode exit_code(const Outcome<Point2>& outcome, bool strict) {
  if (outcome.stopped == Stop::token) return ExitCode::interrupted;
  if (outcome.stopped) return ExitCode::unmet;
  const std::size_t tolerated = strict ? 0 : forced(outcome);
  return outcome.unmet.size() > tolerated ? ExitCode::unmet : ExitCode::ok;
}

std::string verdict(const RunReport& report) {
  const Outcome<Point2>& outcome = report.outcome;
  const std::size_t unmet = outcome.unmet.size(), excused = forced(outcome);
  if (outcome.stopped)
    return fmt::format("{}: the mesh is valid but not finished; {} a criterion.", sentence(report, *outcome.stopped),
                       unmet_elements(outcome, " misses", " miss"));
  if (unmet == 0) return "Every criterion is met.";
  if (unmet == excused)
    return fmt::format("Every criterion is met, but for {} where small angles of the input make that impossible.",
                       unmet_elements(outcome, "", ""));
  return fmt::format("NOT every criterion is met: {} a criterion{}.", unmet_elements(outcome, " misses", " miss"),
                     excused > 0 ? fmt::format(" ({} of them because of small input angles)", grouped(excused)) : "");
}

std::string unmet_table(const Outcome<Point2>& outcome) {
  struct Group {
    std::size_t count = 0;
    Point2 first;
  };
  std::map<std::tuple<Reason, LevelIndex, std::string>, Group> groups;
  for (const auto& unmet : outcome.unmet) {
    Group& group = groups[{unmet.reason, unmet.level, unmet.criterion}];
    if (group.count++ == 0) group.first = unmet.place;
  }
  std::string text;
  for (const auto& [key, group] : groups)
    text += fmt::format("{:>9}  {}: {}; {} ({:.6g}, {:.6g})\n", grouped(group.count), std::get<2>(key), because(std::get<0>(key)),
                        group.count == 1 ? "at" : "one is at", group.first.x, group.first.y);
  return text;
}

std::string summary(const RunReport& report, const PlanarMesh& mesh, const std::vector<std::string>& files) {
  std::string text = fmt::format("{}: {}, {}\n", report.input_file, counted(report.input.vertices, "vertex", "vertices"),
                                 counted(report.input.segments, "segment", "segments"));
  for (const std::string& note : report.notes) text += fmt::format("note: {}\n", note);
  const auto row = [&](const char* name, const std::string& value) { text += fmt::format("{:<16}{}\n", name, value); };
  text += '\n';
  row("triangles", grouped(report.mesh.triangles));
  row("vertices", fmt::format("{} ({})", grouped(report.mesh.vertices), origins(mesh)));
  row("smallest angle", angles(report));
  row("time", times(report));
  const char* name = "written";
  for (const std::string& file : files) row(std::exchange(name, ""), file);
  if (const std::string unmet = unmet_table(report.outcome); !unmet.empty()) text += "\nunmet\n" + unmet;
  return text + '\n' + verdict(report) + '\n';
}

}  // namespace delref::program
