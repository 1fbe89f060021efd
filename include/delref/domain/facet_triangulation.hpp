// SPDX-License-Identifier: GPL-3.0-or-later
//
// The constrained Delaunay triangulation of one facet in its plane (Chew 1989), by CGAL. The facet is all that its sides enclose:
// what a flood from infinity cannot reach, less the parts that hold a hole point. Sides that cross are found, in words.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <delref/core/point.hpp>
#include <delref/domain/plc.hpp>
#include <delref/domain/plc_names.hpp>
#include <delref/domain/polyhedral_domain.hpp>
#include <delref/domain/segment_contact.hpp>

namespace delref {

/// Triangulates facets, one after the other, of one set of vertices.
class FacetTriangulator {
 public:
  using Index = Plc::Index;
  using Ends = std::array<Index, 2>;
  using Triangle = std::array<Index, 3>;

  explicit FacetTriangulator(const PlcNames& names) : names_(names) {}

  /// Appends the triangles of the facet that `sides` bound, counterclockwise in `frame`, with every vertex of `sides` and `loose`
  /// among theirs where it is in the facet. Gives what is wrong with the facet, or nothing; then also the numbers of hole points
  /// that are in no part of it, in `useless_holes`.
  std::string triangulate(const PlaneFrame& frame, std::span<const Ends> sides, std::span<const Index> loose,
                          std::span<const Point3> holes, std::vector<Triangle>& triangles) {
    cdt_.clear();
    handles_.clear();
    useless_holes.clear();
    if (std::string wrong = insert(frame, sides, loose); !wrong.empty()) return wrong;
    if (cdt_.dimension() < 2) return {};
    flood(cdt_.infinite_face());
    for (std::size_t h = 0; h < holes.size(); ++h) {
      const Point2 p = frame.project(holes[h]);
      const auto face = cdt_.locate({p.x, p.y});
      if (face == nullptr || cdt_.is_infinite(face) || face->info() == reached)
        useless_holes.push_back(h);
      else
        flood(face);
    }
    for (const Face face : cdt_.finite_face_handles())
      if (face->info() != reached) triangles.push_back(corners(face));
    return {};
  }

  /// The same for a facet that is known to lie to the left of each of `sides`, seen against the normal; `slits` have it on both
  /// sides.
  std::string triangulate_left_of(const PlaneFrame& frame, std::span<const Ends> sides, std::span<const Ends> slits,
                                  std::span<const Index> loose, std::vector<Triangle>& triangles) {
    cdt_.clear();
    handles_.clear();
    std::vector<Ends> all(sides.begin(), sides.end());
    all.insert(all.end(), slits.begin(), slits.end());
    if (std::string wrong = insert(frame, all, loose); !wrong.empty()) return wrong;
    if (cdt_.dimension() < 2) return "it has no area";
    for (std::size_t s = 0; s < sides.size(); ++s) {
      Face face;
      int i = 0;
      cdt_.is_edge(constraints_[s][0], constraints_[s][1], face, i);
      if (face->vertex(Cdt::ccw(i)) != constraints_[s][0]) face = face->neighbor(i);
      if (face->info() != reached) flood(face);
    }
    for (const Face face : cdt_.all_face_handles()) {
      if (face->info() != reached) continue;
      if (cdt_.is_infinite(face)) return "its sides do not close";
      triangles.push_back(corners(face));
    }
    return {};
  }

  std::vector<std::size_t> useless_holes;

 private:
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>;
  using FaceBase = CGAL::Triangulation_face_base_with_info_2<char, Kernel, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
  using Cdt = CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
                                                         CGAL::No_constraint_intersection_requiring_constructions_tag>;
  using Vertex = Cdt::Vertex_handle;
  using Face = Cdt::Face_handle;
  static constexpr Index unnamed = static_cast<Index>(-1);
  static constexpr char reached = 1;

