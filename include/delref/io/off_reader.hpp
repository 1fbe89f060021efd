// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads polygonal surfaces from the Object File Format of Geomview, as text (www.geomview.org/docs/html/OFF.html). Each face becomes
// a facet. Normals, colours and texture coordinates are passed over. `nan` and `inf` are read as what they are: `check_plc` names
// the vertices that have them.
#pragma once

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

/// The keyword [ST][C][N]OFF, which may be missing. Leaves the scanner before the first count.
inline void read_off_header(TextScanner& in) {
  in.need_line("OFF");
  if (in.at_number() && !in.at_word("4OFF")) return;
  const std::string keyword(in.word("OFF"));
  if (!keyword.ends_with("OFF") || keyword.find_first_not_of("STCN4nOF") != std::string::npos) {
    in.fail("expected OFF: this is not a file in the Object File Format");
  }
  if (keyword.find_first_of("4n") != std::string::npos) in.fail(fmt::format("expected OFF: the points of {} do not have three coordinates", keyword));
  if (!in.has_field()) in.need_line("the number of vertices");
  if (!in.at_number() && in.word("the number of vertices") == "BINARY") in.fail("the file is binary; only text is read: save it as text");
}

}  // namespace detail

/// The surface in the text of an .off file; `name` is what complaints call it.
/// Throws `InvalidInput` with the line and what was expected there, `Interrupted` when the control says stop.
inline Plc parse_off(std::string_view text, const std::string& name, const Control& control = Control{}) {
  TextScanner in(text, name, TextScanner::Layout::lines);
  detail::read_off_header(in);
  const std::size_t points = in.count("the number of vertices", 1), faces = in.count("the number of faces", 1);
  in.check_room(points, 6, "the number of vertices");
  in.check_room(faces, 8, "the number of faces");
  Plc out;
  out.points.reserve(points);
  out.facets.reserve(faces);
  const detail::CoordinateNames names("vertex");
  for (std::size_t i = 0; i != points; ++i) {
    detail::ask_sometimes(control, i);
    in.need_line("vertex", i);
    out.points.push_back(detail::read_point<Point3>(in, names, i));
  }
  for (std::size_t f = 0; f != faces; ++f) {
    detail::ask_sometimes(control, f);
    in.need_line("face", f);
    const std::size_t count = in.count("the number of corners of a face", 2);
    detail::check_corner_count(in, count, f);
    std::vector<Plc::Index> corners;
    corners.reserve(count);
    for (std::size_t k = 0; k != count; ++k) {
      if (!in.has_field()) in.need_line("a corner of face", f);
      corners.push_back(detail::corner_index(in, in.integer<std::int64_t>("a corner of face", f), points, f));
    }
    detail::add_polygon(out, std::move(corners));
  }
  if (in.next_line()) in.fail(fmt::format("more follows after the last of {} faces; is one of the numbers in the header too small?", faces));
  return out;
}

/// Reads an .off file. Throws as `read_file` and `parse_off`.
inline Plc read_off(const std::filesystem::path& path, const Control& control = Control{}) {
  return parse_off(read_file(path, control), path.string(), control);
}

}  // namespace delref
