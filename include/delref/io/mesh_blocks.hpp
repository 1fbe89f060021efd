// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a planar and a tetrahedral mesh have in common, as file formats see it: points, and blocks of cells, each with labels and
// all but the first with the input elements that its cells lie on. A format that is written in these terms stands once for both.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <delref/core/point.hpp>
#include <delref/mesh/planar_mesh.hpp>
#include <delref/mesh/tetrahedral_mesh.hpp>

namespace delref {

/// A mesh that the formats know.
template <class Mesh>
concept IndexedMesh = std::same_as<Mesh, PlanarMesh> || std::same_as<Mesh, TetrahedralMesh>;

namespace detail {

/// The dimension of a mesh's own cells.
template <IndexedMesh Mesh>
inline constexpr std::size_t dimension_of = std::same_as<Mesh, PlanarMesh> ? 2 : 3;

/// The cells of one dimension. `labels` are the regions of the mesh's own cells, and the markers of the cells on input elements.
/// `elements`: the input segments or facets that the cells lie on; null for the mesh's own cells.
template <class Cells, class Labels, class Elements>
struct MeshBlock {
  static constexpr std::size_t corners = std::tuple_size_v<typename std::remove_const_t<Cells>::value_type>;
  static constexpr std::size_t dimension = corners - 1;

  Cells& cells;
  Labels& labels;
  Elements* elements;

  int label(std::size_t i) const { return labels.empty() ? 0 : labels[i]; }
};

template <class Cells, class Labels, class Elements>
MeshBlock<Cells, Labels, Elements> mesh_block(Cells& cells, Labels& labels, Elements* elements) {
  return {cells, labels, elements};
}

/// The blocks of a mesh, which may be const: highest dimension first.
template <class Mesh>
  requires IndexedMesh<std::remove_const_t<Mesh>>
auto mesh_blocks(Mesh& mesh) {
  decltype(&mesh.edge_segments) none = nullptr;
  if constexpr (std::same_as<std::remove_const_t<Mesh>, PlanarMesh>) {
    return std::tuple(mesh_block(mesh.triangles, mesh.regions, none), mesh_block(mesh.edges, mesh.edge_markers, &mesh.edge_segments));
  } else {
    return std::tuple(mesh_block(mesh.tetrahedra, mesh.regions, none), mesh_block(mesh.triangles, mesh.triangle_markers, &mesh.triangle_facets),
                      mesh_block(mesh.edges, mesh.edge_markers, &mesh.edge_segments));
  }
}

/// Visits the blocks, highest dimension first.
template <class Mesh, class Visit>
void for_each_block(Mesh& mesh, Visit&& visit) {
  std::apply([&](const auto&... block) { (visit(block), ...); }, mesh_blocks(mesh));
}
/// Visits the blocks, edges first.
template <class Mesh, class Visit>
void for_each_block_from_edges(Mesh& mesh, Visit&& visit) {
  const auto blocks = mesh_blocks(mesh);
  constexpr std::size_t count = std::tuple_size_v<std::remove_cvref_t<decltype(blocks)>>;
  [&]<std::size_t... I>(std::index_sequence<I...>) { (visit(std::get<count - 1 - I>(blocks)), ...); }(std::make_index_sequence<count>());
}

/// How many cells there are, of all dimensions.
template <class Mesh>
std::size_t cell_count(const Mesh& mesh) {
  std::size_t count = 0;
  for_each_block(mesh, [&](const auto& block) { count += block.cells.size(); });
  return count;
}

/// What the input elements of a dimension are called.
inline constexpr std::array<std::string_view, 3> element_names{"vertex", "segment", "facet"};
inline std::array<double, 3> coordinates(Point2 p) { return {p.x, p.y, 0}; }
inline std::array<double, 3> coordinates(Point3 p) { return {p.x, p.y, p.z}; }

}  // namespace detail

}  // namespace delref