  std::string insert(const PlaneFrame& frame, std::span<const Ends> sides, std::span<const Index> loose) {
    std::string wrong;
    constraints_.clear();
    for (const auto& [a, b] : sides) {
      const Vertex first = vertex(frame, a, wrong), second = vertex(frame, b, wrong);
      if (!wrong.empty()) return wrong;
      constraints_.push_back({first, second});
    }
    for (const Index v : loose) vertex(frame, v, wrong);
    if (!wrong.empty()) return wrong;
    for (const auto& [a, b] : constraints_) {
      try {
        cdt_.insert_constraint(a, b);
      } catch (const typename Cdt::Intersection_of_constraints_exception&) {
        return describe_crossing(a, b);
      }
    }
    for (const auto face : cdt_.all_face_handles()) face->info() = 0;
    for (const auto& [a, b] : constraints_)
      if (!is_side(a, b)) return describe_touching(a, b);
    return {};
  }

  /// The vertex of the triangulation for an input vertex, which is inserted when it is new.
  Vertex vertex(const PlaneFrame& frame, Index v, std::string& wrong) {
    for (std::size_t k = handles_.size(); k > 0 && handles_.size() - k < 2; --k)
      if (handles_[k - 1]->info() == v) return handles_[k - 1];
    const Point2 p = frame.project(names_.points[v]);
    const std::size_t before = cdt_.number_of_vertices();
    const Vertex found = cdt_.insert({p.x, p.y}, handles_.empty() ? Face() : handles_.back()->face());
    if (cdt_.number_of_vertices() > before) found->info() = v;
    if (found->info() != v)
      wrong = names_.placed_vertex(v) + " and " + names_.placed_vertex(found->info()) +
              " are one point in its plane: merge them, or give a facet whose vertices are closer to a plane";
    handles_.push_back(found);
    return found;
  }

  static Triangle corners(Face face) { return {face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()}; }

  bool is_side(Vertex a, Vertex b) const {
    Face face;
    int i = 0;
    return cdt_.is_edge(a, b, face, i) && cdt_.is_constrained({face, i});
  }

  static Point2 place(Vertex v) { return {v->point().x(), v->point().y()}; }

  std::string describe_crossing(Vertex a, Vertex b) const {
    const std::string first = names_.placed_segment(a->info(), b->info());
    for (const auto& [c, d] : constraints_)
      if (contact({place(a), place(b)}, {place(c), place(d)}) == SegmentContact::crossing)
        return first + " crosses " + names_.placed_segment(c->info(), d->info());
    return first + " crosses another of its sides";
  }

  std::string describe_touching(Vertex a, Vertex b) const {
    const std::string first = names_.placed_segment(a->info(), b->info());
    for (const Vertex v : cdt_.finite_vertex_handles())
      if (v != a && v != b && exact_side(place(a), place(b), place(v)) == 0 && between(a, b, v))
        return first + " passes within rounding of " + names_.placed_vertex(v->info()) +
               ", but not through it: make that its end";
    return first + " overlaps another of its sides";
  }

  static bool between(Vertex a, Vertex b, Vertex v) {
    const Vector2 along = place(b) - place(a), to_v = place(v) - place(a);
    return dot(along, to_v) > 0 && squared_length(to_v) < squared_length(along);
  }

  /// Marks what can be reached from a face without passing a side.
  void flood(Face start) {
    std::vector<Face> stack{start};
    start->info() = reached;
    while (!stack.empty()) {
      const Face face = stack.back();
      stack.pop_back();
      for (int i = 0; i < 3; ++i) {
        const Face neighbour = face->neighbor(i);
        if (neighbour->info() == reached || face->is_constrained(i)) continue;
        neighbour->info() = reached;
        stack.push_back(neighbour);
      }
    }
  }

  const PlcNames& names_;
  Cdt cdt_;
  std::vector<Vertex> handles_;
  std::vector<std::array<Vertex, 2>> constraints_;
};

}  // namespace delref
