// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes the MSH format 4.1 of Gmsh as text (Geuzaine and Remacle, gmsh.info/doc/texinfo/gmsh.html#MSH-file-format). Every region
// is a discrete surface and every segment marker a discrete curve, each in a physical group of its own; physical_tags.hpp says
// which tag a label gets. Markers of vertices go into a $NodeData section named "marker".
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <string_view>
#include <vector>

#include <delref/io/file.hpp>
#include <delref/io/physical_tags.hpp>
#include <delref/mesh/planar_mesh.hpp>

namespace delref {

namespace detail {

/// One element per label: the indices of the elements that have it, in order.
inline std::vector<std::vector<std::size_t>> group_by_label(const std::vector<int>& labels, const PhysicalTags& tags) {
  std::vector<std::vector<std::size_t>> groups(tags.pairs().size());
  for (std::size_t i = 0; i != labels.size(); ++i) groups[tags.position(labels[i])].push_back(i);
  return groups;
}

inline void write_msh_names(TextSink& out, const PhysicalTags& markers, const PhysicalTags& regions) {
  out << "$PhysicalNames\n" << markers.pairs().size() + regions.pairs().size() << '\n';
  for (const auto& [label, tag] : markers.pairs()) out << "1 " << tag << " \"marker " << label << "\"\n";
  for (const auto& [label, tag] : regions.pairs()) out << "2 " << tag << " \"region " << label << "\"\n";
  out << "$EndPhysicalNames\n";
}

/// Each entity has the tag of its physical group and, for a bounding box, that of the mesh.
inline void write_msh_entities(TextSink& out, const std::vector<Point2>& points, const PhysicalTags& markers, const PhysicalTags& regions) {
  Point2 low, high;
  if (!points.empty()) low = high = points.front();
  for (const Point2& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const auto entity = [&](int tag, int groups) {
    out << tag << ' ' << low.x << ' ' << low.y << " 0 " << high.x << ' ' << high.y << " 0 " << groups;
    if (groups != 0) out << ' ' << tag;
    out << " 0\n";
  };
  const bool bare = regions.pairs().empty();
  out << "$Entities\n0 " << markers.pairs().size() << ' ' << (bare ? 1 : regions.pairs().size()) << " 0\n";
  for (const auto& [label, tag] : markers.pairs()) entity(tag, 1);
  for (const auto& [label, tag] : regions.pairs()) entity(tag, 1);
  if (bare) entity(1, 0);
  out << "$EndEntities\n";
}

inline void write_msh_nodes(TextSink& out, const std::vector<Point2>& points, int surface) {
  out << "$Nodes\n" << (points.empty() ? 0 : 1) << ' ' << points.size() << ' ' << (points.empty() ? 0 : 1) << ' ' << points.size() << '\n';
  if (!points.empty()) out << "2 " << surface << " 0 " << points.size() << '\n';
  for (std::size_t i = 0; i != points.size(); ++i) out << i + 1 << '\n';
  for (const Point2& p : points) out << p.x << ' ' << p.y << " 0\n";
  out << "$EndNodes\n";
}

/// A block of elements per label. The tag of an element is its place in the mesh, `first` for the first.
template <class Corners>
void write_msh_blocks(TextSink& out, std::string_view dimension, std::string_view type, const std::vector<Corners>& elements,
                      const std::vector<std::vector<std::size_t>>& groups, const PhysicalTags& tags, std::size_t first) {
  for (std::size_t g = 0; g != groups.size(); ++g) {
    out << dimension << ' ' << tags.pairs()[g].second << ' ' << type << ' ' << groups[g].size() << '\n';
    for (const std::size_t i : groups[g]) {
      out << first + i;
      for (const auto corner : elements[i]) out << ' ' << std::size_t{corner} + 1;
      out << '\n';
    }
  }
}

}  // namespace detail

/// Writes nodes, subsegments and triangles, numbered from 1; elements are tagged in the order of the mesh, subsegments first.
/// Throws `OutputError`.
inline void write_msh(const std::filesystem::path& path, const PlanarMesh& mesh) {
  const auto or_zeros = [](const std::vector<int>& labels, std::size_t size) { return labels.empty() ? std::vector<int>(size, 0) : labels; };
  const std::vector<int> markers = or_zeros(mesh.edge_markers, mesh.edges.size()), regions = or_zeros(mesh.regions, mesh.triangles.size());
  const PhysicalTags marker_tags(markers), region_tags(regions);
  const auto edge_groups = detail::group_by_label(markers, marker_tags), triangle_groups = detail::group_by_label(regions, region_tags);
  write_file(path, [&](TextSink& out) {
    out << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
    detail::write_msh_names(out, marker_tags, region_tags);
    detail::write_msh_entities(out, mesh.points, marker_tags, region_tags);
    detail::write_msh_nodes(out, mesh.points, region_tags.pairs().empty() ? 1 : region_tags.pairs().front().second);
    const std::size_t count = mesh.edges.size() + mesh.triangles.size();
    out << "$Elements\n" << edge_groups.size() + triangle_groups.size() << ' ' << count << ' ' << (count == 0 ? 0 : 1) << ' ' << count << '\n';
    detail::write_msh_blocks(out, "1", "1", mesh.edges, edge_groups, marker_tags, 1);
    detail::write_msh_blocks(out, "2", "2", mesh.triangles, triangle_groups, region_tags, mesh.edges.size() + 1);
    out << "$EndElements\n";
    if (std::ranges::all_of(mesh.point_markers, [](int marker) { return marker == 0; })) return;
    out << "$NodeData\n1\n\"marker\"\n1\n0\n3\n0\n1\n" << mesh.points.size() << '\n';
    for (std::size_t i = 0; i != mesh.points.size(); ++i) out << i + 1 << ' ' << mesh.point_markers[i] << '\n';
    out << "$EndNodeData\n";
  });
}

}  // namespace delref
