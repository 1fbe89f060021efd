// SPDX-License-Identifier: GPL-3.0-or-later
//
// How `ConstrainedDelaunay2` finds and fills conflict zones. Included by constrained_delaunay_2.hpp alone.
#pragma once

#include <algorithm>
#include <utility>

#include <delref/triangulation/constrained_delaunay_2.hpp>

namespace delref {

/// Walks along the line from the middle of `start` to `p`, so that the constraint it is stopped by is one that hides `p` from
/// `start`. A vertex on that line counts as being to its left.
template <int EdgeSlots, int FaceSlots>
auto ConstrainedDelaunay2<EdgeSlots, FaceSlots>::walk(const typename Kernel::Point_2& p, CgalFace start, CgalFace& found) const -> Where {
  const std::array<Vertex, 3> corners = vertices(Face{start});
  const typename Kernel::Point_2 q = cgal_point(barycentre(corners));
  const auto left = [&](CgalVertex v) { return cgal_.geom_traits().orientation_2_object()(q, p, v->point()) != CGAL::RIGHT_TURN; };
  const bool on_left[3] = {left(start->vertex(0)), left(start->vertex(1)), left(start->vertex(2))};
  int exit = 0;  // the line leaves through the edge whose source is on its right and whose target is on its left
  while (exit < 3 && (on_left[Cgal::ccw(exit)] || !on_left[Cgal::cw(exit)])) ++exit;
  found = start;
  while (exit < 3 && orientation(found->vertex(Cgal::ccw(exit)), found->vertex(Cgal::cw(exit)), p) == CGAL::RIGHT_TURN) {
    if (found->segment(exit) >= 0) return {Where::Kind::blocked, Edge{found, exit}};
    const CgalFace n = found->neighbor(exit);
    if (cgal_.is_infinite(n)) return {Where::Kind::outside, {}};
    const int entry = n->index(found);
    exit = left(n->vertex(entry)) ? Cgal::ccw(entry) : Cgal::cw(entry);
    found = n;
  }
  // Unless rounding may have put the middle outside of its face, the line tells that `p` is inside the face found.
  const Vector2 u = point(corners[1]) - point(corners[0]), w = point(corners[2]) - point(corners[0]);
  if (exit == 3 || cross(u, w) < 1e-9 * (squared_length(u) + squared_length(w))) return approach(p, found);
  for (int i = 0; i < 3; ++i) {
    if (found->vertex(i)->point() == p) return {Where::Kind::on_vertex, {}};
    if (found->segment(i) >= 0 && orientation(found->vertex(Cgal::ccw(i)), found->vertex(Cgal::cw(i)), p) != CGAL::LEFT_TURN)
      return {Where::Kind::blocked, Edge{found, i}};
  }
  return {};
}

/// Goes from neighbour to neighbour, each time through an edge that has `p` beyond it, until `p` is in the closure of `f`. A point on
/// a constraint is blocked by it.
template <int EdgeSlots, int FaceSlots>
auto ConstrainedDelaunay2<EdgeSlots, FaceSlots>::approach(const typename Kernel::Point_2& p, CgalFace& f) const -> Where {
  for (int steps = 0; steps < 10'000; ++steps) {
    int through = -1, blocker = -1;
    for (int i = 0; i < 3; ++i) {
      if (f->vertex(i)->point() == p) return {Where::Kind::on_vertex, {}};
      const CGAL::Orientation side = orientation(f->vertex(Cgal::ccw(i)), f->vertex(Cgal::cw(i)), p);
      if (side == CGAL::LEFT_TURN) continue;
      if (f->segment(i) >= 0) blocker = i;
      else if (side == CGAL::RIGHT_TURN) through = i;
    }
    if (blocker >= 0) return {Where::Kind::blocked, Edge{f, blocker}};
    if (through < 0) return {};
    f = f->neighbor(through);
    if (cgal_.is_infinite(f)) return {Where::Kind::outside, {}};
  }
  return {Where::Kind::degenerate, {}};
}

/// Takes the faces in conflict beyond the edge `through`, which is named from inside: depth first, each face from its entry edge in
/// counterclockwise order, so that the boundary edges come out in their order around the zone.
template <int EdgeSlots, int FaceSlots>
void ConstrainedDelaunay2<EdgeSlots, FaceSlots>::grow(const typename Kernel::Point_2& p, Edge through, Zone& zone) {
  while (true) {
    const CgalFace n = through.face->neighbor(through.index);
    const int entry = n->index(through.face);
    detail::fetch_record(n->neighbor(Cgal::ccw(entry)));
    detail::fetch_record(n->neighbor(Cgal::cw(entry)));
    if (!through.face->is_constrained(through.index) && !n->dying() && in_conflict(n, p)) {
      take(n, zone);
      zone.stack_.push_back({n, Cgal::cw(entry)});
      through = {n, Cgal::ccw(entry)};
      continue;
    }
    zone.boundary_.push_back({n, entry});
    if (zone.stack_.empty()) return;
    through = zone.stack_.back();
    zone.stack_.pop_back();
  }
}

/// Both faces of `e` die, and so does `e`; the zone grows from both.
template <int EdgeSlots, int FaceSlots>
void ConstrainedDelaunay2<EdgeSlots, FaceSlots>::grow_from_split(const typename Kernel::Point_2& p, Edge e, Zone& zone) {
  const Edge m = mirror(e);
  take(e.face, zone);
  take(m.face, zone);
  zone.split_ = e;
  zone.split_ends_[0] = source(e).handle;
  zone.split_ends_[1] = target(e).handle;
  zone.split_segment_ = e.face->segment(e.index);
  zone.regions_[0] = e.face->region();
  zone.regions_[1] = m.face->region();
  if (zone.split_segment_ >= 0) zone.dying_subsegments_.push_back(e);
  grow(p, {e.face, Cgal::ccw(e.index)}, zone);
  grow(p, {e.face, Cgal::cw(e.index)}, zone);
  zone.second_side_ = zone.boundary_.size();
  grow(p, {m.face, Cgal::ccw(m.index)}, zone);
  grow(p, {m.face, Cgal::cw(m.index)}, zone);
}

template <int EdgeSlots, int FaceSlots>
void ConstrainedDelaunay2<EdgeSlots, FaceSlots>::grow_from_face(const typename Kernel::Point_2& p, CgalFace f, Zone& zone) {
  take(f, zone);
  zone.regions_[0] = f->region();
  for (int i = 0; i < 3; ++i) grow(p, {f, i}, zone);
  zone.second_side_ = zone.boundary_.size();
}

template <int EdgeSlots, int FaceSlots>
bool ConstrainedDelaunay2<EdgeSlots, FaceSlots>::is_star_shaped(const typename Kernel::Point_2& p, const Zone& zone) const {
  return std::ranges::all_of(zone.boundary_, [&](const Edge& e) {
    const CgalVertex a = e.face->vertex(Cgal::ccw(e.index)), b = e.face->vertex(Cgal::cw(e.index));
    return cgal_.is_infinite(a) || cgal_.is_infinite(b) || orientation(a, b, p) == CGAL::RIGHT_TURN;
  });
}

template <int EdgeSlots, int FaceSlots>
auto ConstrainedDelaunay2<EdgeSlots, FaceSlots>::conflict_zone(Point2 point, const Hint& hint, Zone& zone) -> Where {
  if (hint.edge >= 0) return conflict_zone(point, Edge{hint.face, hint.edge}, {}, zone);
  release(zone);
  const typename Kernel::Point_2 p = cgal_point(point);
  CgalFace f = hint.face;
  // The short way: where it ends in a zone of which the start is a part, the start sees the point.
  if (approach(p, f).kind == Where::Kind::zone && in_conflict(f, p)) {
    grow_from_face(p, f, zone);
    if (hint.face->dying()) return {};
    release(zone);
  }
  if (const Where where = walk(p, hint.face, f); where.kind != Where::Kind::zone) return where;
  if (!in_conflict(f, p)) return {Where::Kind::degenerate, {}};
  grow_from_face(p, f, zone);
  return {};
}

template <int EdgeSlots, int FaceSlots>
auto ConstrainedDelaunay2<EdgeSlots, FaceSlots>::conflict_zone(Point2 point, Edge e, std::span<const Vertex> vanishing, Zone& zone) -> Where {
  release(zone);
  const typename Kernel::Point_2 p = cgal_point(point);
  for (const CgalFace f : {e.face, mirror(e).face})
    for (int i = 0; i < 3; ++i)
      if (!cgal_.is_infinite(f->vertex(i)) && f->vertex(i)->point() == p) return {Where::Kind::on_vertex, {}};
  grow_from_split(p, e, zone);
  // Beside the edge by rounding, the point may miss the circumcircle of a thin face: its star would not be Delaunay.
  if (!in_conflict(e.face, p) || !in_conflict(mirror(e).face, p) || !is_star_shaped(p, zone)) return {Where::Kind::degenerate, {}};
  if (!vanishing.empty() && !add_stars(vanishing, zone)) return conflict_zone(point, e, {}, zone);
  return {};
}

/// Adds the stars of the vertices that are to vanish. False when a constraint would have dying faces on both of its sides: its
/// name in the faces that survive could then not be kept.
template <int EdgeSlots, int FaceSlots>
bool ConstrainedDelaunay2<EdgeSlots, FaceSlots>::add_stars(std::span<const Vertex> vanishing, Zone& zone) {
  zone.vanishing_.assign(vanishing.begin(), vanishing.end());
  for (const Vertex v : vanishing) {
    auto around = cgal_.incident_faces(v.handle);
    const auto first = around;
    do {
      const CgalFace f = around;
      if (!f->dying()) take(f, zone);
    } while (++around != first);
  }
  zone.boundary_.clear();
  for (const Face f : zone.dying_)
    for (int i = 0; i < 3; ++i) {
      const Edge inner{f.handle, i}, outer = mirror(inner);
      if (!outer.face->dying()) zone.boundary_.push_back(outer);
      else if (is_constrained(inner) && !(inner == zone.split_) && !(outer == zone.split_)) return false;
    }
  return true;
}

/// Removes the vanishing vertices, which leaves the zone with the faces to be starred from `p`, and all others as new.
template <int EdgeSlots, int FaceSlots>
void ConstrainedDelaunay2<EdgeSlots, FaceSlots>::remove_vanishing(Point2 point, Zone& zone) {
  for (const Face f : zone.dying_) f.handle->set_dying(false);
  const std::vector<Edge> outline = zone.boundary_;
  const std::vector<Vertex> gone = zone.vanishing_;
  const CgalVertex a = zone.split_ends_[0], b = zone.split_ends_[1];
  const std::int32_t segment = zone.split_segment_;
  std::vector<std::int32_t> names;
  std::vector<int> regions;
  for (const Edge& e : outline) {
    names.push_back(e.face->segment(e.index));
    regions.push_back(mirror(e).face->region());
  }
  for (const Vertex v : gone) cgal_.remove(v.handle);
  // CGAL makes nameless faces: give the outline its segments, slots and regions again, from outside.
  std::vector<Face> made;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Edge inner = mirror(outline[k]);
    inner.face->set_segment(inner.index, names[k]);
    for (std::size_t s = 0; s < std::size_t{EdgeSlots}; ++s)
      inner.face->edge_slots[s][static_cast<std::size_t>(inner.index)] =
          outline[k].face->edge_slots[s][static_cast<std::size_t>(outline[k].index)];
    inner.face->set_region(regions[k]);
    if (!inner.face->dying()) take(inner.face, zone), made.push_back({inner.face});
  }
  CgalFace f;
  int i = 0;
  cgal_.is_edge(a, b, f, i);
  set_segment({f, i}, static_cast<std::size_t>(segment));
  for (std::size_t k = 0; k < made.size(); ++k)
    for (int j = 0; j < 3; ++j) {
      const CgalFace n = made[k].handle->neighbor(j);
      if (made[k].handle->segment(j) >= 0 || n->dying()) continue;
      const Edge outer{n, n->index(made[k].handle)};
      if (std::ranges::find(outline, outer) != outline.end()) continue;
      n->set_region(made[k].handle->region());
      take(n, zone), made.push_back({n});
    }
  for (const Face m : made) m.handle->set_dying(false), m.handle->face_slots.fill(-1);
  zone.clear();
  grow_from_split(cgal_point(point), {f, i}, zone);
  for (const Face m : made)
    if (!m.handle->dying()) zone.new_.push_back(m);
}

