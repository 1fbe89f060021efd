// SPDX-License-Identifier: GPL-3.0-or-later
//
// The records that the meshes of Triangle and of TetGen have in common: the vertices of a .node file, and numbered rows of corners with
// a marker or label, as in .ele, .face and .edge files.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include <delref/core/budget.hpp>
#include <delref/io/mesh_blocks.hpp>
#include <delref/io/node_records.hpp>
#include <delref/io/text_scanner.hpp>
#include <delref/io/text_sink.hpp>

namespace delref::detail {

/// A .node file. `original(i)` is the input vertex whose row of attributes a vertex carries that is vertex i of the domain.
template <class Mesh, class Graph, class Original>
void write_node_records(TextSink& out, const Mesh& mesh, const Graph& input, Original&& original) {
  constexpr std::size_t dimension = dimension_of<Mesh>;
  const bool marked = !mesh.point_markers.empty();
  const std::size_t attributes = mesh.carriers.empty() ? 0 : input.attribute_count;
  const auto attribute = [&](std::size_t vertex, std::size_t k) {
    if (mesh.carriers[vertex].dimension != 0) return 0.0;
    const std::size_t place = original(mesh.carriers[vertex].index) * attributes + k;
    return place < input.attributes.size() ? input.attributes[place] : 0.0;
  };
  out << mesh.points.size() << ' ' << dimension << ' ' << attributes << ' ' << int{marked} << '\n';
  for (std::size_t i = 0; i != mesh.points.size(); ++i) {
    const auto point = coordinates(mesh.points[i]);
    out << i + input.first_index;
    for (std::size_t k = 0; k != dimension; ++k) out << ' ' << point[k];
    for (std::size_t k = 0; k != attributes; ++k) out << ' ' << attribute(i, k);
    if (marked) out << ' ' << mesh.point_markers[i];
    out << '\n';
  }
}

/// Rows of the number, the corners and, if `labelled`, the label of each cell of a block, all counted from `first`.
template <class Block>
void write_cell_records(TextSink& out, const Block& block, std::size_t first, bool labelled) {
  for (std::size_t i = 0; i != block.cells.size(); ++i) {
    out << i + first;
    for (const auto corner : block.cells[i]) out << ' ' << corner + first;
    if (labelled) out << ' ' << block.label(i);
    out << '\n';
  }
}

/// An .ele file: the labels of the regions stand as attributes, unless all are 0.
template <class Block>
void write_ele_records(TextSink& out, const Block& block, std::size_t first) {
  const bool labelled = std::ranges::any_of(block.labels, [](int label) { return label != 0; });
  out << block.cells.size() << ' ' << block.corners << ' ' << int{labelled} << '\n';
  write_cell_records(out, block, first, labelled);
}

/// An index that is one of a vertex of the .node file, counted from 0.
template <class Graph>
typename Graph::Index read_mesh_index(TextScanner& in, const Graph& nodes, std::string_view what, std::size_t id) {
  const auto index = read_vertex_index(in, nodes, what, id);
  if (index >= nodes.points.size()) {
    in.fail(fmt::format("{} {} is vertex {}, but the vertices are numbered from {} and there are {}", what, id,
                        index + std::size_t{nodes.first_index}, nodes.first_index, nodes.points.size()));
  }
  return index;
}

/// One row of a cell: its number and its corners.
template <std::size_t Corners, class Graph>
std::array<typename Graph::Index, Corners> read_cell_record(TextScanner& in, const Graph& nodes, const std::array<std::string, Corners>& corner_names,
                                                            std::string_view number_name, std::uint32_t& number) {
  number = in.integer<std::uint32_t>(number_name);
  std::array<typename Graph::Index, Corners> corners{};
  for (std::size_t k = 0; k != Corners; ++k) corners[k] = read_mesh_index(in, nodes, corner_names[k], number);
  return corners;
}

/// "the first vertex of triangle" and so on.
template <std::size_t Corners>
std::array<std::string, Corners> corner_names(std::string_view corner, std::string_view cell) {
  static constexpr std::array<std::string_view, 4> ordinals{"first", "second", "third", "fourth"};
  std::array<std::string, Corners> names;
  for (std::size_t k = 0; k != Corners; ++k) names[k] = fmt::format("the {} {} of {}", ordinals[k], corner, cell);
  return names;
}

/// An .ele file, into the block of a mesh's own cells. `cell` is what complaints call one: "triangle", "tetrahedron".
template <class Graph, class Block>
void read_ele_records(std::string_view text, const std::string& name, const Graph& nodes, std::string_view cell, std::string_view cells,
                      const Block& block, const Control& control) {
  TextScanner in(text, name, TextScanner::Layout::lines);
  const std::string count_name = fmt::format("the number of {}", cells), number_name = fmt::format("the number of a {}", cell),
                    label_name = fmt::format("the attribute of {}", cell);
  in.need_line(count_name);
  const std::size_t count = in.count(count_name, 1);
  if (const auto corners = in.integer<std::uint32_t>(fmt::format("the number of vertices of a {}", cell)); corners != block.corners) {
    in.fail(fmt::format("the {0} have {1} vertices each; only {0} with {2} are read", cells, corners, block.corners));
  }
  const auto attributes = in.has_field() ? in.integer<std::uint32_t>("the number of attributes") : 0;
  in.check_room(count, 2 * (block.corners + 1), count_name);
  block.cells.reserve(count);
  block.labels.reserve(count);
  const auto names = corner_names<Block::corners>("vertex", cell);
  for (std::size_t i = 0; i != count; ++i) {
    ask_sometimes(control, i);
    in.need_line(cell, i + nodes.first_index);
    std::uint32_t number = 0;
    block.cells.push_back(read_cell_record<Block::corners>(in, nodes, names, number_name, number));
    block.labels.push_back(attributes != 0 ? read_label(in, label_name, number) : 0);
  }
}

/// A .face or .edge file, into a block of cells on input elements: all rows or, with `marked_only`, those with a marker that is not 0.
template <class Graph, class Block>
void read_marked_records(std::string_view text, const std::string& name, const Graph& nodes, std::string_view corner, std::string_view cell,
                         const Block& block, bool marked_only, const Control& control) {
  TextScanner in(text, name, TextScanner::Layout::lines);
  const std::string count_name = fmt::format("the number of {}s", cell), marker_name = fmt::format("the marker of {}", cell),
                    number_name = fmt::format("the number of {} {}", cell == "edge" ? "an" : "a", cell);
  in.need_line(count_name);
  const std::size_t count = in.count(count_name, 1);
  const bool marked = read_marker_count(in, fmt::format("the number of {} markers", cell));
  if (marked_only && !marked) return;
  in.check_room(count, 2 * (block.corners + 1), count_name);
  const auto names = corner_names<Block::corners>(corner, cell);
  for (std::size_t i = 0; i != count; ++i) {
    ask_sometimes(control, i);
    in.need_line(cell, i + nodes.first_index);
    std::uint32_t number = 0;
    const auto corners = read_cell_record<Block::corners>(in, nodes, names, number_name, number);
    const int marker = marked ? in.integer<int>(marker_name, number) : 0;
    if (marked_only && marker == 0) continue;
    block.cells.push_back(corners);
    block.labels.push_back(marker);
  }
}

}  // namespace delref::detail
