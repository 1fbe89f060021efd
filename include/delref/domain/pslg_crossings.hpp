// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which segments of a planar straight line graph cross or overlap. A sweep finds in O(n log n) whether any do, and few segments
// that are part of every such pair; only those are compared with the rest.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>

#include <delref/core/budget.hpp>
#include <delref/domain/crossing_sweep.hpp>
#include <delref/domain/describe.hpp>
#include <delref/domain/pslg.hpp>
#include <delref/domain/pslg_merge.hpp>
#include <delref/domain/pslg_names.hpp>
#include <delref/domain/segment_contact.hpp>

namespace delref {

/// How much `crossing_pairs` may do.
struct CrossingLimits {
  std::size_t pairs = std::numeric_limits<std::size_t>::max();
  /// Pairs of segments with intersecting boxes that are looked at.
  std::size_t tests = std::numeric_limits<std::size_t>::max();
};

/// The pairs of segments that cross or overlap, by index. When a limit was reached `complete` is false: there may be more.
struct CrossingPairs {
  std::vector<SegmentPair> pairs;
  bool complete = true;
};

namespace pslg_crossings {

inline Ends2 ends(const Pslg& pslg, std::size_t s) {
  return {pslg.points[pslg.segments[s][0]], pslg.points[pslg.segments[s][1]]};
}

/// Compares each segment that the sweep set aside with all that its box meets.
inline void compare_boxes(const Pslg& pslg, const std::vector<bool>& set_aside, const CrossingLimits& limits,
                          const Control& control, CrossingPairs& found) {
  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 2, Pslg::Index>;
  struct Enough {};
  std::vector<Box> all, aside;
  for (Pslg::Index s = 0; s < pslg.segments.size(); ++s) {
    const auto [a, b] = ends(pslg, s);
    std::array low{std::min(a.x, b.x), std::min(a.y, b.y)};
    std::array high{std::max(a.x, b.x), std::max(a.y, b.y)};
    all.emplace_back(low.data(), high.data(), s);
    if (set_aside[s]) aside.push_back(all.back());
  }
  std::size_t tests = 0;
  const auto compare = [&](const Box& box, const Box& other) {
    const Pslg::Index s = box.info(), t = other.info();
    if (s == t || (set_aside[t] && t < s)) return;  // of two that were set aside, each finds the other
    if (++tests % 1024 == 0) throw_if_stopped(control);
    if (tests > limits.tests) throw Enough{};
    const SegmentContact kind = contact(ends(pslg, s), ends(pslg, t));
    if (kind == SegmentContact::valid) return;
    if (found.pairs.size() >= limits.pairs) throw Enough{};
    found.pairs.push_back({std::min(s, t), std::max(s, t), kind});
  };
  try {
    CGAL::box_intersection_d(aside.begin(), aside.end(), all.begin(), all.end(), compare);
  } catch (const Enough&) {
    found.complete = false;
  }
}

}  // namespace pslg_crossings

/// All pairs of segments that cross or overlap, sorted; not empty if there is one, even when a limit is reached. Segments that
/// touch are no such pair. Requires what `check_pslg` gives. O(n log n) when there is none; then the pairs, and boxes of
/// crossing segments that meet other boxes, are added. Throws `Interrupted`.
inline CrossingPairs crossing_pairs(const Pslg& pslg, const CrossingLimits& limits, const Control& control) {
  const CrossingSweep sweep(pslg, control);
  CrossingPairs found;
  if (sweep.pairs().empty()) return found;
  pslg_crossings::compare_boxes(pslg, sweep.set_aside(), limits, control, found);
  if (!found.complete) found.pairs.insert(found.pairs.end(), sweep.pairs().begin(), sweep.pairs().end());
  std::ranges::sort(found.pairs, [](const SegmentPair& a, const SegmentPair& b) { return a < b; });
  found.pairs.erase(std::unique(found.pairs.begin(), found.pairs.end()), found.pairs.end());
  return found;
}

/// The pair in a sentence: both segments with their ends, and where they meet.
inline Defect describe_crossing(const PslgNames& names, const SegmentPair& pair) {
  const Ends2 a = pslg_crossings::ends(names.pslg, pair.first), b = pslg_crossings::ends(names.pslg, pair.second);
  const std::string both = names.placed_segment(pair.first) + " and " + names.placed_segment(pair.second);
  if (pair.contact == SegmentContact::overlap) {
    const Ends2 common = common_part(a, b);
    return {both + " overlap from " + describe(common[0]) + " to " + describe(common[1]), {common[0], common[1]}};
  }
  const Point2 where = rounded_crossing(a, b);
  return {both + " cross at " + describe(where), {where}};
}

/// Every pair of segments that cross or overlap, as defects: twenty in words, the last of which says how many more there are
/// (at least) and what to do. Empty when the graph is valid. Elements are called by the numbers that `names` gives them.
/// Requires what `check_pslg` gives. Throws `Interrupted`.
inline std::vector<Defect> find_crossings(const PslgNames& names, const Control& control) {
  const CrossingPairs found = crossing_pairs(names.pslg, {.pairs = 100'000, .tests = 20'000'000}, control);
  std::vector<Defect> defects;
  for (const SegmentPair& pair : found.pairs) {
    if (defects.size() == DefectList::spelled_out) break;
    defects.push_back(describe_crossing(names, pair));
  }
  if (defects.empty()) return defects;
  std::string& last = defects.back().message;
  if (const std::size_t more = found.pairs.size() - defects.size(); more > 0)
    last += "; and " + std::string(found.complete ? "" : "at least ") + std::to_string(more) + " more pairs of segments";
  else if (!found.complete)
    last += "; and perhaps more pairs of segments";
  last += ". Let segments meet only in vertices, or ask for a split at crossings (split_crossings, --split-crossings)";
  return defects;
}

/// The same for a graph whose elements are numbered as in the file.
inline std::vector<Defect> find_crossings(const Pslg& pslg, const Control& control) {
  return find_crossings(PslgNames{pslg}, control);
}

/// The same for a checked graph: elements are called by their numbers in the input.
inline std::vector<Defect> find_crossings(const CheckedPslg& checked, const Control& control) {
  return find_crossings(checked.names(), control);
}

}  // namespace delref
