// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a report of a run tells, as plain data: the program fills it, report_json.hpp writes and reads it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <delref/core/outcome.hpp>
#include <delref/core/point.hpp>
#include <delref/mesh/quality.hpp>

namespace delref {

/// What was asked for, spelled as on the command line.
struct ReportedOptions {
  double min_angle_degrees = 0;    ///< 0: no bound
  std::optional<double> max_area;  ///< for the whole domain; bounds of single regions are in the input
  std::optional<double> max_edge;
  std::string size_points_file;  ///< empty: no sizing field
  double gradation = 0;
  std::string encroachment;  ///< "circle" or "lens"
  std::string points;        ///< "circumcentre" or "off-centre"
  bool keep_boundary = false;
  bool split_crossings = false;
  double merge_tolerance = 0;
  double smallest_edge = 0;
  std::optional<std::size_t> max_vertices;
  std::optional<double> time_limit_seconds;

  friend bool operator==(const ReportedOptions&, const ReportedOptions&) = default;
};

/// The sizes of the input, or of the mesh, by name.
struct ReportedCounts {
  std::size_t vertices = 0, segments = 0, triangles = 0, holes = 0, regions = 0;

  friend bool operator==(const ReportedCounts&, const ReportedCounts&) = default;
};

/// One run.
struct RunReport {
  std::string version;  ///< of the program
  std::string input_file;
  std::vector<std::string> output_files;
  ReportedOptions options;
  ReportedCounts input, mesh;
  Outcome<Point2> outcome;
  std::optional<PlanarQuality> quality;
  std::vector<std::string> notes;
  /// Seconds by stage. All that differs between two runs of the same thing is here.
  std::vector<std::pair<std::string, double>> seconds;
};

}  // namespace delref
