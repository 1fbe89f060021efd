// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bounds that no refinement of a smooth domain can meet are refused before any work is done, and those that were left open are set.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <delref/algorithms/smooth_options.hpp>
#include <delref/domain/bounding_box_3.hpp>
#include <delref/domain/describe.hpp>
#include <delref/domain/invalid_input.hpp>

namespace delref {

/// Throws `InvalidInput` when a size is not greater than 0, a bound is not a number or the radius-edge bound is under 1. Sizing fields
/// are checked where they are asked.
inline void check_smooth_options(const SmoothOptions& options) {
  if (!(options.radius_edge >= 1))
    throw InvalidInput("the bound on the radius-edge ratio is " + describe(options.radius_edge) +
                       ": give a number of at least 1, for refinement under that bound would never end; 2 is reached, infinity is no bound");
  const auto check_size = [](double bound, const std::string& what) {
    if (!(bound > 0)) throw InvalidInput(what + " is " + describe(bound) + ": give a number greater than 0 in the unit of the domain, or infinity for no bound");
  };
  check_size(options.facet_size, "the bound on the size of facets");
  check_size(options.facet_distance, "the bound on the distance of facets to the surface");
  check_size(options.cell_size, "the bound on the circumradius of tetrahedra");
  for (std::size_t i = 0; i < options.region_cell_sizes.size(); ++i)
    if (options.region_cell_sizes[i] != 0) check_size(options.region_cell_sizes[i], "the bound on the circumradius of tetrahedra of region " + std::to_string(i));
  if (!(options.surface_tolerance > 0 && options.surface_tolerance < 0.1))
    throw InvalidInput("the tolerance of the surface is " + describe(options.surface_tolerance) + " of an edge: give a number between 0 and 0.1");
  if (!(options.smallest_facet >= 0 && std::isfinite(options.smallest_facet)))
    throw InvalidInput("the size below which facets are left as they are is " + describe(options.smallest_facet) + ": give a number of at least 0");
}

/// The options with their defaults for a surface in such a box; a note says what was chosen.
inline SmoothOptions with_default_sizes(SmoothOptions options, const BoundingBox3& surface, std::vector<std::string>& notes) {
  const double usual = surface.extent() / 20;
  const bool has_size = std::isfinite(options.facet_size) || options.facet_size_field;
  if (!has_size && !std::isfinite(options.facet_distance) && !options.facet_distance_field) {
    options.facet_size = usual;
    notes.push_back(fmt::format("no size of facets was asked for: it is {:.4g}, a 20th of the extent of the surface", usual));
  }
  if (options.smallest_facet == 0) options.smallest_facet = 1e-3 * (std::isfinite(options.facet_size) ? std::min(usual, options.facet_size) : usual);
  return options;
}

}  // namespace delref
