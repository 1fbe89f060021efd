// SPDX-License-Identifier: GPL-3.0-or-later
//
// The checks that need nothing but the mesh: indices, orientation, how tetrahedra meet, the Delaunay property.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <fmt/format.h>

#include <delref/mesh/verify/report.hpp>
#include <delref/mesh/verify_3/subject.hpp>
#include <delref/mesh/verify_3/topology.hpp>

namespace delref::verification_3 {

/// Whether the input can be worked with at all: valid indices, finite coordinates.
inline void check_input(const Subject& s, Finding& finding) {
  const Plc& input = s.input;
  finding.examined = input.points.size() + input.segments.size() + input.facets.size();
  for (std::size_t i = 0; i < input.points.size(); ++i)
    if (!is_finite(input.points[i])) finding.fail([&] { return fmt::format("input vertex {} is not finite", s.number(i)); });
  const auto valid = [&](const auto& element, std::string_view what, std::size_t i) {
    for (const Index v : element)
      if (v >= input.points.size())
        finding.fail([&] { return fmt::format("{} {} has vertex {}, which does not exist", what, s.number(i), s.number(v)); });
  };
  for (std::size_t i = 0; i < input.segments.size(); ++i) valid(input.segments[i], "segment", i);
  for (std::size_t f = 0; f < input.facets.size(); ++f) {
    s.breathe(f);
    for (const auto& polygon : input.facets[f].polygons) valid(polygon, "facet", f);
    for (const Point3 hole : input.facets[f].holes)
      if (!is_finite(hole)) finding.fail([&] { return fmt::format("a hole seed of {} is not finite", s.facet(f)); });
  }
  for (const Point3 hole : input.holes)
    if (!is_finite(hole)) finding.fail([] { return std::string("a hole seed is not finite"); });
  for (const Plc::Region& region : input.regions)
    if (!is_finite(region.seed)) finding.fail([] { return std::string("a region seed is not finite"); });
}

/// Lengths of the parallel vectors, indices of vertices, coordinates.
inline void check_arrays(const Subject& s, Finding& finding) {
  const TetrahedralMesh& mesh = s.mesh;
  finding.examined = mesh.tetrahedra.size() + mesh.triangles.size() + mesh.edges.size() + mesh.points.size();
  const auto parallel = [&](std::string_view what, std::size_t size, std::size_t expected) {
    if (size != 0 && size != expected)
      finding.fail([&] { return fmt::format("{}: {} given for {} elements", what, size, expected); });
  };
  parallel("vertex markers", mesh.point_markers.size(), mesh.points.size());
  parallel("carriers", mesh.carriers.size(), mesh.points.size());
  parallel("provenance", mesh.provenance.size(), mesh.points.size());
  parallel("region labels", mesh.regions.size(), mesh.tetrahedra.size());
  parallel("triangle markers", mesh.triangle_markers.size(), mesh.triangles.size());
  parallel("facets of triangles", mesh.triangle_facets.size(), mesh.triangles.size());
  parallel("edge markers", mesh.edge_markers.size(), mesh.edges.size());
  parallel("segments of edges", mesh.edge_segments.size(), mesh.edges.size());
  for (Index v = 0; v < mesh.points.size(); ++v)
    if (!is_finite(mesh.points[v])) finding.fail([&] { return s.vertex(v) + " is not finite"; });
  const auto valid = [&](const auto& element, std::string_view what, std::size_t i) {
    s.breathe(i);
    for (std::size_t k = 0; k < element.size(); ++k) {
      const bool exists = element[k] < mesh.points.size();
      if (exists && std::count(element.begin(), element.end(), element[k]) == 1) continue;
      finding.fail([&] {
        return fmt::format("{} {} has vertex {}, which {}", what, s.number(i), s.number(element[k]),
                           exists ? "it has more than once" : "does not exist");
      });
      break;
    }
  };
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) valid(mesh.tetrahedra[t], "tetrahedron", t);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) valid(mesh.triangles[t], "triangle", t);
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) valid(mesh.edges[e], "edge", e);
}

/// The same, and that there are tetrahedra, and facets of the input where triangles name them.
inline void check_indices(const Subject& s, Finding& finding) {
  if (s.mesh.tetrahedra.empty()) finding.fail([] { return std::string("the mesh has no tetrahedra"); });
  check_arrays(s, finding);
  for (const Index f : s.mesh.triangle_facets)
    if (f >= s.input.facets.size())
      finding.fail([&] { return fmt::format("a triangle names facet {}, which does not exist", s.number(f)); });
}

inline void check_orientation(const Subject& s, Finding& finding) {
  finding.examined = s.mesh.tetrahedra.size();
  for (std::size_t t = 0; t < s.mesh.tetrahedra.size(); ++t) {
    s.breathe(t);
    const auto& [a, b, c, d] = s.mesh.tetrahedra[t];
    const auto sign = s.orientation(a, b, c, d);
    if (sign != CGAL::POSITIVE)
      finding.fail([&] { return s.tetrahedron(t) + (sign == CGAL::ZERO ? " is flat" : " is inverted"); });
  }
}

/// Two positively oriented tetrahedra with a common face lie on opposite sides of it exactly when they see it turned differently.
inline void check_faces(const Subject& s, const MeshTopology& topology, Finding& finding) {
  finding.examined = topology.faces().size();
  for (const MeshTopology::Face& f : topology.faces())
    if (f.crowded) finding.fail([&] { return s.triangle(f.corners()) + " has two tetrahedra on one side"; });
}

/// No corner lies strictly inside the circumsphere of the tetrahedron on the other side of its face, facets included.
inline void check_delaunay(const Subject& s, const MeshTopology& topology, Finding& finding) {
  for (std::size_t i = 0; i < topology.faces().size(); ++i) {
    s.breathe(i);
    const MeshTopology::Face& f = topology.faces()[i];
    if (f.positive == none || f.negative == none) continue;
    ++finding.examined;
    const Index apex = topology.apex(f.negative);
    const auto side = CGAL::side_of_oriented_sphere(exact(s.points[f.a]), exact(s.points[f.b]), exact(s.points[f.c]),
                                                    exact(s.points[topology.apex(f.positive)]), exact(s.points[apex]));
    if (side == CGAL::ON_POSITIVE_SIDE)
      finding.fail(
          [&] { return fmt::format("{} lies inside the circumsphere of {}", s.vertex(apex), s.tetrahedron(f.positive / 4)); });
  }
}

}  // namespace delref::verification_3
