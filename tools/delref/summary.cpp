// SPDX-License-Identifier: GPL-3.0-or-later
#include "summary.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <tuple>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include <delref/domain/describe.hpp>

#include "rows.hpp"
#include "surface_summary.hpp"
#include "words.hpp"

namespace delref::program {
namespace {

/// Why an element was left, as a clause after its number.
const char* because(Reason reason, bool is_smooth) {
  switch (reason) {
    case Reason::small_input_angle:
      return "forced by a small angle of the input";
    case Reason::precision:
      return "at the limit of floating-point numbers";
    case Reason::size_floor:
      return is_smooth ? "already as small as the size floor" : "already as small as --smallest-edge allows";
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

std::string sentence(const ReportedOptions& options, Stop stop) {
  switch (stop) {
    case Stop::token:
      return "Interrupted";
    case Stop::time:
      return options.time_limit_seconds
                 ? fmt::format("Stopped at the time limit of {:g} s", *options.time_limit_seconds)
                 : "Stopped at the time limit (--time-limit gives more)";
    case Stop::vertices:
      return options.max_vertices
                 ? fmt::format("Stopped at the limit of {} vertices", grouped(*options.max_vertices))
                 : "Stopped at the limit of vertices (--max-vertices gives more)";
  }
  return "Stopped";
}

/// All that is unmet, listed or not.
template <class Point>
std::size_t unmet_elements(const Outcome<Point>& outcome) {
  const auto listed = std::ranges::count_if(outcome.unmet, [](const auto& u) { return u.reason != Reason::budget; });
  return static_cast<std::size_t>(listed) + outcome.unmet_count(Reason::budget);
}

/// "1 triangle misses", "12 edges miss": what the unmet elements are, by their number of vertices.
template <class Point>
std::string unmet_elements(const Outcome<Point>& outcome, const char* one_verb, const char* many_verb) {
  const auto all_have = [&](std::size_t vertices) {
    return std::ranges::all_of(outcome.unmet, [=](const auto& u) { return u.vertex_count == vertices; });
  };
  const std::size_t count = unmet_elements(outcome);
  const std::string text = all_have(4)   ? counted(count, "tetrahedron", "tetrahedra")
                           : all_have(3) ? counted(count, "triangle", "triangles")
                           : all_have(2) ? counted(count, "edge", "edges")
                                         : counted(count, "element", "elements");
  return text + (count == 1 ? one_verb : many_verb);
}

template <class Point>
std::size_t forced(const Outcome<Point>& outcome) {
  return outcome.unmet_count(Reason::small_input_angle);
}

std::string at(Point2 p) { return fmt::format("({:.6g}, {:.6g})", p.x, p.y); }
std::string at(Point3 p) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x, p.y, p.z); }

/// Of a smooth domain: "5 seeds, 1,234 added on the surface, 2,527 added inside".
std::string smooth_origins(const TetrahedralMesh& mesh) {
  std::size_t seeds = 0, on_surface = 0;
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    seeds += mesh.provenance[v] == input_level;
    on_surface += mesh.provenance[v] != input_level && mesh.carriers[v].dimension == 2;
  }
  return fmt::format("{} seeds, {} added on the surface, {} added inside", grouped(seeds), grouped(on_surface),
                     grouped(mesh.points.size() - seeds - on_surface));
}

/// "5,984 of the input, 819 added on segments, 2,527 added inside", and in space those on facets.
template <class Mesh>
std::string origins(const Mesh& mesh) {
  constexpr bool in_space = std::is_same_v<Mesh, TetrahedralMesh>;
  std::size_t of_input = 0, on_segments = 0, on_facets = 0;
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    if (mesh.provenance[v] == input_level)
      ++of_input;
    else if (mesh.carriers[v].dimension == 1)
      ++on_segments;
    else if (in_space && mesh.carriers[v].dimension == 2)
      ++on_facets;
  }
  return fmt::format("{} of the input, {} added on segments, {}{} added inside", grouped(of_input), grouped(on_segments),
                     in_space ? grouped(on_facets) + " on facets, " : "",
                     grouped(mesh.points.size() - of_input - on_segments - on_facets));
}

