// SPDX-License-Identifier: GPL-3.0-or-later
//
// CGAL's constrained Delaunay triangulation of the plane as delref's levels see it: each face knows its region, the input segment
// of each of its edges, and a slot per level; each vertex its carrier, its provenance and a number. Refinement points are inserted
// by the star of their conflict zone, found once (Bowyer 1981, Watson 1981; Chew 1989 for constraints).
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <delref/core/carrier.hpp>
#include <delref/core/point.hpp>
#include <delref/core/proposal.hpp>
#include <delref/triangulation/detail/planar_filters.hpp>
#include <delref/triangulation/detail/planar_records.hpp>
#include <delref/triangulation/detail/range_of.hpp>

namespace delref {

/// A constrained Delaunay triangulation with `EdgeSlots` slots per edge and `FaceSlots` per face; models `PlanarTriangulation`.
///
/// Faces outside the domain have a negative region; which they are is decided by `domain/planar_domain.hpp`. Handles stay valid
/// until their element dies. Copying is not offered.
template <int EdgeSlots = 1, int FaceSlots = 1>
class ConstrainedDelaunay2 {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using VertexBase = detail::PlanarVertexRecord<Kernel>;
  using FaceBase = detail::PlanarFaceRecord<Kernel, EdgeSlots, FaceSlots>;

 public:
  /// The triangulation that does the work, for those who include CGAL.
  using Cgal = CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
                                                          CGAL::No_constraint_intersection_requiring_constructions_tag>;
  using CgalVertex = typename Cgal::Vertex_handle;
  using CgalFace = typename Cgal::Face_handle;

  using Point = Point2;
  static constexpr int dimension = 2;

  /// A vertex. Default: none.
  struct Vertex {
    CgalVertex handle{};
    friend bool operator==(const Vertex& a, const Vertex& b) { return a.handle == b.handle; }
  };
  /// A face. Default: none.
  struct Face {
    CgalFace handle{};
    friend bool operator==(const Face& a, const Face& b) { return a.handle == b.handle; }
    /// Announces work on a face that comes after `n` others (`RefinementQueue`): fetches its record into the cache, one step later
    /// what that refers to, and then what its neighbours refer to.
    friend void prefetch(const Face& f, int n) {
      if (n > 2) return detail::fetch_record(f.handle);
      if (n == 2) return detail::fetch_around(f.handle);
      for (int i = 0; i < 3; ++i) detail::fetch_around(f.handle->neighbor(i));
    }
  };
  /// The edge of `face` that is opposite to its vertex `index`.
  struct Edge {
    CgalFace face{};
    int index = 0;
    friend bool operator==(const Edge& a, const Edge& b) { return a.face == b.face && a.index == b.index; }
    friend void prefetch(const Edge& e, int n) { prefetch(Face{e.face}, n); }
  };
  /// Where the search for a point starts: in a face, or on an edge, which the point then splits.
  struct Hint {
    CgalFace face{};
    int edge = -1;
    Hint() = default;
    Hint(const Face& f) : face(f.handle) {}
    Hint(const Edge& e) : face(e.face), edge(e.index) {}
    Hint(const Vertex& v) : face(v.handle->face()) {}
  };

  /// The conflict zone of a point. Reused from one point to the next, so that it costs no allocation.
  class Zone {
   public:
    /// Before insertion: the faces that die.
    std::span<const Face> dying_faces() const { return dying_; }
    /// Before insertion: the subsegments that die.
    std::span<const Edge> dying_subsegments() const { return dying_subsegments_; }
    /// The edges around the zone, named from the faces outside it, which survive.
    std::span<const Edge> boundary_edges() const { return boundary_; }
    /// The vertices that this insertion removes.
    std::span<const Vertex> vanishing() const { return vanishing_; }
    /// After insertion: the faces that are new.
    std::span<const Face> new_faces() const { return new_; }

   private:
    friend class ConstrainedDelaunay2;
    void clear() {
      dying_.clear(), dying_subsegments_.clear(), boundary_.clear(), vanishing_.clear(), new_.clear();
      split_ = {};
      split_segment_ = -1;
    }
    std::vector<Face> dying_, new_;
    std::vector<Edge> dying_subsegments_, boundary_;
    int regions_[2] = {};            // of the dying faces on the two sides of the split edge; of all of them if none is split
    std::size_t second_side_ = 0;    // the number of boundary edges on the first side
    std::vector<Vertex> vanishing_;
    std::vector<Edge> stack_;
    Edge split_{};                   // the edge that the point splits, if its face is set
    CgalVertex split_ends_[2] = {};  // and its ends
    std::int32_t split_segment_ = -1;
  };

  template <class Element>
  static constexpr std::size_t slot_count = std::is_same_v<Element, Face>   ? std::size_t{FaceSlots}
                                            : std::is_same_v<Element, Edge> ? std::size_t{EdgeSlots}
                                                                            : std::size_t{0};

