// SPDX-License-Identifier: MIT
//
// What every hook of every level receives: who proposes which point to kill which element, and the conflict zone of that point.
// One type for all levels of a mesher, so that a level needs no template to listen to the others.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include <delref/core/carrier.hpp>

namespace delref {

/// A refinement point on its way into a triangulation `Tr`.
template <class Tr>
struct Proposal {
  /// The index of the proposing level in its mesher; 0 is the highest priority.
  LevelIndex level = 0;
  typename Tr::Point point{};
  /// What the new vertex will lie on.
  Carrier carrier{};
  /// The conflict zone of `point`: before insertion the elements that die and their boundary, after insertion the elements that
  /// are new. Null as long as there is no zone: for `on_proposed`, when a blocked proposal is judged, and when the element is dropped
  /// before the zone was found.
  const typename Tr::Zone* zone = nullptr;
  /// No element has more vertices.
  static constexpr std::size_t max_vertices = 4;
  /// The vertices of the element that the point is to kill.
  std::array<typename Tr::Vertex, max_vertices> vertices{};
  std::size_t vertex_count = 0;

  std::span<const typename Tr::Vertex> element_vertices() const { return {vertices.data(), vertex_count}; }
};

/// The answer of `Tr::conflict_zone`.
template <class Tr>
struct Location {
  enum class Kind : unsigned char {
    zone,        ///< the zone was found
    blocked,     ///< a constraint lies between the hint and the point: `blocker`
    outside,     ///< the point is outside the triangulation
    on_vertex,   ///< the point has the coordinates of a vertex
    degenerate   ///< no vertex can be made of it: rounding left it without a valid star, or a weighted point would be hidden
  };
  Kind kind = Kind::zone;
  typename Tr::Edge blocker{};
};

}  // namespace delref
