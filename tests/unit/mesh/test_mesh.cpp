// SPDX-License-Identifier: GPL-3.0-or-later
#include "test_mesh.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

namespace delref::testing_mesh {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Index = PlanarMesh::Index;
struct FaceLabel {
  bool visited = false, inside = true;
  int label = 0;
};
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>;
using FaceBase = CGAL::Triangulation_face_base_with_info_2<FaceLabel, Kernel, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
                                                       CGAL::No_constraint_intersection_requiring_constructions_tag>;

Kernel::Point_2 cgal(Point2 p) { return {p.x, p.y}; }

template <class Mark>
void flood(Cdt& cdt, Cdt::Face_handle start, Mark mark) {
  for (const auto f : cdt.all_face_handles()) f->info().visited = false;
  std::vector<Cdt::Face_handle> stack{start};
  while (!stack.empty()) {
    const auto f = stack.back();
    stack.pop_back();
    if (f->info().visited) continue;
    f->info().visited = true;
    mark(f->info());
    for (int i = 0; i < 3; ++i)
      if (!f->is_constrained(i)) stack.push_back(f->neighbor(i));
  }
}

/// The first segment that two points lie on.
Index segment_of(const Pslg& input, Point2 a, Point2 b) {
  for (Index s = 0; s < input.segments.size(); ++s) {
    const auto p = cgal(input.points[input.segments[s][0]]), q = cgal(input.points[input.segments[s][1]]);
    const auto on = [&](Point2 r) { return p != q && CGAL::collinear(p, cgal(r), q) && CGAL::collinear_are_ordered_along_line(p, cgal(r), q); };
    if (on(a) && on(b)) return s;
  }
  return Carrier::none;
}

}  // namespace

PlanarMesh triangulated(const Pslg& input, const std::vector<Point2>& steiner_points) {
  Cdt cdt;
  std::vector<Cdt::Vertex_handle> handles;
  std::vector<Point2> points = input.points;
  points.insert(points.end(), steiner_points.begin(), steiner_points.end());
  for (Index i = 0; i < points.size(); ++i) {
    const std::size_t before = cdt.number_of_vertices();
    handles.push_back(cdt.insert(cgal(points[i])));
    if (cdt.number_of_vertices() > before) handles.back()->info() = i;
  }
  for (const auto& [a, b] : input.segments)
    if (handles[a] != handles[b]) cdt.insert_constraint(handles[a], handles[b]);
  const auto outside = [](FaceLabel& f) { f.inside = false; };
  flood(cdt, cdt.infinite_face(), outside);
  for (const Point2 hole : input.holes) flood(cdt, cdt.locate(cgal(hole)), outside);
  for (const Pslg::Region& r : input.regions) flood(cdt, cdt.locate(cgal(r.seed)), [&](FaceLabel& f) { f.label = r.label; });

  std::vector<Index> number(points.size(), Carrier::none);
  for (const auto f : cdt.finite_face_handles())
    for (int i = 0; i < 3 && f->info().inside; ++i) number[f->vertex(i)->info()] = 0;
  PlanarMesh mesh;
  mesh.level_names = {"edges", "faces"};
  for (Index i = 0; i < points.size(); ++i) {
    if (number[i] == Carrier::none) continue;
    number[i] = static_cast<Index>(mesh.points.size());
    mesh.points.push_back(points[i]);
    const bool is_input = i < input.points.size();
    const Index segment = is_input ? Carrier::none : segment_of(input, points[i], points[i]);
    const bool on_segment = segment != Carrier::none;
    mesh.point_markers.push_back(is_input ? input.point_marker(i) : on_segment ? input.segment_marker(segment) : 0);
    mesh.carriers.push_back(is_input ? Carrier{0, i} : on_segment ? Carrier{1, segment} : Carrier{2, Carrier::none});
    mesh.provenance.push_back(is_input ? input_level : on_segment ? LevelIndex{0} : LevelIndex{1});
  }
  for (const auto f : cdt.finite_face_handles()) {
    if (!f->info().inside) continue;
    mesh.triangles.push_back({number[f->vertex(0)->info()], number[f->vertex(1)->info()], number[f->vertex(2)->info()]});
    mesh.regions.push_back(f->info().label);
  }
  for (const auto& [f, i] : cdt.constrained_edges()) {
    if (!f->info().inside && !f->neighbor(i)->info().inside) continue;
    const Index a = f->vertex(Cdt::ccw(i))->info(), b = f->vertex(Cdt::cw(i))->info();
    const Index segment = segment_of(input, points[a], points[b]);
    mesh.edges.push_back({number[a], number[b]});
    mesh.edge_segments.push_back(segment);
    mesh.edge_markers.push_back(input.segment_marker(segment));
  }
  return mesh;
}

Pslg two_rooms() {
  Pslg p;
  p.points = {{0, 0}, {2, 0}, {4, 0}, {4, 4}, {2, 4}, {0, 4}, {2.5, 1}, {3.5, 1}, {3.5, 2}, {2.5, 2}, {0.75, 2.875}, {2, 2.5}};
  p.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 0}, {1, 11}, {11, 4}, {6, 7}, {7, 8}, {8, 9}, {9, 6}, {11, 10}};
  p.segment_markers = {1, 1, 2, 3, 3, 4, 5, 5, 9, 9, 9, 9, 6};
  p.point_markers = {1, 1, 2, 3, 3, 4, 9, 9, 9, 9, 0, 7};
  p.holes = {{3, 1.5}};
  p.regions = {{{1, 1}, 1, 1.0}, {{3, 3}, 2, 0}};
  p.first_index = 1;
  return p;
}

PlanarMesh two_rooms_mesh() {
  return triangulated(two_rooms(), {{0.8125, 0},      {2.875, 0},     {4, 1.6875},      {4, 3.0625},       {3.1875, 4},     {1.125, 4},
                                    {0, 2.9375},      {0, 1.1875},    {2, 1.1875},      {2, 3.3125},       {0.71875, 0.8125}, {1.34375, 1.53125},
                                    {1.28125, 0.65625}, {0.6875, 1.90625}, {0.59375, 3.40625}, {1.40625, 3.28125}, {1.46875, 2.21875}, {2.78125, 3.15625},
                                    {3.28125, 2.59375}, {3.0, 0.53125}});
}

std::vector<std::string> failed(const VerifyReport& report) {
  std::vector<std::string> names;
  for (const Finding& f : report.findings)
    if (f.status == CheckStatus::failed) names.push_back(f.name);
  return names;
}

}  // namespace delref::testing_mesh
