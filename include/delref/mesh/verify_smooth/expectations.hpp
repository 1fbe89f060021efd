// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the mesh of a smooth domain is verified against, besides the domain and the options of the run.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <delref/core/outcome.hpp>
#include <delref/core/point.hpp>

namespace delref {

/// What the run said of its mesh, and what the caller knows of the surface.
struct SmoothExpectations {
  /// The run came to its end. When false, elements that miss a criterion are counted as unfinished and are no failure.
  bool complete = true;
  /// Neither `listed` nor the size floor excuses anything.
  bool strict = false;
  /// What the run says it could not meet. An element that misses a criterion is covered by an entry whose place is its barycentre
  /// (to 1e-6 of its longest edge); a vertex whose facets are no disk, when all facets at it are; one that is off the surface, when
  /// one of them is.
  std::vector<Unmet<Point3>> listed;
  /// How many components of the surface the run says it did not get.
  std::size_t missed_components = 0;
  /// How many connected pieces the surface is in, all its patches together; nothing: any number.
  std::optional<std::size_t> components;
  /// Vertices less edges plus triangles of the whole surface; nothing: any number.
  std::optional<long> euler_characteristic;
  /// The number of the first vertex, triangle and tetrahedron in messages.
  std::uint32_t first_index = 0;
};

}  // namespace delref
