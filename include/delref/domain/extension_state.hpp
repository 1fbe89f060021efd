// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the steps of an extension of a domain (`extend_planar_domain.hpp`) hand to each other.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/core/point.hpp>
#include <delref/domain/planar_domain.hpp>
#include <delref/domain/unite_pslg.hpp>

namespace delref::detail {

/// A Steiner vertex of the old triangulation: in the new scale, with the segment that it is on (of the old graph at first), or none.
struct ExtensionSteiner {
  static constexpr auto none = std::numeric_limits<std::uint32_t>::max();
  Point2 point;
  LevelIndex provenance;
  std::uint32_t on;
  bool dropped;
};

/// Part of a segment between two input vertices, and the Steiner vertices on it, in order.
struct ExtensionPiece {
  std::array<Pslg::Index, 2> ends;
  std::size_t of;  ///< the united graph's segment
  std::vector<std::uint32_t> chain;
};

/// The old triangulation and domain, the new ones in the making, and what is known on the way.
template <class Tr>
struct PlanarExtension {
  using Index = Pslg::Index;

  const Tr& before;
  const PlanarDomain& old;
  UnitedPslg united;
  Tr& tr;
  const Control& control;
  PlanarDomain domain{};
  std::vector<ExtensionSteiner> steiner{};
  std::vector<std::vector<std::uint32_t>> chains{};  ///< the Steiner vertices on each segment of the old graph
  std::vector<std::vector<Index>> cuts{};            ///< the input vertices that cut it
  std::vector<ExtensionPiece> pieces{};              ///< of old segments, then of new ones
  std::size_t old_pieces = 0;
  std::vector<typename Tr::Vertex> vertices{};       ///< input, then those of `steiner` that were kept
  std::vector<std::size_t> place{};                  ///< of those of `steiner` in `vertices`
  std::vector<std::uint32_t> steiner_at{};           ///< the place in `steiner` by vertex number

  Point2 point(Index i) const { return domain.pslg.points[i]; }
  bool is_new_point(std::size_t i) const { return united.point_source[i] >= old.pslg.points.size(); }
  bool is_new_segment(std::size_t s) const { return united.segment_source[s] >= old.pslg.segments.size(); }
};

}  // namespace delref::detail