  ConstrainedDelaunay2() = default;
  ConstrainedDelaunay2(const ConstrainedDelaunay2&) = delete;
  ConstrainedDelaunay2& operator=(const ConstrainedDelaunay2&) = delete;

  Cgal& cgal() { return cgal_; }
  const Cgal& cgal() const { return cgal_; }

  // -- vertices
  Point2 point(Vertex v) const { return point_of(v.handle); }
  std::size_t index(Vertex v) const { return v.handle->index; }
  Carrier carrier(Vertex v) const { return v.handle->carrier; }
  LevelIndex provenance(Vertex v) const { return v.handle->provenance; }
  void set_origin(Vertex v, Carrier carrier, LevelIndex provenance) {
    v.handle->carrier = carrier;
    v.handle->provenance = provenance;
  }
  std::size_t number_of_vertices() const { return cgal_.number_of_vertices(); }
  std::size_t number_of_faces() const { return cgal_.number_of_faces(); }

  // -- faces and edges
  Vertex vertex(Face f, int i) const { return {f.handle->vertex(i)}; }
  std::array<Vertex, 3> vertices(Face f) const { return {vertex(f, 0), vertex(f, 1), vertex(f, 2)}; }
  std::array<Vertex, 2> vertices(Edge e) const { return {source(e), target(e)}; }
  Vertex source(Edge e) const { return {e.face->vertex(Cgal::ccw(e.index))}; }
  Vertex target(Edge e) const { return {e.face->vertex(Cgal::cw(e.index))}; }
  /// The vertex of the edge's face that is not on the edge.
  Vertex apex(Edge e) const { return {e.face->vertex(e.index)}; }
  Edge edge(Face f, int i) const { return {f.handle, i}; }
  Face face(Edge e) const { return {e.face}; }
  Edge mirror(Edge e) const {
    const CgalFace n = e.face->neighbor(e.index);
    return {n, n->index(e.face)};
  }
  bool is_constrained(Edge e) const { return e.face->is_constrained(e.index); }
  /// Whether any edge of the face is constrained.
  bool is_constrained(Face f) const { return f.handle->is_constrained(); }
  /// The input segment that a constrained edge lies on.
  std::size_t segment(Edge e) const { return static_cast<std::size_t>(e.face->segment(e.index)); }
  void set_segment(Edge e, std::size_t segment) {
    const Edge m = mirror(e);
    e.face->set_segment(e.index, static_cast<std::int32_t>(segment));
    m.face->set_segment(m.index, static_cast<std::int32_t>(segment));
  }
  bool in_domain(Face f) const { return f.handle->region() >= 0; }
  int region(Face f) const { return f.handle->region(); }
  void set_region(Face f, int region) { f.handle->set_region(region); }
  bool is_simplex(std::span<const Vertex> v) const {
    if (v.size() == 2) return cgal_.is_edge(v[0].handle, v[1].handle);
    return v.size() == 3 && cgal_.is_face(v[0].handle, v[1].handle, v[2].handle);
  }
  Point2 barycentre(std::span<const Vertex> vertices) const {
    Point2 sum;
    const double w = 1.0 / static_cast<double>(vertices.size());
    for (const Vertex v : vertices) sum = sum + w * (point(v) - Point2{});
    return sum;
  }

  /// The finite faces of the domain, all finite faces, and all finite vertices, in the order of storage.
  auto finite_faces() const {
    return detail::range_of<Face>(cgal_.finite_faces_begin(), cgal_.finite_faces_end(), [](const auto&) { return true; });
  }
  auto domain_faces() const {  // no infinite face is of the domain
    return detail::range_of<Face>(cgal_.all_faces_begin(), cgal_.all_faces_end(), [](const auto& f) { return f->region() >= 0; });
  }
  auto finite_vertices() const {
    return detail::range_of<Vertex>(cgal_.finite_vertices_begin(), cgal_.finite_vertices_end(), [](const auto&) { return true; });
  }
  /// Every constrained edge that has the domain on one side at least, once, named from a face of the domain.
  std::vector<Edge> subsegments() const {
    std::vector<Edge> result;
    for (const Face f : domain_faces())
      for (int i = 0; i < 3; ++i)
        if (const Edge e{f.handle, i}; is_constrained(e) && (!in_domain(face(mirror(e))) || index(source(e)) < index(target(e))))
          result.push_back(e);
    return result;
  }

  // -- slots
  QueuePosition slot(Face f, std::size_t k) const { return f.handle->face_slots[k]; }
  QueuePosition slot(Edge e, std::size_t k) const { return e.face->edge_slots[k][static_cast<std::size_t>(e.index)]; }
  void set_slot(Face f, std::size_t k, QueuePosition position) {
    any_slot_set_ = true;
    f.handle->face_slots[k] = position;
  }
  void set_slot(Edge e, std::size_t k, QueuePosition position) {
    any_slot_set_ = true;
    const Edge m = mirror(e);
    e.face->edge_slots[k][static_cast<std::size_t>(e.index)] = position;
    m.face->edge_slots[k][static_cast<std::size_t>(m.index)] = position;
  }
  void clear_slots() {
    if (!std::exchange(any_slot_set_, false)) return;
    for (auto f = cgal_.all_faces_begin(); f != cgal_.all_faces_end(); ++f) f->clear_slots();
  }

