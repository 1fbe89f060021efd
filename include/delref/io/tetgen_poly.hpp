// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the .poly, .smesh and .node files of TetGen (Si 2015, wias-berlin.de/software/tetgen/fformats.html): vertices numbered from
// 0 or 1 with attributes and markers; facets of several polygons and holes (.poly) or of one polygon each (.smesh), with markers;
// holes; regions with a label and a bound on the volume.
//
// As with the planar files (triangle_poly.hpp) vertices must be numbered one after the other, every announced number must be there,
// a region's attribute is its label and must be an integer, and nothing may follow the last record.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/domain/plc.hpp>
#include <delref/io/file.hpp>
#include <delref/io/node_records.hpp>
#include <delref/io/text_scanner.hpp>

namespace delref {

namespace detail {

/// The number of corners and the corners of a polygon, which may go on over the ends of lines.
inline std::vector<Plc::Index> read_polygon_corners(TextScanner& in, const Plc& out, std::size_t facet) {
  const std::size_t count = in.count("the number of corners of a polygon", 2);
  if (count == 0) in.fail(fmt::format("a polygon of facet {} has no corners", facet));
  std::vector<Plc::Index> corners;
  corners.reserve(count);
  for (std::size_t i = 0; i != count; ++i) {
    if (!in.has_field()) in.need_line("a corner of a polygon of facet", facet);
    corners.push_back(read_vertex_index(in, out, "a corner of a polygon of facet", facet));
  }
  return corners;
}

/// .poly: a line `polygons [holes [marker]]`, the polygons, the holes.
inline Plc::Facet read_poly_facet(TextScanner& in, const Plc& out, bool marked, std::size_t number) {
  Plc::Facet facet;
  const std::size_t polygons = in.count("the number of polygons of a facet", 4);
  const std::size_t holes = in.has_field() ? in.count("the number of holes of a facet", 8) : 0;
  if (marked) facet.marker = in.has_field() ? in.integer<int>("the marker of facet", number) : 0;
  for (std::size_t i = 0; i != polygons; ++i) {
    in.need_line("a polygon of facet", number);
    facet.polygons.push_back(read_polygon_corners(in, out, number));
  }
  const CoordinateNames names("a hole of facet");
  for (std::size_t i = 0; i != holes; ++i) {
    in.need_line("a hole of facet", number);
    in.integer<std::uint32_t>("the number of a hole of facet", number);
    facet.holes.push_back(read_point<Point3>(in, names, number));
  }
  return facet;
}

/// .smesh: a line `corners corner ... [marker]`.
inline Plc::Facet read_smesh_facet(TextScanner& in, const Plc& out, bool marked, std::size_t number) {
  Plc::Facet facet;
  facet.polygons.push_back(read_polygon_corners(in, out, number));
  if (marked) facet.marker = in.has_field() ? in.integer<int>("the marker of facet", number) : 0;
  return facet;
}

template <class ReadFacet>
void read_facet_records(TextScanner& in, Plc& out, const Control& control, ReadFacet&& read_facet) {
  in.need_line("the number of facets");
  const std::size_t count = in.count("the number of facets", 1);
  const bool marked = read_marker_count(in, "the number of facet markers");
  in.check_room(count, 2, "the number of facets");
  out.facets.reserve(count);
  for (std::size_t i = 0; i != count; ++i) {
    ask_sometimes(control, i);
    in.need_line("facet", i + out.first_index);
    out.facets.push_back(read_facet(in, out, marked, i + out.first_index));
  }
}

}  // namespace detail

/// A .node file as a complex without facets. `name` is what complaints call it.
/// Throws `InvalidInput` with the line and what was expected there, `Interrupted` when the control says stop.
inline Plc parse_tetgen_node(std::string_view text, const std::string& name, const Control& control = Control{}) {
  return detail::parse_node_records<Plc>(text, name, control);
}

/// The two files that TetGen has for a complex.
enum class TetgenFile : unsigned char { poly, smesh };

/// A .poly or .smesh file. `separate_vertices()` is called when the file says that it has none itself, and gives those of the .node
/// file. Facets are numbered as vertices are. A volume bound that is 0, negative, infinite or missing is none. Indices of vertices
/// that do not exist are kept for `check_plc`. Throws as `parse_tetgen_node`.
template <std::invocable SeparateVertices>
Plc parse_tetgen_poly(std::string_view text, const std::string& name, TetgenFile kind, SeparateVertices&& separate_vertices,
                      const Control& control = Control{}) {
  const auto facets = [&](TextScanner& in, Plc& out) {
    if (kind == TetgenFile::poly) detail::read_facet_records(in, out, control, detail::read_poly_facet);
    else detail::read_facet_records(in, out, control, detail::read_smesh_facet);
  };
  return detail::parse_poly_records<Plc>(text, name, std::forward<SeparateVertices>(separate_vertices), facets, control);
}

/// Reads a .node file: vertices, no facets. Throws as `read_file` and `parse_tetgen_node`.
inline Plc read_tetgen_node(const std::filesystem::path& path, const Control& control = Control{}) {
  return parse_tetgen_node(read_file(path, control), path.string(), control);
}

/// Reads a .poly or .smesh file, and the .node file of the same stem when it says that it has 0 vertices.
inline Plc read_tetgen_poly(const std::filesystem::path& path, TetgenFile kind, const Control& control = Control{}) {
  const auto separate_vertices = [&] { return read_tetgen_node(detail::separate_node_file(path), control); };
  return parse_tetgen_poly(read_file(path, control), path.string(), kind, separate_vertices, control);
}

}  // namespace delref
