// SPDX-License-Identifier: GPL-3.0-or-later
//
// How `ConstrainedDelaunay2` finds and fills conflict zones. Included by constrained_delaunay_2.hpp alone.
#pragma once

#include <algorithm>

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
  return approach(p, found);
}

/// Makes sure that `p` is in the closure of `f`, which it is unless the line started outside its face by rounding; then goes on
/// from neighbour to neighbour. A point on a constraint is blocked by it.
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

/// Takes the neighbours in conflict, depth first, each from its entry edge in counterclockwise order: the boundary edges come out
/// in their order around the zone. The stack holds edges still to be crossed, named from inside.
template <int EdgeSlots, int FaceSlots>
void ConstrainedDelaunay2<EdgeSlots, FaceSlots>::grow(const typename Kernel::Point_2& p, Zone& zone) {
  while (!zone.stack_.empty()) {
    const Edge e = zone.stack_.back();
    zone.stack_.pop_back();
    const CgalFace n = e.face->neighbor(e.index);
    const int entry = n->index(e.face);
    if (e.face->segment(e.index) < 0 && !n->dying() && in_conflict(n, p)) {
      take(n, zone);
      zone.stack_.push_back({n, Cgal::cw(entry)});
      zone.stack_.push_back({n, Cgal::ccw(entry)});
    } else {
      zone.boundary_.push_back({n, entry});
      zone.regions_.push_back(e.face->region());
    }
  }
}

/// Both faces of `e` die, and so does `e`.
template <int EdgeSlots, int FaceSlots>
void ConstrainedDelaunay2<EdgeSlots, FaceSlots>::seed_split(Edge e, Zone& zone) {
  const Edge m = mirror(e);
  take(e.face, zone);
  take(m.face, zone);
  zone.split_ = e;
  zone.split_ends_[0] = source(e).handle;
  zone.split_ends_[1] = target(e).handle;
  zone.split_segment_ = e.face->segment(e.index);
  if (zone.split_segment_ >= 0) zone.dying_subsegments_.push_back(e);
  zone.stack_.push_back({m.face, Cgal::cw(m.index)});
  zone.stack_.push_back({m.face, Cgal::ccw(m.index)});
  zone.stack_.push_back({e.face, Cgal::cw(e.index)});
  zone.stack_.push_back({e.face, Cgal::ccw(e.index)});
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
  CgalFace f;
  if (const Where where = walk(p, hint.face, f); where.kind != Where::Kind::zone) return where;
  if (!in_conflict(f, p)) return {Where::Kind::degenerate, {}};
  take(f, zone);
  for (int i = 2; i >= 0; --i) zone.stack_.push_back({f, i});
  grow(p, zone);
  return {};
}

template <int EdgeSlots, int FaceSlots>
auto ConstrainedDelaunay2<EdgeSlots, FaceSlots>::conflict_zone(Point2 point, Edge e, std::span<const Vertex> vanishing, Zone& zone) -> Where {
  release(zone);
  const typename Kernel::Point_2 p = cgal_point(point);
  for (const CgalFace f : {e.face, mirror(e).face})
    for (int i = 0; i < 3; ++i)
      if (!cgal_.is_infinite(f->vertex(i)) && f->vertex(i)->point() == p) return {Where::Kind::on_vertex, {}};
  seed_split(e, zone);
  grow(p, zone);
  if (!is_star_shaped(p, zone)) return {Where::Kind::degenerate, {}};
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
  zone.boundary_.clear(), zone.regions_.clear();
  for (const Face f : zone.dying_)
    for (int i = 0; i < 3; ++i) {
      const Edge inner{f.handle, i}, outer = mirror(inner);
      if (!outer.face->dying()) zone.boundary_.push_back(outer), zone.regions_.push_back(f.handle->region());
      else if (is_constrained(inner) && !(inner == zone.split_) && !(outer == zone.split_)) return false;
    }
  return true;
}

/// Removes the vanishing vertices, which leaves the zone with the faces to be starred from `p`, and all others as new.
template <int EdgeSlots, int FaceSlots>
void ConstrainedDelaunay2<EdgeSlots, FaceSlots>::remove_vanishing(Point2 point, Zone& zone) {
  for (const Face f : zone.dying_) f.handle->set_dying(false);
  const std::vector<Edge> outline = zone.boundary_;
  const std::vector<std::int32_t> regions = zone.regions_;
  const std::vector<Vertex> gone = zone.vanishing_;
  const CgalVertex a = zone.split_ends_[0], b = zone.split_ends_[1];
  const std::int32_t segment = zone.split_segment_;
  std::vector<std::int32_t> names;
  for (const Edge& e : outline) names.push_back(e.face->segment(e.index));
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
  seed_split({f, i}, zone);
  grow(cgal_point(point), zone);
  for (const Face m : made)
    if (!m.handle->dying()) zone.new_.push_back(m);
}

template <int EdgeSlots, int FaceSlots>
auto ConstrainedDelaunay2<EdgeSlots, FaceSlots>::insert(Point2 p, Zone& zone) -> std::optional<Vertex> {
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
    f->forget();
    f->set_vertices(v, outer.face->vertex(Cgal::cw(outer.index)), outer.face->vertex(Cgal::ccw(outer.index)));
    f->set_region(zone.regions_[k]);
    f->set_segment(0, outer.face->segment(outer.index));
    for (std::size_t s = 0; s < std::size_t{EdgeSlots}; ++s)
      f->edge_slots[s][0] = outer.face->edge_slots[s][static_cast<std::size_t>(outer.index)];
    f->vertex(1)->set_face(f);
    zone.new_.push_back({f});
  }
  for (std::size_t k = 0; k < n; ++k) {  // in their order around the zone: the next one starts where this one ends
    const CgalFace f = zone.new_[old + k].handle;
    const Edge& outer = zone.boundary_[k];
    f->set_neighbors(outer.face, zone.new_[old + (k + 1) % n].handle, zone.new_[old + (k + n - 1) % n].handle);
    outer.face->set_neighbor(outer.index, f);
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
