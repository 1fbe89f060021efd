// SPDX-License-Identifier: GPL-3.0-or-later
//
// The checks that need nothing but the mesh: indices, orientation, edges, and the triangles around each vertex.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <fmt/format.h>

#include <delref/mesh/verify/input_domain.hpp>
#include <delref/mesh/verify/report.hpp>
#include <delref/mesh/verify/subject.hpp>
#include <delref/mesh/verify/topology.hpp>

namespace delref::verification {

/// Whether the input can be worked with at all: valid indices, finite coordinates.
inline void check_input(const Subject& s, Finding& finding) {
  finding.examined = s.input.points.size() + s.input.segments.size();
  for (std::size_t i = 0; i < s.input.points.size(); ++i)
    if (!is_finite(s.input.points[i])) finding.fail([&] { return fmt::format("input vertex {} is not finite", s.number(i)); });
  for (std::size_t i = 0; i < s.input.segments.size(); ++i)
    for (const Index v : s.input.segments[i])
      if (v >= s.input.points.size())
        finding.fail([&] { return fmt::format("segment {} ends at vertex {}, which does not exist", s.number(i), s.number(v)); });
  const auto names = [&](const char* what, std::size_t given, std::size_t needed) {
    if (given != 0 && given != needed) finding.fail([&] { return fmt::format("{} names of {} for {}", given, what, needed); });
  };
  names("points", s.criteria.point_names.size(), s.input.points.size());
  names("segments", s.criteria.segment_names.size(), s.input.segments.size());
  for (const Point2 hole : s.input.holes)
    if (!is_finite(hole)) finding.fail([] { return std::string("a hole seed is not finite"); });
  for (const Pslg::Region& region : s.input.regions)
    if (!is_finite(region.seed)) finding.fail([] { return std::string("a region seed is not finite"); });
}

/// Lengths of the parallel vectors, indices, coordinates.
inline void check_indices(const Subject& s, Finding& finding) {
  const PlanarMesh& mesh = s.mesh;
  finding.examined = mesh.triangles.size() + mesh.points.size() + mesh.edges.size();
  if (mesh.triangles.empty()) finding.fail([] { return std::string("the mesh has no triangles"); });
  const auto parallel = [&](std::string_view what, std::size_t size, std::size_t expected) {
    if (size != 0 && size != expected) finding.fail([&] { return fmt::format("{}: {} given for {} elements", what, size, expected); });
  };
  parallel("vertex markers", mesh.point_markers.size(), mesh.points.size());
  parallel("carriers", mesh.carriers.size(), mesh.points.size());
  parallel("provenance", mesh.provenance.size(), mesh.points.size());
  parallel("region labels", mesh.regions.size(), mesh.triangles.size());
  parallel("edge markers", mesh.edge_markers.size(), mesh.edges.size());
  parallel("segments of edges", mesh.edge_segments.size(), mesh.edges.size());
  for (Index v = 0; v < mesh.points.size(); ++v)
    if (!is_finite(mesh.points[v])) finding.fail([&] { return s.vertex(v) + " is not finite"; });
  const auto valid = [&](const auto& element, std::string_view what, std::size_t i) {
    for (const Index v : element)
      if (v >= mesh.points.size())
        finding.fail([&] { return fmt::format("{} {} has vertex {}, which does not exist", what, s.number(i), s.number(v)); });
  };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) valid(mesh.triangles[t], "triangle", t);
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) valid(mesh.edges[e], "subsegment", e);
}

inline void check_orientation(const Subject& s, Finding& finding) {
  finding.examined = s.mesh.triangles.size();
  for (std::size_t t = 0; t < s.mesh.triangles.size(); ++t) {
    s.breathe(t);
    const auto& [a, b, c] = s.mesh.triangles[t];
    const auto turn = CGAL::orientation(exact(s.points[a]), exact(s.points[b]), exact(s.points[c]));
    if (turn != CGAL::LEFT_TURN) finding.fail([&] { return s.triangle(t) + (turn == CGAL::RIGHT_TURN ? " is clockwise" : " is flat"); });
  }
}

inline void check_edges(const Subject& s, const MeshTopology& topology, Finding& finding) {
  finding.examined = topology.edges().size();
  for (const MeshTopology::Edge& e : topology.edges())
    if (e.crowded) finding.fail([&] { return s.edge(e.a, e.b) + " has two triangles on one side"; });
}

/// The triangles at a vertex are one closed ring, or open fans: walked from triangle to triangle over shared edges, all of them
/// are met. Requires that `check_edges` passed.
inline void check_stars(const Subject& s, const MeshTopology& topology, Finding& finding) {
  const std::size_t vertices = s.points.size();
  std::vector<Index> triangles(vertices, 0), met(vertices, 0), some_edge(vertices, none);
  const auto half_edges = static_cast<Index>(3 * s.mesh.triangles.size());
  const auto walk = [&](Index first) {
    const Index v = topology.origin(first);
    Index h = first;
    do {
      ++met[v];
      h = topology.twin(MeshTopology::previous(h));
    } while (h != none && h != first);
  };
  for (Index h = 0; h < half_edges; ++h) {
    s.breathe(h);
    const Index v = topology.origin(h);
    ++triangles[v];
    some_edge[v] = h;
    if (topology.twin(h) == none) walk(h);
  }
  for (Index v = 0; v < vertices; ++v) {
    if (triangles[v] == 0) continue;
    ++finding.examined;
    if (met[v] == 0) walk(some_edge[v]);
    if (met[v] != triangles[v]) finding.fail([&] { return s.vertex(v) + " has a closed ring of triangles and others besides"; });
  }
}

}  // namespace delref::verification
