// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads polygonal surfaces from Wavefront's .obj by CGAL: vertices (`v`), faces (`f`), of which each becomes a facet, and lines (`l`), whose
// pieces become segments. Texture coordinates, normals, groups and materials are passed over; curves and free-form surfaces are told.
//
// CGAL ends a face at the first corner that it cannot read, takes vertex 0 for the next one, and refuses lines and keywords that it does not
// know. So corners are looked at before; lines are handed to it as faces and taken out of them again; what is passed over it does not see.
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <istream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <CGAL/IO/OBJ.h>
#include <fmt/format.h>

#include <delref/core/budget.hpp>
#include <delref/domain/plc.hpp>
#include <delref/io/cgal_stream.hpp>
#include <delref/io/file.hpp>
#include <delref/io/node_records.hpp>
#include <delref/io/plc_file.hpp>
#include <delref/io/polygon_soup.hpp>
#include <delref/io/text_scanner.hpp>

namespace delref {

namespace detail {

/// A corner `v`, `v/vt`, `v//vn` or `v/vt/vn`, whose v counts from 1 or, when it is negative, back from the last vertex so far.
inline void check_obj_corner(TextScanner& in, std::size_t points) {
  const std::string_view field = in.word("a vertex"), digits = field.substr(0, field.find('/'));
  std::int32_t written = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), written);
  if (error == std::errc::result_out_of_range) {
    in.fail(fmt::format("there is no vertex {}", std::string_view(digits.data(), std::min(end, digits.data() + 40))));
  }
  // CGAL looks no further than 256 characters for the end of a corner.
  if (error != std::errc{} || end != digits.data() + digits.size() || field.size() > 200) {
    in.fail("expected the number of a vertex, alone or as in 1/2/3");
  }
  if (written == 0 || -std::int64_t{written} > static_cast<std::int64_t>(points)) {
    in.fail(fmt::format("there is no vertex {}; vertices are numbered from 1, and from -1 backwards", written));
  }
}

inline bool is_free_form(std::string_view keyword) {
  static constexpr std::array<std::string_view, 6> keywords{"curv", "curv2", "surf", "bzp", "bsp", "cstype"};
  return std::ranges::find(keywords, keyword) != keywords.end();
}

/// What the guard has seen of a file.
struct ObjContent {
  /// Which of the polygons that CGAL will read are lines, in order.
  std::vector<std::size_t> lines;
  bool free_form = false;
};

/// Looks at every corner, turns `l` into `f`, and blanks what is neither v nor f.
inline ObjContent guard_obj(std::string& text, const std::string& name, const Control& control) {
  blank_comments(text);
  TextScanner in(text, name, TextScanner::Layout::lines);
  ObjContent content;
  std::size_t points = 0, polygons = 0;
  for (std::size_t line = 0; in.next_line(); ++line) {
    ask_sometimes(control, line);
    const std::string_view keyword = in.word("a keyword");
    const std::size_t begin = text.size() - in.bytes_left() - keyword.size(), end = begin + keyword.size() + line_ahead(in, text).size();
    if (keyword == "v") {
      refuse_commas(text, name, begin, end);
      ++points;
    } else if (keyword == "f" || keyword == "l") {
      refuse_commas(text, name, begin, end);
      std::size_t corners = 0;
      for (; in.has_field(); ++corners) check_obj_corner(in, points);
      const std::size_t face = polygons + 1 - content.lines.size();
      if (keyword == "l") content.lines.push_back(polygons);
      else if (corners < 3) in.fail(fmt::format("face {} has {} corners; a polygon has three or more", face, corners));
      ++polygons;
      text[begin] = 'f';
    } else {
      content.free_form = content.free_form || is_free_form(keyword);
      blank_out(text, begin, end);
    }
  }
  if (points == 0) in.fail("the file ends without a vertex, that is a line that starts with v");
  if (polygons == 0) in.fail("the file ends without a face, that is a line that starts with f");
  return content;
}

}  // namespace detail

/// The surface in the text of an .obj file; `name` is what complaints call it.
/// Throws `InvalidInput` with the line or face and what was expected there, `Interrupted` when the control says stop.
inline PlcFile parse_obj(std::string text, const std::string& name, const Control& control = Control{}) {
  const detail::ObjContent content = detail::guard_obj(text, name, control);
  detail::PolygonSoup soup(control);
  const auto read = [&](std::istream& in) { return CGAL::IO::read_OBJ(in, soup.points, soup.polygons, CGAL::parameters::verbose(false)); };
  const auto end = detail::call_cgal_reader(std::move(text), name, false, read);
  if (!end.good) {
    throw InvalidInput(fmt::format("{}, line {}: expected the three coordinates of vertex {}, found \"{}\"", name, end.line,
                                   soup.points.size() + 1, end.found));
  }
  PlcFile out{detail::soup_to_plc(soup, name, 1, control, content.lines), {}};
  if (content.free_form) out.notes.emplace_back("curves and free-form surfaces are passed over; only v, f and l are read");
  return out;
}

/// Reads an .obj file. Throws as `read_file` and `parse_obj`.
inline PlcFile read_obj(const std::filesystem::path& path, const Control& control = Control{}) {
  return parse_obj(read_file(path, control), path.string(), control);
}

}  // namespace delref
