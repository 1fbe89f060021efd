// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads triangulated surfaces from .stl files (3D Systems 1989), binary and text, by CGAL, which makes one point of equal ones. Every
// triangle becomes a facet. Normals and attributes are passed over.
//
// CGAL guesses whether a file is text, takes a broken text for bytes and either for an empty surface, and merges points that are not numbers
// with others. So the kind is told here, by a file's length where it can be, and made plain to CGAL; coordinates in bytes are looked at before.
#pragma once

#include <algorithm>
#include <bit>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <istream>
#include <string>
#include <string_view>
#include <utility>

#include <CGAL/IO/STL.h>
#include <fmt/format.h>

#include <delref/core/budget.hpp>
#include <delref/domain/invalid_input.hpp>
#include <delref/domain/plc.hpp>
#include <delref/io/binary_numbers.hpp>
#include <delref/io/cgal_stream.hpp>
#include <delref/io/file.hpp>
#include <delref/io/node_records.hpp>
#include <delref/io/polygon_soup.hpp>

namespace delref {

namespace detail {

inline constexpr std::size_t stl_head = 84, stl_triangle = 50;

/// The number of triangles that a binary file announces after 80 bytes of any text.
inline std::size_t stl_count(std::string_view bytes) { return number_from_bytes<std::uint32_t>(bytes.data() + 80, std::endian::little); }

/// A binary file may begin with `solid` as a text does, but has bytes that no text has, or the size that its count gives.
inline bool is_binary_stl(std::string_view bytes) {
  if (bytes.size() >= stl_head && bytes.size() == stl_head + stl_triangle * stl_count(bytes)) return true;
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  return first == std::string_view::npos || !bytes.substr(first).starts_with("solid") || bytes.find('\0') != std::string_view::npos;
}

/// Compares the length with the count and looks at every coordinate; the text at the head becomes one that CGAL does not take for a text's.
inline void guard_binary_stl(std::string& bytes, const std::string& name, const Control& control) {
  if (bytes.size() < stl_head) {
    throw InvalidInput(fmt::format("{}: neither begins with \"solid\", as text does, nor has the {} bytes with which a binary file begins", name, stl_head));
  }
  const std::size_t count = stl_count(bytes);
  if (bytes.size() != stl_head + stl_triangle * count) {
    throw InvalidInput(fmt::format("{}: announces {} triangles and should then have {} bytes, but has {}; is it cut off?", name, count,
                                   stl_head + stl_triangle * count, bytes.size()));
  }
  for (std::size_t t = 0; t != count; ++t) {
    ask_sometimes(control, t);
    const char* corner = bytes.data() + stl_head + stl_triangle * t + 12;
    for (int k = 0; k != 3; ++k, corner += 12) {
      const auto coordinate = [&](std::size_t i) { return double{number_from_bytes<float>(corner + 4 * i, std::endian::little)}; };
      check_finite({coordinate(0), coordinate(1), coordinate(2)}, t, name, "a corner of triangle");
    }
  }
  bytes.replace(0, 80, std::string(80, '-'));
}

/// Puts the words into small letters and takes away the names after `solid` and `endsolid`, in which CGAL would look for words of its own.
inline void guard_text_stl(std::string& text, const Control& control) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (std::size_t begin = 0, line = 0; begin < text.size(); ++line) {
    ask_sometimes(control, line);
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::size_t word = std::min(text.find_first_not_of(" \t\r", begin), end);
    for (const std::string_view keyword : {"solid", "endsolid"}) {
      if (std::string_view(text).substr(word).starts_with(keyword)) blank_out(text, word + keyword.size(), end);
    }
    begin = end + 1;
  }
  // CGAL takes what is shorter than the head of a binary file for an empty surface.
  text.append(stl_head, ' ').append("\n");
}

}  // namespace detail

/// The surface in the bytes of an .stl file; `name` is what complaints call it.
/// Throws `InvalidInput` saying what was expected (and in which line, of a text), `Interrupted` when the control says stop.
inline Plc parse_stl(std::string bytes, const std::string& name, const Control& control = Control{}) {
  const bool binary = detail::is_binary_stl(bytes);
  if (binary) detail::guard_binary_stl(bytes, name, control);
  else detail::guard_text_stl(bytes, control);
  detail::PolygonSoup soup(control);
  const auto read = [&](std::istream& in) { return CGAL::IO::read_STL(in, soup.points, soup.polygons, CGAL::parameters::verbose(false)); };
  const auto end = detail::call_cgal_reader(std::move(bytes), name, true, read);
  if (!end.good) {
    throw InvalidInput(fmt::format("{}, line {}: the text is no whole surface up to here; expected facets of three vertices with three coordinates each, "
                                   "between \"solid\" and \"endsolid\", found \"{}\"", name, end.line, end.found));
  }
  return detail::soup_to_plc(soup, name, 0, control);
}

/// Reads an .stl file. Throws as `read_file` and `parse_stl`.
inline Plc read_stl(const std::filesystem::path& path, const Control& control = Control{}) {
  return parse_stl(read_file(path, control), path.string(), control);
}

}  // namespace delref
