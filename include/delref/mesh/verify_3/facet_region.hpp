// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part of a plane that the segments of a facet enclose, less what its hole seeds take away, by CGAL's constrained Delaunay
// triangulation of the projected segments. Needed for facets that are more than one simple polygon.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <delref/mesh/verify_3/input_complex.hpp>
#include <delref/mesh/verify_3/subject.hpp>

namespace delref::verification_3 {

class FacetRegion {
 public:
  using Edge = std::pair<Index, Index>;

  /// `place(v)` gives the scaled point of a vertex that `edges` names.
  template <class Place>
  FacetRegion(const Group& plane, std::span<const Edge> edges, Place&& place, std::span<const Point3> holes)
      : origin_(plane.origin) {
    const Vector3 n = plane.normal;
    const bool along_x = std::abs(n.x) < 0.6;
    u_ = cross(n, along_x ? Vector3{1, 0, 0} : Vector3{0, 1, 0});
    u_ = (1 / std::sqrt(squared_length(u_))) * u_;
    v_ = cross(n, u_);
    for (const auto& [a, b] : edges)
      for (const Index vertex : {a, b}) insert(vertex, place(vertex));
    try {
      for (const auto& [a, b] : edges) cdt_.insert_constraint(handle_.at(a), handle_.at(b));
    } catch (const Cdt::Intersection_of_constraints_exception&) {
      usable_ = false;
    }
    if (usable_ && cdt_.dimension() == 2)
      mark_outside(holes);
    else
      usable_ = false;
  }

  /// False when the segments cross, in projection.
  bool usable() const { return usable_; }
  /// Whether the facet is on the left and on the right of an edge from a to b, as seen from the head of the normal.
  std::array<bool, 2> sides(Index a, Index b) const {
    Cdt::Face_handle face;
    int i = 0;
    if (!cdt_.is_edge(handle_.at(a), handle_.at(b), face, i)) return {false, false};
    const bool here = face->info(), there = face->neighbor(i)->info(), face_on_left = face->vertex(Cdt::cw(i)) == handle_.at(b);
    return {face_on_left ? here : there, face_on_left ? there : here};
  }
  /// A triangulation of the facet.
  std::vector<std::array<Index, 3>> triangles() const {
    std::vector<std::array<Index, 3>> found;
    for (const auto f : cdt_.finite_face_handles())
      if (f->info()) found.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
    return found;
  }

 private:
  using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<Index, ExactKernel>;
  using FaceBase =
      CGAL::Triangulation_face_base_with_info_2<bool, ExactKernel, CGAL::Constrained_triangulation_face_base_2<ExactKernel>>;
  using Cdt = CGAL::Constrained_Delaunay_triangulation_2<ExactKernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
                                                         CGAL::No_constraint_intersection_requiring_constructions_tag>;

  ExactKernel::Point_2 project(Point3 p) const { return {dot(p - origin_, u_), dot(p - origin_, v_)}; }

  void insert(Index vertex, Point3 p) {
    if (handle_.contains(vertex)) return;
    const std::size_t before = cdt_.number_of_vertices();
    const auto handle = cdt_.insert(project(p));
    if (cdt_.number_of_vertices() == before) usable_ = false;
    handle->info() = vertex;
    handle_[vertex] = handle;
  }

  void mark_outside(std::span<const Point3> holes) {
    for (const auto f : cdt_.all_face_handles()) f->info() = true;
    flood(cdt_.infinite_face());
    for (const Point3 hole : holes) {
      const auto f = cdt_.locate(project(hole));
      if (f != Cdt::Face_handle()) flood(f);
    }
  }
  void flood(Cdt::Face_handle start) {
    std::vector<Cdt::Face_handle> stack{start};
    start->info() = false;
    while (!stack.empty()) {
      const auto f = stack.back();
      stack.pop_back();
      for (int i = 0; i < 3; ++i) {
        const auto next = f->neighbor(i);
        if (f->is_constrained(i) || !next->info()) continue;
        next->info() = false;
        stack.push_back(next);
      }
    }
  }

  Point3 origin_;
  Vector3 u_, v_;
  Cdt cdt_;
  std::map<Index, Cdt::Vertex_handle> handle_;
  bool usable_ = true;
};

}  // namespace delref::verification_3
