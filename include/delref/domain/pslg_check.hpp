// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a planar straight line graph must be before it is meshed. Everything that can be checked in linear time is checked here;
// crossings are looked for by `pslg_crossings.hpp` when something hits one, and what needs the triangulation (seeds,
// boundedness) by the mesher.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/domain/describe.hpp>
#include <delref/domain/exact_side.hpp>
#include <delref/domain/invalid_input.hpp>
#include <delref/domain/pslg.hpp>
#include <delref/domain/pslg_defects.hpp>
#include <delref/domain/pslg_merge.hpp>
#include <delref/domain/pslg_split.hpp>

namespace delref {

struct PslgCheckOptions {
  /// Vertices no farther apart than this become one, in the unit of the input. 0: only those with equal coordinates.
  double merge_tolerance = 0;
  /// Whether segments that cross or overlap are cut at each other (see `split_crossings`); otherwise nobody looks for them here.
  bool split_crossings = false;
};

/// True when one straight line holds all points, exactly; also for no point at all. Linear at worst, and immediate as a rule.
inline bool all_collinear(const std::vector<Point2>& points, const Control& control) {
  const auto other = std::ranges::find_if(points, [&](Point2 p) { return p != points.front(); });
  for (auto p = other; p != points.end(); ++p) {
    if ((p - points.begin()) % 8192 == 0) throw_if_stopped(control);
    if (exact_side(points.front(), *other, *p) != 0) return false;
  }
  return true;
}

namespace pslg_check {

inline std::string collinear_message(const CheckedPslg& checked) {
  const std::vector<Point2>& points = checked.pslg.points;
  if (points.size() == 1)
    return "all vertices are one point, " + describe(points.front()) +
           " (after merging): they bound no area; check the coordinates, and the merge tolerance if one was given";
  const auto before = [&](std::size_t i, std::size_t j) {
    return std::pair(points[i].x, points[i].y) < std::pair(points[j].x, points[j].y);
  };
  std::size_t low = 0, high = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (before(i, low)) low = i;
    if (before(high, i)) high = i;
  }
  return "all " + std::to_string(points.size()) + " vertices lie on one straight line, from " +
         checked.names().placed_vertex(low) + " to " + checked.names().placed_vertex(high) +
         ": they bound no area; give vertices on both sides of it";
}

}  // namespace pslg_check

/// Checks the graph and makes it free of doubles (see `merge_doubles`). Throws `InvalidInput` that names every defect, the first
/// twenty in words, when it holds bad indices, numbers or counts, has no vertices or segments, or lies on one line; throws
/// `Interrupted` when the control says so. O(n),
/// unless crossings are to be split.
inline CheckedPslg check_pslg(Pslg pslg, const PslgCheckOptions& options, const Control& control) {
  if (!(options.merge_tolerance >= 0 && std::isfinite(options.merge_tolerance)))
    throw InvalidInput("the merge tolerance is " + describe(options.merge_tolerance) +
                       ": give a length in the unit of the input, 0 to merge only vertices with equal coordinates");
  if (DefectList defects = find_plain_defects(pslg, control); !defects.empty()) throw InvalidInput(defects.take());
  CheckedPslg checked = merge_doubles(std::move(pslg), options.merge_tolerance, control);
  if (all_collinear(checked.pslg.points, control)) throw InvalidInput(pslg_check::collinear_message(checked));
  if (checked.pslg.segments.empty())
    throw InvalidInput("no segment has any length (after merging): nothing bounds a domain; give the segments of its boundary");
  if (options.split_crossings) return split_crossings(std::move(checked), control);
  return checked;
}

}  // namespace delref
