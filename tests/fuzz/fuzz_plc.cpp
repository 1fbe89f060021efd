// SPDX-License-Identifier: GPL-3.0-or-later
#include <delref/io/point_set_reader.hpp>
#include <delref/io/polyhedral_formats.hpp>

#include "survive.hpp"

namespace {

/// Vectors have their lengths. Indices may be wrong: `check_plc` names those.
void require_whole(const delref::Plc& plc) {
  delref_fuzz::require(plc.attributes.size() == plc.points.size() * plc.attribute_count);
  delref_fuzz::require(plc.point_markers.empty() || plc.point_markers.size() == plc.points.size());
  for (const auto& facet : plc.facets) for (const auto& polygon : facet.polygons) delref_fuzz::require(!polygon.empty());
}

/// The readers of surfaces check indices and coordinates themselves.
void require_surface(const delref::Plc& plc) {
  require_whole(plc);
  delref_fuzz::require(!plc.points.empty());
  for (const auto p : plc.points) delref_fuzz::require(is_finite(p));
  for (const auto& segment : plc.segments) for (const auto v : segment) delref_fuzz::require(v < plc.points.size());
  for (const auto& facet : plc.facets) {
    delref_fuzz::require(facet.polygons.size() == 1 && facet.polygons[0].size() >= 3);
    for (const auto v : facet.polygons[0]) delref_fuzz::require(v < plc.points.size());
  }
}

/// Normals are for all points or for none.
void require_points(const delref::PointSet& set) {
  delref_fuzz::require(!set.points.empty() && (set.normals.empty() || set.normals.size() == set.points.size()));
  for (const auto p : set.points) delref_fuzz::require(is_finite(p));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(delref_fuzz::text_of(data, size));
  const auto vertices = [] { return delref::parse_tetgen_node("3 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n", "fuzz.node"); };
  for (const auto kind : {delref::TetgenFile::poly, delref::TetgenFile::smesh}) {
    delref_fuzz::survive([&] { require_whole(delref::parse_tetgen_poly(text, "fuzz.poly", kind, vertices)); });
  }
  delref_fuzz::survive([&] { require_whole(delref::parse_tetgen_node(text, "fuzz.node")); });
  delref_fuzz::survive([&] { require_surface(delref::parse_off(text, "fuzz.off")); });
  delref_fuzz::survive([&] { require_surface(delref::parse_obj(text, "fuzz.obj").plc); });
  delref_fuzz::survive([&] { require_surface(delref::parse_ply(text, "fuzz.ply").plc); });
  delref_fuzz::survive([&] { require_surface(delref::parse_stl(text, "fuzz.stl")); });
  delref_fuzz::survive([&] { require_points(delref::parse_xyz(text, "fuzz.xyz")); });
  delref_fuzz::survive([&] { require_points(delref::parse_ply_points(text, "fuzz.ply")); });
  return 0;
}