std::string origins_of(const RunReport&, const PlanarMesh& mesh) { return origins(mesh); }
std::string origins_of(const PolyhedralRunReport& report, const TetrahedralMesh& mesh) {
  return report.surface ? smooth_origins(mesh) : origins(mesh);
}

std::string times(const std::vector<std::pair<std::string, double>>& seconds) {
  double total = 0;
  std::string parts;
  for (const auto& [stage, its] : seconds) {
    total += its;
    parts += fmt::format("{}{} {}", parts.empty() ? "" : ", ", stage, seconds_text(its));
  }
  return fmt::format("{} ({})", seconds_text(total), parts);
}

void add_quality(Rows& rows, const RunReport& report) {
  const double bound = report.options.min_angle_degrees;
  rows.add("smallest angle", fmt::format("{:.4g} degrees{}", report.quality ? report.quality->smallest_angle : 0.0,
                                         bound > 0 ? fmt::format(" ({:g} asked for)", bound) : ""));
}

void add_quality(Rows& rows, const PolyhedralRunReport& report) {
  if (report.surface) add_surface(rows, report);
  if (report.quality && report.mesh.tetrahedra > 0) {
    const TetrahedralQuality& q = *report.quality;
    rows.add("radius-edge", fmt::format("{:.4g} at worst ({:g} asked for)", q.worst_radius_edge, report.options.radius_edge));
    rows.add("dihedral angles", fmt::format("{:.4g} to {:.4g} degrees; {} under 5 degrees", q.smallest_dihedral, q.largest_dihedral,
                                            counted(q.under_5_degrees, "tetrahedron has one", "tetrahedra have one")));
    rows.add("volume", fmt::format("{:.10g}", q.total_volume));
  }
  if (report.input_angles.empty()) return;
  const ReportedAngle& smallest = report.input_angles.front();
  rows.add("input angles", fmt::format("{} under 90 degrees; the smallest is {:.4g}, of {} and {} at {}", grouped(report.input_angle_count),
                                       smallest.degrees, smallest.elements[0], smallest.elements[1], at(smallest.place)));
}

std::string input_text(const ReportedCounts& input, bool in_space) {
  std::string text = counted(input.vertices, "vertex", "vertices");
  if (input.segments > 0 || !in_space) text += ", " + counted(input.segments, "segment", "segments");
  if (in_space) text += ", " + counted(input.facets, "facet", "facets");
  return text;
}

template <class Report, class Mesh>
std::string summary_of(const Report& report, const Mesh& mesh, const std::vector<std::string>& files) {
  constexpr bool in_space = std::is_same_v<Mesh, TetrahedralMesh>;
  const std::string input = report.surface ? report.surface->domain : input_text(report.input, in_space);
  std::string text = report.input_file.empty() ? input + '\n' : fmt::format("{}: {}\n", report.input_file, input);
  for (const std::string& note : report.notes) text += fmt::format("note: {}\n", note);
  Rows rows;
  if (report.surface && report.options.smooth->surface_only)
    rows.add("tetrahedra", "none (--surface-only)");
  else if (in_space)
    rows.add("tetrahedra", grouped(report.mesh.tetrahedra));
  else
    rows.add("triangles", grouped(report.mesh.triangles));
  rows.add("vertices", fmt::format("{} ({})", grouped(report.mesh.vertices), origins_of(report, mesh)));
  add_quality(rows, report);
  rows.add("time", times(report.seconds));
  const char* name = "written";
  for (const std::string& file : files) rows.add(std::exchange(name, ""), file);
  text += '\n' + rows.text();
  if (const std::string unmet = unmet_table(report); !unmet.empty()) text += "\nunmet\n" + unmet;
  return text + '\n' + verdict(report) + '\n';
}

