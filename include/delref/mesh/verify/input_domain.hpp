// SPDX-License-Identifier: GPL-3.0-or-later
//
// The domain that a planar straight line graph describes, worked out anew for verification from CGAL's constrained Delaunay
// triangulation of the input alone: its components, their labels and areas, and the pieces into which vertices cut segments.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>
#include <fmt/format.h>

#include <delref/core/budget.hpp>
#include <delref/core/point.hpp>
#include <delref/domain/pslg.hpp>
#include <delref/mesh/scaling.hpp>
#include <delref/mesh/twofold.hpp>
#include <delref/mesh/verify/topology.hpp>

namespace delref::verification {

using ExactKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
inline ExactKernel::Point_2 exact(Point2 p) { return {p.x, p.y}; }

/// A connected part of the plane minus the segments.
struct Component {
  bool inside = true;
  double area = 0;  ///< of the scaled input
  /// The regions whose seeds lie in it, by their index in the input.
  std::vector<Index> regions;
};

/// A stretch of one or more input segments between two input vertices, with no input vertex in between.
struct Piece {
  Index from, to;             ///< canonical input vertices
  Index left, right;          ///< components
  std::vector<Index> segments;  ///< the input segments that run over it, in order; more than one only where they overlap
};

class InputDomain {
 public:
  /// `points` are the scaled points of the input, finite; the indices of its segments are valid.
  InputDomain(const Pslg& input, std::span<const Point2> points, const PowerOfTwoScaling& scaling, const Control& control)
      : input_(input), points_(points), scaling_(scaling), control_(control) {
    insert_points();
    if (cdt_.dimension() < 2) {
      problem("all points of the input lie on a line: it has no area");
      return;
    }
    if (!insert_segments()) return;
    find_components();
    place_seeds();
    measure();
    find_pieces();
  }

  /// Why the input describes no domain; empty when it does.
  std::span<const std::string> problems() const { return problems_; }
  /// The first input vertex at the same coordinates.
  Index canonical(Index vertex) const { return handles_[vertex]->info(); }
  std::span<const Component> components() const { return components_; }
  std::span<const Piece> pieces() const { return pieces_; }
  /// The pieces at a canonical vertex.
  std::span<const Index> pieces_at(Index vertex) const {
    return std::span(piece_at_).subspan(piece_at_begin_[vertex], piece_at_begin_[vertex + 1] - piece_at_begin_[vertex]);
  }
  bool inside(Index component) const { return components_[component].inside; }
  bool bounds_domain(const Piece& p) const { return inside(p.left) || inside(p.right); }
  /// Whether a vertex lies in the closure of the domain.
  bool vertex_in_domain(Index vertex) const {
    auto face = cdt_.incident_faces(handles_[vertex]);
    const auto first = face;
    do
      if (inside(face->info())) return true;
    while (++face != first);
    return false;
  }
  /// The area of the domain of the scaled input.
  double area() const { return area_; }

 private:
  using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<Index, ExactKernel>;
  using FaceBase =
      CGAL::Triangulation_face_base_with_info_2<Index, ExactKernel, CGAL::Constrained_triangulation_face_base_2<ExactKernel>>;
  using Cdt = CGAL::Constrained_Delaunay_triangulation_2<ExactKernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
                                                         CGAL::No_constraint_intersection_requiring_constructions_tag>;
  using Vertex = Cdt::Vertex_handle;
  using Face = Cdt::Face_handle;

  void problem(std::string words) { problems_.push_back(std::move(words)); }
  void breathe(std::size_t step) const {
    if (step % 4096 == 0) throw_if_stopped(control_);
  }