template <int EdgeSlots, int FaceSlots>
auto ConstrainedDelaunay2<EdgeSlots, FaceSlots>::insert(Point2 p, Zone& zone) -> Vertex {
  if (!zone.vanishing_.empty()) remove_vanishing(p, zone);
  const CgalVertex v = cgal_.tds().create_vertex();
  v->set_point(cgal_point(p));
  v->index = take_index();
  link_star(v, zone);
  if (zone.split_segment_ >= 0) constrain_halves(v, zone);
  return Vertex{v};
}

/// Makes the face between `v` and each boundary edge, in the memory of those that die.
template <int EdgeSlots, int FaceSlots>
void ConstrainedDelaunay2<EdgeSlots, FaceSlots>::link_star(CgalVertex v, Zone& zone) {
  auto& tds = cgal_.tds();
  const std::size_t n = zone.boundary_.size(), old = zone.new_.size();
  std::size_t reused = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const CgalFace f = reused < zone.dying_.size() ? zone.dying_[reused++].handle : tds.create_face();
    const Edge& outer = zone.boundary_[k];
    f->renew(zone.regions_[k < zone.second_side_ ? 0 : 1], outer.face->segment(outer.index));
    f->set_vertices(v, outer.face->vertex(Cgal::cw(outer.index)), outer.face->vertex(Cgal::ccw(outer.index)));
    for (std::size_t s = 0; s < std::size_t{EdgeSlots}; ++s)
      f->edge_slots[s][0] = outer.face->edge_slots[s][static_cast<std::size_t>(outer.index)];
    f->vertex(1)->set_face(f);
    zone.new_.push_back({f});
  }
  CgalFace last = zone.new_.back().handle, f = zone.new_[old].handle;
  for (std::size_t k = 0; k < n; ++k) {  // in their order around the zone: the next one starts where this one ends
    const CgalFace next = zone.new_[k + 1 < n ? old + k + 1 : old].handle;
    const Edge& outer = zone.boundary_[k];
    f->set_neighbors(outer.face, next, last);
    outer.face->set_neighbor(outer.index, f);
    last = std::exchange(f, next);
  }
  v->set_face(zone.new_[old].handle);
  for (; reused < zone.dying_.size(); ++reused) tds.delete_face(zone.dying_[reused].handle);
  zone.dying_.clear();
}

/// The two edges from `v` to the ends of the edge that it split are constrained as that one was.
template <int EdgeSlots, int FaceSlots>
void ConstrainedDelaunay2<EdgeSlots, FaceSlots>::constrain_halves(CgalVertex v, const Zone& zone) {
  for (const Face f : zone.new_) {
    if (f.handle->vertex(0) != v) continue;
    for (const CgalVertex end : zone.split_ends_) {
      if (f.handle->vertex(1) == end) f.handle->set_segment(2, zone.split_segment_);
      if (f.handle->vertex(2) == end) f.handle->set_segment(1, zone.split_segment_);
    }
  }
}

}  // namespace delref
