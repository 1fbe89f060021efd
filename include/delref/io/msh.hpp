// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes the MSH format 4.1 of Gmsh as text (Geuzaine and Remacle, gmsh.info/doc/texinfo/gmsh.html#MSH-file-format). Every region
// is a discrete surface or volume, every segment marker a discrete curve, every facet marker of a mesh of space a discrete surface,
// each in a physical group of its own; physical_tags.hpp says which tag a label gets. Markers of vertices go into a $NodeData section named "marker".
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <numeric>
#include <string_view>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/io/file.hpp>
#include <delref/io/mesh_blocks.hpp>
#include <delref/io/physical_tags.hpp>

namespace delref {

namespace detail {

/// Per label the indices of the elements that have it, in order.
inline std::vector<std::vector<std::size_t>> group_by_label(const std::vector<int>& labels, const PhysicalTags& tags) {
  std::vector<std::vector<std::size_t>> groups(tags.pairs().size());
  for (std::size_t i = 0; i != labels.size(); ++i) groups[tags.position(labels[i])].push_back(i);
  return groups;
}

/// The labels of a block as groups: the tags, and per tag the cells that have the label.
struct MshGroups {
  template <class Block>
  explicit MshGroups(const Block& block)
      : tags(block.labels.empty() ? std::vector<int>(std::min<std::size_t>(block.cells.size(), 1), 0) : block.labels) {
    if (!block.labels.empty()) members = group_by_label(block.labels, tags);
    else if (!block.cells.empty()) members.emplace_back(block.cells.size()), std::iota(members[0].begin(), members[0].end(), std::size_t{0});
  }

