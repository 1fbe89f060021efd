// SPDX-License-Identifier: GPL-3.0-or-later
#include "test_solids.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

namespace delref::testing_mesh_3 {

namespace {

using Index = Plc::Index;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Base = CGAL::Triangulation_vertex_base_with_info_3<Index, Kernel>;
using Delaunay = CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<Base>>;

Kernel::Point_3 exact(Point3 p) { return {p.x, p.y, p.z}; }

Index vertex(Plc& plc, Point3 p) {
  const auto found = std::ranges::find(plc.points, p);
  const auto index = static_cast<Index>(found - plc.points.begin());
  if (found == plc.points.end()) plc.points.push_back(p);
  return index;
}

/// Two of the coordinates, those that an area with that normal does not lose.
Point2 dropped(Point3 p, Vector3 normal) {
  const double x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
  return x >= y && x >= z ? Point2{p.y, p.z} : y >= z ? Point2{p.z, p.x} : Point2{p.x, p.y};
}

bool in_facet(const Plc& plc, const Plc::Facet& facet, const std::array<Point3, 3>& t) {
  const auto at = [&](std::size_t i) { return plc.points[facet.polygons[0][i]]; };
  for (const Point3 p : t)
    if (!CGAL::coplanar(exact(at(0)), exact(at(1)), exact(at(2)), exact(p))) return false;
  const Vector3 normal = cross(at(1) - at(0), at(2) - at(0));
  const Point2 middle = dropped(t[0] + (1.0 / 3) * ((t[1] - t[0]) + (t[2] - t[0])), normal);
  bool inside = false;
  for (const auto& polygon : facet.polygons)
    for (std::size_t i = 0; polygon.size() > 2 && i < polygon.size(); ++i) {
      const Point2 a = dropped(plc.points[polygon[i]], normal),
                   b = dropped(plc.points[polygon[(i + 1) % polygon.size()]], normal);
      if ((a.y > middle.y) != (b.y > middle.y) && middle.x < a.x + (b.x - a.x) * (middle.y - a.y) / (b.y - a.y)) inside = !inside;
    }
  return inside;
}

bool on_segment(Point3 a, Point3 b, Point3 p) { return CGAL::collinear(exact(a), exact(b), exact(p)) && dot(a - p, b - p) <= 0; }

struct Segment {
  Index a, b;
  int marker;
};

std::vector<Segment> segments_of(const Plc& plc) {
  std::map<std::array<Index, 2>, int> found;
  for (std::size_t i = 0; i < plc.segments.size(); ++i)
    found.insert({{std::min(plc.segments[i][0], plc.segments[i][1]), std::max(plc.segments[i][0], plc.segments[i][1])},
                  plc.segment_marker(i)});
  for (const Plc::Facet& facet : plc.facets)
    for (const auto& polygon : facet.polygons)
      for (std::size_t i = 0; i < polygon.size() && polygon.size() > 1; ++i) {
        const Index v = polygon[i], w = polygon[(i + 1) % polygon.size()];
        found.insert({{std::min(v, w), std::max(v, w)}, 0});
      }
  std::vector<Segment> segments;
  for (const auto& [ends, marker] : found) segments.push_back({ends[0], ends[1], marker});
  return segments;
}

}  // namespace

TetrahedralMesh meshed(const Plc& input, const std::vector<Point3>& steiner_points, const std::function<int(Point3)>& label) {
  TetrahedralMesh mesh;
  mesh.points = input.points;
  mesh.points.insert(mesh.points.end(), steiner_points.begin(), steiner_points.end());
  Delaunay delaunay;
  for (Index v = 0; v < mesh.points.size(); ++v) delaunay.insert(exact(mesh.points[v]))->info() = v;
  std::vector<bool> used(mesh.points.size(), false);
  for (const auto c : delaunay.finite_cell_handles()) {
    const std::array<Index, 4> t{c->vertex(0)->info(), c->vertex(1)->info(), c->vertex(2)->info(), c->vertex(3)->info()};
    Vector3 sum;
    for (const Index v : t) sum = sum + 0.25 * (mesh.points[v] - Point3{});
    const int its = label(Point3{} + sum);
    if (its == outside) continue;
    mesh.tetrahedra.push_back(t);
    mesh.regions.push_back(its);
    for (const Index v : t) used[v] = true;
  }
  mesh.carriers.assign(mesh.points.size(), {3, Carrier::none});
  mesh.point_markers.assign(mesh.points.size(), 0);
  mesh.provenance.assign(mesh.points.size(), 0);
  mesh.level_names = {"test"};
  const auto carry = [&](Index v, std::uint8_t dimension, Index element, int marker) {
    if (mesh.carriers[v].dimension <= dimension) return;
    mesh.carriers[v] = {dimension, element};
    mesh.point_markers[v] = marker;
  };
  for (Index v = 0; v < input.points.size(); ++v) {
    carry(v, 0, v, input.point_marker(v));
    mesh.provenance[v] = input_level;
  }
  for (const auto& e : delaunay.finite_edges()) {
    const Index v = e.first->vertex(e.second)->info(), w = e.first->vertex(e.third)->info();
    if (!used[v] || !used[w]) continue;
    Index number = 0;
    for (const Segment& s : segments_of(input)) {
      const Point3 a = input.points[s.a], b = input.points[s.b];
      if (on_segment(a, b, mesh.points[v]) && on_segment(a, b, mesh.points[w])) {
        mesh.edges.push_back({v, w});
        mesh.edge_markers.push_back(s.marker);
        mesh.edge_segments.push_back(number);
        carry(v, 1, number, s.marker), carry(w, 1, number, s.marker);
      }
      ++number;
    }
  }
  for (const auto& face : delaunay.finite_facets()) {
    std::array<Index, 3> t{};
    for (int i = 0; i < 3; ++i) t[static_cast<std::size_t>(i)] = face.first->vertex((face.second + 1 + i) % 4)->info();
    if (std::ranges::any_of(t, [&](Index v) { return !used[v]; })) continue;
    for (Index f = 0; f < input.facets.size(); ++f)
      if (in_facet(input, input.facets[f], {mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]})) {
        mesh.triangles.push_back(t);
        mesh.triangle_markers.push_back(input.facets[f].marker);
        mesh.triangle_facets.push_back(f);
        for (const Index v : t) carry(v, 2, f, input.facets[f].marker);
      }
  }
  return mesh;
}

