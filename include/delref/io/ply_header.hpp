// SPDX-License-Identifier: GPL-3.0-or-later
//
// The header of a .ply file (Turk 1994, The PLY polygon file format): which elements follow, how many, and of what; and what CGAL's
// readers get in its place. They crash on properties that have the names but not the types they look for, pass over types that they do not
// know, and take the memory for whatever length a list says it has. So they see no names but the wanted ones, and in text one type.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include <delref/core/budget.hpp>
#include <delref/domain/invalid_input.hpp>
#include <delref/io/binary_numbers.hpp>
#include <delref/io/node_records.hpp>
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
  /// Where the elements begin, in bytes.
  std::size_t size = 0;
};

inline constexpr std::array<std::string_view, 8> ply_type_names{"char", "uchar", "short", "ushort", "int", "uint", "float", "double"};

inline PlyType read_ply_type(TextScanner& in) {
  static constexpr std::array<std::string_view, 8> others{"int8", "uint8", "int16", "uint16", "int32", "uint32", "float32", "float64"};
  const std::string_view word = in.word("the type of a property");
  for (std::size_t i = 0; i != others.size(); ++i) if (word == ply_type_names[i] || word == others[i]) return static_cast<PlyType>(i);
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

/// Reads the header of a file. Elements that the rest of the file cannot hold are refused.
inline PlyHeader read_ply_header(std::string_view bytes, const std::string& file) {
  TextScanner in(bytes, file, TextScanner::Layout::lines);
  if (!in.next_line() || in.word("ply") != "ply") in.fail("expected \"ply\" in the first line: this is not a file in the PLY format");
  PlyHeader header{read_ply_layout(in), {}, 0};
  for (;;) {
    in.need_line("end_header");
    const std::string_view keyword = in.word("a keyword");
    if (keyword == "end_header") break;
    if (keyword == "element") {
      const std::string name(in.word("the name of an element"));
      if (std::ranges::any_of(name, [](char c) { return c >= 0 && c < ' '; })) in.fail("the name of an element has a character that no text has");
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
    if (const std::size_t least = element.least_bytes(header.layout); least != 0) in.check_room(element.count, least, "the number of elements");
  }
  in.rest_of_line();
  header.size = bytes.size() - in.bytes_left();
  return header;
}

/// The length of a list in a binary file, taken for unsigned.
inline std::uint64_t ply_list_length(const char* bytes, PlyType type, PlyLayout layout) {
  const auto order = layout == PlyLayout::little ? std::endian::little : std::endian::big;
  if (size_of(type) == 1) return number_from_bytes<std::uint8_t>(bytes, order);
  if (size_of(type) == 2) return number_from_bytes<std::uint16_t>(bytes, order);
  return number_from_bytes<std::uint32_t>(bytes, order);
}

/// Goes over the elements of a binary file, so that none and no list in one is longer than the file.
inline void check_ply_lengths(const PlyHeader& header, std::string_view bytes, const std::string& name, const Control& control) {
  bytes.remove_prefix(header.size);
  for (const PlyElement& element : header.elements) {
    if (element.properties.empty()) continue;
    for (std::uint64_t i = 0; i != element.count; ++i) {
      ask_sometimes(control, i);
      const auto pass_over = [&](std::uint64_t size) {
        if (size > bytes.size()) throw InvalidInput(fmt::format("{}: {} {}: the file ends here; is it cut off?", name, element.name, i));
        bytes.remove_prefix(size);
      };
      for (const PlyProperty& property : element.properties) {
        if (!property.count) {
          pass_over(size_of(property.type));
          continue;
        }
        const char* const length = bytes.data();
        pass_over(size_of(*property.count));
        pass_over(ply_list_length(length, *property.count, header.layout) * size_of(property.type));
      }
    }
  }
}

/// An element that CGAL's reader is to see by its name, and the properties with which.
struct PlyWanted {
  std::string_view element;
  std::vector<std::string_view> properties;
};

/// The type that CGAL's reader is told. Text is read as real numbers, but for indices and the lengths of lists.
inline std::string_view plain_ply_type(PlyType type, PlyLayout layout, std::string_view in_text) {
  return layout == PlyLayout::text ? in_text : ply_type_names[static_cast<std::size_t>(type)];
}

/// The same header with other elements and properties unnamed, in as many lines as the first `size` bytes of the file have.
inline std::string plain_ply_header(const PlyHeader& header, std::string_view bytes, const std::vector<PlyWanted>& wanted) {
  static constexpr std::array<std::string_view, 3> layouts{"ascii", "binary_little_endian", "binary_big_endian"};
  std::string text = fmt::format("ply\nformat {} 1.0\n", layouts[static_cast<std::size_t>(header.layout)]);
  for (const PlyElement& element : header.elements) {
    if (element.properties.empty()) continue;
    const auto found = std::ranges::find(wanted, element.name, &PlyWanted::element);
    text += fmt::format("element {} {}\n", found == wanted.end() ? "other" : found->element, element.count);
    for (std::size_t k = 0; k != element.properties.size(); ++k) {
      const PlyProperty& property = element.properties[k];
      const bool named = found != wanted.end() && element.find(property.name) == k && std::ranges::count(found->properties, property.name) != 0;
      if (property.count) {
        text += fmt::format("property list {} {}", plain_ply_type(*property.count, header.layout, "ushort"),
                            plain_ply_type(property.type, header.layout, named ? "int" : "double"));
      } else {
        text += fmt::format("property {}", plain_ply_type(property.type, header.layout, "double"));
      }
      text += fmt::format(" {}\n", named ? property.name : "other");
    }
  }
  const auto lines = [](std::string_view of) { return std::ranges::count(of, '\n'); };
  for (auto i = lines(text) + 1; i < lines(bytes.substr(0, header.size)); ++i) text += "comment\n";
  return text + "end_header\n";
}

/// Refuses a number of an element that is missing, a list, or in a binary file of a type that CGAL's readers do not take for a coordinate.
inline void check_ply_number(const PlyHeader& header, const PlyElement& element, std::string_view property, const std::string& name) {
  const auto found = element.find(property);
  if (!found) throw InvalidInput(fmt::format("{}: the element \"{}\" has no property {}", name, element.name, property));
  const PlyProperty& number = element.properties[*found];
  if (number.count) throw InvalidInput(fmt::format("{}: {} of the element \"{}\" is a list", name, property, element.name));
  if (header.layout != PlyLayout::text && number.type < PlyType::float32) {
    throw InvalidInput(fmt::format("{}: {} of the element \"{}\" is of type {}; binary files are read with float or double: save it with those, or as text",
                                   name, property, element.name, ply_type_names[static_cast<std::size_t>(number.type)]));
  }
}

}  // namespace delref::detail
