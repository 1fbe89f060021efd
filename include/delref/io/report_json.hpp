// SPDX-License-Identifier: GPL-3.0-or-later
//
// A report of a run as JSON. Every object has its keys in the order written here, and all that differs between two runs of the
// same thing is in "times", so that reports can be compared as text. Numbers that JSON cannot spell (infinity) are null.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <delref/core/budget.hpp>
#include <delref/io/file.hpp>
#include <delref/io/json.hpp>
#include <delref/io/report.hpp>

namespace delref {

namespace detail {

using OrderedJson = nlohmann::ordered_json;

inline std::string_view stop_name(Stop stop) {
  switch (stop) {
    case Stop::vertices: return "vertices";
    case Stop::time: return "time";
    case Stop::token: return "interrupted";
  }
  return "unknown";
}

template <class Value>
OrderedJson or_null(const std::optional<Value>& value) {
  return value ? OrderedJson(*value) : OrderedJson(nullptr);
}

inline OrderedJson options_json(const ReportedOptions& o, Point2) {
  return {{"min_angle_degrees", o.min_angle_degrees}, {"max_area", or_null(o.max_area)},
          {"max_edge", or_null(o.max_edge)},          {"size_points_file", o.size_points_file},
          {"gradation", o.gradation},                 {"encroachment", o.encroachment},
          {"points", o.points},                       {"keep_boundary", o.keep_boundary},
          {"split_crossings", o.split_crossings},     {"merge_tolerance", o.merge_tolerance},
          {"smallest_edge", o.smallest_edge},         {"max_vertices", or_null(o.max_vertices)},
          {"time_limit_seconds", or_null(o.time_limit_seconds)}};
}
inline OrderedJson smooth_options_json(const ReportedOptions& o, const ReportedSmoothOptions& s) {
  OrderedJson sizes = OrderedJson::array();
  for (const auto& [label, size] : s.region_cell_sizes) sizes.push_back({{"region", label}, {"cell_size", size}});
  return {{"expressions", s.expressions},
          {"bounds", s.bounds},
          {"iso", or_null(s.iso)},
          {"inside", s.inside},
          {"closed_at_border", s.closed_at_border},
          {"labels", s.labels},
          {"background_label", or_null(s.background_label)},
          {"label_smoothing", s.label_smoothing},
          {"point_set", s.point_set},
          {"neighbours", s.neighbours},
          {"outlier_distance", s.outlier_distance},
          {"point_smoothing", s.point_smoothing},
          {"sampling", s.sampling},
          {"facet_angle_degrees", s.facet_angle_degrees},
          {"facet_size", or_null(s.facet_size)},
          {"facet_distance", or_null(s.facet_distance)},
          {"smallest_facet", s.smallest_facet},
          {"surface_only", s.surface_only},
          {"radius_edge", o.radius_edge},
          {"cell_size", or_null(o.cell_size)},
          {"region_cell_sizes", std::move(sizes)},
          {"size_points_file", o.size_points_file},
          {"gradation", o.gradation},
          {"smallest_edge", o.smallest_edge},
          {"max_vertices", or_null(o.max_vertices)},
          {"time_limit_seconds", or_null(o.time_limit_seconds)}};
}
inline OrderedJson options_json(const ReportedOptions& o, Point3) {
  if (o.smooth) return smooth_options_json(o, *o.smooth);
  return {{"radius_edge", o.radius_edge},
          {"max_volume", or_null(o.max_volume)},
          {"cell_size", or_null(o.cell_size)},
          {"size_points_file", o.size_points_file},
          {"gradation", o.gradation},
          {"join_coplanar_degrees", or_null(o.join_coplanar_degrees)},
          {"planarity_tolerance", o.planarity_tolerance},
          {"merge_tolerance", o.merge_tolerance},
          {"smallest_edge", o.smallest_edge},
          {"max_vertices", or_null(o.max_vertices)},
          {"time_limit_seconds", or_null(o.time_limit_seconds)}};
}

inline OrderedJson place_json(Point2 p) { return {p.x, p.y}; }
inline OrderedJson place_json(Point3 p) { return {p.x, p.y, p.z}; }

/// The unmet elements by level, criterion and reason, with their number and their places.
template <class Point>
OrderedJson unmet_json(const Outcome<Point>& outcome) {
  std::map<std::tuple<LevelIndex, std::string, Reason>, OrderedJson> groups;
  for (const auto& unmet : outcome.unmet) {
    auto& places = groups.try_emplace({unmet.level, unmet.criterion, unmet.reason}, OrderedJson::array()).first->second;
    places.push_back(place_json(unmet.place));
  }
  OrderedJson list = OrderedJson::array();
  for (auto& [key, places] : groups) {
    const auto& [level, criterion, reason] = key;
    const std::string name = level < outcome.levels.size() ? outcome.levels[level].name : fmt::format("level {}", level);
    const std::size_t count = places.size();
    list.push_back({{"level", name}, {"criterion", criterion}, {"reason", to_string(reason)}, {"count", count}, {"places", std::move(places)}});
  }
  return list;
}

template <class Point>
OrderedJson outcome_json(const Outcome<Point>& outcome) {
  OrderedJson levels = OrderedJson::array();
  for (const LevelCounts& l : outcome.levels) {
    levels.push_back({{"name", l.name}, {"inserted", l.inserted}, {"rejected", l.rejected}, {"rejected_forever", l.rejected_forever}, {"queued", l.queued}});
  }
  return {{"status", outcome.stopped ? "stopped" : outcome.unmet.empty() ? "every criterion met" : "complete with unmet elements"},
          {"stopped_by", outcome.stopped ? OrderedJson(stop_name(*outcome.stopped)) : OrderedJson(nullptr)},
          {"levels", std::move(levels)},
          {"unmet_count", outcome.unmet.size()},
          {"unmet", unmet_json(outcome)}};
}

inline OrderedJson quality_json(const PlanarQuality& q) {
  return {{"smallest_angle_degrees", q.smallest_angle},
          {"largest_angle_degrees", q.largest_angle},
          {"mean_smallest_angle_degrees", q.mean_smallest_angle},
          {"degrees_per_bin", PlanarQuality::degrees_per_bin},
          {"smallest_angles", q.smallest_angles},
          {"all_angles", q.all_angles},
          {"smallest_area", q.smallest_area},
          {"largest_area", q.largest_area},
          {"total_area", q.total_area},
          {"shortest_edge", q.shortest_edge},
          {"longest_edge", q.longest_edge},
          {"worst_radius_edge", q.worst_radius_edge}};
}

inline OrderedJson quality_json(const TetrahedralQuality& q) {
  OrderedJson regions = OrderedJson::array();
  for (const auto& [label, region] : q.regions)
    regions.push_back({{"label", label}, {"tetrahedra", region.tetrahedron_count}, {"volume", region.volume}});
  return {{"worst_radius_edge", q.worst_radius_edge},
          {"radius_edge_bins", q.radius_edge_bins},
          {"radius_edges", q.radius_edge},
          {"smallest_dihedral_degrees", q.smallest_dihedral},
          {"largest_dihedral_degrees", q.largest_dihedral},
          {"degrees_per_bin", TetrahedralQuality::degrees_per_bin},
          {"smallest_dihedrals", q.smallest_dihedrals},
          {"all_dihedrals", q.all_dihedrals},
          {"tetrahedra_under_5_degrees", q.under_5_degrees},
          {"tetrahedra_under_10_degrees", q.under_10_degrees},
          {"flat_or_inverted_tetrahedra", q.flat_or_inverted},
          {"smallest_triangle_angle_degrees", q.smallest_triangle_angle},
          {"smallest_volume", q.smallest_volume},
          {"largest_volume", q.largest_volume},
          {"total_volume", q.total_volume},
          {"shortest_edge", q.shortest_edge},
          {"longest_edge", q.longest_edge},
          {"regions", std::move(regions)}};
}

inline OrderedJson input_json(const ReportedCounts& c, Point2) {
  return {{"vertices", c.vertices}, {"segments", c.segments}, {"holes", c.holes}, {"regions", c.regions}};
}
inline OrderedJson input_json(const ReportedCounts& c, Point3) {
  return {{"vertices", c.vertices}, {"segments", c.segments}, {"facets", c.facets}, {"holes", c.holes}, {"regions", c.regions}};
}
inline OrderedJson mesh_json(const ReportedCounts& c, Point2) {
  return {{"vertices", c.vertices}, {"segments", c.segments}, {"triangles", c.triangles}};
}
inline OrderedJson mesh_json(const ReportedCounts& c, Point3) {
  return {{"vertices", c.vertices}, {"segments", c.segments}, {"triangles", c.triangles}, {"tetrahedra", c.tetrahedra}};
}

template <class Report>
OrderedJson input_angles_json(const Report& report) {
  OrderedJson list = OrderedJson::array();
  for (const ReportedAngle& angle : report.input_angles)
    list.push_back({{"degrees", angle.degrees}, {"elements", angle.elements}, {"place", place_json(angle.place)}});
  return {{"count", report.input_angle_count}, {"smallest", std::move(list)}};
}

inline OrderedJson finite_or_null(double value) { return std::isfinite(value) ? OrderedJson(value) : OrderedJson(nullptr); }

inline OrderedJson surface_input_json(const ReportedSurface& s) {
  return {{"domain", s.domain}, {"bounds", {place_json(s.bounds[0]), place_json(s.bounds[1])}}};
}
inline OrderedJson surface_json(const ReportedSurface& s) {
  OrderedJson patches = OrderedJson::array(), boundaries = OrderedJson::array();
  for (const ReportedPatch& p : s.patches)
    patches.push_back({{"marker", p.marker}, {"regions", {or_null(p.regions[0]), or_null(p.regions[1])}}, {"triangles", p.triangles}});
  for (const ReportedBoundary& b : s.boundaries)
    boundaries.push_back({{"region", b.label},
                          {"triangles", b.triangles},
                          {"components", b.components},
                          {"euler_characteristic", b.euler_characteristic},
                          {"closed_manifold", b.is_closed_manifold()},
                          {"edges_not_of_two_triangles", b.crowded_edges},
                          {"pinched_vertices", b.pinched_vertices}});
  return {{"vertices", s.vertices},
          {"smallest_angle_degrees", s.smallest_angle_degrees},
          {"facet_size", finite_or_null(s.sizes.facet_size)},
          {"facet_distance", finite_or_null(s.sizes.facet_distance)},
          {"smallest_facet", s.sizes.smallest_facet},
          {"facets_stopped_by_the_size_floor", s.stopped_by_floor},
          {"components",
           {{"found", s.components_found},
            {"found_by", s.found_by},
            {"found_exactly", s.found_exactly},
            {"seeded_again", s.components_seeded_again},
            {"missed", s.components_missed},
            {"loose_vertices", s.loose_vertices}}},
          {"patches", std::move(patches)},
          {"boundaries", std::move(boundaries)}};
}

template <class Point>
inline constexpr int report_dimension = std::is_same_v<Point, Point2> ? 2 : 3;

template <class Value>
void read_value(const nlohmann::json& from, const char* key, Value& to) {
  if (const auto found = from.find(key); found != from.end() && !found->is_null()) to = found->template get<Value>();
}
template <class Value>
void read_value(const nlohmann::json& from, const char* key, std::optional<Value>& to) {
  if (const auto found = from.find(key); found != from.end() && !found->is_null()) to = found->template get<Value>();
}

inline ReportedSmoothOptions read_smooth_options(const nlohmann::json& json) {
  ReportedSmoothOptions s;
  read_value(json, "expressions", s.expressions);
  read_value(json, "bounds", s.bounds);
  read_value(json, "iso", s.iso);
  read_value(json, "inside", s.inside);
  read_value(json, "closed_at_border", s.closed_at_border);
  read_value(json, "labels", s.labels);
  s.background_label.reset();
  read_value(json, "background_label", s.background_label);
  read_value(json, "label_smoothing", s.label_smoothing);
  read_value(json, "point_set", s.point_set);
  read_value(json, "neighbours", s.neighbours);
  read_value(json, "outlier_distance", s.outlier_distance);
  read_value(json, "point_smoothing", s.point_smoothing);
  read_value(json, "sampling", s.sampling);
  read_value(json, "facet_angle_degrees", s.facet_angle_degrees);
  read_value(json, "facet_size", s.facet_size);
  read_value(json, "facet_distance", s.facet_distance);
  read_value(json, "smallest_facet", s.smallest_facet);
  read_value(json, "surface_only", s.surface_only);
  for (const auto& size : json.at("region_cell_sizes"))
    s.region_cell_sizes.emplace_back(size.at("region").get<int>(), size.at("cell_size").get<double>());
  return s;
}

inline ReportedFacetSizes read_facet_sizes(const nlohmann::json& surface) {
  constexpr double none = std::numeric_limits<double>::infinity();
  ReportedFacetSizes sizes{.facet_size = none, .facet_distance = none};
  read_value(surface, "facet_size", sizes.facet_size);
  read_value(surface, "facet_distance", sizes.facet_distance);
  read_value(surface, "smallest_facet", sizes.smallest_facet);
  return sizes;
}

inline ReportedOptions read_options(const nlohmann::json& json) {
  ReportedOptions o;
  read_value(json, "min_angle_degrees", o.min_angle_degrees);
  read_value(json, "max_area", o.max_area);
  read_value(json, "max_edge", o.max_edge);
  read_value(json, "size_points_file", o.size_points_file);
  read_value(json, "gradation", o.gradation);
  read_value(json, "encroachment", o.encroachment);
  read_value(json, "points", o.points);
  read_value(json, "keep_boundary", o.keep_boundary);
  read_value(json, "split_crossings", o.split_crossings);
  read_value(json, "merge_tolerance", o.merge_tolerance);
  read_value(json, "smallest_edge", o.smallest_edge);
  read_value(json, "max_vertices", o.max_vertices);
  read_value(json, "time_limit_seconds", o.time_limit_seconds);
  read_value(json, "radius_edge", o.radius_edge);
  read_value(json, "max_volume", o.max_volume);
  read_value(json, "cell_size", o.cell_size);
  read_value(json, "join_coplanar_degrees", o.join_coplanar_degrees);
  read_value(json, "planarity_tolerance", o.planarity_tolerance);
  if (json.contains("facet_angle_degrees")) o.smooth = read_smooth_options(json);
  return o;
}

}  // namespace detail

/// The text of a report.
template <class Point, class Quality>
std::string report_text(const BasicRunReport<Point, Quality>& report) {
  using detail::OrderedJson;
  OrderedJson json{{"program", "delref"},
                   {"version", report.version},
                   {"dimension", detail::report_dimension<Point>},
                   {"input_file", report.input_file},
                   {"output_files", report.output_files},
                   {"options", detail::options_json(report.options, Point{})},
                   {"input", report.surface ? detail::surface_input_json(*report.surface) : detail::input_json(report.input, Point{})}};
  if (detail::report_dimension<Point> == 3 && !report.surface) json["small_input_angles"] = detail::input_angles_json(report);
  json["mesh"] = detail::mesh_json(report.mesh, Point{});
  if (report.surface) json["surface"] = detail::surface_json(*report.surface);
  json["outcome"] = detail::outcome_json(report.outcome);
  if (detail::report_dimension<Point> == 3 && !report.surface) json["outcome"]["conforms"] = report.conforms;
  json["quality"] = report.quality ? detail::quality_json(*report.quality) : OrderedJson(nullptr);
  json["notes"] = report.notes;
  OrderedJson times = OrderedJson::object();
  for (const auto& [stage, seconds] : report.seconds) times[stage + "_seconds"] = seconds;
  json["times"] = std::move(times);
  return json.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + '\n';
}

/// Writes a report. Throws `OutputError`.
template <class Point, class Quality>
void write_report(const std::filesystem::path& path, const BasicRunReport<Point, Quality>& report) {
  write_file(path, [&](TextSink& out) { out << report_text(report); });
}

/// What `delref verify` needs of a report: what was asked for, and what was given up where. Of a run in the plane
/// (`ReportedPromise`) or in space (`PolyhedralPromise`).
template <class Point>
struct BasicPromise {
  std::string input_file;
  ReportedOptions options;
  bool complete = false;
  std::size_t missed_components = 0;                ///< of the surface of a smooth domain
  std::optional<ReportedFacetSizes> facet_sizes{};  ///< of a smooth domain
  std::vector<std::string> level_names;
  /// Level, criterion, reason and place of every unmet element; its vertices are not in a report.
  std::vector<Unmet<Point>> unmet;
};

using ReportedPromise = BasicPromise<Point2>;
using PolyhedralPromise = BasicPromise<Point3>;

namespace detail {

inline Reason read_reason(const std::string& text, const std::string& name) {
  for (int i = 0; i <= static_cast<int>(Reason::budget); ++i) {
    if (to_string(static_cast<Reason>(i)) == text) return static_cast<Reason>(i);
  }
  throw InvalidInput(fmt::format("{}: \"{}\" is no reason that delref knows", name, text));
}

inline void read_place(const nlohmann::json& place, Point2& to) { to = {place.at(0).get<double>(), place.at(1).get<double>()}; }
inline void read_place(const nlohmann::json& place, Point3& to) {
  to = {place.at(0).get<double>(), place.at(1).get<double>(), place.at(2).get<double>()};
}

template <class Point>
void read_unmet(const nlohmann::json& group, const std::string& name, BasicPromise<Point>& promise) {
  const auto level = std::ranges::find(promise.level_names, group.at("level").get<std::string>());
  Unmet<Point> unmet;
  unmet.level = static_cast<LevelIndex>(level - promise.level_names.begin());
  unmet.criterion = group.at("criterion").get<std::string>();
  unmet.reason = read_reason(group.at("reason").get<std::string>(), name);
  for (const auto& place : group.at("places")) {
    read_place(place, unmet.place);
    promise.unmet.push_back(unmet);
  }
}

/// Reports from before there was space have no dimension.
template <class Point>
void check_dimension(const nlohmann::json& json, const std::string& name) {
  int found = 2;
  read_value(json, "dimension", found);
  if (found == report_dimension<Point>) return;
  throw InvalidInput(fmt::format("{}: is the report of a run in {}, but what it is asked about lies in {}", name,
                                 found == 2 ? "the plane" : "space", report_dimension<Point> == 2 ? "the plane" : "space"));
}

}  // namespace detail

/// The promise in the text of a report; `name` is what complaints call the file. Throws `InvalidInput`, also for the report of a run
/// in the other dimension.
template <class Point = Point2>
BasicPromise<Point> parse_report(std::string_view text, const std::string& name) {
  try {
    const nlohmann::json json = parse_json(text, name);
    BasicPromise<Point> promise;
    detail::check_dimension<Point>(json, name);
    detail::read_value(json, "input_file", promise.input_file);
    promise.options = detail::read_options(json.at("options"));
    const auto& outcome = json.at("outcome");
    promise.complete = outcome.at("stopped_by").is_null();
    if (const auto surface = json.find("surface"); surface != json.end()) {
      detail::read_value(surface->at("components"), "missed", promise.missed_components);
      promise.facet_sizes = detail::read_facet_sizes(*surface);
    }
    for (const auto& level : outcome.at("levels")) promise.level_names.push_back(level.at("name").get<std::string>());
    for (const auto& group : outcome.at("unmet")) detail::read_unmet(group, name, promise);
    return promise;
  } catch (const nlohmann::json::exception& error) {
    throw InvalidInput(fmt::format("{}: is not a report of delref: {}", name, error.what()));
  }
}

/// Reads a report. Throws as `read_file` and `parse_report`.
template <class Point = Point2>
BasicPromise<Point> read_report(const std::filesystem::path& path, const Control& control = Control{}) {
  return parse_report<Point>(read_file(path, control), path.string());
}

}  // namespace delref