  PhysicalTags tags;
  std::vector<std::vector<std::size_t>> members;
};

/// The groups of every block, edges first.
template <class Mesh>
std::vector<MshGroups> msh_groups(const Mesh& mesh) {
  std::vector<MshGroups> groups;
  for_each_block_from_edges(mesh, [&](const auto& block) { groups.emplace_back(block); });
  return groups;
}

/// What the name of a physical group has before the label. Of a mesh of space segments and facets are told apart, since some programs
/// know groups by their names alone.
inline std::string_view msh_group_name(std::size_t dimension, std::size_t dimension_of_mesh) {
  if (dimension == dimension_of_mesh) return "region";
  if (dimension_of_mesh == 2) return "marker";
  return dimension == 1 ? "segment marker" : "facet marker";
}

inline void write_msh_names(TextSink& out, const std::vector<MshGroups>& groups) {
  std::size_t count = 0;
  for (const MshGroups& g : groups) count += g.tags.pairs().size();
  out << "$PhysicalNames\n" << count << '\n';
  for (std::size_t k = 0; k != groups.size(); ++k) {
    const std::string_view name = msh_group_name(k + 1, groups.size());
    for (const auto& [label, tag] : groups[k].tags.pairs()) out << k + 1 << ' ' << tag << " \"" << name << ' ' << label << "\"\n";
  }
  out << "$EndPhysicalNames\n";
}

/// Each entity has the tag of its physical group and, for a bounding box, that of the mesh. A mesh without cells of its own has one
/// entity of its dimension all the same, to which the nodes belong.
template <class Mesh>
void write_msh_entities(TextSink& out, const Mesh& mesh, const std::vector<MshGroups>& groups) {
  std::array<double, 3> low{}, high{};
  if (!mesh.points.empty()) low = high = coordinates(mesh.points.front());
  for (const auto& point : mesh.points) {
    const auto p = coordinates(point);
    for (std::size_t k = 0; k != 3; ++k) low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
  }
  const auto entity = [&](int tag, int physical_tags) {
    out << tag;
    for (const double x : low) out << ' ' << x;
    for (const double x : high) out << ' ' << x;
    out << ' ' << physical_tags;
    if (physical_tags != 0) out << ' ' << tag;
    out << " 0\n";
  };
  const bool bare = groups.back().tags.pairs().empty();
  out << "$Entities\n0";
  for (std::size_t k = 0; k != 3; ++k) {
    const std::size_t count = k < groups.size() ? groups[k].tags.pairs().size() : 0;
    out << ' ' << (bare && k + 1 == groups.size() ? 1 : count);
  }
  out << '\n';
  for (const MshGroups& g : groups) for (const auto& [label, tag] : g.tags.pairs()) entity(tag, 1);
  if (bare) entity(1, 0);
  out << "$EndEntities\n";
}

/// All nodes belong to the first entity of the mesh's own dimension.
template <class Mesh>
void write_msh_nodes(TextSink& out, const Mesh& mesh, const PhysicalTags& regions) {
  const std::size_t count = mesh.points.size(), blocks = count == 0 ? 0 : 1;
  out << "$Nodes\n" << blocks << ' ' << count << ' ' << blocks << ' ' << count << '\n';
  if (count != 0) {
    out << dimension_of<Mesh> << ' ' << (regions.pairs().empty() ? 1 : regions.pairs().front().second) << " 0 " << count << '\n';
  }
  for (std::size_t i = 0; i != count; ++i) out << i + 1 << '\n';
  for (const auto& point : mesh.points) {
    const auto p = coordinates(point);
    out << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  }
  out << "$EndNodes\n";
}

/// Gmsh's numbers of points, lines, triangles and tetrahedra, by dimension.
inline constexpr std::array<int, 4> msh_element_types{15, 1, 2, 4};

/// A block of elements per label. The tag of an element is its place among all of them, edges first.
template <class Mesh>
void write_msh_elements(TextSink& out, const Mesh& mesh, const std::vector<MshGroups>& groups) {
  const std::size_t count = cell_count(mesh);
  std::size_t blocks = 0, first = 1;
  for (const MshGroups& g : groups) blocks += g.members.size();
  out << "$Elements\n" << blocks << ' ' << count << ' ' << (count == 0 ? 0 : 1) << ' ' << count << '\n';
  for_each_block_from_edges(mesh, [&](const auto& block) {
    const auto& [tags, members] = groups[block.dimension - 1];
    for (std::size_t g = 0; g != members.size(); ++g) {
      out << block.dimension << ' ' << tags.pairs()[g].second << ' ' << msh_element_types[block.dimension] << ' ' << members[g].size() << '\n';
      for (const std::size_t i : members[g]) {
        out << first + i;
        for (const auto corner : block.cells[i]) out << ' ' << std::size_t{corner} + 1;
        out << '\n';
      }
    }
    first += block.cells.size();
  });
  out << "$EndElements\n";
}

}  // namespace detail

/// Writes nodes, subsegments, triangles and tetrahedra, numbered from 1; elements are tagged in the order of the mesh, subsegments
/// first. Throws `OutputError`, and `Interrupted` when the control says stop.
template <IndexedMesh Mesh>
void write_msh(const std::filesystem::path& path, const Mesh& mesh, const Control& control = Control{}) {
  const std::vector<detail::MshGroups> groups = detail::msh_groups(mesh);
  const auto write = [&](TextSink& out) {
    out << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
    detail::write_msh_names(out, groups);
    detail::write_msh_entities(out, mesh, groups);
    detail::write_msh_nodes(out, mesh, groups.back().tags);
    detail::write_msh_elements(out, mesh, groups);
    if (std::ranges::all_of(mesh.point_markers, [](int marker) { return marker == 0; })) return;
    out << "$NodeData\n1\n\"marker\"\n1\n0\n3\n0\n1\n" << mesh.points.size() << '\n';
    for (std::size_t i = 0; i != mesh.points.size(); ++i) out << i + 1 << ' ' << mesh.point_markers[i] << '\n';
    out << "$EndNodeData\n";
  };
  write_file(path, write, control);
}

}  // namespace delref
