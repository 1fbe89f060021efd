// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a report of a run tells, as plain data: the program fills it, report_json.hpp writes and reads it.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <delref/core/outcome.hpp>
#include <delref/core/point.hpp>
#include <delref/domain/plc_options.hpp>
#include <delref/mesh/quality.hpp>
#include <delref/mesh/tetrahedral_quality.hpp>

namespace delref {

/// What was asked for, spelled as on the command line. The report of a run has those of its dimension.
struct ReportedOptions {
  // in the plane
  double min_angle_degrees = 0;    ///< 0: no bound
  std::optional<double> max_area;  ///< for the whole domain; bounds of single regions are in the input
  std::optional<double> max_edge;
  // in both
  std::string size_points_file;  ///< empty: no sizing field
  double gradation = 0;
  // in the plane
  std::string encroachment;  ///< "circle" or "lens"
  std::string points;        ///< "circumcentre" or "off-centre"
  bool keep_boundary = false;
  bool split_crossings = false;
  // in both
  double merge_tolerance = 0;
  double smallest_edge = 0;
  std::optional<std::size_t> max_vertices;
  std::optional<double> time_limit_seconds;
  // in space
  double radius_edge = 2;
  std::optional<double> max_volume;  ///< for the whole domain; bounds of single regions are in the input
  std::optional<double> cell_size;
  std::optional<double> join_coplanar_degrees;  ///< none: facets are as the input has them
  double planarity_tolerance = PlcOptions{}.planarity_tolerance;

  friend bool operator==(const ReportedOptions&, const ReportedOptions&) = default;
};

/// The sizes of the input, or of the mesh, by name.
struct ReportedCounts {
  std::size_t vertices = 0, segments = 0, triangles = 0, holes = 0, regions = 0, facets = 0, tetrahedra = 0;

  friend bool operator==(const ReportedCounts&, const ReportedCounts&) = default;
};

/// An angle under 90 degrees at which two elements of a polyhedral input meet.
struct ReportedAngle {
  double degrees = 0;
  std::array<std::string, 2> elements;  ///< such as "facet 3" and "segment 5-7", in the numbers of the input file
  Point3 place;
};

/// One run in the plane (`RunReport`) or in space (`PolyhedralRunReport`).
template <class Point, class Quality>
struct BasicRunReport {
  std::string version;  ///< of the program
  std::string input_file;
  std::vector<std::string> output_files;
  ReportedOptions options;
  ReportedCounts input, mesh;
  /// In space: the smallest first; when there are very many, not all of them.
  std::vector<ReportedAngle> input_angles;
  std::size_t input_angle_count = 0;
  Outcome<Point> outcome;
  /// In space: every segment and facet of the input is in the mesh. A run that is stopped early may not come so far.
  bool conforms = true;
  std::optional<Quality> quality;
  std::vector<std::string> notes;
  /// Seconds by stage. All that differs between two runs of the same thing is here.
  std::vector<std::pair<std::string, double>> seconds;
};

using RunReport = BasicRunReport<Point2, PlanarQuality>;
using PolyhedralRunReport = BasicRunReport<Point3, TetrahedralQuality>;

}  // namespace delref
