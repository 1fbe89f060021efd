// SPDX-License-Identifier: GPL-3.0-or-later
//
// The finished mesh of a planar triangulation, as plain data in the numbering of the input. A run that was stopped waits for this:
// faces and vertices are passed over once each, in the order of storage.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <delref/domain/planar_domain.hpp>
#include <delref/mesh/planar_mesh.hpp>
#include <delref/triangulation/planar_concept.hpp>

namespace delref {

namespace detail {

/// Takes the mesh out of `tr`: faces and subsegments by the triangulation's vertex numbers first, then the vertices that they use,
/// and then the mesh's own numbers.
template <PlanarTriangulation Tr>
class PlanarExtraction {
 public:
  PlanarExtraction(const Tr& tr, const PlanarDomain& domain) : tr_(tr), domain_(domain) {
    take_faces();
    take_vertices();
    renumber();
  }
  PlanarMesh mesh() && { return std::move(mesh_); }

 private:
  using Index = PlanarMesh::Index;
  static constexpr Index unused = std::numeric_limits<Index>::max(), used = unused - 1;

  void take_faces() {
    const std::size_t about = 2 * tr_.number_of_vertices();
    mesh_.triangles.reserve(about);
    mesh_.regions.reserve(about);
    number_.assign(tr_.number_of_vertices(), unused);
    for (const auto f : tr_.domain_faces()) {
      const auto v = tr_.vertices(f);
      const std::array<std::size_t, 3> i{tr_.index(v[0]), tr_.index(v[1]), tr_.index(v[2])};
      for (const std::size_t k : i) {
        if (k >= number_.size()) number_.resize(2 * k + 1, unused);
        number_[k] = used;
      }
      mesh_.triangles.push_back({static_cast<Index>(i[0]), static_cast<Index>(i[1]), static_cast<Index>(i[2])});
      mesh_.regions.push_back(domain_.regions[static_cast<std::size_t>(tr_.region(f))].label);
    }
    for (const auto e : tr_.subsegments()) {
      const auto s = domain_.segments[tr_.segment(e)].original;
      mesh_.edges.push_back({static_cast<Index>(tr_.index(tr_.source(e))), static_cast<Index>(tr_.index(tr_.target(e)))});
      mesh_.edge_markers.push_back(domain_.pslg.segment_marker(s));
      mesh_.edge_segments.push_back(s);
    }
  }

  /// In the order of the triangulation's numbers, which puts the input first.
  void take_vertices() {
    std::size_t count = 0;
    for (Index& n : number_)
      if (n == used) n = static_cast<Index>(count++);
    mesh_.points.resize(count);
    mesh_.point_markers.resize(count);
    mesh_.carriers.resize(count);
    mesh_.provenance.resize(count);
    for (const auto v : tr_.finite_vertices()) {
      const std::size_t i = tr_.index(v);
      if (i < number_.size() && number_[i] != unused) put_vertex(number_[i], v);
    }
  }
  void put_vertex(Index n, typename Tr::Vertex v) {
    Carrier carrier = tr_.carrier(v);
    const bool on_segment = carrier.dimension == 1;
    if (on_segment) carrier.index = domain_.segments[carrier.index].original;
    mesh_.points[n] = tr_.point(v);
    mesh_.point_markers[n] = carrier.dimension == 0 ? domain_.pslg.point_marker(carrier.index)
                             : on_segment           ? domain_.pslg.segment_marker(carrier.index)
                                                    : 0;
    mesh_.carriers[n] = carrier;
    mesh_.provenance[n] = tr_.provenance(v);
  }

  void renumber() {
    for (auto& triangle : mesh_.triangles)
      for (Index& v : triangle) v = number_[v];
    for (auto& edge : mesh_.edges)
      for (Index& v : edge) v = number_[v];
  }

  const Tr& tr_;
  const PlanarDomain& domain_;
  PlanarMesh mesh_;
  std::vector<Index> number_;  // of each vertex in the mesh, by the triangulation's number
};

}  // namespace detail

/// The part of `tr` in the domain. Carriers name the domain's vertices and the original PSLG segments. Linear time.
template <PlanarTriangulation Tr>
PlanarMesh extract_planar_mesh(const Tr& tr, const PlanarDomain& domain, std::vector<std::string> level_names) {
  PlanarMesh mesh = detail::PlanarExtraction<Tr>(tr, domain).mesh();
  mesh.level_names = std::move(level_names);
  return mesh;
}

}  // namespace delref