void add_facet(Plc& plc, const std::vector<Point3>& polygon, int marker) {
  Plc::Facet facet;
  facet.polygons.emplace_back();
  for (const Point3 p : polygon) facet.polygons[0].push_back(vertex(plc, p));
  facet.marker = marker;
  plc.facets.push_back(facet);
}

void add_box(Plc& plc, Point3 low, Point3 high, int first_marker, const std::string& without) {
  const auto at = [&](int x, int y, int z) { return Point3{x ? high.x : low.x, y ? high.y : low.y, z ? high.z : low.z}; };
  const auto add = [&](char name, const std::vector<Point3>& polygon) {
    if (without.find(name) == std::string::npos) add_facet(plc, polygon, first_marker);
    ++first_marker;
  };
  add('x', {at(0, 0, 0), at(0, 1, 0), at(0, 1, 1), at(0, 0, 1)});
  add('X', {at(1, 0, 0), at(1, 1, 0), at(1, 1, 1), at(1, 0, 1)});
  add('y', {at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1)});
  add('Y', {at(0, 1, 0), at(1, 1, 0), at(1, 1, 1), at(0, 1, 1)});
  add('z', {at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 1, 0)});
  add('Z', {at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)});
}

Plc three_rooms() {
  Plc plc;
  add_box(plc, {0, 0, 0}, {1, 1, 1}, 1);
  add_box(plc, {1, 0, 0}, {3, 1, 1}, 11, "x");
  add_box(plc, {3, 0, 0}, {4, 1, 1}, 21, "x");
  add_facet(plc, {{1.75, 0.25, 0.5}, {2.25, 0.25, 0.5}, {2.25, 0.75, 0.5}, {1.75, 0.75, 0.5}}, 31);
  plc.points.push_back({0.5, 0.4375, 0.5625});
  plc.segments = {{vertex(plc, {0, 0, 0}), vertex(plc, {1, 0, 0})}};
  plc.segment_markers = {50};
  plc.point_markers.assign(plc.points.size(), 0);
  plc.point_markers[0] = 7;
  plc.holes = {{3.4, 0.6, 0.7}};
  plc.regions = {{{0.3, 0.2, 0.1}, 1, 0.5}, {{1.2, 0.3, 0.4}, 2, 0}};
  return plc;
}

int label_in_three_rooms(Point3 p) { return p.x < 1 ? 1 : p.x < 3 ? 2 : outside; }

TetrahedralMesh three_rooms_mesh() {
  std::vector<Point3> steiner;
  for (const double x : {1.0, 3.0})
    for (const Point2 p : {Point2{0.5, 0}, {0.5, 1}, {0, 0.5}, {1, 0.5}, {0.5, 0.5}}) steiner.push_back({x, p.x, p.y});
  steiner.insert(steiner.end(), {{0.25, 0, 0}, {0.5, 0, 0}, {0.4375, 0.5625, 0}, {2, 0.5, 0.1875}, {0.3125, 0.6875, 0.25}});
  return meshed(three_rooms(), steiner, label_in_three_rooms);
}

std::vector<std::string> failed(const VerifyReport& report) {
  std::vector<std::string> names;
  for (const Finding& f : report.findings)
    if (f.status == CheckStatus::failed) names.push_back(f.name);
  return names;
}

}  // namespace delref::testing_mesh_3
