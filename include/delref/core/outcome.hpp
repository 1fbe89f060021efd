// SPDX-License-Identifier: MIT
//
// What a run tells at its end: whether it is complete, what it did, and everything that it could not do, with the place and
// the reason.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/core/carrier.hpp>
#include <delref/core/verdict.hpp>

namespace delref {

/// One element that does not meet its level's criterion.
template <class Point>
struct Unmet {
  LevelIndex level = 0;
  /// The name of the criterion that it does not meet, such as "minimum angle".
  std::string criterion;
  Reason reason = Reason::precision;
  /// The barycentre of the element.
  Point place;
  /// Its vertices, by the index that the triangulation gave them.
  std::array<std::size_t, 4> vertices{};
  std::size_t vertex_count = 0;
};

/// What one level did.
struct LevelCounts {
  std::string name;
  std::size_t inserted = 0;          ///< vertices that its proposals made
  std::size_t rejected = 0;          ///< its proposals that another level rejected
  std::size_t rejected_forever = 0;  ///< its proposals that were dropped for good, for any reason
  std::size_t queued = 0;            ///< elements still in its set (nonzero only when stopped)
};

/// The result of a run of a mesher.
template <class Point>
struct Outcome {
  /// Set when the run was stopped before every set was empty; refining can go on later.
  std::optional<Stop> stopped;
  /// Every set was empty when this outcome was made.
  bool finished = false;
  std::vector<LevelCounts> levels;
  /// Elements that are still in the mesh and do not meet their criterion: all that were given up for good, and, when the run was
  /// stopped, the first `listed_per_level` that each level had still queued (`levels[i].queued` counts all of them).
  std::vector<Unmet<Point>> unmet;
  static constexpr std::size_t listed_per_level = 100'000;

  /// Every set was emptied: what does not meet its criterion is listed in `unmet` and nothing else.
  bool complete() const { return finished; }
  /// How many elements are unmet for this reason, listed or not.
  std::size_t unmet_count(Reason reason) const {
    if (reason == Reason::budget) {
      std::size_t queued = 0;
      for (const LevelCounts& level : levels) queued += level.queued;
      return queued;
    }
    return static_cast<std::size_t>(std::ranges::count(unmet, reason, &Unmet<Point>::reason));
  }
};

}  // namespace delref
