// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes and reads meshes as Triangle does (Shewchuk, www.cs.cmu.edu/~quake/triangle.html): a .node, an .ele, an .edge and a
// .poly file of one stem. The .ele file carries the labels of the regions, the .poly file the subsegments with their markers,
// the holes and the regions, the .edge file every edge of the mesh.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/domain/pslg.hpp>
#include <delref/io/element_records.hpp>
#include <delref/io/file.hpp>
#include <delref/io/file_set.hpp>
#include <delref/io/mesh_blocks.hpp>
#include <delref/io/text_sink.hpp>
#include <delref/io/triangle_poly.hpp>
#include <delref/mesh/planar_mesh.hpp>

namespace delref {

/// The files that `write_triangle_mesh` writes for a path: `.node`, `.ele`, `.edge` and `.poly`, whatever the path's extension.
inline std::array<std::filesystem::path, 4> triangle_mesh_files(const std::filesystem::path& path) {
  return files_of_stem(path, {".node", ".ele", ".edge", ".poly"});
}

namespace detail {

struct MarkedEdge {
  PlanarMesh::Index a, b;
  int marker;
};

/// Every edge of the triangles and every subsegment, once, by ascending smaller end.
inline std::vector<MarkedEdge> all_edges(const PlanarMesh& mesh) {
  std::vector<std::size_t> begin(mesh.points.size() + 1, 0);
  const auto for_each = [&](auto&& visit) {
    for (const auto& t : mesh.triangles) {
      for (std::size_t k = 0; k != 3; ++k) visit(std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3]), 0);
    }
    for (std::size_t i = 0; i != mesh.edges.size(); ++i) {
      const auto [a, b] = mesh.edges[i];
      visit(std::min(a, b), std::max(a, b), mesh.edge_markers.empty() ? 0 : mesh.edge_markers[i]);
    }
  };
  for_each([&](auto a, auto, int) { ++begin[a + 1]; });
  for (std::size_t v = 0; v != mesh.points.size(); ++v) begin[v + 1] += begin[v];
  std::vector<MarkedEdge> edges(begin.back());
  std::vector<std::size_t> end(begin.begin(), begin.end() - 1);
  for_each([&](auto a, auto b, int marker) {
    const auto first = edges.begin() + static_cast<std::ptrdiff_t>(begin[a]), last = edges.begin() + static_cast<std::ptrdiff_t>(end[a]);
    const auto known = std::find_if(first, last, [b = b](const MarkedEdge& e) { return e.b == b; });
    if (known == last) edges[end[a]++] = {a, b, marker};
    else if (marker != 0) known->marker = marker;
  });
  std::size_t size = 0;
  for (std::size_t v = 0; v != mesh.points.size(); ++v) {
    for (std::size_t i = begin[v]; i != end[v]; ++i) edges[size++] = edges[i];
  }
  edges.resize(size);
  return edges;
}

inline void write_edge(TextSink& out, const PlanarMesh& mesh, std::size_t first) {
  const std::vector<MarkedEdge> edges = all_edges(mesh);
  out << edges.size() << " 1\n";
  std::size_t number = first;
  for (const MarkedEdge& e : edges) out << number++ << ' ' << e.a + first << ' ' << e.b + first << ' ' << e.marker << '\n';
}

inline void write_poly(TextSink& out, const PlanarMesh& mesh, const Pslg& input) {
  const std::size_t first = input.first_index;
  out << "0 2 0 " << int{!mesh.point_markers.empty()} << '\n' << mesh.edges.size() << " 1\n";
  write_cell_records(out, std::get<1>(mesh_blocks(mesh)), first, true);
  out << input.holes.size() << '\n';
  std::size_t number = first;
  for (const Point2& hole : input.holes) out << number++ << ' ' << hole.x << ' ' << hole.y << '\n';
  if (input.regions.empty()) return;
  out << input.regions.size() << '\n';
  number = first;
  for (const Pslg::Region& region : input.regions) {
    out << number++ << ' ' << region.seed.x << ' ' << region.seed.y << ' ' << region.label << ' '
        << (region.max_area > 0 ? region.max_area : -1.0) << '\n';
  }
}

}  // namespace detail

