// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes VTK's XML format for unstructured grids, which ParaView opens: the tetrahedra of a mesh of space, triangles, subsegments as
// lines. It carries all that a mesh holds. Arrays are base64 without compression, so that every double is exact and a mesh of
// millions of cells is written as fast as the disk takes it.
//
// Points: marker, provenance (the index of a level in level_names, -1 for the input), carrier_dimension, carrier (-1 for none).
// Cells: region of the mesh's own cells, marker of those on input elements, segment of lines, facet of the triangles in space; in the
// plane min_angle in degrees, in space the dimension of the cell. A value that a cell cannot have is 0, for min_angle not a number,
// for segment and facet -1. Field data: level_names, the bytes of the names with a line feed between two.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>

#include <delref/core/budget.hpp>
#include <delref/core/carrier.hpp>
#include <delref/io/base64.hpp>
#include <delref/io/file.hpp>
#include <delref/io/mesh_blocks.hpp>
#include <delref/io/smallest_angles.hpp>

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

/// An array of one number per cell; `value(block, i)` gives that of the i-th cell of a block.
template <class Number, class Mesh, class Value>
void write_vtu_cell_values(TextSink& out, std::string_view name, const Mesh& mesh, Value&& value) {
  write_vtu_array<Number>(out, name, cell_count(mesh), 1, [&](auto&& put) {
    for_each_block(mesh, [&](const auto& block) {
      for (std::size_t i = 0; i != block.cells.size(); ++i) put(static_cast<Number>(value(block, i)));
    });
  });
}

template <class Mesh>
void write_vtu_field_data(TextSink& out, const Mesh& mesh) {
  if (mesh.level_names.empty()) return;
  std::string names;
  for (const std::string& name : mesh.level_names) names += (names.empty() ? "" : "\n") + name;
  out << "<FieldData>\n<DataArray type=\"UInt8\" Name=\"level_names\" NumberOfTuples=\"" << names.size() << "\" format=\"ascii\">";
  for (const char c : names) out << int{static_cast<unsigned char>(c)} << ' ';
  out << "</DataArray>\n</FieldData>\n";
}

template <class Mesh>
void write_vtu_point_data(TextSink& out, const Mesh& mesh) {
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

template <class Mesh>
void write_vtu_cell_data(TextSink& out, const Mesh& mesh) {
  constexpr std::size_t own = dimension_of<Mesh>;
  bool marked = false;
  for_each_block(mesh, [&](const auto& block) { marked = marked || (block.dimension != own && !block.labels.empty()); });
  out << "<CellData>\n";
  const auto label = [](bool wanted, const auto& block, std::size_t i) { return wanted ? block.label(i) : 0; };
  if (!mesh.regions.empty()) {
    write_vtu_cell_values<std::int32_t>(out, "region", mesh, [&](const auto& block, std::size_t i) { return label(block.dimension == own, block, i); });
  }
  if (marked) {
    write_vtu_cell_values<std::int32_t>(out, "marker", mesh, [&](const auto& block, std::size_t i) { return label(block.dimension != own, block, i); });
  }
  for_each_block(mesh, [&](const auto& wanted) {
    if (wanted.elements == nullptr || wanted.elements->empty()) return;
    write_vtu_cell_values<std::int32_t>(out, element_names[wanted.dimension], mesh, [&](const auto& block, std::size_t i) {
      return block.dimension == wanted.dimension ? (*block.elements)[i] : Carrier::none;
    });
  });
  if constexpr (own == 2) {
    const SmallestAngles angles(mesh);
    write_vtu_cell_values<float>(out, "min_angle", mesh, [&](const auto& block, std::size_t i) {
      return block.dimension == own ? angles(i) : std::numeric_limits<double>::quiet_NaN();
    });
  } else {
    write_vtu_cell_values<std::uint8_t>(out, "dimension", mesh, [](const auto& block, std::size_t) { return block.dimension; });
  }
  out << "</CellData>\n";
}

/// VTK's numbers of lines, triangles and tetrahedra, by dimension.
inline constexpr std::array<std::uint8_t, 4> vtk_cell_types{1, 3, 5, 10};

template <class Mesh>
void write_vtu_cells(TextSink& out, const Mesh& mesh) {
  out << "<Cells>\n";
  std::size_t corners = 0, end = 0;
  for_each_block(mesh, [&](const auto& block) { corners += block.corners * block.cells.size(); });
  write_vtu_array<std::int32_t>(out, "connectivity", corners, 1, [&](auto&& put) {
    for_each_block(mesh, [&](const auto& block) {
      for (const auto& cell : block.cells) for (const auto v : cell) put(static_cast<std::int32_t>(v));
    });
  });
  write_vtu_cell_values<std::int32_t>(out, "offsets", mesh, [&](const auto& block, std::size_t) { return end += block.corners; });
  write_vtu_cell_values<std::uint8_t>(out, "types", mesh, [](const auto& block, std::size_t) { return vtk_cell_types[block.dimension]; });
  out << "</Cells>\n";
}

}  // namespace detail

/// Writes the mesh with all its data. Requires fewer than 500 million cells. Throws `OutputError`, and `Interrupted` when the control
/// says stop.
template <IndexedMesh Mesh>
void write_vtu(const std::filesystem::path& path, const Mesh& mesh, const Control& control = Control{}) {
  const auto write = [&](TextSink& out) {
    const bool little = std::endian::native == std::endian::little;
    out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\""
        << (little ? "LittleEndian" : "BigEndian") << "\" header_type=\"UInt64\">\n<UnstructuredGrid>\n";
    detail::write_vtu_field_data(out, mesh);
    out << "<Piece NumberOfPoints=\"" << mesh.points.size() << "\" NumberOfCells=\"" << detail::cell_count(mesh) << "\">\n";
    detail::write_vtu_point_data(out, mesh);
    detail::write_vtu_cell_data(out, mesh);
    out << "<Points>\n";
    detail::write_vtu_array<double>(out, "Points", mesh.points.size(), 3, [&](auto&& put) {
      for (const auto& p : mesh.points) for (const double x : detail::coordinates(p)) put(x);
    });
    out << "</Points>\n";
    detail::write_vtu_cells(out, mesh);
    out << "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  };
  write_file(path, write, control);
}

}  // namespace delref