template <class Report>
std::string missing_of(const Report& report) {
  return report.surface ? missing_parts(*report.surface) : std::string();
}

}  // namespace

template <class Report>
ExitCode exit_code(const Report& report, bool strict) {
  if (report.outcome.stopped == Stop::token) return ExitCode::interrupted;
  if (report.outcome.stopped || !report.conforms || !missing_of(report).empty()) return ExitCode::unmet;
  const std::size_t tolerated = strict ? 0 : forced(report.outcome);
  return report.outcome.unmet.size() > tolerated ? ExitCode::unmet : ExitCode::ok;
}

template <class Report>
std::string verdict(const Report& report) {
  const auto& outcome = report.outcome;
  const std::size_t unmet = outcome.unmet.size(), excused = forced(outcome);
  if (!report.conforms)
    return fmt::format("{} before every segment and facet of the input was known to be in the mesh; {} to be refined.",
                       outcome.stopped ? sentence(report.options, *outcome.stopped) : "The run ended",
                       unmet_elements(outcome, " is", " are"));
  if (outcome.stopped)
    return fmt::format("{}: the mesh is valid but not finished; {} a criterion.", sentence(report.options, *outcome.stopped),
                       unmet_elements(outcome, " misses", " miss"));
  if (const std::string missing = missing_of(report); !missing.empty())
    return fmt::format("NOT the whole surface is in the mesh: it lacks {}, thinner or smaller than the facets there. A smaller --facet-size, or "
                       "--smallest-facet, may bring them in.{}",
                       missing, unmet > 0 ? fmt::format(" Besides, {} a criterion.", unmet_elements(outcome, " misses", " miss")) : "");
  if (unmet == 0) {
    const std::string doubt = report.surface ? doubt_about_components(*report.surface) : std::string();
    return doubt.empty() ? "Every criterion is met." : "Every criterion is met, but " + doubt;
  }
  if (unmet == excused)
    return fmt::format("Every criterion is met, but for {} where small angles of the input make that impossible.",
                       unmet_elements(outcome, "", ""));
  return fmt::format("NOT every criterion is met: {} a criterion{}.", unmet_elements(outcome, " misses", " miss"),
                     excused > 0 ? fmt::format(" ({} of them because of small input angles)", grouped(excused)) : "");
}

template <class Report>
std::string unmet_table(const Report& report) {
  const auto& outcome = report.outcome;
  struct Group {
    std::size_t count = 0;
    std::remove_cvref_t<decltype(outcome.unmet.front().place)> first;
  };
  std::map<std::tuple<Reason, LevelIndex, std::string>, Group> groups;
  for (const auto& unmet : outcome.unmet) {
    Group& group = groups[{unmet.reason, unmet.level, unmet.criterion}];
    if (group.count++ == 0) group.first = unmet.place;
  }
  std::string text;
  for (const auto& [key, group] : groups)
    text += fmt::format("{:>9}  {}: {}; {} {}\n", grouped(group.count), std::get<2>(key), because(std::get<0>(key), report.surface.has_value()),
                        group.count == 1 ? "at" : "one is at", at(group.first));
  if (const std::size_t more = unmet_elements(outcome) - outcome.unmet.size(); more > 0)
    text += fmt::format("{:>9}  more that were not reached\n", grouped(more));
  return text;
}

std::string summary(const RunReport& report, const PlanarMesh& mesh, const std::vector<std::string>& files) {
  return summary_of(report, mesh, files);
}
std::string summary(const PolyhedralRunReport& report, const TetrahedralMesh& mesh, const std::vector<std::string>& files) {
  return summary_of(report, mesh, files);
}

template ExitCode exit_code(const RunReport&, bool);
template ExitCode exit_code(const PolyhedralRunReport&, bool);
template std::string verdict(const RunReport&);
template std::string verdict(const PolyhedralRunReport&);
template std::string unmet_table(const RunReport&);
template std::string unmet_table(const PolyhedralRunReport&);

}  // namespace delref::program
