// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random additions to a mesh, by seed: vertices at, beside and between its vertices, segments along its edges and across its
// triangles, seeds of regions and holes.
#pragma once

#include <cstddef>

#include <delref/domain/pslg.hpp>
#include <delref/mesh/planar_mesh.hpp>

#include "generators.hpp"

namespace delref::property {

inline std::size_t any_of(Random& random, std::size_t count) { return static_cast<std::size_t>(random.next() % count); }

inline Point2 barycentre(const PlanarMesh& mesh, std::size_t t) {
  const auto& [a, b, c] = mesh.triangles[t];
  return mesh.points[a] + (1.0 / 3) * ((mesh.points[b] - mesh.points[a]) + (mesh.points[c] - mesh.points[a]));
}

inline void add_segment(Pslg& extra, Point2 a, Point2 b, int marker) {
  const auto first = static_cast<Pslg::Index>(extra.points.size());
  extra.points.push_back(a);
  extra.points.push_back(b);
  extra.segments.push_back({first, first + 1});
  extra.segment_markers.push_back(marker);
}

/// Some of everything. Whether its segments cross what is there is left to chance for those across triangles alone.
inline Pslg addition(const PlanarMesh& mesh, std::uint64_t seed) {
  Random random(seed);
  Pslg extra;
  const auto point = [&](std::size_t i) { return mesh.points[i]; };
  for (int k = random.integer(0, 3); k > 0; --k) {
    const auto& t = mesh.triangles[any_of(random, mesh.triangles.size())];
    const auto i = any_of(random, 3);
    add_segment(extra, point(t[i]), point(t[(i + 1) % 3]), 100 + k);
  }
  if (random.chance(0.3)) {  // across an edge, which may be a subsegment
    const std::size_t t = any_of(random, mesh.triangles.size());
    add_segment(extra, barycentre(mesh, t), point(any_of(random, mesh.points.size())), 200);
  }
  for (int k = random.integer(0, 3); k > 0; --k) {
    const auto& [a, b] = mesh.edges[any_of(random, mesh.edges.size())];
    extra.points.push_back(point(a) + random.uniform(0.1, 0.9) * (point(b) - point(a)));
  }
  for (int k = random.integer(0, 3); k > 0; --k) extra.points.push_back(barycentre(mesh, any_of(random, mesh.triangles.size())));
  if (random.chance(0.3)) extra.points.push_back(point(any_of(random, mesh.points.size())));
  if (random.chance(0.2)) extra.regions.push_back({barycentre(mesh, any_of(random, mesh.triangles.size())), 77, 0});
  if (random.chance(0.1)) extra.holes.push_back(barycentre(mesh, any_of(random, mesh.triangles.size())));
  return extra;
}

}  // namespace delref::property
