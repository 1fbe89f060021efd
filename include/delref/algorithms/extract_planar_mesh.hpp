// SPDX-License-Identifier: GPL-3.0-or-later
//
// The finished mesh of a planar triangulation, as plain data in the numbering of the input.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <delref/domain/planar_domain.hpp>
#include <delref/mesh/planar_mesh.hpp>
#include <delref/triangulation/planar_concept.hpp>

namespace delref {

/// The part of `tr` in the domain. Carriers name the domain's vertices and the original PSLG segments. Linear time.
template <PlanarTriangulation Tr>
PlanarMesh extract_planar_mesh(const Tr& tr, const PlanarDomain& domain, std::vector<std::string> level_names) {
  PlanarMesh mesh;
  mesh.level_names = std::move(level_names);

  std::vector<std::optional<typename Tr::Vertex>> used;  // by vertex number, which puts the input first
  std::size_t faces = 0;
  for (const auto f : tr.domain_faces()) {
    ++faces;
    for (const auto v : tr.vertices(f)) {
      const std::size_t i = tr.index(v);
      if (i >= used.size()) used.resize(std::max(i + 1, 2 * used.size()));
      used[i] = v;
    }
  }
  std::vector<PlanarMesh::Index> number(used.size());
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (!used[i]) continue;
    number[i] = static_cast<PlanarMesh::Index>(mesh.points.size());
    Carrier carrier = tr.carrier(*used[i]);
    const bool on_segment = carrier.dimension == 1;
    if (on_segment) carrier.index = domain.segments[carrier.index].original;
    mesh.points.push_back(tr.point(*used[i]));
    mesh.point_markers.push_back(carrier.dimension == 0 ? domain.pslg.point_marker(carrier.index)
                                 : on_segment          ? domain.pslg.segment_marker(carrier.index)
                                                       : 0);
    mesh.carriers.push_back(carrier);
    mesh.provenance.push_back(tr.provenance(*used[i]));
  }
  used = {};
  mesh.triangles.reserve(faces);
  mesh.regions.reserve(faces);
  for (const auto f : tr.domain_faces()) {
    const auto v = tr.vertices(f);
    mesh.triangles.push_back({number[tr.index(v[0])], number[tr.index(v[1])], number[tr.index(v[2])]});
    mesh.regions.push_back(domain.regions[static_cast<std::size_t>(tr.region(f))].label);
  }
  for (const auto e : tr.subsegments()) {
    const auto s = domain.segments[tr.segment(e)].original;
    mesh.edges.push_back({number[tr.index(tr.source(e))], number[tr.index(tr.target(e))]});
    mesh.edge_markers.push_back(domain.pslg.segment_marker(s));
    mesh.edge_segments.push_back(s);
  }
  return mesh;
}

}  // namespace delref
