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
#include <string>
#include <string_view>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/domain/pslg.hpp>
#include <delref/io/file.hpp>
#include <delref/io/text_scanner.hpp>
#include <delref/io/triangle_poly.hpp>
#include <delref/mesh/planar_mesh.hpp>

namespace delref {

/// The files that `write_triangle_mesh` writes for a path: `.node`, `.ele`, `.edge` and `.poly`, whatever the path's extension.
inline std::array<std::filesystem::path, 4> triangle_mesh_files(const std::filesystem::path& path) {
  std::array<std::filesystem::path, 4> files{path, path, path, path};
  constexpr std::array<const char*, 4> extensions{".node", ".ele", ".edge", ".poly"};
  for (std::size_t i = 0; i != files.size(); ++i) files[i].replace_extension(extensions[i]);
  return files;
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

/// The row of the input's attributes that a vertex carries; null for a Steiner vertex.
inline const double* attribute_row(const PlanarMesh& mesh, const Pslg& input, std::size_t vertex) {
  if (vertex >= mesh.carriers.size() || mesh.carriers[vertex].dimension != 0) return nullptr;
  const std::size_t row = mesh.carriers[vertex].index;
  return (row + 1) * input.attribute_count <= input.attributes.size() ? input.attributes.data() + row * input.attribute_count : nullptr;
}

inline void write_node(TextSink& out, const PlanarMesh& mesh, const Pslg& input) {
  const bool marked = !mesh.point_markers.empty();
  const std::size_t attributes = mesh.carriers.empty() ? 0 : input.attribute_count;
  out << mesh.points.size() << " 2 " << attributes << ' ' << int{marked} << '\n';
  for (std::size_t i = 0; i != mesh.points.size(); ++i) {
    out << i + input.first_index << ' ' << mesh.points[i].x << ' ' << mesh.points[i].y;
    const double* row = attributes == 0 ? nullptr : attribute_row(mesh, input, i);
    for (std::size_t k = 0; k != attributes; ++k) out << ' ' << (row ? row[k] : 0.0);
    if (marked) out << ' ' << mesh.point_markers[i];
    out << '\n';
  }
}

inline void write_ele(TextSink& out, const PlanarMesh& mesh, std::size_t first) {
  const bool labelled = std::ranges::any_of(mesh.regions, [](int label) { return label != 0; });
  out << mesh.triangles.size() << " 3 " << int{labelled} << '\n';
  for (std::size_t i = 0; i != mesh.triangles.size(); ++i) {
    const auto& t = mesh.triangles[i];
    out << i + first << ' ' << t[0] + first << ' ' << t[1] + first << ' ' << t[2] + first;
    if (labelled) out << ' ' << mesh.regions[i];
    out << '\n';
  }
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
  for (std::size_t i = 0; i != mesh.edges.size(); ++i) {
    out << i + first << ' ' << mesh.edges[i][0] + first << ' ' << mesh.edges[i][1] + first << ' '
        << (mesh.edge_markers.empty() ? 0 : mesh.edge_markers[i]) << '\n';
  }
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

inline PlanarMesh::Index read_mesh_index(TextScanner& in, const Pslg& nodes, std::string_view what, std::size_t id) {
  const auto index = read_vertex_index(in, nodes, what, id);
  if (index >= nodes.points.size()) {
    in.fail(fmt::format("{} {} is vertex {}, but the vertices are numbered from {} and there are {}", what, id,
                        index + std::size_t{nodes.first_index}, nodes.first_index, nodes.points.size()));
  }
  return index;
}

inline void read_ele(std::string_view text, const std::string& name, const Pslg& nodes, PlanarMesh& mesh, const Control& control) {
  TextScanner in(text, name, TextScanner::Layout::lines);
  in.need_line("the number of triangles");
  const std::size_t count = in.count("the number of triangles", 1);
  if (const auto corners = in.integer<std::uint32_t>("the number of vertices of a triangle"); corners != 3) {
    in.fail(fmt::format("the triangles have {} vertices each; only triangles with 3 are read", corners));
  }
  const auto attributes = in.has_field() ? in.integer<std::uint32_t>("the number of attributes") : 0;
  in.check_room(count, 8, "the number of triangles");
  mesh.triangles.reserve(count);
  mesh.regions.reserve(count);
  for (std::size_t i = 0; i != count; ++i) {
    ask_sometimes(control, i);
    in.need_line("triangle", i + nodes.first_index);
    const auto number = in.integer<std::uint32_t>("the number of a triangle");
    const auto a = read_mesh_index(in, nodes, "the first vertex of triangle", number);
    const auto b = read_mesh_index(in, nodes, "the second vertex of triangle", number);
    mesh.triangles.push_back({a, b, read_mesh_index(in, nodes, "the third vertex of triangle", number)});
    mesh.regions.push_back(attributes != 0 ? read_label(in, "the attribute of triangle", number) : 0);
  }
}

/// The edges with a marker: what an .edge file tells of the subsegments.
inline void read_edge(std::string_view text, const std::string& name, const Pslg& nodes, PlanarMesh& mesh, const Control& control) {
  TextScanner in(text, name, TextScanner::Layout::lines);
  in.need_line("the number of edges");
  const std::size_t count = in.count("the number of edges", 1);
  const bool marked = read_marker_count(in, "the number of edge markers");
  for (std::size_t i = 0; i != count && marked; ++i) {
    ask_sometimes(control, i);
    in.need_line("edge", i + nodes.first_index);
    const auto number = in.integer<std::uint32_t>("the number of an edge");
    const auto a = read_mesh_index(in, nodes, "the first end of edge", number);
    const auto b = read_mesh_index(in, nodes, "the second end of edge", number);
    const int marker = in.integer<int>("the marker of edge", number);
    if (marker == 0) continue;
    mesh.edges.push_back({a, b});
    mesh.edge_markers.push_back(marker);
  }
}

}  // namespace detail

/// Writes the four files of `triangle_mesh_files(path)`. Numbers start at `input.first_index`; holes, regions and attributes are
/// the input's, which may be empty. A Steiner vertex has the attributes 0. Throws `OutputError`.
inline void write_triangle_mesh(const std::filesystem::path& path, const PlanarMesh& mesh, const Pslg& input = {}) {
  const auto [node, ele, edge, poly] = triangle_mesh_files(path);
  write_file(node, [&](TextSink& out) { detail::write_node(out, mesh, input); });
  write_file(ele, [&](TextSink& out) { detail::write_ele(out, mesh, input.first_index); });
  write_file(edge, [&](TextSink& out) { detail::write_edge(out, mesh, input.first_index); });
  write_file(poly, [&](TextSink& out) { detail::write_poly(out, mesh, input); });
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
  detail::read_ele(text.ele, stem + ".ele", nodes, mesh, control);
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
    detail::read_edge(text.edge, stem + ".edge", nodes, mesh, control);
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
