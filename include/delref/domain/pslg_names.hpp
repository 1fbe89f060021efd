// SPDX-License-Identifier: GPL-3.0-or-later
//
// What messages call the vertices and segments of a planar straight line graph: by their number in the file and their place.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>

#include <delref/core/point.hpp>
#include <delref/domain/describe.hpp>
#include <delref/domain/pslg.hpp>

namespace delref {

/// Names for the elements of a graph that may have been made from another: `original_point[i]` and `original_segment[s]` are the
/// indices in the input of the elements i and s of `pslg`. Empty spans mean that they are the same. Holds references only.
struct PslgNames {
  /// Stands in `original_point` for a vertex that no input vertex became: it was made where segments cross.
  static constexpr Pslg::Index made = std::numeric_limits<Pslg::Index>::max();

  const Pslg& pslg;
  std::span<const Pslg::Index> original_point = {};
  std::span<const Pslg::Index> original_segment = {};

  /// The number of a vertex in the file; "(new)" for one that was made.
  std::string point_number(std::size_t i) const {
    if (!original_point.empty() && original_point[i] == made) return "(new)";
    return std::to_string((original_point.empty() ? i : std::size_t{original_point[i]}) + pslg.first_index);
  }
  /// The number of a segment in the file.
  std::size_t segment_number(std::size_t s) const {
    return (original_segment.empty() ? s : std::size_t{original_segment[s]}) + pslg.first_index;
  }
  /// "vertex 4".
  std::string vertex(std::size_t i) const { return "vertex " + point_number(i); }
  /// "vertex 4 at (0.5, 0.5)".
  std::string placed_vertex(std::size_t i) const { return vertex(i) + " at " + describe(pslg.points[i]); }
  /// "segment 4 (vertices 0 and 2)".
  std::string segment(std::size_t s) const {
    const auto [a, b] = pslg.segments[s];
    return "segment " + std::to_string(segment_number(s)) + " (vertices " + point_number(a) + " and " + point_number(b) + ")";
  }
  /// "segment 4 (vertices 0 and 2, (0, 0) to (1, 1))".
  std::string placed_segment(std::size_t s) const {
    const auto [a, b] = pslg.segments[s];
    return "segment " + std::to_string(segment_number(s)) + " (vertices " + point_number(a) + " and " + point_number(b) + ", " +
           describe(pslg.points[a]) + " to " + describe(pslg.points[b]) + ")";
  }
};

}  // namespace delref
