// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a piecewise linear complex must be before it is meshed, and the form in which it is meshed. Everything that needs no
// tetrahedra is checked here; what does (seeds, whether anything is enclosed) by the mesher.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/domain/invalid_input.hpp>
#include <delref/domain/join_coplanar.hpp>
#include <delref/domain/loose_vertices.hpp>
#include <delref/domain/needle_facets.hpp>
#include <delref/domain/plc.hpp>
#include <delref/domain/plc_angles.hpp>
#include <delref/domain/plc_closure.hpp>
#include <delref/domain/plc_defects.hpp>
#include <delref/domain/plc_intersections.hpp>
#include <delref/domain/plc_merge.hpp>
#include <delref/domain/plc_names.hpp>
#include <delref/domain/plc_options.hpp>
#include <delref/domain/plc_scale.hpp>
#include <delref/domain/polyhedral_domain.hpp>
#include <delref/domain/segment_wedges.hpp>
#include <delref/domain/triangulated_plc.hpp>

namespace delref {

namespace check_plc_steps {

/// Throws when there is a defect.
inline void refuse(DefectList& defects) {
  if (!defects.empty()) throw InvalidInput(defects.take());
}

inline void check_options(const PlcOptions& options) {
  if (!(options.merge_tolerance >= 0 && std::isfinite(options.merge_tolerance)))
    throw InvalidInput("the merge tolerance is " + describe(options.merge_tolerance) +
                       ": give a length in the unit of the input, 0 to merge only vertices with equal coordinates");
  if (!(options.planarity_tolerance >= 0 && options.planarity_tolerance <= 0.1))
    throw InvalidInput("the planarity tolerance is " + describe(options.planarity_tolerance) +
                       ": give a part of the diameter of a facet, from 0 to 0.1");
  if (!(options.join_coplanar_degrees <= 45))
    throw InvalidInput("facets are to be joined up to " + describe(options.join_coplanar_degrees) +
                       " degrees: give an angle of at most 45 degrees, negative for none");
}

/// Throws when one plane holds all vertices.
inline void check_flat(const PlcNames& names) {
  const auto points = names.points;
  if (points.size() < 4)
    throw InvalidInput("there are only " + count_of(points.size(), "vertex", "vertices") +
                       " (after merging): they bound no volume");
  std::size_t b = 1, c = 2, d = 3;
  while (c < points.size() && exactly_collinear(points[0], points[b], points[c])) ++c;
  if (c == points.size())
    throw InvalidInput("all " + std::to_string(points.size()) + " vertices lie on one straight line through " +
                       names.placed_vertex(0) + " and " + names.placed_vertex(b) + ": they bound no volume");
  for (d = 2; d < points.size(); ++d)
    if (exact_side(points[0], points[b], points[c], points[d]) != 0) return;
  throw InvalidInput("all " + std::to_string(points.size()) + " vertices lie in one plane, that of " + names.placed_vertex(0) +
                     ", " + names.placed_vertex(b) + " and " + names.placed_vertex(c) +
                     ": they bound no volume; give vertices on both sides of it");
}

/// The domain without what the later checks find.
inline PolyhedralDomain assembled(const TriangulatedPlc& plc, Plc& input, MergedVertices& merged, int scale) {
  PolyhedralDomain domain;
  domain.segments.resize(plc.segments.size());
  for (std::size_t s = 0; s < plc.segments.size(); ++s) domain.segments[s].ends = plc.segments[s];
  for (std::size_t s = 0; s < plc.listed.size(); ++s) {
    int& marker = domain.segments[plc.segments.find(plc.listed[s][0], plc.listed[s][1])].marker;
    if (marker == 0) marker = plc.listed_markers[s];
  }
  std::vector<bool> used(merged.points.size(), false);
  for (const auto& [a, b] : plc.segments.all()) used[a] = used[b] = true;
  domain.facets.resize(plc.size());
  for (std::size_t f = 0; f < plc.size(); ++f) {
    PolyhedralDomain::Facet& facet = domain.facets[f];
    facet.frame = plc.frames[f];
    facet.marker = plc.outlines.facets[f].marker;
    facet.original = plc.outlines.facets[f].original;
    for (const auto& [a, b] : plc.outlines.sides(f)) facet.segments.push_back(plc.segments.find(a, b));
    if (!plc.outlines.is_triangle(f)) {
      std::ranges::sort(facet.segments);
      facet.segments.erase(std::unique(facet.segments.begin(), facet.segments.end()), facet.segments.end());
    }
    facet.triangles.assign(plc.triangles_of(f).begin(), plc.triangles_of(f).end());
    for (const auto& triangle : facet.triangles)
      for (const auto v : triangle) used[v] = true;
  }
  for (PolyhedralDomain::Index v = 0; v < used.size(); ++v)
    if (!used[v]) domain.isolated.push_back(v);
  domain.points = std::move(merged.points);
  domain.point_markers = std::move(merged.markers);
  domain.original_point = std::move(merged.original_point);
  domain.holes = std::move(input.holes);
  domain.regions = std::move(input.regions);
  domain.first_index = input.first_index;
  domain.scale = scale;
  return domain;
}

}  // namespace check_plc_steps

/// Checks a complex and brings it into the form that is meshed.
///
/// Equal vertices are merged, facets that are there twice dropped, segments cut where vertices lie on them, facets triangulated,
/// and by option coplanar neighbours joined; notes tell what was done. Throws `InvalidInput` that names every defect, the first
/// twenty in words: wrong indices and numbers, flat input, facets that are not planar, do not close or repeat one another with
/// different markers, elements that cross, overlap or touch elsewhere than in common vertices and segments, surfaces that enclose
/// nothing. Throws `Interrupted` when the control says stop. O(n log^2 n) where boxes of elements meet few others.
inline PolyhedralDomain check_plc(Plc input, const PlcOptions& options = {}, const Control& control = Control{}) {
  using namespace check_plc_steps;
  check_options(options);
  DefectList defects = find_plain_defects(input, control);
  refuse(defects);
  const int scale = scale_exponent(input.points);
  scale_plc(input, scale);
  std::vector<std::string> notes;
  MergedVertices merged = merge_vertices(input, std::ldexp(options.merge_tolerance, scale), scale, control, notes);
  const PlcNames names{merged.points, merged.original_point, input.first_index, scale};
  check_flat(names);
  TriangulatedPlc plc = triangulated(input, merged.renumbered, options, names, control, defects, notes);
  refuse(defects);
  if (adopt_loose_vertices(plc, names, control, notes)) {
    std::vector<std::string> told_before;
    triangulated_plc::triangulate_facets(plc, input, names, control, defects, told_before);
  }
  find_needle_facets(plc, names, defects);
  refuse(defects);
  find_intersections(plc, names, control, defects);
  check_closure(plc, SegmentWedges(plc), names, control, defects, notes);
  refuse(defects);
  join_coplanar(plc, options, names, control, notes);
  const SegmentWedges wedges(plc);
  PolyhedralDomain domain = assembled(plc, input, merged, scale);
  plc.points = domain.points;
  find_small_angles(plc, wedges, domain, control);
  domain.notes = std::move(notes);
  return domain;
}

}  // namespace delref
