// SPDX-License-Identifier: GPL-3.0-or-later
//
// The finished mesh of a smooth domain, as plain data: tetrahedra with the label of their region, and the triangles between regions.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <delref/levels/surface_complex.hpp>
#include <delref/mesh/tetrahedral_mesh.hpp>
#include <delref/triangulation/spatial_concept.hpp>

namespace delref {

/// The part of a surface between two regions. -1 is the outside.
struct SurfacePatch {
  std::array<int, 2> regions{};  ///< their numbers, the greater first
  friend auto operator<=>(const SurfacePatch&, const SurfacePatch&) = default;
};

/// The pairs of regions that have a common surface, in order.
template <SpatialTriangulation Tr>
std::vector<SurfacePatch> surface_patches(const SurfaceComplex<Tr>& complex) {
  std::vector<SurfacePatch> patches;
  complex.for_each([&](const auto& r) {
    if (patches.empty() || patches.back().regions != r.regions) patches.push_back({r.regions});
    if (patches.size() < 4096) return;
    std::ranges::sort(patches);
    patches.erase(std::ranges::unique(patches).begin(), patches.end());
  });
  std::ranges::sort(patches);
  patches.erase(std::ranges::unique(patches).begin(), patches.end());
  return patches;
}

/// The mesh: triangles see the greater region, which the surface bounds, behind them, and have the marker 1 + the number of their patch.
/// `region_labels[r]` is the label of region r. Linear time.
template <SpatialTriangulation Tr>
TetrahedralMesh extract_smooth_mesh(const Tr& tr, const SurfaceComplex<Tr>& complex, const std::vector<SurfacePatch>& patches,
                                    const std::vector<int>& region_labels, bool surface_only, std::vector<std::string> level_names) {
  constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();
  TetrahedralMesh mesh;
  mesh.level_names = std::move(level_names);
  std::vector<typename Tr::Vertex> vertices;  // by number
  std::vector<std::uint32_t> number;
  const auto use = [&](typename Tr::Vertex v) {
    const std::size_t i = tr.index(v);
    if (i >= number.size()) number.resize(i + i / 2 + 1, unused), vertices.resize(number.size());
    number[i] = 0;
    vertices[i] = v;
  };
  std::size_t cells = 0;
  if (!surface_only)
    for (const auto c : tr.domain_cells()) {
      ++cells;
      for (const auto v : tr.vertices(c)) use(v);
    }
  complex.for_each([&](const auto& r) {
    for (const auto v : tr.vertices(r.facet)) use(v);
  });
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (number[i] == unused) continue;
    number[i] = static_cast<std::uint32_t>(mesh.points.size());
    mesh.points.push_back(tr.point(vertices[i]));
    mesh.carriers.push_back(tr.carrier(vertices[i]));
    mesh.provenance.push_back(tr.provenance(vertices[i]));
  }
  mesh.point_markers.assign(mesh.points.size(), 0);
  const auto at = [&](typename Tr::Vertex v) { return number[tr.index(v)]; };

  mesh.tetrahedra.reserve(cells);
  mesh.regions.reserve(cells);
  if (!surface_only)
    for (const auto c : tr.domain_cells()) {
      const auto v = tr.vertices(c);
      mesh.tetrahedra.push_back({at(v[0]), at(v[1]), at(v[2]), at(v[3])});
      mesh.regions.push_back(region_labels[static_cast<std::size_t>(tr.region(c))]);
    }
  complex.for_each([&](const auto& r) {
    const bool is_seen_from_inside = tr.region(tr.cell(r.facet)) == r.regions[0];
    auto v = tr.vertices(r.facet);
    if (is_seen_from_inside) std::swap(v[1], v[2]);
    mesh.triangles.push_back({at(v[0]), at(v[1]), at(v[2])});
    const auto patch = static_cast<std::uint32_t>(std::ranges::lower_bound(patches, SurfacePatch{r.regions}) - patches.begin());
    mesh.triangle_facets.push_back(patch);
    mesh.triangle_markers.push_back(static_cast<int>(patch) + 1);
    for (const auto i : mesh.triangles.back()) {
      int& marker = mesh.point_markers[i];
      marker = marker == 0 ? mesh.triangle_markers.back() : std::min(marker, mesh.triangle_markers.back());
    }
  });
  return mesh;
}

}  // namespace delref