  void insert_points() {
    std::vector<ExactKernel::Point_2> points;
    for (const Point2 p : points_) points.push_back(exact(p));
    std::vector<std::size_t> order(points.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    using Map = CGAL::Pointer_property_map<ExactKernel::Point_2>::type;
    CGAL::spatial_sort(order.begin(), order.end(),
                       CGAL::Spatial_sort_traits_adapter_2<ExactKernel, Map>(CGAL::make_property_map(points)));
    handles_.resize(points.size());
    Face hint;
    for (std::size_t i = 0; i < order.size(); ++i) {
      breathe(i);
      const std::size_t before = cdt_.number_of_vertices();
      const Vertex v = cdt_.insert(points[order[i]], hint);
      const auto index = static_cast<Index>(order[i]);
      v->info() = cdt_.number_of_vertices() > before ? index : std::min(v->info(), index);
      handles_[order[i]] = v;
      hint = v->face();
    }
  }

  bool insert_segments() {
    std::size_t s = 0;
    try {
      for (; s < input_.segments.size(); ++s) {
        breathe(s);
        const auto [a, b] = input_.segments[s];
        if (handles_[a] != handles_[b]) cdt_.insert_constraint(handles_[a], handles_[b]);
      }
    } catch (const Cdt::Intersection_of_constraints_exception&) {
      problem(fmt::format("segment {} crosses another one; a mesh is verified against input that was split at its crossings",
                          s + input_.first_index));
      return false;
    }
    return true;
  }

  void find_components() {
    for (const Face f : cdt_.all_face_handles()) f->info() = none;
    flood(cdt_.infinite_face());
    components_[0].inside = false;
    for (const Face f : cdt_.finite_face_handles())
      if (f->info() == none) flood(f);
  }

  void flood(Face start) {
    const auto number = static_cast<Index>(components_.size());
    components_.emplace_back();
    std::vector<Face> stack{start};
    start->info() = number;
    for (std::size_t step = 1; !stack.empty(); ++step) {
      breathe(step);
      const Face f = stack.back();
      stack.pop_back();
      for (int i = 0; i < 3; ++i) {
        const Face next = f->neighbor(i);
        if (f->is_constrained(i) || next->info() != none) continue;
        next->info() = number;
        stack.push_back(next);
      }
    }
  }

  /// The component that strictly contains a seed; `none` when the seed lies on a segment.
  Index component_at(Point2 seed) const {
    Cdt::Locate_type type{};
    int i = 0;
    const Face f = cdt_.locate(exact(scaling_(seed)), type, i);
    if (type == Cdt::OUTSIDE_CONVEX_HULL || type == Cdt::OUTSIDE_AFFINE_HULL) return 0;
    if (type == Cdt::EDGE && f->is_constrained(i)) return none;
    if (type == Cdt::VERTEX && cdt_.are_there_incident_constraints(f->vertex(i))) return none;
    return f->info();
  }

  void place_seeds() {
    const auto on_a_segment = [](const char* what, Point2 p) {
      return fmt::format("the {} seed at ({}, {}) lies on a segment, so it marks neither side", what, p.x, p.y);
    };
    for (const Point2 hole : input_.holes) {
      const Index c = component_at(hole);
      if (c == none) problem(on_a_segment("hole", hole));
      else components_[c].inside = false;
    }
    for (std::size_t r = 0; r < input_.regions.size(); ++r) {
      const Index c = component_at(input_.regions[r].seed);
      if (c == none) problem(on_a_segment("region", input_.regions[r].seed));
      else components_[c].regions.push_back(static_cast<Index>(r));
    }
  }

  void measure() {
    std::vector<PreciseSum> sums(components_.size());
    for (const Face f : cdt_.finite_face_handles()) sums[f->info()] += 0.5 * precise_cross(at(f, 0), at(f, 1), at(f, 2));
    PreciseSum total;
    for (std::size_t c = 0; c < components_.size(); ++c) {
      components_[c].area = sums[c].value();
      if (components_[c].inside) total += components_[c].area;
    }
    area_ = total.value();
    if (std::ranges::none_of(components_, &Component::inside))
      problem("the segments and holes of the input leave no bounded region");
  }
  Point2 at(Face f, int i) const { return points_[f->vertex(i)->info()]; }

  void find_pieces() {
    std::map<std::pair<Index, Index>, Index> known;
    for (std::size_t s = 0; s < input_.segments.size(); ++s) {
      breathe(s);
      const Vertex end = handles_[input_.segments[s][1]];
      for (Vertex v = handles_[input_.segments[s][0]]; v != end;) {
        Vertex next;
        Face face;
        int i = 0;
        cdt_.includes_edge(v, end, next, face, i);
        const std::pair key{std::min(v->info(), next->info()), std::max(v->info(), next->info())};
        const auto [entry, is_new] = known.emplace(key, static_cast<Index>(pieces_.size()));
        if (is_new) pieces_.push_back(piece(v, next, face, i));
        pieces_[entry->second].segments.push_back(static_cast<Index>(s));
        v = next;
      }
    }
    piece_at_begin_.assign(points_.size() + 2, 0);
    for (const Piece& p : pieces_)
      for (const Index v : {p.from, p.to}) ++piece_at_begin_[v + 2];
    for (std::size_t i = 2; i < piece_at_begin_.size(); ++i) piece_at_begin_[i] += piece_at_begin_[i - 1];
    piece_at_.resize(2 * pieces_.size());
    for (Index p = 0; p < pieces_.size(); ++p)
      for (const Index v : {pieces_[p].from, pieces_[p].to}) piece_at_[piece_at_begin_[v + 1]++] = p;
    piece_at_begin_.pop_back();
  }

  Piece piece(Vertex from, Vertex to, Face face, int i) const {
    const Index here = face->info(), there = face->neighbor(i)->info();
    const bool face_on_left = face->vertex(Cdt::cw(i)) == to;
    return {from->info(), to->info(), face_on_left ? here : there, face_on_left ? there : here, {}};
  }

  const Pslg& input_;
  std::span<const Point2> points_;
  PowerOfTwoScaling scaling_;
  const Control& control_;
  Cdt cdt_;
  std::vector<Vertex> handles_;
  std::vector<Component> components_;
  std::vector<Piece> pieces_;
  std::vector<Index> piece_at_begin_, piece_at_;
  double area_ = 0;
  std::vector<std::string> problems_;
};

}  // namespace delref::verification
