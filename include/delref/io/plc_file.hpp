// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a reader of polyhedral domains gives, and what the readers of polygonal surfaces (.off, .obj, .ply, .stl) have in common.
//
// CGAL reads these formats too. But its readers (tried: 5.5) answer a broken file with "no" and neither line nor reason, refuse NaN the
// same way, take the memory that a header announces, let indices pass that are out of range (.obj, .ply), refuse lines (.obj), and
// crash on integer coordinates (.ply). To guard against all that takes as much reading as reading.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <delref/domain/plc.hpp>
#include <delref/io/text_scanner.hpp>

namespace delref {

/// What a file of a polyhedral domain holds.
struct PlcFile {
  Plc plc;
  /// For people: what was passed over.
  std::vector<std::string> notes;
};

namespace detail {

/// A polygon becomes a facet of its own.
inline void add_polygon(Plc& out, std::vector<Plc::Index> corners) {
  out.facets.emplace_back();
  out.facets.back().polygons.push_back(std::move(corners));
}

inline void check_corner_count(const TextScanner& in, std::size_t count, std::size_t face) {
  if (count < 3) in.fail(fmt::format("face {} has {} corners; a polygon has three or more", face, count));
}

/// The index of a corner, counted from 0, among the points that the file has.
inline Plc::Index corner_index(const TextScanner& in, std::int64_t index, std::size_t points, std::size_t face) {
  if (index < 0 || static_cast<std::uint64_t>(index) >= points) {
    in.fail(fmt::format("a corner of face {} is vertex {}, but the vertices are numbered from 0 and there are {}", face, index, points));
  }
  return static_cast<Plc::Index>(index);
}

}  // namespace detail

}  // namespace delref
