// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes VTK's XML format for unstructured grids, which ParaView opens: the triangles, then the subsegments as lines. It carries
// all that a PlanarMesh holds. Arrays are base64 without compression, so that every double is exact and a mesh of millions of
// triangles is written as fast as the disk takes it.
//
// Points: marker, provenance (the index of a level in level_names, -1 for the input), carrier_dimension, carrier (-1 for none).
// Cells: region and min_angle in degrees of triangles, marker and segment of lines. A value that a cell cannot have is 0, for
// min_angle not a number, for segment -1. Field data: level_names, the bytes of the names with a line feed between two.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>

#include <delref/io/base64.hpp>
#include <delref/io/file.hpp>
#include <delref/io/smallest_angles.hpp>
#include <delref/mesh/planar_mesh.hpp>

namespace delref {

namespace detail {

template <class Number>
constexpr std::string_view vtk_type() {
  if constexpr (std::is_same_v<Number, double>) return "Float64";
  if constexpr (std::is_same_v<Number, float>) return "Float32";
  if constexpr (std::is_same_v<Number, std::int16_t>) return "Int16";
  if constexpr (std::is_same_v<Number, std::int32_t>) return "Int32";
  if constexpr (std::is_same_v<Number, std::uint8_t>) return "UInt8";
}

/// An array of `rows` times `components` numbers; `rows_to(put)` calls `put` with each of them.
template <class Number, class Rows>
void write_vtu_array(TextSink& out, std::string_view name, std::size_t rows, std::size_t components, Rows&& rows_to) {
  out << "<DataArray type=\"" << vtk_type<Number>() << "\" Name=\"" << name << '"';
  if (components != 1) out << " NumberOfComponents=\"" << components << '"';
  out << " format=\"binary\">";
  Base64Writer bytes(out);
  bytes.put(std::uint64_t{rows * components * sizeof(Number)});
  rows_to([&](Number value) { bytes.put(value); });
  bytes.finish();
  out << "</DataArray>\n";
}

/// An array of one number per element, from an index.
template <class Number, class Value>
void write_vtu_values(TextSink& out, std::string_view name, std::size_t count, Value&& value) {
  write_vtu_array<Number>(out, name, count, 1, [&](auto&& put) {
    for (std::size_t i = 0; i != count; ++i) put(static_cast<Number>(value(i)));
  });
}

inline void write_vtu_field_data(TextSink& out, const PlanarMesh& mesh) {
  if (mesh.level_names.empty()) return;
  std::string names;
  for (const std::string& name : mesh.level_names) names += (names.empty() ? "" : "\n") + name;
  out << "<FieldData>\n<DataArray type=\"UInt8\" Name=\"level_names\" NumberOfTuples=\"" << names.size() << "\" format=\"ascii\">";
  for (const char c : names) out << int{static_cast<unsigned char>(c)} << ' ';
  out << "</DataArray>\n</FieldData>\n";
}

inline void write_vtu_point_data(TextSink& out, const PlanarMesh& mesh) {
  const std::size_t count = mesh.points.size();
  out << "<PointData>\n";
  if (!mesh.point_markers.empty()) write_vtu_values<std::int32_t>(out, "marker", count, [&](std::size_t i) { return mesh.point_markers[i]; });
  if (!mesh.provenance.empty()) {
    write_vtu_values<std::int16_t>(out, "provenance", count,
                                   [&](std::size_t i) { return mesh.provenance[i] == input_level ? -1 : int{mesh.provenance[i]}; });
  }
  if (!mesh.carriers.empty()) {
    write_vtu_values<std::uint8_t>(out, "carrier_dimension", count, [&](std::size_t i) { return mesh.carriers[i].dimension; });
    write_vtu_values<std::int32_t>(out, "carrier", count, [&](std::size_t i) { return mesh.carriers[i].index; });
  }
  out << "</PointData>\n";
}

inline void write_vtu_cell_data(TextSink& out, const PlanarMesh& mesh) {
  const std::size_t triangles = mesh.triangles.size(), cells = triangles + mesh.edges.size();
  const SmallestAngles angles(mesh);
  const auto smallest_angle = [&](std::size_t i) { return i < triangles ? angles(i) : std::numeric_limits<double>::quiet_NaN(); };
  out << "<CellData>\n";
  if (!mesh.regions.empty()) write_vtu_values<std::int32_t>(out, "region", cells, [&](std::size_t i) { return i < triangles ? mesh.regions[i] : 0; });
  if (!mesh.edge_markers.empty()) {
    write_vtu_values<std::int32_t>(out, "marker", cells, [&](std::size_t i) { return i < triangles ? 0 : mesh.edge_markers[i - triangles]; });
  }
  if (!mesh.edge_segments.empty()) {
    write_vtu_values<std::int32_t>(out, "segment", cells,
                                   [&](std::size_t i) { return i < triangles ? PlanarMesh::Index(-1) : mesh.edge_segments[i - triangles]; });
  }
  write_vtu_values<float>(out, "min_angle", cells, smallest_angle);
  out << "</CellData>\n";
}

inline void write_vtu_cells(TextSink& out, const PlanarMesh& mesh) {
  const std::size_t triangles = mesh.triangles.size(), cells = triangles + mesh.edges.size();
  out << "<Cells>\n";
  write_vtu_array<std::int32_t>(out, "connectivity", 3 * triangles + 2 * mesh.edges.size(), 1, [&](auto&& put) {
    for (const auto& triangle : mesh.triangles) for (const auto v : triangle) put(static_cast<std::int32_t>(v));
    for (const auto& edge : mesh.edges) for (const auto v : edge) put(static_cast<std::int32_t>(v));
  });
  write_vtu_values<std::int32_t>(out, "offsets", cells, [&](std::size_t i) { return i < triangles ? 3 * (i + 1) : triangles + 2 * (i + 1); });
  write_vtu_values<std::uint8_t>(out, "types", cells, [&](std::size_t i) { return i < triangles ? 5 : 3; });
  out << "</Cells>\n";
}

}  // namespace detail

/// Writes the mesh with all its data. Requires fewer than 700 million triangles. Throws `OutputError`.
inline void write_vtu(const std::filesystem::path& path, const PlanarMesh& mesh) {
  write_file(path, [&](TextSink& out) {
    const bool little = std::endian::native == std::endian::little;
    out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\""
        << (little ? "LittleEndian" : "BigEndian") << "\" header_type=\"UInt64\">\n<UnstructuredGrid>\n";
    detail::write_vtu_field_data(out, mesh);
    out << "<Piece NumberOfPoints=\"" << mesh.points.size() << "\" NumberOfCells=\"" << mesh.triangles.size() + mesh.edges.size() << "\">\n";
    detail::write_vtu_point_data(out, mesh);
    detail::write_vtu_cell_data(out, mesh);
    out << "<Points>\n";
    detail::write_vtu_array<double>(out, "Points", mesh.points.size(), 3, [&](auto&& put) {
      for (const Point2& p : mesh.points) put(p.x), put(p.y), put(0.0);
    });
    out << "</Points>\n";
    detail::write_vtu_cells(out, mesh);
    out << "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  });
}

}  // namespace delref
