// SPDX-License-Identifier: MIT
//
// What a vertex lies on. Rounded coordinates cannot tell whether a point lies on an input segment or facet; the refinement rule
// that computed it can, and writes it here.
#pragma once

#include <cstdint>
#include <limits>

namespace delref {

/// The input element of lowest dimension that a vertex lies on.
struct Carrier {
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  /// 0: an input vertex, 1: an input segment, 2: a facet (3D) or the inside of a planar domain, 3: the inside of a solid one.
  std::uint8_t dimension = 0;
  /// The index of that element among the input elements of its dimension; `none` for the inside of the domain.
  std::uint32_t index = none;

  friend constexpr bool operator==(const Carrier&, const Carrier&) = default;
};

/// The provenance of a vertex: the index of the level that inserted it in its mesher, or `input`.
using LevelIndex = std::uint8_t;
inline constexpr LevelIndex input_level = std::numeric_limits<LevelIndex>::max();

}  // namespace delref
