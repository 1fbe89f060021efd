// SPDX-License-Identifier: GPL-3.0-or-later
//
// The finished mesh of a triangulation of space, as plain data in the numbering of the input.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <delref/domain/label_polyhedral_domain.hpp>
#include <delref/domain/polyhedral_domain.hpp>
#include <delref/mesh/tetrahedral_mesh.hpp>
#include <delref/triangulation/spatial_concept.hpp>

namespace delref {

/// The part of `tr` in the domain, with the subfacets and subsegments that the levels know. Linear time.
template <SpatialTriangulation Tr, class Subsegments, class Complex>
TetrahedralMesh extract_tetrahedral_mesh(const Tr& tr, const PolyhedralDomain& domain, const PolyhedralRegions& regions,
                                         const Subsegments& subsegments, const Complex& complex, std::vector<std::string> level_names) {
  constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();
  TetrahedralMesh mesh;
  mesh.level_names = std::move(level_names);

  std::vector<typename Tr::Vertex> vertices;  // by number, which puts the input first
  std::vector<std::uint32_t> number;
  std::size_t cells = 0;
  const auto use = [&](typename Tr::Vertex v) {
    const std::size_t i = tr.index(v);
    if (i >= number.size()) number.resize(i + i / 2 + 1, unused), vertices.resize(number.size());
    number[i] = 0;
    vertices[i] = v;
  };
  for (const auto c : tr.domain_cells()) {
    ++cells;
    for (const auto v : tr.vertices(c)) use(v);
  }
  complex.for_each([&](auto id) {
    if (complex[id].is_present)
      for (const auto v : complex[id].corners) use(v);
  });
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (number[i] == unused) continue;
    const Carrier carrier = tr.carrier(vertices[i]);
    number[i] = static_cast<std::uint32_t>(mesh.points.size());
    mesh.points.push_back(tr.point(vertices[i]));
    mesh.carriers.push_back(carrier);
    mesh.provenance.push_back(tr.provenance(vertices[i]));
    mesh.point_markers.push_back(carrier.dimension == 0   ? domain.point_markers[carrier.index]
                                 : carrier.dimension == 1 ? domain.segments[carrier.index].marker
                                 : carrier.dimension == 2 ? domain.facets[carrier.index].marker
                                                          : 0);
  }
  const auto at = [&](typename Tr::Vertex v) { return number[tr.index(v)]; };

  mesh.tetrahedra.reserve(cells);
  mesh.regions.reserve(cells);
  for (const auto c : tr.domain_cells()) {
    const auto v = tr.vertices(c);
    mesh.tetrahedra.push_back({at(v[0]), at(v[1]), at(v[2]), at(v[3])});
    mesh.regions.push_back(regions.regions[static_cast<std::size_t>(tr.region(c))].label);
  }
  complex.for_each([&](auto id) {
    const auto& s = complex[id];
    if (!s.is_present) return;
    mesh.triangles.push_back({at(s.corners[0]), at(s.corners[1]), at(s.corners[2])});
    mesh.triangle_markers.push_back(domain.facets[s.facet].marker);
    mesh.triangle_facets.push_back(domain.facets[s.facet].original);
  });
  subsegments.for_each([&](auto id) {
    const auto& s = subsegments[id];
    const std::size_t a = tr.index(s.ends[0]), b = tr.index(s.ends[1]);
    if (a >= number.size() || b >= number.size() || number[a] == unused || number[b] == unused) return;
    mesh.edges.push_back({number[a], number[b]});
    mesh.edge_markers.push_back(domain.segments[s.segment].marker);
    mesh.edge_segments.push_back(s.segment);
  });
  return mesh;
}

}  // namespace delref
