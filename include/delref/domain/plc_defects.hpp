// SPDX-License-Identifier: GPL-3.0-or-later
//
// The defects of a piecewise linear complex that one look at each element shows: lengths, indices, numbers.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/domain/describe.hpp>
#include <delref/domain/plc.hpp>
#include <delref/domain/plc_names.hpp>

namespace delref {

namespace plc_defects {

/// Coordinates beyond this are refused: widths and distances would overflow.
inline constexpr double largest_coordinate = 1e300;
/// More vertices, segments or facets than this are refused.
inline constexpr std::size_t largest_count = std::numeric_limits<Plc::Index>::max() / 4;

/// Why a point cannot be used; empty when it can.
inline std::string why_unusable(Point3 p) {
  if (std::isnan(p.x) || std::isnan(p.y) || std::isnan(p.z)) return "a coordinate is not a number";
  if (!is_finite(p)) return "a coordinate is infinite";
  if (std::abs(p.x) > largest_coordinate || std::abs(p.y) > largest_coordinate || std::abs(p.z) > largest_coordinate)
    return "a coordinate is greater than 1e300; change the unit of length";
  return {};
}

/// ", which does not exist: vertices are numbered from 1 to 8".
inline std::string wrong_index(const Plc& plc, Plc::Index v) {
  // A number below the first one wraps around when the first is taken from it.
  const auto number = static_cast<long long>(static_cast<std::int32_t>(v)) + plc.first_index;
  const auto shown = number < static_cast<long long>(plc.first_index) ? number : static_cast<long long>(v) + plc.first_index;
  return "vertex " + std::to_string(shown) + ", which does not exist: vertices are numbered from " +
         std::to_string(plc.first_index) + " to " + std::to_string(plc.points.size() - 1 + plc.first_index);
}

inline void check_counts(const Plc& plc, DefectList& defects) {
  const auto length = [&defects](const char* name, std::size_t actual, std::size_t expected, const char* what) {
    if (actual != expected)
      defects.add(std::string("there are ") + std::to_string(actual) + ' ' + name + " for " + std::to_string(expected) + ' ' +
                  what);
  };
  for (const auto& [count, what] : {std::pair(plc.points.size(), "vertices"), std::pair(plc.segments.size(), "segments"),
                                    std::pair(plc.facets.size(), "facets")})
    if (count > largest_count)
      defects.add("there are " + std::to_string(count) + ' ' + what + ": at most " + std::to_string(largest_count) +
                  " are handled");
  if (!plc.point_markers.empty()) length("vertex markers", plc.point_markers.size(), plc.points.size(), "vertices");
  if (!plc.segment_markers.empty()) length("segment markers", plc.segment_markers.size(), plc.segments.size(), "segments");
  length("attribute values", plc.attributes.size(), plc.attribute_count * plc.points.size(),
         "(vertices times attributes of each)");
  if (plc.points.empty())
    defects.add("the input has no vertices: there is nothing to mesh");
  else if (plc.facets.empty())
    defects.add("the input has " + count_of(plc.points.size(), "vertex", "vertices") +
                " but no facets: nothing bounds a domain; give the facets of its boundary");
}

inline void check_points(const Plc& plc, const Control& control, DefectList& defects) {
  const PlcNames names{plc.points, {}, plc.first_index};
  for (std::size_t i = 0; i < plc.points.size(); ++i) {
    if (i % 8192 == 0) throw_if_stopped(control);
    if (const std::string why = why_unusable(plc.points[i]); !why.empty()) defects.add(names.placed_vertex(i) + ": " + why);
  }
}

inline void check_segments(const Plc& plc, const Control& control, DefectList& defects) {
  for (std::size_t s = 0; s < plc.segments.size(); ++s) {
    if (s % 8192 == 0) throw_if_stopped(control);
    for (const Plc::Index v : plc.segments[s])
      if (v >= plc.points.size())
        defects.add("segment " + std::to_string(s + plc.first_index) + " refers to " + wrong_index(plc, v));
  }
}

/// Indices in range, no vertex twice in a polygon. `last_polygon[v]` is the polygon that visited v last.
inline void check_polygon(const Plc& plc, std::size_t f, const std::vector<Plc::Index>& polygon, Plc::Index stamp,
                          std::vector<Plc::Index>& last_polygon, DefectList& defects) {
  const PlcNames names{plc.points, {}, plc.first_index};
  if (polygon.empty()) defects.add(names.facet(f) + " has a polygon without vertices");
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Plc::Index v = polygon[k];
    if (v >= plc.points.size()) {
      defects.add(names.facet(f) + " refers to " + wrong_index(plc, v));
      continue;
    }
    const bool follows_itself = k > 0 && (polygon[k - 1] == v || (k + 1 == polygon.size() && polygon.front() == v));
    if (last_polygon[v] == stamp && !follows_itself)
      defects.add(names.facet(f) + ": a polygon passes twice through " + names.placed_vertex(v) +
                  "; give each closed curve as a polygon of its own, and a point in each hole");
    last_polygon[v] = stamp;
  }
}

inline void check_facets(const Plc& plc, const Control& control, DefectList& defects) {
  const PlcNames names{plc.points, {}, plc.first_index};
  std::vector<Plc::Index> last_polygon(plc.points.size(), 0);
  Plc::Index stamp = 0;
  for (std::size_t f = 0; f < plc.facets.size(); ++f) {
    if (f % 4096 == 0) throw_if_stopped(control);
    const Plc::Facet& facet = plc.facets[f];
    if (facet.polygons.empty()) defects.add(names.facet(f) + " has no polygon");
    for (const auto& polygon : facet.polygons) check_polygon(plc, f, polygon, ++stamp, last_polygon, defects);
    for (const Point3 hole : facet.holes)
      if (const std::string why = why_unusable(hole); !why.empty())
        defects.add("the hole point of " + names.facet(f) + " at " + describe(hole) + ": " + why);
  }
}

inline void check_seeds(const Plc& plc, DefectList& defects) {
  for (std::size_t h = 0; h < plc.holes.size(); ++h)
    if (const std::string why = why_unusable(plc.holes[h]); !why.empty())
      defects.add("the seed of hole " + std::to_string(h + plc.first_index) + " at " + describe(plc.holes[h]) + ": " + why);
  for (std::size_t r = 0; r < plc.regions.size(); ++r) {
    const Plc::Region& region = plc.regions[r];
    const std::string name = "region " + std::to_string(r + plc.first_index) + " (label " + std::to_string(region.label) + ")";
    if (const std::string why = why_unusable(region.seed); !why.empty())
      defects.add("the seed of " + name + " at " + describe(region.seed) + ": " + why);
    if (!(region.max_volume >= 0))
      defects.add("the greatest volume in " + name + " is " + describe(region.max_volume) +
                  ": give a positive volume, or 0 for no bound");
  }
}

}  // namespace plc_defects

/// Every defect of the numbers of a complex; empty when it has none.
inline DefectList find_plain_defects(const Plc& plc, const Control& control) {
  DefectList defects;
  plc_defects::check_counts(plc, defects);
  plc_defects::check_points(plc, control, defects);
  plc_defects::check_segments(plc, control, defects);
  plc_defects::check_facets(plc, control, defects);
  plc_defects::check_seeds(plc, defects);
  return defects;
}

}  // namespace delref