/// Writes the four files of `triangle_mesh_files(path)`, all of them or none. Numbers start at `input.first_index`; holes, regions and attributes are
/// the input's, which may be empty. A Steiner vertex has the attributes 0. Throws `OutputError`, and `Interrupted` when the control says
/// stop.
inline void write_triangle_mesh(const std::filesystem::path& path, const PlanarMesh& mesh, const Pslg& input = {},
                                const Control& control = Control{}) {
  const auto write = [&](const std::array<TextSink*, 4>& sinks) {
    const auto [node, ele, edge, poly] = sinks;
    detail::write_node_records(*node, mesh, input, std::identity());
    detail::write_ele_records(*ele, std::get<0>(detail::mesh_blocks(mesh)), input.first_index);
    detail::write_edge(*edge, mesh, input.first_index);
    detail::write_poly(*poly, mesh, input);
  };
  write_file_set(triangle_mesh_files(path), write, control);
}

/// The text of a mesh in Triangle's format; an empty `poly` or `edge` is a file that is not there.
struct TriangleMeshText {
  std::string_view node, ele, poly, edge;
};

/// The mesh in those texts; `stem` is what complaints call the files, with their extensions. The subsegments are the segments of
/// the .poly file or, without one, the marked edges of the .edge file. Carriers, provenance and input segments are not in these
/// files. Throws `InvalidInput` with the line and what was expected there, `Interrupted` when the control says stop.
inline PlanarMesh parse_triangle_mesh(const TriangleMeshText& text, const std::string& stem, const Control& control = Control{}) {
  Pslg nodes = parse_triangle_node(text.node, stem + ".node", control);
  PlanarMesh mesh;
  const auto [triangles, edges] = detail::mesh_blocks(mesh);
  detail::read_ele_records(text.ele, stem + ".ele", nodes, "triangle", "triangles", triangles, control);
  if (!text.poly.empty()) {
    Pslg poly = parse_triangle_poly(text.poly, stem + ".poly", [&] { return nodes; }, control);
    if (poly.points.size() != nodes.points.size()) {
      throw InvalidInput(fmt::format("{0}.poly: has {1} vertices of its own, so its segments are not those of the mesh in {0}.node", stem,
                                     poly.points.size()));
    }
    for (std::size_t i = 0; i != poly.segments.size(); ++i) {
      if (std::ranges::max(poly.segments[i]) < nodes.points.size()) continue;
      throw InvalidInput(fmt::format("{}.poly: segment {} ends at vertex {}, but {}.node has {} vertices", stem, i + nodes.first_index,
                                     std::ranges::max(poly.segments[i]) + std::size_t{nodes.first_index}, stem, nodes.points.size()));
    }
    mesh.edge_markers = poly.segment_markers.empty() ? std::vector<int>(poly.segments.size(), 0) : std::move(poly.segment_markers);
    mesh.edges = std::move(poly.segments);
  } else if (!text.edge.empty()) {
    detail::read_marked_records(text.edge, stem + ".edge", nodes, "end", "edge", edges, true, control);
  }
  mesh.points = std::move(nodes.points);
  mesh.point_markers = std::move(nodes.point_markers);
  return mesh;
}

/// Reads the .node and .ele files of the path's stem, and the .poly or else the .edge file if there is one.
/// Throws as `read_file` and `parse_triangle_mesh`.
inline PlanarMesh read_triangle_mesh(const std::filesystem::path& path, const Control& control = Control{}) {
  const auto [node, ele, edge, poly] = triangle_mesh_files(path);
  const std::string node_text = read_file(node, control), ele_text = read_file(ele, control);
  const std::string poly_text = std::filesystem::exists(poly) ? read_file(poly, control) : std::string();
  const bool edges_needed = poly_text.empty() && std::filesystem::exists(edge);
  const std::string edge_text = edges_needed ? read_file(edge, control) : std::string();
  return parse_triangle_mesh({node_text, ele_text, poly_text, edge_text}, std::filesystem::path(path).replace_extension().string(), control);
}

}  // namespace delref
