// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a report of a run tells, as plain data: the program fills it, report_json.hpp writes and reads it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
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

/// What a smooth domain is made of and what is asked of its surface, spelled as on the command line.
struct ReportedSmoothOptions {
  // which domain: expressions, an image with grey levels, an image with labels, or a set of points
  std::vector<std::string> expressions;
  std::vector<double> bounds;  ///< of expressions: six numbers, the low corner first
  std::optional<double> iso;
  std::string inside = "above";  ///< "above" or "below" the iso value
  bool closed_at_border = false;
  bool labels = false;
  std::optional<int> background_label = 0;  ///< none: every label is a region
  double label_smoothing = 0;
  bool point_set = false;
  std::size_t neighbours = 18;   ///< of points; see `PointSetOptions`, as for the next two
  double outlier_distance = 0;
  std::size_t point_smoothing = 0;
  double sampling = 0;  ///< of expressions; 0: chosen
  // of the surface
  double facet_angle_degrees = 30;
  std::optional<double> facet_size, facet_distance;
  double smallest_facet = 0;                              ///< 0: chosen
  std::vector<std::pair<int, double>> region_cell_sizes;  ///< by label
  bool surface_only = false;

  friend bool operator==(const ReportedSmoothOptions&, const ReportedSmoothOptions&) = default;
};

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
  std::optional<ReportedSmoothOptions> smooth;  ///< of smooth domains only

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

/// The surface between two regions of a smooth domain.
struct ReportedPatch {
  int marker = 0;                               ///< of its triangles in the mesh
  std::array<std::optional<int>, 2> regions{};  ///< their labels; none: the outside
  std::size_t triangles = 0;
};

/// The whole surface of a region of a smooth domain, as it is in the mesh.
struct ReportedBoundary {
  int label = 0;
  std::size_t triangles = 0, components = 0;
  std::int64_t euler_characteristic = 0;  ///< 2 per sphere, 0 per torus
  std::size_t crowded_edges = 0;          ///< that not two triangles share
  std::size_t pinched_vertices = 0;       ///< at which the triangles are not one disk
  bool is_closed_manifold() const { return crowded_edges == 0 && pinched_vertices == 0; }
};

/// The sizes of the facets of a smooth domain that were in force, with those that were chosen. Infinite: none.
struct ReportedFacetSizes {
  double facet_size = 0, facet_distance = 0, smallest_facet = 0;
};

/// What a run tells of the surface of a smooth domain.
struct ReportedSurface {
  std::string domain;  ///< what was meshed, in words
  std::array<Point3, 2> bounds{};
  ReportedFacetSizes sizes;
  std::size_t components_found = 0, components_seeded_again = 0, components_missed = 0, loose_vertices = 0;
  std::string found_by;
  bool found_exactly = false;
  std::vector<ReportedPatch> patches;
  std::vector<ReportedBoundary> boundaries;  ///< by label
  std::size_t stopped_by_floor = 0;          ///< facets that are as small as the size floor
  double smallest_angle_degrees = 0;
  std::size_t vertices = 0;
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
  std::optional<ReportedSurface> surface;  ///< of a smooth domain
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
