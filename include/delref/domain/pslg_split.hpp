// SPDX-License-Identifier: GPL-3.0-or-later
//
// A valid planar straight line graph from one whose segments cross or overlap. Points of intersection are computed exactly and
// rounded. Rounding bends segments by an ulp or so, which can make them cross again: as a rule once or twice more; among segments
// that lie within a few ulp of each other without end, and those are snap rounded.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/domain/describe.hpp>
#include <delref/domain/invalid_input.hpp>
#include <delref/domain/pair_table.hpp>
#include <delref/domain/pslg.hpp>
#include <delref/domain/pslg_crossings.hpp>
#include <delref/domain/pslg_merge.hpp>
#include <delref/domain/snap_rounding.hpp>
#include <delref/domain/split_pieces.hpp>

namespace delref {

namespace pslg_split {

/// Cuts two overlapping segments at each other's ends.
inline void cut_overlap(const Pslg& pslg, const SegmentPair& pair, std::vector<Cut>& cuts) {
  for (const auto& [cut, by] : {std::pair(pair.first, pair.second), std::pair(pair.second, pair.first)}) {
    const Ends2 ends = ordered(pslg_crossings::ends(pslg, cut));
    for (const Pslg::Index v : pslg.segments[by])
      if (lexicographically_less(ends[0], pslg.points[v]) && lexicographically_less(pslg.points[v], ends[1]))
        cuts.push_back({cut, v});
  }
}

/// Adds the vertices in which pairs cross, and gives where to cut.
inline std::vector<Cut> find_cuts(CheckedPslg& checked, const std::vector<SegmentPair>& pairs, const Control& control) {
  const Pslg& pslg = checked.pslg;
  std::vector<Cut> cuts;
  PairTable vertex_at(pslg.points.size() + pairs.size());
  for (Pslg::Index v = 0; v < pslg.points.size(); ++v) vertex_at[PairTable::key(pslg.points[v])] = v;
  std::size_t steps = 0;
  for (const SegmentPair& pair : pairs) {
    if (++steps % 256 == 0) throw_if_stopped(control);
    if (pair.contact == SegmentContact::overlap) {
      cut_overlap(pslg, pair, cuts);
      continue;
    }
    const Point2 where = rounded_crossing(pslg_crossings::ends(pslg, pair.first), pslg_crossings::ends(pslg, pair.second));
    Pslg::Index& vertex = vertex_at[PairTable::key(where)];
    if (vertex == PairTable::none) {
      vertex = static_cast<Pslg::Index>(pslg.points.size());
      checked.add_made_point(where, pair.first, pair.second);
    }
    for (const Pslg::Index s : {pair.first, pair.second})
      if (pslg.segments[s][0] != vertex && pslg.segments[s][1] != vertex) cuts.push_back({s, vertex});
  }
  return cuts;
}

inline SplitPieces cut_segments(const CheckedPslg& checked, std::vector<Cut> cuts) {
  const Pslg& pslg = checked.pslg;
  sort_cuts(pslg, pslg.points, cuts);
  SplitPieces pieces(pslg.segments.size() + cuts.size(), !pslg.segment_markers.empty());
  auto cut = cuts.begin();
  for (Pslg::Index s = 0; s < pslg.segments.size(); ++s) {
    const auto add = [&](Pslg::Index a, Pslg::Index b) { pieces.add(a, b, pslg.segment_marker(s), checked.original_segment[s]); };
    Pslg::Index from = pslg.segments[s][0];
    for (; cut != cuts.end() && cut->segment == s; ++cut) add(std::exchange(from, cut->vertex), cut->vertex);
    add(from, pslg.segments[s][1]);
  }
  return pieces;
}

/// What was found, with examples.
inline std::string found_note(const CheckedPslg& checked, const std::vector<SegmentPair>& pairs) {
  ExampleList examples;
  for (const SegmentPair& pair : pairs) {
    if (examples.full())
      examples.add();
    else
      examples.add(describe_crossing(checked.names(), pair).message);
  }
  return count_of(pairs.size(), "pair of segments was", "pairs of segments were") +
         " split where they cross or overlap: " + examples.text();
}

inline std::string made_note(std::size_t made, std::size_t shared, std::size_t conflicts) {
  std::string note = "splitting made " + count_of(made, "new vertex", "new vertices");
  if (shared > 0) note += "; pieces shared by several segments were kept once (" + std::to_string(shared) + " dropped)";
  if (conflicts > 0)
    note += ", " + std::to_string(conflicts) + " of them with a different marker: the first marker that is not 0 was kept";
  return note;
}

inline std::string snapped_note(const SnapRounded& snapped) {
  return "some segments lie so close that rounding the points where they cross makes them cross again: all vertices were rounded "
         "to multiples of " +
         describe(snapped.spacing) + ", which moved " + std::to_string(snapped.moved) +
         " of them by at most half that in each coordinate and made " + std::to_string(snapped.merged) + " one with another";
}

[[noreturn]] inline void throw_too_many(std::size_t limit) {
  throw InvalidInput("the segments cross or overlap in more than " + std::to_string(limit) +
                     " places, the greatest number of vertices that the budget allows: raise it, or give fewer segments");
}

/// The graph snap rounded, with its notes. The pairs are those of `checked`.
inline CheckedPslg snap(const CheckedPslg& checked, const std::vector<SegmentPair>& pairs, std::string found,
                        const Control& control) {
  SnapRounded snapped = snap_rounded(checked, pairs, control);
  const std::size_t kept = checked.pslg.points.size() - snapped.merged;
  CheckedPslg& result = snapped.checked;
  result.notes.push_back(std::move(found));
  result.notes.push_back(snapped_note(snapped));
  result.notes.push_back(made_note(result.pslg.points.size() - kept, snapped.shared, snapped.conflicts));
  if (!crossing_pairs(result.pslg, {.pairs = 1, .tests = 1}, control).pairs.empty())
    throw InvalidInput(
        "segments that lie very close to each other could not be split where they cross: merge close vertices with "
        "a merge tolerance first");
  return std::move(result);
}

}  // namespace pslg_split

/// Cuts segments at each other until none cross or overlap, and tells in notes what it did.
///
/// New vertices come after the old ones; their `original_point` is `PslgNames::made`, and their attributes are 0. The pieces of a
/// segment have its marker and its `original_segment`; a piece that several segments share is there once, with the first marker
/// that is not 0. Old vertices stay where they are and a piece lies within a few ulp (of the largest coordinate) of the segment
/// that it is part of; only when segments lie within a few ulp of each other are all vertices rounded to a grid of less than
/// 2^-48 of the largest coordinate, which a note tells. Requires what `check_pslg` gives. Throws `InvalidInput` when there are
/// more crossings than the budget has vertices; `Interrupted` when the control says stop.
inline CheckedPslg split_crossings(CheckedPslg checked, const Control& control) {
  constexpr int most_rounds = 8;
  constexpr std::size_t few = 16;
  const std::size_t limit = control.budget().max_vertices;
  const CrossingPairs first = crossing_pairs(checked.pslg, {.pairs = limit}, control);
  if (!first.complete) pslg_split::throw_too_many(limit);
  if (first.pairs.empty()) return checked;
  std::string found = pslg_split::found_note(checked, first.pairs);
  CheckedPslg split = checked;
  CrossingPairs left = first;
  std::size_t shared = 0, conflicts = 0;
  for (int round = 0; round < most_rounds && left.complete; ++round) {
    std::vector<Cut> cuts = pslg_split::find_cuts(split, left.pairs, control);
    if (split.pslg.points.size() > limit) pslg_split::throw_too_many(limit);
    SplitPieces pieces = pslg_split::cut_segments(split, std::move(cuts));
    pieces.move_into(split);
    shared += pieces.shared();
    conflicts += pieces.conflicts();
    // What rounding made must be much less than what it resolved, or it would go on for ever.
    left = crossing_pairs(split.pslg, {.pairs = std::max(few, left.pairs.size() / 4)}, control);
    if (!left.pairs.empty()) continue;
    split.notes.push_back(std::move(found));
    split.notes.push_back(pslg_split::made_note(split.pslg.points.size() - checked.pslg.points.size(), shared, conflicts));
    return split;
  }
  return pslg_split::snap(checked, first.pairs, std::move(found), control);
}

/// The same for a graph that was not checked: coincident vertices and segments are merged first.
inline CheckedPslg split_crossings(Pslg pslg, const Control& control) {
  return split_crossings(merge_doubles(std::move(pslg), 0, control), control);
}

}  // namespace delref