  // -- predicates, exact
  /// Whether `p` is strictly inside the circle whose diameter is `e`.
  bool in_diametral_circle(Edge e, Point2 p) const {
    const Point2 a = point(source(e)), b = point(target(e));
    const double x = (a.x - p.x) * (b.x - p.x), y = (a.y - p.y) * (b.y - p.y), s = x + y;
    const double error = 1e-15 * (std::abs(x) + std::abs(y));  // over 4 roundings of 2^-53 each
    if (s > error) return false;
    if (s < -error) return true;
    return cgal_.geom_traits().angle_2_object()(cgal_point(a), cgal_point(p), cgal_point(b)) == CGAL::OBTUSE;
  }
  bool dies(Face f, const Zone&) const { return f.handle->dying(); }
  bool dies(Edge e, const Zone&) const { return e.face->dying() && e.face->neighbor(e.index)->dying(); }

  // -- insertion
  /// Finds the faces whose circumcircle contains `p` and that are visible from it. A hint that is an edge means that `p` splits
  /// it: the zone then spans that edge, even if rounding put `p` beside it.
  Location<ConstrainedDelaunay2> conflict_zone(Point2 p, const Hint& hint, Zone& zone);
  /// The same for a point that splits `e`, together with the stars of the vertices `vanishing`, which are removed first. They
  /// must be on no constraint and visible from `e`.
  Location<ConstrainedDelaunay2> conflict_zone(Point2 p, Edge e, std::span<const Vertex> vanishing, Zone& zone);
  /// Inserts `p` into its zone, which then lists the new faces. Constraints and regions come from the sides of the zone.
  Vertex insert(Point2 p, Zone& zone);
  /// The next number for a vertex that is inserted through `cgal()`.
  std::uint32_t take_index() { return next_index_++; }

 private:
  using Where = Location<ConstrainedDelaunay2>;

  static Point2 point_of(CgalVertex v) { return {v->point().x(), v->point().y()}; }
  static typename Kernel::Point_2 cgal_point(Point2 p) { return {p.x, p.y}; }
  CGAL::Orientation orientation(CgalVertex a, CgalVertex b, const typename Kernel::Point_2& p) const {
    const int sign = detail::filtered_orientation(point_of(a), point_of(b), {p.x(), p.y()});
    if (sign != 0) return sign > 0 ? CGAL::LEFT_TURN : CGAL::RIGHT_TURN;
    return cgal_.geom_traits().orientation_2_object()(a->point(), b->point(), p);
  }
  /// Whether `p` kills the face `f`, were it visible.
  bool in_conflict(CgalFace f, const typename Kernel::Point_2& p) const {
    for (int i = 0; i < 3 && f->region() < 0; ++i)
      if (cgal_.is_infinite(f->vertex(i)))
        return orientation(f->vertex(Cgal::ccw(i)), f->vertex(Cgal::cw(i)), p) == CGAL::LEFT_TURN;
    const int sign =
        detail::filtered_side_of_circle(point_of(f->vertex(0)), point_of(f->vertex(1)), point_of(f->vertex(2)), {p.x(), p.y()});
    if (sign != 0) return sign > 0;
    return cgal_.geom_traits().side_of_oriented_circle_2_object()(f->vertex(0)->point(), f->vertex(1)->point(),
                                                                  f->vertex(2)->point(), p) == CGAL::ON_POSITIVE_SIDE;
  }
  void release(Zone& zone) {
    for (const Face f : zone.dying_) f.handle->set_dying(false);
    zone.clear();
  }
  Where walk(const typename Kernel::Point_2& p, CgalFace start, CgalFace& found) const;
  Where approach(const typename Kernel::Point_2& p, CgalFace& f) const;
  void take(CgalFace f, Zone& zone) {
    f->set_dying(true);
    zone.dying_.push_back({f});
  }
  void grow(const typename Kernel::Point_2& p, Edge through, Zone& zone);
  void grow_from_face(const typename Kernel::Point_2& p, CgalFace f, Zone& zone);
  void grow_from_split(const typename Kernel::Point_2& p, Edge e, Zone& zone);
  bool is_star_shaped(const typename Kernel::Point_2& p, const Zone& zone) const;
  bool add_stars(std::span<const Vertex> vanishing, Zone& zone);
  void remove_vanishing(Point2 p, Zone& zone);
  void link_star(CgalVertex v, Zone& zone);
  void constrain_halves(CgalVertex v, const Zone& zone);

  Cgal cgal_;
  std::uint32_t next_index_ = 0;
  bool any_slot_set_ = false;  // since the last time they were cleared
};

}  // namespace delref

#include <delref/triangulation/detail/constrained_delaunay_2_zone.hpp>
