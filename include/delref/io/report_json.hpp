// SPDX-License-Identifier: GPL-3.0-or-later
//
// A report of a run as JSON. Every object has its keys in the order written here, and all that differs between two runs of the
// same thing is in "times", so that reports can be compared as text. Numbers that JSON cannot spell (infinity) are null.
#pragma once

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
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

inline OrderedJson options_json(const ReportedOptions& o) {
  return {{"min_angle_degrees", o.min_angle_degrees}, {"max_area", or_null(o.max_area)},
          {"max_edge", or_null(o.max_edge)},          {"size_points_file", o.size_points_file},
          {"gradation", o.gradation},                 {"encroachment", o.encroachment},
          {"points", o.points},                       {"keep_boundary", o.keep_boundary},
          {"split_crossings", o.split_crossings},     {"merge_tolerance", o.merge_tolerance},
          {"smallest_edge", o.smallest_edge},
          {"max_vertices", or_null(o.max_vertices)},  {"time_limit_seconds", or_null(o.time_limit_seconds)}};
}

/// The unmet elements by level, criterion and reason, with their number and their places.
inline OrderedJson unmet_json(const Outcome<Point2>& outcome) {
  std::map<std::tuple<LevelIndex, std::string, Reason>, OrderedJson> groups;
  for (const auto& unmet : outcome.unmet) {
    auto& places = groups.try_emplace({unmet.level, unmet.criterion, unmet.reason}, OrderedJson::array()).first->second;
    places.push_back({unmet.place.x, unmet.place.y});
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

inline OrderedJson outcome_json(const Outcome<Point2>& outcome) {
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

inline OrderedJson counts_json(const ReportedCounts& c, bool mesh) {
  OrderedJson json{{"vertices", c.vertices}, {"segments", c.segments}};
  if (mesh) json["triangles"] = c.triangles;
  else json.update({{"holes", c.holes}, {"regions", c.regions}});
  return json;
}

template <class Value>
void read_value(const nlohmann::json& from, const char* key, Value& to) {
  if (const auto found = from.find(key); found != from.end() && !found->is_null()) to = found->template get<Value>();
}
template <class Value>
void read_value(const nlohmann::json& from, const char* key, std::optional<Value>& to) {
  if (const auto found = from.find(key); found != from.end() && !found->is_null()) to = found->template get<Value>();
}

inline ReportedOptions read_options(const nlohmann::json& json) {
  ReportedOptions o;
  o.min_angle_degrees = json.at("min_angle_degrees").get<double>();
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
  return o;
}

}  // namespace detail

/// The text of a report.
inline std::string report_text(const RunReport& report) {
  using detail::OrderedJson;
  OrderedJson json{{"program", "delref"},
                   {"version", report.version},
                   {"input_file", report.input_file},
                   {"output_files", report.output_files},
                   {"options", detail::options_json(report.options)},
                   {"input", detail::counts_json(report.input, false)},
                   {"mesh", detail::counts_json(report.mesh, true)},
                   {"outcome", detail::outcome_json(report.outcome)}};
  json["quality"] = report.quality ? detail::quality_json(*report.quality) : OrderedJson(nullptr);
  json["notes"] = report.notes;
  OrderedJson times = OrderedJson::object();
  for (const auto& [stage, seconds] : report.seconds) times[stage + "_seconds"] = seconds;
  json["times"] = std::move(times);
  return json.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + '\n';
}

/// Writes a report. Throws `OutputError`.
inline void write_report(const std::filesystem::path& path, const RunReport& report) {
  write_file(path, [&](TextSink& out) { out << report_text(report); });
}

/// What `delref verify` needs of a report: what was asked for, and what was given up where.
struct ReportedPromise {
  std::string input_file;
  ReportedOptions options;
  bool complete = false;
  std::vector<std::string> level_names;
  /// Level, criterion, reason and place of every unmet element; its vertices are not in a report.
  std::vector<Unmet<Point2>> unmet;
};

namespace detail {

inline Reason read_reason(const std::string& text, const std::string& name) {
  for (int i = 0; i <= static_cast<int>(Reason::budget); ++i) {
    if (to_string(static_cast<Reason>(i)) == text) return static_cast<Reason>(i);
  }
  throw InvalidInput(fmt::format("{}: \"{}\" is no reason that delref knows", name, text));
}

inline void read_unmet(const nlohmann::json& group, const std::string& name, ReportedPromise& promise) {
  const auto level = std::ranges::find(promise.level_names, group.at("level").get<std::string>());
  Unmet<Point2> unmet;
  unmet.level = static_cast<LevelIndex>(level - promise.level_names.begin());
  unmet.criterion = group.at("criterion").get<std::string>();
  unmet.reason = read_reason(group.at("reason").get<std::string>(), name);
  for (const auto& place : group.at("places")) {
    unmet.place = {place.at(0).get<double>(), place.at(1).get<double>()};
    promise.unmet.push_back(unmet);
  }
}

}  // namespace detail

/// The promise in the text of a report; `name` is what complaints call the file. Throws `InvalidInput`.
inline ReportedPromise parse_report(std::string_view text, const std::string& name) {
  try {
    const nlohmann::json json = parse_json(text, name);
    ReportedPromise promise;
    detail::read_value(json, "input_file", promise.input_file);
    promise.options = detail::read_options(json.at("options"));
    const auto& outcome = json.at("outcome");
    promise.complete = outcome.at("stopped_by").is_null();
    for (const auto& level : outcome.at("levels")) promise.level_names.push_back(level.at("name").get<std::string>());
    for (const auto& group : outcome.at("unmet")) detail::read_unmet(group, name, promise);
    return promise;
  } catch (const nlohmann::json::exception& error) {
    throw InvalidInput(fmt::format("{}: is not a report of delref: {}", name, error.what()));
  }
}

/// Reads a report. Throws as `read_file` and `parse_report`.
inline ReportedPromise read_report(const std::filesystem::path& path, const Control& control = Control{}) {
  return parse_report(read_file(path, control), path.string());
}

}  // namespace delref
