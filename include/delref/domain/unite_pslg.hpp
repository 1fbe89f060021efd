// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is added to a planar straight line graph that was meshed already, joined to it and checked.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/domain/describe.hpp>
#include <delref/domain/invalid_input.hpp>
#include <delref/domain/pslg_check.hpp>
#include <delref/domain/pslg_names.hpp>

namespace delref {

/// A checked graph and an addition, as one checked graph.
struct UnitedPslg {
  /// Named by the numbers of all that was given: those of the addition follow those of the graph before.
  CheckedPslg checked;
  /// Per vertex and per segment: its index in the checked graph before, or, counted on from the size of that, in the addition.
  /// `PslgNames::made` for a vertex where segments were split at a crossing.
  std::vector<Pslg::Index> point_source, segment_source;
};

/// How many vertices and segments were given so far, before any check.
struct GivenCounts {
  std::size_t points = 0, segments = 0;
};

namespace pslg_unite {

inline void check_addition(const Pslg& before, const Pslg& extra, const Control& control) {
  DefectList defects;
  const auto length = [&](const char* name, std::size_t actual, std::size_t expected) {
    if (actual != 0 && actual != expected)
      defects.add("in what is added there are " + std::to_string(actual) + ' ' + name + " for " + std::to_string(expected));
  };
  length("vertex markers", extra.point_markers.size(), extra.points.size());
  length("segment markers", extra.segment_markers.size(), extra.segments.size());
  if (extra.attribute_count != 0 && extra.attribute_count != before.attribute_count)
    defects.add("the vertices that are added have " + std::to_string(extra.attribute_count) + " attributes, those before have " +
                std::to_string(before.attribute_count));
  if (extra.attributes.size() != extra.attribute_count * extra.points.size())
    defects.add("in what is added there are " + std::to_string(extra.attributes.size()) + " attributes for " +
                std::to_string(extra.points.size()) + " vertices of " + std::to_string(extra.attribute_count));
  if (extra.points.empty() && !extra.segments.empty())
    defects.add("segments are added without vertices: their ends are indices into the vertices that are added with them; give a "
                "vertex that is there already once more, with the same coordinates");
  pslg_defects::check_points(extra, control, defects);
  pslg_defects::check_segments(extra, control, defects);
  pslg_defects::check_seeds(extra, defects);
  if (!defects.empty()) throw InvalidInput(defects.take());
}

template <class T>
void append_markers(std::vector<T>& markers, std::size_t count, const std::vector<T>& extra, std::size_t extra_count) {
  if (markers.empty() && extra.empty()) return;
  markers.resize(count);
  markers.insert(markers.end(), extra.begin(), extra.end());
  markers.resize(count + extra_count);
}

inline Pslg joined(Pslg pslg, const Pslg& extra) {
  const auto shift = static_cast<Pslg::Index>(pslg.points.size());
  append_markers(pslg.point_markers, pslg.points.size(), extra.point_markers, extra.points.size());
  append_markers(pslg.segment_markers, pslg.segments.size(), extra.segment_markers, extra.segments.size());
  pslg.points.insert(pslg.points.end(), extra.points.begin(), extra.points.end());
  pslg.attributes.insert(pslg.attributes.end(), extra.attributes.begin(), extra.attributes.end());
  pslg.attributes.resize(pslg.attribute_count * pslg.points.size());
  for (const auto& [a, b] : extra.segments) pslg.segments.push_back({a + shift, b + shift});
  pslg.holes.insert(pslg.holes.end(), extra.holes.begin(), extra.holes.end());
  pslg.regions.insert(pslg.regions.end(), extra.regions.begin(), extra.regions.end());
  return pslg;
}

}  // namespace pslg_unite

/// Joins `extra`, whose segments name its own points, to a checked graph. Vertices with the coordinates of an earlier one are that
/// one, repeated segments are dropped; crossings are split when the options say so. Throws `InvalidInput` that names the
/// defects of `extra` by its own numbers; `Interrupted`.
inline UnitedPslg unite_pslg(const CheckedPslg& before, const Pslg& extra, GivenCounts given, const PslgCheckOptions& options,
                             const Control& control) {
  pslg_unite::check_addition(before.pslg, extra, control);
  UnitedPslg result;
  CheckedPslg checked = merge_doubles(pslg_unite::joined(before.pslg, extra), options.merge_tolerance, control);
  checked.notes.clear();  // that vertices are given again is how they are referred to
  if (options.split_crossings) checked = split_crossings(std::move(checked), control);
  result.point_source = checked.original_point;
  result.segment_source = checked.original_segment;
  const auto name = [](Pslg::Index& source, const std::vector<Pslg::Index>& names, std::size_t count) {
    if (source == PslgNames::made) return;
    source = source < names.size() ? names[source] : static_cast<Pslg::Index>(source - names.size() + count);
  };
  for (Pslg::Index& i : checked.original_point) name(i, before.original_point, given.points);
  for (Pslg::Index& s : checked.original_segment) name(s, before.original_segment, given.segments);
  result.checked = std::move(checked);
  return result;
}

}  // namespace delref
