// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads polygonal surfaces from the Object File Format of Geomview, as text (www.geomview.org/docs/html/OFF.html), by CGAL. Each face
// becomes a facet. Normals, colours and texture coordinates are passed over.
//
// CGAL takes the memory for as many vertices, faces and corners as the file says there are, reads past its own arrays where
// colours announced are missing, and casts corners from real numbers. So its reader gets a bare header, and counts and corners are compared
// with the file before; the coordinates it reads alone.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <istream>
#include <string>
#include <utility>

#include <CGAL/IO/OFF.h>
#include <fmt/format.h>

#include <delref/core/budget.hpp>
#include <delref/domain/plc.hpp>
#include <delref/io/cgal_stream.hpp>
#include <delref/io/file.hpp>
#include <delref/io/node_records.hpp>
#include <delref/io/polygon_soup.hpp>
#include <delref/io/text_scanner.hpp>

namespace delref {

namespace detail {

/// The keyword [ST][C][N]OFF, which may be missing. Leaves the scanner before the first count.
inline void check_off_keyword(TextScanner& in) {
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

/// The number of corners of a face and the corners. A face that goes on in the next line is brought into one, which CGAL expects.
inline void check_off_face(TextScanner& in, std::string& text, std::size_t points, std::size_t face) {
  const std::size_t count = in.count("the number of corners of a face", 2);
  if (count < 3) in.fail(fmt::format("face {} has {} corners; a polygon has three or more", face, count));
  for (std::size_t k = 0; k != count; ++k) {
    const std::size_t end = text.size() - in.bytes_left();
    if (!in.has_field()) {
      in.need_line("a corner of face", face);
      blank_out(text, end, text.size() - in.bytes_left());
    }
    const auto corner = in.integer<std::int64_t>("a corner of face", face);
    if (corner < 0 || static_cast<std::uint64_t>(corner) >= points) {
      in.fail(fmt::format("a corner of face {} is vertex {}, but the vertices are numbered from 0 and there are {}", face, corner, points));
    }
  }
}

/// Compares counts and corners with what the file has, and puts a bare header in the place of its own, with the same number of lines.
inline void guard_off(std::string& text, const std::string& name, const Control& control) {
  blank_comments(text);
  refuse_commas(text, name);
  TextScanner in(text, name, TextScanner::Layout::lines);
  check_off_keyword(in);
  const std::size_t points = in.count("the number of vertices", 1), faces = in.count("the number of faces", 1);
  in.check_room(points, 6, "the number of vertices");
  in.check_room(faces, 8, "the number of faces");
  const std::size_t header = text.size() - in.bytes_left() + line_ahead(in, text).size();
  if (points + faces > 1'000'000'000) in.fail("there are more than 1000000000 vertices and faces, which CGAL's reader cannot count");
  for (std::size_t i = 0; i != points; ++i) {
    ask_sometimes(control, i);
    in.need_line("vertex", i);
  }
  for (std::size_t f = 0; f != faces; ++f) {
    ask_sometimes(control, f);
    in.need_line("face", f);
    check_off_face(in, text, points, f);
  }
  if (in.next_line()) in.fail(fmt::format("more follows after the last of {} faces; is one of the numbers in the header too small?", faces));
  const auto lines = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(header), '\n');
  text.replace(0, header, fmt::format("OFF {} {} 0", points, faces) + std::string(static_cast<std::size_t>(lines), '\n'));
  text += '\n';
}

}  // namespace detail

/// The surface in the text of an .off file; `name` is what complaints call it.
/// Throws `InvalidInput` with the line and what was expected there, `Interrupted` when the control says stop.
inline Plc parse_off(std::string text, const std::string& name, const Control& control = Control{}) {
  detail::guard_off(text, name, control);
  detail::PolygonSoup soup(control);
  const auto read = [&](std::istream& in) { return CGAL::IO::read_OFF(in, soup.points, soup.polygons, CGAL::parameters::verbose(false)); };
  const auto end = detail::call_cgal_reader(std::move(text), name, false, read);
  if (!end.good) throw InvalidInput(fmt::format("{}, line {}: expected the three coordinates of a vertex, found \"{}\"", name, end.line, end.found));
  return detail::soup_to_plc(soup, name, 0, control);
}

/// Reads an .off file. Throws as `read_file` and `parse_off`.
inline Plc read_off(const std::filesystem::path& path, const Control& control = Control{}) {
  return parse_off(read_file(path, control), path.string(), control);
}

}  // namespace delref
