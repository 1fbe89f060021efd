// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads meshes of lines, triangles and (in space) tetrahedra from VTK's XML format for unstructured grids: what `write_vtu` writes, and what VTK,
// ParaView and meshio write as text or as base64, inline or appended, without compression.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <pugixml.hpp>

#include <delref/core/budget.hpp>
#include <delref/io/base64.hpp>
#include <delref/io/binary_numbers.hpp>
#include <delref/io/file.hpp>
#include <delref/io/mesh_blocks.hpp>
#include <delref/io/text_scanner.hpp>
#include <delref/io/vtu.hpp>

namespace delref {

namespace detail {

/// The numbers of one DataArray.
class VtuArrays {
 public:
  VtuArrays(pugi::xml_node root, std::string file, const Control& control) : file_(std::move(file)), control_(control) {
    const std::string_view order = root.attribute("byte_order").as_string("LittleEndian");
    order_ = order == "LittleEndian" ? std::endian::little : std::endian::big;
    wide_ = std::string_view(root.attribute("header_type").as_string("UInt32")) == "UInt64";
    appended_ = root.child("AppendedData").text().get();
    if (const auto start = appended_.find('_'); start != std::string_view::npos) appended_.remove_prefix(start + 1);
  }

  /// The array of that name in a parent, which must hold `count` numbers. Empty when there is no such array.
  std::vector<double> find(pugi::xml_node parent, const char* name, std::size_t count) const {
    const pugi::xml_node node = parent.find_child_by_attribute("DataArray", "Name", name);
    return node ? read(node, count) : std::vector<double>();
  }
  std::vector<double> read(pugi::xml_node node, std::size_t count) const {
    std::vector<double> values = read(node);
    if (values.size() != count) fail(node, fmt::format("has {} numbers, not {}", values.size(), count));
    return values;
  }
  std::vector<double> read(pugi::xml_node node) const {
    throw_if_stopped(control_);
    const std::string_view format = node.attribute("format").as_string("ascii"), text = node.text().get();
    if (format == "ascii") return read_text(node, text);
    if (format == "binary") return read_bytes(node, text);
    const std::uint64_t offset = node.attribute("offset").as_ullong();
    if (format != "appended" || offset > appended_.size()) fail(node, "is neither ascii, nor binary, nor in the appended data");
    return read_bytes(node, appended_.substr(offset));
  }
  [[noreturn]] void fail(pugi::xml_node node, std::string_view message) const {
    throw InvalidInput(fmt::format("{}: the array \"{}\" {}", file_, node.attribute("Name").as_string(), message));
  }

 private:
  std::vector<double> read_text(pugi::xml_node node, std::string_view text) const {
    TextScanner in(text, fmt::format("{}, array \"{}\"", file_, node.attribute("Name").as_string()), TextScanner::Layout::free);
    std::vector<double> values;
    while (in.has_field()) values.push_back(in.number("a number"));
    return values;
  }
  std::vector<double> read_bytes(pugi::xml_node node, std::string_view text) const {
    const std::size_t header = wide_ ? 8 : 4;
    const auto length_bytes = decode_base64(text, header);
    if (!length_bytes || length_bytes->size() < header) fail(node, "does not begin with its length in base64");
    const std::uint64_t length = wide_ ? number<std::uint64_t>(length_bytes->data()) : number<std::uint32_t>(length_bytes->data());
    if (length > text.size()) fail(node, fmt::format("should have {} bytes, but is shorter", length));
    const auto bytes = decode_base64(text, header + length);
    if (!bytes || bytes->size() < header + length) fail(node, fmt::format("should have {} bytes in base64, but is broken or shorter", length));
    return convert(node, std::string_view(*bytes).substr(header));
  }
  std::vector<double> convert(pugi::xml_node node, std::string_view bytes) const {
    const std::string_view type = node.attribute("type").as_string();
    if (type == "Float64") return numbers<double>(bytes);
    if (type == "Float32") return numbers<float>(bytes);
    if (type == "Int8") return numbers<std::int8_t>(bytes);
    if (type == "UInt8") return numbers<std::uint8_t>(bytes);
    if (type == "Int16") return numbers<std::int16_t>(bytes);
    if (type == "UInt16") return numbers<std::uint16_t>(bytes);
    if (type == "Int32") return numbers<std::int32_t>(bytes);
    if (type == "UInt32") return numbers<std::uint32_t>(bytes);
    if (type == "Int64") return numbers<std::int64_t>(bytes);
    if (type == "UInt64") return numbers<std::uint64_t>(bytes);
    fail(node, fmt::format("has the type \"{}\", which is not known", type));
  }
  template <class Number>
  std::vector<double> numbers(std::string_view bytes) const {
    std::vector<double> values(bytes.size() / sizeof(Number));
    for (std::size_t i = 0; i != values.size(); ++i) values[i] = static_cast<double>(number<Number>(bytes.data() + i * sizeof(Number)));
    return values;
  }
  template <class Number>
  Number number(const char* bytes) const {
    return number_from_bytes<Number>(bytes, order_);
  }

