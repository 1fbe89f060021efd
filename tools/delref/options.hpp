// SPDX-License-Identifier: GPL-3.0-or-later
//
// From what was asked for on the command line, or what a report says was, to what the library takes. Sizing fields are left out, for
// they come from files.
#pragma once

#include <limits>

#include <delref/algorithms/planar_options.hpp>
#include <delref/algorithms/polyhedral_options.hpp>
#include <delref/algorithms/smooth_options.hpp>
#include <delref/io/report.hpp>
#include <delref/mesh/verify/criteria.hpp>
#include <delref/mesh/verify_3/criteria.hpp>

namespace delref::program {

inline constexpr double no_bound = std::numeric_limits<double>::infinity();

inline PlanarOptions planar_options(const ReportedOptions& o) {
  PlanarOptions options;
  options.min_angle = AngleBound::degrees(o.min_angle_degrees);
  options.max_area = o.max_area.value_or(no_bound);
  options.max_edge = o.max_edge.value_or(no_bound);
  options.encroachment = o.encroachment == "lens" ? Encroachment::lens : Encroachment::circle;
  options.points = o.points == "circumcentre" ? PointChoice::circumcentre : PointChoice::off_centre;
  options.keep_boundary = o.keep_boundary;
  options.split_crossings = o.split_crossings;
  options.merge_tolerance = o.merge_tolerance;
  return options;
}

inline PlcOptions plc_options(const ReportedOptions& o) {
  PlcOptions options;
  if (o.join_coplanar_degrees) options.join_coplanar_degrees = *o.join_coplanar_degrees;
  options.merge_tolerance = o.merge_tolerance;
  options.planarity_tolerance = o.planarity_tolerance;
  return options;
}

inline PolyhedralOptions polyhedral_options(const ReportedOptions& o) {
  PolyhedralOptions options;
  options.radius_edge = o.radius_edge;
  options.max_volume = o.max_volume.value_or(no_bound);
  options.cell_size = o.cell_size.value_or(no_bound);
  options.input = plc_options(o);
  return options;
}

/// Sizes by region are left out, for they are known by the labels of the domain. Requires the options of a smooth domain.
inline SmoothOptions smooth_options(const ReportedOptions& o) {
  SmoothOptions options;
  options.facet_angle = AngleBound::degrees(o.smooth->facet_angle_degrees);
  options.facet_size = o.smooth->facet_size.value_or(no_bound);
  options.facet_distance = o.smooth->facet_distance.value_or(no_bound);
  options.smallest_facet = o.smooth->smallest_facet;
  options.surface_only = o.smooth->surface_only;
  options.radius_edge = o.radius_edge;
  options.cell_size = o.cell_size.value_or(no_bound);
  return options;
}

/// The promises of a run that came to its end and reported nothing unmet.
inline PlanarCriteria planar_criteria(const ReportedOptions& o) {
  PlanarCriteria criteria;
  criteria.min_angle_degrees = o.min_angle_degrees;
  criteria.max_area = o.max_area.value_or(no_bound);
  criteria.max_edge = o.max_edge.value_or(no_bound);
  criteria.circle = o.encroachment != "lens";
  return criteria;
}

inline PolyhedralCriteria polyhedral_criteria(const ReportedOptions& o) {
  PolyhedralCriteria criteria;
  criteria.radius_edge = o.radius_edge;
  criteria.max_volume = o.max_volume.value_or(no_bound);
  criteria.cell_size = o.cell_size.value_or(no_bound);
  criteria.input = plc_options(o);
  return criteria;
}

}  // namespace delref::program
