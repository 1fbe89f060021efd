// SPDX-License-Identifier: GPL-3.0-or-later
//
// The vertices of a piecewise linear complex without doubles: coincident ones become one. What is done, and what looks as if it
// should have been, is told in notes.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/domain/bounding_box_3.hpp>
#include <delref/domain/describe.hpp>
#include <delref/domain/merge_points_3.hpp>
#include <delref/domain/plc.hpp>
#include <delref/domain/plc_names.hpp>

namespace delref {

/// Vertices that were merged: `renumbered[i]` is what input vertex i became, `original_point[j]` the first that became j.
struct MergedVertices {
  std::vector<Point3> points;
  std::vector<int> markers;
  std::vector<Plc::Index> renumbered, original_point;
};

namespace plc_merge {

/// Vertices nearer than this part of the extent of the input are told.
inline constexpr double suspicious_part = 1e-9;

inline std::string example(const PlcNames& names, std::size_t i, std::size_t kept) {
  const Point3 a = names.points[i], b = names.points[kept];
  if (a == b) return names.vertex(i) + " with " + names.vertex(kept) + " at " + names.place(b);
  return names.placed_vertex(i) + " with " + names.placed_vertex(kept) + ", " + names.length(std::sqrt(squared_distance(a, b))) +
         " apart";
}

template <class Wanted>
ExampleList examples(const PlcNames& names, const std::vector<std::uint32_t>& representative, const Wanted& wanted) {
  ExampleList list;
  for (std::size_t i = 0; i < representative.size(); ++i) {
    if (representative[i] == i || !wanted(i)) continue;
    if (list.full())
      list.add();
    else
      list.add(example(names, i, representative[i]));
  }
  return list;
}

inline void tell_close(const PlcNames& names, const std::vector<std::uint32_t>& close, double distance,
                       std::vector<std::string>& notes) {
  const ExampleList list = examples(names, close, [&](std::size_t i) { return names.points[close[i]] != names.points[i]; });
  if (list.count() == 0) return;
  notes.push_back(count_of(list.count(), "vertex lies", "vertices lie") + " nearer than " + names.length(distance) + " (" +
                  describe(suspicious_part) + " of the extent of the input) to another: " + list.text() +
                  ". They were kept and make tiny tetrahedra; a merge tolerance of " + names.length(distance) +
                  " makes them one");
}

inline void tell_merged(const PlcNames& names, const std::vector<std::uint32_t>& representative, double tolerance,
                        std::vector<std::string>& notes) {
  const ExampleList list = examples(names, representative, [](std::size_t) { return true; });
  if (list.count() == 0) return;
  notes.push_back(count_of(list.count(), "vertex was", "vertices were") + " merged with an earlier one " +
                  (tolerance == 0 ? std::string("with the same coordinates (merge tolerance 0)")
                                  : "no farther than the merge tolerance of " + names.length(tolerance)) +
                  ": " + list.text());
}

}  // namespace plc_merge

/// Merges equal vertices, or with a positive tolerance those no farther from an earlier one than that. The first of merged
/// vertices keeps its place; the marker is the first that is not 0. Requires finite coordinates. O(n log n).
inline MergedVertices merge_vertices(const Plc& plc, double tolerance, int scale, const Control& control,
                                     std::vector<std::string>& notes) {
  const PlcNames names{plc.points, {}, plc.first_index, scale};
  const std::vector<std::uint32_t> representative = close_points(plc.points, tolerance, control);
  plc_merge::tell_merged(names, representative, tolerance, notes);
  const double suspicious = plc_merge::suspicious_part * bounding_box_3(plc.points).extent();
  if (tolerance < suspicious) plc_merge::tell_close(names, close_points(plc.points, suspicious, control), suspicious, notes);
  MergedVertices merged;
  merged.renumbered.resize(plc.points.size());
  merged.points.reserve(plc.points.size());
  for (std::size_t i = 0; i < plc.points.size(); ++i) {
    const int marker = plc.point_marker(i);
    if (representative[i] != i) {  // the representative is earlier: its number is known
      const Plc::Index kept = merged.renumbered[i] = merged.renumbered[representative[i]];
      if (merged.markers[kept] == 0) merged.markers[kept] = marker;
      continue;
    }
    merged.renumbered[i] = static_cast<Plc::Index>(merged.points.size());
    merged.points.push_back(plc.points[i]);
    merged.markers.push_back(marker);
    merged.original_point.push_back(static_cast<Plc::Index>(i));
  }
  return merged;
}

}  // namespace delref
