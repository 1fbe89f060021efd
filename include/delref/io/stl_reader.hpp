// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads triangulated surfaces from .stl files (3D Systems 1989), binary and text. Every triangle brings three points of its own
// and becomes a facet; `check_plc` merges equal points. Normals and attributes are passed over.
#pragma once

#include <array>
#include <bit>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <delref/core/budget.hpp>
#include <delref/domain/invalid_input.hpp>
#include <delref/domain/plc.hpp>
#include <delref/io/binary_numbers.hpp>
#include <delref/io/file.hpp>
#include <delref/io/node_records.hpp>
#include <delref/io/plc_file.hpp>
#include <delref/io/text_scanner.hpp>

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

inline Plc parse_binary_stl(std::string_view bytes, const std::string& name, const Control& control) {
  if (bytes.size() < stl_head) {
    throw InvalidInput(fmt::format("{}: neither begins with \"solid\", as text does, nor has the {} bytes with which a binary file begins", name, stl_head));
  }
  const std::size_t count = stl_count(bytes);
  if (bytes.size() != stl_head + stl_triangle * count) {
    throw InvalidInput(fmt::format("{}: announces {} triangles and should then have {} bytes, but has {}; is it cut off?", name, count,
                                   stl_head + stl_triangle * count, bytes.size()));
  }
  Plc out;
  out.points.reserve(3 * count);
  out.facets.reserve(count);
  for (std::size_t t = 0; t != count; ++t) {
    ask_sometimes(control, t);
    const char* corner = bytes.data() + stl_head + stl_triangle * t + 12;
    for (int k = 0; k != 3; ++k, corner += 12) {
      const auto coordinate = [&](std::size_t i) { return double{number_from_bytes<float>(corner + 4 * i, std::endian::little)}; };
      out.points.push_back({coordinate(0), coordinate(1), coordinate(2)});
    }
    const auto first = static_cast<Plc::Index>(3 * t);
    add_polygon(out, {first, first + 1, first + 2});
  }
  return out;
}

/// Goes over a word that must be there, in small or capital letters.
inline void expect_stl_word(TextScanner& in, std::string_view wanted) {
  std::string word(in.word(wanted));
  for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (word != wanted) in.fail(fmt::format("expected \"{}\"", wanted));
}

/// `facet normal x y z outer loop vertex x y z ... endloop endfacet`, less its first word.
inline void read_stl_facet(TextScanner& in, const CoordinateNames& names, Plc& out) {
  expect_stl_word(in, "normal");
  for (int i = 0; i != 3; ++i) in.word("a normal");
  expect_stl_word(in, "outer");
  expect_stl_word(in, "loop");
  for (int k = 0; k != 3; ++k) {
    expect_stl_word(in, "vertex");
    out.points.push_back(read_point<Point3>(in, names, out.points.size()));
  }
  expect_stl_word(in, "endloop");
  expect_stl_word(in, "endfacet");
  const auto end = static_cast<Plc::Index>(out.points.size());
  add_polygon(out, {end - 3, end - 2, end - 1});
}

inline Plc parse_text_stl(std::string_view text, const std::string& name, const Control& control) {
  TextScanner in(text, name, TextScanner::Layout::free);
  Plc out;
  const CoordinateNames names("vertex");
  while (in.has_field()) {
    expect_stl_word(in, "solid");
    in.rest_of_line();
    for (;;) {
      ask_sometimes(control, out.facets.size());
      const std::string_view word = in.word("facet or endsolid");
      if (word == "endsolid" || word == "ENDSOLID") break;
      if (word != "facet" && word != "FACET") in.fail("expected \"facet\" or \"endsolid\"");
      read_stl_facet(in, names, out);
    }
    in.rest_of_line();
  }
  return out;
}

}  // namespace detail

/// The surface in the bytes of an .stl file; `name` is what complaints call it.
/// Throws `InvalidInput` saying what was expected (and in which line, of a text), `Interrupted` when the control says stop.
inline Plc parse_stl(std::string_view bytes, const std::string& name, const Control& control = Control{}) {
  return detail::is_binary_stl(bytes) ? detail::parse_binary_stl(bytes, name, control) : detail::parse_text_stl(bytes, name, control);
}

/// Reads an .stl file. Throws as `read_file` and `parse_stl`.
inline Plc read_stl(const std::filesystem::path& path, const Control& control = Control{}) {
  return parse_stl(read_file(path, control), path.string(), control);
}

}  // namespace delref