  std::string file_;
  const Control& control_;
  std::string_view appended_;
  std::endian order_ = std::endian::little;
  bool wide_ = false;
};

/// Integers between two bounds, or a complaint with the place of the first that is not.
template <class Integer>
std::vector<Integer> vtu_integers(const std::vector<double>& values, const std::string& what, double low, double high) {
  std::vector<Integer> integers;
  integers.reserve(values.size());
  for (std::size_t i = 0; i != values.size(); ++i) {
    if (!(values[i] >= low && values[i] <= high) || values[i] != std::floor(values[i])) {
      throw InvalidInput(fmt::format("{} {} is {}, which is not an integer from {} to {}", what, i, values[i], low, high));
    }
    integers.push_back(static_cast<Integer>(static_cast<std::int64_t>(values[i])));
  }
  return integers;
}

/// Where the cells of each dimension stand among all cells.
using VtuPlaces = std::array<std::vector<std::size_t>, 4>;

template <class Value>
std::vector<Value> pick(const std::vector<Value>& all, const std::vector<std::size_t>& cells) {
  std::vector<Value> picked;
  if (all.empty()) return picked;
  picked.reserve(cells.size());
  for (const std::size_t i : cells) picked.push_back(all[i]);
  return picked;
}

/// The corners of cell `i`, which start at `begin`.
template <std::size_t Corners>
void add_vtu_cell(std::vector<std::array<std::uint32_t, Corners>>& out, const std::vector<std::uint32_t>& corners, std::uint64_t begin,
                  std::uint64_t end, std::size_t i, const std::string& file) {
  if (end > corners.size() || end < begin || end - begin != Corners) {
    throw InvalidInput(fmt::format("{}: cell {} should have {} corners; its offsets are {} and {}, the connectivity has {} numbers", file, i,
                                   Corners, begin, end, corners.size()));
  }
  std::array<std::uint32_t, Corners> cell{};
  for (std::size_t k = 0; k != Corners; ++k) cell[k] = corners[begin + k];
  out.push_back(cell);
}

template <class Mesh>
VtuPlaces read_vtu_cells(const VtuArrays& arrays, pugi::xml_node piece, std::size_t count, const std::string& file, Mesh& mesh) {
  const pugi::xml_node cells = piece.child("Cells");
  const auto all = [&](const char* name) {
    const pugi::xml_node node = cells.find_child_by_attribute("DataArray", "Name", name);
    if (!node) throw InvalidInput(fmt::format("{}: the cells have no array \"{}\"", file, name));
    return node;
  };
  const auto corners = vtu_integers<std::uint32_t>(arrays.read(all("connectivity")), file + ": in connectivity, number", 0,
                                                   static_cast<double>(mesh.points.size()) - 1);
  const auto offsets = vtu_integers<std::uint64_t>(arrays.read(all("offsets"), count), file + ": the offset of cell", 0, 1e15);
  const auto types = vtu_integers<int>(arrays.read(all("types"), count), file + ": the type of cell", 0, 255);
  VtuPlaces places;
  for (std::size_t i = 0; i != count; ++i) {
    bool known = types[i] == vtk_cell_types[0];
    for_each_block(mesh, [&](const auto& block) {
      if (types[i] != vtk_cell_types[block.dimension]) return;
      known = true;
      add_vtu_cell(block.cells, corners, i == 0 ? 0 : offsets[i - 1], offsets[i], i, file);
      places[block.dimension].push_back(i);
    });
    if (!known) {
      throw InvalidInput(fmt::format("{}: cell {} is of type {}; only {}triangles (5), lines (3) and vertices (1) are read", file, i, types[i],
                                     dimension_of<Mesh> == 3 ? "tetrahedra (10), " : ""));
    }
  }
  return places;
}

template <class Mesh>
void read_vtu_data(const VtuArrays& arrays, pugi::xml_node grid, pugi::xml_node piece, const VtuPlaces& places, std::size_t cells,
                   const std::string& file, Mesh& mesh) {
  constexpr double least = std::numeric_limits<std::int32_t>::min(), most = std::numeric_limits<std::int32_t>::max();
  const auto values = [&](const char* group, const char* name, std::size_t count, double low, double high) {
    return vtu_integers<int>(arrays.find(piece.child(group), name, count), fmt::format("{}: in {}, {}", file, group, name), low, high);
  };
  const std::size_t points = mesh.points.size();
  mesh.point_markers = values("PointData", "marker", points, least, most);
  for (const int level : values("PointData", "provenance", points, -1, 254)) {
    mesh.provenance.push_back(level < 0 ? input_level : static_cast<LevelIndex>(level));
  }
  const auto dimensions = values("PointData", "carrier_dimension", points, 0, 3), carriers = values("PointData", "carrier", points, least, most);
  if (!carriers.empty() && !dimensions.empty()) {
    for (std::size_t i = 0; i != points; ++i) {
      mesh.carriers.push_back({static_cast<std::uint8_t>(dimensions[i]), static_cast<std::uint32_t>(carriers[i])});
    }
  }
  const auto regions = values("CellData", "region", cells, least, most), markers = values("CellData", "marker", cells, least, most);
  for_each_block(mesh, [&](const auto& block) {
    const auto& here = places[block.dimension];
    block.labels = pick(block.dimension == dimension_of<Mesh> ? regions : markers, here);
    if (block.elements == nullptr) return;
    for (const int element : pick(values("CellData", element_names[block.dimension].data(), cells, least, most), here)) {
      block.elements->push_back(static_cast<std::uint32_t>(element));
    }
  });
  const pugi::xml_node names = grid.child("FieldData").find_child_by_attribute("DataArray", "Name", "level_names");
  if (!names) return;
  mesh.level_names.emplace_back();
  for (const int c : vtu_integers<int>(arrays.read(names), file + ": in FieldData, level_names", 0, 255)) {
    if (c == '\n') mesh.level_names.emplace_back();
    else mesh.level_names.back() += static_cast<char>(c);
  }
}

}  // namespace detail

/// The mesh in the text of a .vtu file; `name` is what complaints call it. Data that the file does not carry is left empty.
/// Throws `InvalidInput` saying what is wrong where, `Interrupted` when the control says stop.
template <IndexedMesh Mesh = PlanarMesh>
Mesh parse_vtu(std::string text, const std::string& name, const Control& control = Control{}) {
  const auto fail = [&](std::string_view message) { throw InvalidInput(fmt::format("{}: {}", name, message)); };
  if (text.find("encoding=\"raw\"") != std::string::npos) fail("its data is appended raw; only text and base64 are read");
  pugi::xml_document document;
  if (const auto result = document.load_buffer_inplace(text.data(), text.size()); !result) {
    fail(fmt::format("is not XML: {} at byte {}", result.description(), result.offset));
  }
  const pugi::xml_node root = document.child("VTKFile"), grid = root.child("UnstructuredGrid"), piece = grid.child("Piece");
  if (!piece) fail("is not an unstructured grid of VTK with a piece");
  if (piece.next_sibling("Piece")) fail("has more than one piece; merge them first");
  if (root.attribute("compressor")) fail("is compressed; save it without compression");
  const std::size_t points = piece.attribute("NumberOfPoints").as_ullong(), cells = piece.attribute("NumberOfCells").as_ullong();
  const detail::VtuArrays arrays(root, name, control);
  const auto most = text.size();
  if (points > most || cells > most) fail(fmt::format("announces {} points and {} cells, more than its {} bytes can hold", points, cells, most));

  Mesh mesh;
  const auto coordinates = arrays.read(piece.child("Points").child("DataArray"), 3 * points);
  mesh.points.reserve(points);
  for (std::size_t i = 0; i != points; ++i) {
    const Point3 p{coordinates[3 * i], coordinates[3 * i + 1], coordinates[3 * i + 2]};
    if constexpr (detail::dimension_of<Mesh> == 2) {
      if (p.z != 0) fail(fmt::format("point {} has z coordinate {}; only planar meshes, with z = 0, are read", i, p.z));
      mesh.points.push_back({p.x, p.y});
    } else {
      mesh.points.push_back(p);
    }
  }
  const detail::VtuPlaces places = detail::read_vtu_cells(arrays, piece, cells, name, mesh);
  detail::read_vtu_data(arrays, grid, piece, places, cells, name, mesh);
  return mesh;
}

/// Reads a .vtu file. Throws as `read_file` and `parse_vtu`.
template <IndexedMesh Mesh = PlanarMesh>
Mesh read_vtu(const std::filesystem::path& path, const Control& control = Control{}) {
  return parse_vtu<Mesh>(read_file(path, control), path.string(), control);
}

}  // namespace delref
