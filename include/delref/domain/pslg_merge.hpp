// SPDX-License-Identifier: GPL-3.0-or-later
//
// A planar straight line graph without doubles: coincident vertices become one, and segments that lose their length or become
// the same as another are dropped. Everything done is told in notes.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <ranges>
#include <string>
#include <utility>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/domain/bounding_box.hpp>
#include <delref/domain/describe.hpp>
#include <delref/domain/merge_points.hpp>
#include <delref/domain/pair_table.hpp>
#include <delref/domain/pslg.hpp>
#include <delref/domain/pslg_names.hpp>

namespace delref {

/// A graph made from an input, with what its elements were in it.
struct CheckedPslg {
  Pslg pslg;
  /// Per vertex and per segment of `pslg`: the index in the input. A merged vertex has the index of the first.
  std::vector<Pslg::Index> original_point, original_segment;
  /// What was changed, and what looks wrong but can be meshed: a sentence each.
  std::vector<std::string> notes;

  /// Names of the elements by their numbers in the input. Refers to this object.
  PslgNames names() const { return {pslg, original_point, original_segment}; }

  /// Adds the vertex in which segments `a` and `b` cross, with the first of their markers that is not 0.
  void add_made_point(Point2 p, Pslg::Index a, Pslg::Index b) {
    pslg.points.push_back(p);
    const int marker = pslg.segment_marker(a);
    if (!pslg.point_markers.empty()) pslg.point_markers.push_back(marker != 0 ? marker : pslg.segment_marker(b));
    pslg.attributes.resize(pslg.attributes.size() + pslg.attribute_count, 0.0);
    original_point.push_back(PslgNames::made);
  }
};

namespace pslg_merge {

/// What `close_points` found, as an example for a note.
inline std::string example(const Pslg& pslg, std::size_t i, std::size_t kept) {
  const PslgNames names{pslg};
  const Point2 a = pslg.points[i], b = pslg.points[kept];
  if (a == b) return names.vertex(i) + " with " + names.vertex(kept) + " at " + describe(b);
  return names.placed_vertex(i) + " with " + names.placed_vertex(kept) + ", " + describe(std::hypot(a.x - b.x, a.y - b.y)) +
         " apart";
}

inline void tell_close(const Pslg& pslg, const std::vector<std::uint32_t>& close, double distance,
                       std::vector<std::string>& notes) {
  ExampleList examples;
  for (std::size_t i = 0; i < close.size(); ++i) {
    if (pslg.points[close[i]] == pslg.points[i]) continue;
    if (examples.full())
      examples.add();
    else
      examples.add(example(pslg, i, close[i]));
  }
  if (examples.count() == 0) return;
  notes.push_back(count_of(examples.count(), "vertex lies", "vertices lie") + " nearer than " + describe(distance) +
                  " (1e-12 of the extent of the input) to another: " + examples.text() +
                  ". They were kept and make tiny triangles; a merge tolerance of " + describe(distance) + " makes them one");
}

inline void tell_merged(const Pslg& pslg, const std::vector<std::uint32_t>& representative, double tolerance,
                        std::vector<std::string>& notes) {
  ExampleList examples;
  for (std::size_t i = 0; i < representative.size(); ++i) {
    if (representative[i] == i) continue;
    if (examples.full())
      examples.add();
    else
      examples.add(example(pslg, i, representative[i]));
  }
  if (examples.count() == 0) return;
  notes.push_back(count_of(examples.count(), "vertex was", "vertices were") + " merged with an earlier one " +
                  (tolerance == 0 ? std::string("with the same coordinates (merge tolerance 0)")
                                  : "no farther than the merge tolerance of " + describe(tolerance)) +
                  ": " + examples.text());
}

/// The representatives with the tolerance asked for; notes of them, and of vertices that are suspiciously close.
inline std::vector<std::uint32_t> representatives(const Pslg& pslg, double tolerance, const Control& control,
                                                  std::vector<std::string>& notes) {
  const double suspicious = 1e-12 * bounding_box(pslg.points).extent();
  std::vector<std::uint32_t> representative = close_points(pslg.points, tolerance > 0 ? tolerance : suspicious, control);
  if (tolerance == 0) {
    const auto close = std::exchange(representative, coincident_points(pslg.points, control));
    tell_close(pslg, close, suspicious, notes);
  }
  tell_merged(pslg, representative, tolerance, notes);
  return representative;
}

/// Keeps the vertices that represent themselves; gives for each old vertex its new index.
inline std::vector<Pslg::Index> drop_points(CheckedPslg& checked, const std::vector<std::uint32_t>& representative) {
  Pslg& pslg = checked.pslg;
  std::vector<Pslg::Index> renumbered(representative.size());
  std::size_t kept = 0;
  for (std::size_t i = 0; i < representative.size(); ++i) {
    if (representative[i] != i) {  // the representative is earlier: its number is known
      renumbered[i] = renumbered[representative[i]];
      if (!pslg.point_markers.empty() && pslg.point_markers[renumbered[i]] == 0)
        pslg.point_markers[renumbered[i]] = pslg.point_markers[i];
      continue;
    }
    renumbered[i] = static_cast<Pslg::Index>(kept);
    pslg.points[kept] = pslg.points[i];
    if (!pslg.point_markers.empty()) pslg.point_markers[kept] = pslg.point_markers[i];
    for (std::size_t a = 0; a < pslg.attribute_count; ++a)
      pslg.attributes[kept * pslg.attribute_count + a] = pslg.attributes[i * pslg.attribute_count + a];
    checked.original_point[kept] = checked.original_point[i];
    ++kept;
  }
  pslg.points.resize(kept);
  if (!pslg.point_markers.empty()) pslg.point_markers.resize(kept);
  pslg.attributes.resize(kept * pslg.attribute_count);
  checked.original_point.resize(kept);
  return renumbered;
}

/// Drops segments without length and repeated ones. The names are those of the input.
inline void drop_segments(CheckedPslg& checked, const Control& control) {
  Pslg& pslg = checked.pslg;
  const auto number = [&](std::size_t original) { return "segment " + std::to_string(original + pslg.first_index); };
  ExampleList zero_length, repeated;
  PairTable first(pslg.segments.size());
  std::size_t kept = 0;
  for (std::size_t s = 0; s < pslg.segments.size(); ++s) {
    if (s % 8192 == 0) throw_if_stopped(control);
    const auto [a, b] = pslg.segments[s];
    const Pslg::Index original = checked.original_segment[s];
    if (a == b) {
      if (zero_length.full())
        zero_length.add();
      else
        zero_length.add(number(original) + " at " + checked.names().placed_vertex(a));
      continue;
    }
    std::uint32_t& same = first[{std::min(a, b), std::max(a, b)}];
    const int marker = pslg.segment_marker(s);
    if (same != PairTable::none) {
      const int first_marker = pslg.segment_marker(same);
      const int shared = first_marker != 0 ? first_marker : marker;
      std::string text;
      if (!repeated.full()) text = number(original) + " repeats " + number(checked.original_segment[same]);
      if (!repeated.full() && marker != first_marker)
        text += " with marker " + std::to_string(marker) + " instead of " + std::to_string(first_marker) + ", " +
                std::to_string(shared) + " was kept";
      repeated.add(text);
      if (!pslg.segment_markers.empty()) pslg.segment_markers[same] = shared;
      continue;
    }
    same = static_cast<std::uint32_t>(kept);
    pslg.segments[kept] = {a, b};
    if (!pslg.segment_markers.empty()) pslg.segment_markers[kept] = marker;
    checked.original_segment[kept] = original;
    ++kept;
  }
  pslg.segments.resize(kept);
  if (!pslg.segment_markers.empty()) pslg.segment_markers.resize(kept);
  checked.original_segment.resize(kept);
  if (zero_length.count() > 0)
    checked.notes.push_back(count_of(zero_length.count(), "segment of no length was", "segments of no length were") +
                            " dropped: " + zero_length.text());
  if (repeated.count() > 0)
    checked.notes.push_back(count_of(repeated.count(), "repeated segment was", "repeated segments were") +
                            " dropped: " + repeated.text());
}

}  // namespace pslg_merge

/// Merges vertices that coincide, or with a positive tolerance those no farther from an earlier one than that, and drops segments
/// that have no length or repeat another. The first of merged elements keeps its place and attributes; the marker is the first
/// that is not 0. Requires what `find_plain_defects` checks. O(n).
inline CheckedPslg merge_doubles(Pslg pslg, double tolerance, const Control& control) {
  CheckedPslg checked;
  const std::vector<std::uint32_t> representative = pslg_merge::representatives(pslg, tolerance, control, checked.notes);
  checked.original_point.resize(pslg.points.size());
  checked.original_segment.resize(pslg.segments.size());
  std::iota(checked.original_point.begin(), checked.original_point.end(), 0u);
  std::iota(checked.original_segment.begin(), checked.original_segment.end(), 0u);
  checked.pslg = std::move(pslg);
  const std::vector<Pslg::Index> renumbered = pslg_merge::drop_points(checked, representative);
  if (checked.pslg.points.size() < renumbered.size())
    for (auto& segment : checked.pslg.segments)
      for (Pslg::Index& v : segment) v = renumbered[v];
  pslg_merge::drop_segments(checked, control);
  return checked;
}

}  // namespace delref
