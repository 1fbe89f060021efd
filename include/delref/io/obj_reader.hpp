// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads polygonal surfaces from Wavefront's .obj: vertices (`v`), faces (`f`), of which each becomes a facet, and lines (`l`), whose
// pieces become segments. Texture coordinates, normals, groups and materials are passed over; curves and free-form surfaces are told.
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <delref/core/budget.hpp>
#include <delref/domain/plc.hpp>
#include <delref/io/file.hpp>
#include <delref/io/node_records.hpp>
#include <delref/io/plc_file.hpp>
#include <delref/io/text_scanner.hpp>

namespace delref {

namespace detail {

/// A corner `v`, `v/vt`, `v//vn` or `v/vt/vn`, whose v counts from 1 or, when it is negative, back from the last vertex so far.
inline Plc::Index read_obj_corner(TextScanner& in, std::size_t points) {
  const std::string_view field = in.word("a vertex"), digits = field.substr(0, field.find('/'));
  std::int64_t written = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), written);
  if (error != std::errc{} || end != digits.data() + digits.size()) in.fail("expected the number of a vertex, alone or as in 1/2/3");
  const std::int64_t index = written < 0 ? static_cast<std::int64_t>(points) + written : written - 1;
  if (index < 0) in.fail(fmt::format("there is no vertex {}; vertices are numbered from 1, and from -1 backwards", written));
  if (index >= std::int64_t{Plc::Index(-1)}) in.fail(fmt::format("there is no vertex {}", written));
  return static_cast<Plc::Index>(index);
}

inline std::vector<Plc::Index> read_obj_corners(TextScanner& in, std::size_t points) {
  std::vector<Plc::Index> corners;
  while (in.has_field()) corners.push_back(read_obj_corner(in, points));
  return corners;
}

/// Faces may come before their vertices, so that indices are compared at the end.
inline void check_obj_corners(const TextScanner& in, const Plc& plc) {
  const auto refuse = [&](Plc::Index corner) {
    in.fail(fmt::format("a face or line has the vertex {}, but there are {}", std::size_t{corner} + 1, plc.points.size()));
  };
  for (const Plc::Facet& facet : plc.facets) {
    for (const auto corner : facet.polygons[0]) if (corner >= plc.points.size()) refuse(corner);
  }
  for (const auto& segment : plc.segments) {
    for (const auto corner : segment) if (corner >= plc.points.size()) refuse(corner);
  }
}

inline bool is_free_form(std::string_view keyword) {
  static constexpr std::array<std::string_view, 6> keywords{"curv", "curv2", "surf", "bzp", "bsp", "cstype"};
  return std::ranges::find(keywords, keyword) != keywords.end();
}

}  // namespace detail

/// The surface in the text of an .obj file; `name` is what complaints call it.
/// Throws `InvalidInput` with the line and what was expected there, `Interrupted` when the control says stop.
inline PlcFile parse_obj(std::string_view text, const std::string& name, const Control& control = Control{}) {
  TextScanner in(text, name, TextScanner::Layout::lines);
  PlcFile out;
  out.plc.first_index = 1;
  bool free_form = false;
  const detail::CoordinateNames names("vertex");
  for (std::size_t line = 0; in.next_line(); ++line) {
    detail::ask_sometimes(control, line);
    const std::string_view keyword = in.word("a keyword");
    if (keyword == "v") {
      out.plc.points.push_back(detail::read_point<Point3>(in, names, out.plc.points.size() + 1));
    } else if (keyword == "f") {
      auto corners = detail::read_obj_corners(in, out.plc.points.size());
      detail::check_corner_count(in, corners.size(), out.plc.facets.size() + 1);
      detail::add_polygon(out.plc, std::move(corners));
    } else if (keyword == "l") {
      const auto corners = detail::read_obj_corners(in, out.plc.points.size());
      for (std::size_t k = 1; k < corners.size(); ++k) out.plc.segments.push_back({corners[k - 1], corners[k]});
    } else {
      free_form = free_form || detail::is_free_form(keyword);
    }
  }
  detail::check_obj_corners(in, out.plc);
  if (out.plc.points.empty()) in.fail("the file ends without a vertex, that is a line that starts with v");
  if (free_form) out.notes.emplace_back("curves and free-form surfaces are passed over; only v, f and l are read");
  return out;
}

/// Reads an .obj file. Throws as `read_file` and `parse_obj`.
inline PlcFile read_obj(const std::filesystem::path& path, const Control& control = Control{}) {
  return parse_obj(read_file(path, control), path.string(), control);
}

}  // namespace delref
