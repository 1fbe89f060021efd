// SPDX-License-Identifier: GPL-3.0-or-later
//
// The header of a .ply file (Turk 1994, The PLY polygon file format): which elements follow, how many, and of what.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include <delref/io/text_scanner.hpp>

namespace delref::detail {

enum class PlyType : unsigned char { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
enum class PlyLayout : unsigned char { text, little, big };

inline std::size_t size_of(PlyType type) {
  static constexpr std::array<std::size_t, 8> sizes{1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

/// A number of an element or, with a `count` type, a list of them.
struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float64;
  std::optional<PlyType> count;
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  /// The position of a property; nothing without it.
  std::optional<std::size_t> find(std::string_view property) const {
    const auto found = std::ranges::find(properties, property, &PlyProperty::name);
    if (found == properties.end()) return std::nullopt;
    return static_cast<std::size_t>(found - properties.begin());
  }
  /// The fewest bytes that one of these elements takes.
  std::size_t least_bytes(PlyLayout layout) const {
    std::size_t bytes = 0;
    for (const PlyProperty& p : properties) bytes += layout == PlyLayout::text ? 2 : size_of(p.count.value_or(p.type));
    return bytes;
  }
};

struct PlyHeader {
  PlyLayout layout = PlyLayout::text;
  std::vector<PlyElement> elements;
};

inline PlyType read_ply_type(TextScanner& in) {
  static constexpr std::array<std::string_view, 8> names{"char", "uchar", "short", "ushort", "int", "uint", "float", "double"};
  static constexpr std::array<std::string_view, 8> others{"int8", "uint8", "int16", "uint16", "int32", "uint32", "float32", "float64"};
  const std::string_view word = in.word("the type of a property");
  for (std::size_t i = 0; i != names.size(); ++i) if (word == names[i] || word == others[i]) return static_cast<PlyType>(i);
  in.fail("expected the type of a property: char, uchar, short, ushort, int, uint, float or double");
}

inline PlyLayout read_ply_layout(TextScanner& in) {
  in.need_line("the format");
  if (in.word("the format") != "format") in.fail("expected \"format\" in the second line");
  const std::string_view word = in.word("the format");
  if (word == "ascii") return PlyLayout::text;
  if (word == "binary_little_endian") return PlyLayout::little;
  if (word == "binary_big_endian") return PlyLayout::big;
  in.fail("expected the format ascii, binary_little_endian or binary_big_endian");
}

/// Reads up to the end of the header's last line. Elements that the rest of the file cannot hold are refused.
inline PlyHeader read_ply_header(TextScanner& in) {
  if (!in.next_line() || in.word("ply") != "ply") in.fail("expected \"ply\" in the first line: this is not a file in the PLY format");
  PlyHeader header{read_ply_layout(in), {}};
  for (;;) {
    in.need_line("end_header");
    const std::string_view keyword = in.word("a keyword");
    if (keyword == "end_header") break;
    if (keyword == "element") {
      const std::string name(in.word("the name of an element"));
      header.elements.push_back({name, in.integer<std::uint64_t>("the number of elements"), {}});
    } else if (keyword == "property") {
      if (header.elements.empty()) in.fail("a property comes before the first element");
      PlyProperty property;
      if (in.at_word("list")) {
        in.word("list");
        property.count = read_ply_type(in);
        if (*property.count >= PlyType::float32) in.fail("the length of a list is a real number; it must be an integer");
      }
      property.type = read_ply_type(in);
      property.name = in.word("the name of a property");
      header.elements.back().properties.push_back(property);
    } else if (keyword != "comment" && keyword != "obj_info") {
      in.fail("expected element, property, comment or end_header");
    }
  }
  if (in.has_field()) in.fail("expected the end of the line after end_header");
  for (const PlyElement& element : header.elements) {
    if (const std::size_t bytes = element.least_bytes(header.layout); bytes != 0) in.check_room(element.count, bytes, "the number of elements");
  }
  return header;
}

}  // namespace delref::detail
