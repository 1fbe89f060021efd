// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads polygonal surfaces from .ply files, text and binary of either byte order, by CGAL behind the guard of ply_header.hpp. The element
// `vertex` gives the points, the list `vertex_indices` or `vertex_index` of the element `face` the facets; all else is passed over.
#pragma once

#include <cstddef>
#include <filesystem>
#include <istream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <CGAL/IO/PLY.h>
#include <fmt/format.h>

#include <delref/core/budget.hpp>
#include <delref/domain/invalid_input.hpp>
#include <delref/domain/plc.hpp>
#include <delref/io/cgal_stream.hpp>
#include <delref/io/file.hpp>
#include <delref/io/plc_file.hpp>
#include <delref/io/ply_header.hpp>
#include <delref/io/polygon_soup.hpp>

namespace delref {

namespace detail {

/// The list of an element that has the corners of a face.
inline std::string_view ply_corner_list(const PlyHeader& header, const PlyElement& element, const std::string& name) {
  const std::string_view list = element.find("vertex_indices") ? "vertex_indices" : "vertex_index";
  const auto found = element.find(list);
  if (!found || !element.properties[*found].count) throw InvalidInput(fmt::format("{}: the element \"face\" has no list vertex_indices", name));
  const PlyType type = element.properties[*found].type;
  if (header.layout != PlyLayout::text && type != PlyType::int32 && type != PlyType::uint32) {
    throw InvalidInput(fmt::format("{}: the list {} is of type {}; binary files are read with int or uint: save it with those, or as text", name, list,
                                   ply_type_names[static_cast<std::size_t>(type)]));
  }
  return list;
}

/// Compares the header with the file, and puts a plain one in its place. Gives notes about what is passed over.
inline std::vector<std::string> guard_ply_surface(std::string& bytes, const std::string& name, const Control& control) {
  const PlyHeader header = read_ply_header(bytes, name);
  std::vector<PlyWanted> wanted{{"vertex", {"x", "y", "z"}}};
  std::vector<std::string> notes;
  for (const PlyElement& element : header.elements) {
    if (element.name == "vertex") {
      for (const auto property : wanted[0].properties) check_ply_number(header, element, property, name);
    } else if (element.name == "face") {
      if (wanted.size() != 1) throw InvalidInput(fmt::format("{}: there are several elements \"face\"", name));
      wanted.push_back({"face", {ply_corner_list(header, element, name)}});
    } else if (element.count != 0) {
      notes.push_back(fmt::format("{} elements \"{}\" are passed over", element.count, element.name));
    }
  }
  if (header.layout != PlyLayout::text) check_ply_lengths(header, bytes, name, control);
  bytes.replace(0, header.size, plain_ply_header(header, bytes, wanted));
  return notes;
}

/// Throws unless a file in the PLY format was read to its end.
inline void check_ply_end(const ReaderEnd& end, const std::string& name, std::size_t vertices, std::size_t faces) {
  if (!end.good) {
    throw InvalidInput(fmt::format("{}, line {}: expected the numbers of the next element after {} vertices and {} faces, found \"{}\"", name,
                                   end.line, vertices, faces, end.found));
  }
  if (end.more_follows) throw InvalidInput(fmt::format("{}: more follows after the last element; is one of the numbers in the header too small?", name));
}

}  // namespace detail

/// The surface in the bytes of a .ply file; `name` is what complaints call it.
/// Throws `InvalidInput` with the line or element and what was expected there, `Interrupted` when the control says stop.
inline PlcFile parse_ply(std::string bytes, const std::string& name, const Control& control = Control{}) {
  PlcFile out;
  out.notes = detail::guard_ply_surface(bytes, name, control);
  detail::PolygonSoup soup(control);
  const auto read = [&](std::istream& in) { return CGAL::IO::read_PLY(in, soup.points, soup.polygons, CGAL::parameters::verbose(false)); };
  const auto end = detail::call_cgal_reader(std::move(bytes), name, false, read);
  detail::check_ply_end(end, name, soup.points.size(), soup.polygons.size());
  out.plc = detail::soup_to_plc(soup, name, 0, control);
  return out;
}

/// Reads a .ply file. Throws as `read_file` and `parse_ply`.
inline PlcFile read_ply(const std::filesystem::path& path, const Control& control = Control{}) {
  return parse_ply(read_file(path, control), path.string(), control);
}

}  // namespace delref
