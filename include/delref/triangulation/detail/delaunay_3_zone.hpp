// SPDX-License-Identifier: GPL-3.0-or-later
//
// How `Delaunay3` finds and fills conflict zones. The hole of a point is starred from its walls: each wall becomes a cell, and two
// cells are neighbours where their walls share an edge, which a short list per corner of the hole finds.
#pragma once

#include <delref/triangulation/delaunay_3.hpp>

namespace delref {

/// A face around the hole, with what the cell that is built on it takes over.
template <int CellSlots, int FacetSlots>
struct Delaunay3<CellSlots, FacetSlots>::Zone::Wall {
  CgalCell outside;                      ///< the surviving cell behind it
  int index = 0;                         ///< and the face's number there
  std::array<CgalVertex, 3> corners{};   ///< such that (corners, p) is positively oriented
  std::array<bool, 3> marked_edges{};    ///< the edge opposite to each corner
  bool marked = false;
  int region = -1;
  CgalCell cell{};                       ///< the new one
};

/// A side of a wall, in the list of one of its ends.
template <int CellSlots, int FacetSlots>
struct Delaunay3<CellSlots, FacetSlots>::Zone::Link {
  std::int32_t other_end = 0, wall = 0, next = -1;
  int side = 0;
};

template <int CellSlots, int FacetSlots>
bool Delaunay3<CellSlots, FacetSlots>::is_simplex(std::span<const Vertex> v) const {
  CgalCell c;
  int i = 0, j = 0, k = 0, l = 0;
  if (v.size() == 2) return cgal_.is_edge(v[0].handle, v[1].handle, c, i, j);
  if (v.size() == 3) return cgal_.is_facet(v[0].handle, v[1].handle, v[2].handle, c, i, j, k);
  return v.size() == 4 && cgal_.is_cell(v[0].handle, v[1].handle, v[2].handle, v[3].handle, c, i, j, k, l);
}

/// A visibility walk; ends in an infinite cell when `p` is outside the hull. In a Delaunay triangulation it comes to no cell twice (Edelsbrunner 1990), so it needs no chance.
template <int CellSlots, int FacetSlots>
auto Delaunay3<CellSlots, FacetSlots>::walk(const CgalPoint& p, CgalCell start, CgalCell& found) const -> Where {
  const auto orientation = cgal_.geom_traits().orientation_3_object();
  CgalCell c = start, from{};
  int infinite = 0;
  if (c->has_vertex(cgal_.infinite_vertex(), infinite)) c = c->neighbor(infinite);
  while (true) {
    bool moved = false;
    for (int i = 0; i < 4 && !moved; ++i) {
      const CgalCell next = c->neighbor(i);
      if (next == from) continue;
      const auto& q = [&](int k) -> const CgalPoint& { return k == i ? p : c->vertex(k)->point(); };
      if (orientation(q(0), q(1), q(2), q(3)) != CGAL::NEGATIVE) continue;
      if (cgal_.is_infinite(next)) {
        found = next;
        return {Where::Kind::outside, {}};
      }
      from = c;
      c = next;
      moved = true;
    }
    if (moved) continue;
    found = c;
    for (int i = 0; i < 4; ++i)
      if (c->vertex(i)->point() == p) return {Where::Kind::on_vertex, {}};
    return {Where::Kind::zone, {}};
  }
}

/// False when `p` is a vertex. No cell next to a vertex may be asked whether it is in conflict with it: perturbation cannot tell
/// equal points apart.
template <int CellSlots, int FacetSlots>
bool Delaunay3<CellSlots, FacetSlots>::grow(const CgalPoint& p, CgalCell start, Zone& zone, bool up_to_marks) {
  // What is looked at next lies anywhere in memory: asked for as soon as it is known, it is there in time.
  const auto die = [&zone](CgalCell c) {
    c->set_dying(true);
    for (int i = 0; i < 4; ++i) {
      const auto* n = reinterpret_cast<const char*>(&*c->neighbor(i));
      __builtin_prefetch(n), __builtin_prefetch(n + 64);
    }
    zone.dying_.push_back({c});
  };
  die(start);
  for (std::size_t k = 0; k < zone.dying_.size(); ++k) {
    const CgalCell c = zone.dying_[k].handle;
    if (k + 1 < zone.dying_.size()) {
      const CgalCell next = zone.dying_[k + 1].handle;
      for (int i = 0; i < 4; ++i) {
        const CgalCell n = next->neighbor(i);
        if (!n->dying()) __builtin_prefetch(&*n->vertex(n->index(next)));
      }
    }
    for (int i = 0; i < 4; ++i) {
      const CgalCell n = c->neighbor(i);
      if (n->dying()) continue;
      if (!n->surviving()) {
        if (is_at(n->vertex(n->index(c)), p)) return clear_surviving(zone), false;
        if (in_conflict(n, p)) {
          if (up_to_marks && c->is_face_marked(i)) {
            n->set_dying(true);
            zone.behind_.push_back({n});
          } else {
            die(n);
          }
          continue;
        }
        n->set_surviving(true);
      }
      zone.boundary_.push_back({n, n->index(c)});
    }
  }
  for (std::size_t k = 0; k < zone.behind_.size(); ++k) {
    const CgalCell c = zone.behind_[k].handle;
    for (int i = 0; i < 4; ++i) {
      const CgalCell n = c->neighbor(i);
      if (n->dying()) continue;
      if (!n->surviving() && zone.behind_.size() < enough_behind_marks) {
        if (is_at(n->vertex(n->index(c)), p)) return clear_surviving(zone), false;
        if (in_conflict(n, p)) {
          n->set_dying(true);
          zone.behind_.push_back({n});
          continue;
        }
      }
      zone.boundary_.push_back({n, n->index(c)});
    }
  }
  clear_surviving(zone);
  zone.dying_.insert(zone.dying_.end(), zone.behind_.begin(), zone.behind_.end());
  return true;
}

template <int CellSlots, int FacetSlots>
auto Delaunay3<CellSlots, FacetSlots>::conflict_zone(Point3 point, const Hint& hint, Zone& zone, bool up_to_marks) -> Where {
  release(zone);
  const CgalPoint p(point.x, point.y, point.z);
  CgalCell start = hint.cell;
  if (has_corner_at(start, p)) return {Where::Kind::on_vertex, {}};
  if (!in_conflict(start, p)) {
    const Where where = walk(p, hint.cell, start);
    if (where.kind == Where::Kind::on_vertex) return where;
    if (!in_conflict(start, p)) return {Where::Kind::degenerate, {}};
  }
  if (!grow(p, start, zone, up_to_marks)) {
    release(zone);
    return {Where::Kind::on_vertex, {}};
  }
  return {Where::Kind::zone, {}};
}

/// Notes what the faces around the hole are, and numbers its corners.
template <int CellSlots, int FacetSlots>
void Delaunay3<CellSlots, FacetSlots>::build_walls(Zone& zone) {
  zone.walls_.clear(), zone.corners_.clear();
  for (const Facet f : zone.boundary_) {
    typename Zone::Wall wall;
    wall.outside = f.cell;
    wall.index = f.index;
    const CgalCell inside = f.cell->neighbor(f.index);
    wall.region = inside->region();
    wall.marked = f.cell->is_face_marked(f.index);
    for (int i = 0; i < 3; ++i) {
      // Seen from outside the face turns the other way round.
      const int j = Cgal::vertex_triple_index(f.index, 2 - i);
      const CgalVertex v = f.cell->vertex(j);
      wall.corners[static_cast<std::size_t>(i)] = v;
      const int a = Cgal::vertex_triple_index(f.index, (3 - i) % 3), b = Cgal::vertex_triple_index(f.index, (4 - i) % 3);
      wall.marked_edges[static_cast<std::size_t>(i)] = f.cell->is_edge_marked(a, b);
      if (v->number_in_hole < 0) {
        v->number_in_hole = static_cast<std::int32_t>(zone.corners_.size());
        zone.corners_.push_back(v);
      }
    }
    zone.walls_.push_back(wall);
  }
}

/// Makes the cells of two walls neighbours when the second of them comes.
template <int CellSlots, int FacetSlots>
void Delaunay3<CellSlots, FacetSlots>::link(Zone& zone, std::size_t wall, int side) {
  const auto& w = zone.walls_[wall];
  std::int32_t a = w.corners[static_cast<std::size_t>((side + 1) % 3)]->number_in_hole;
  std::int32_t b = w.corners[static_cast<std::size_t>((side + 2) % 3)]->number_in_hole;
  if (a > b) std::swap(a, b);
  std::int32_t* at = &zone.first_link_[static_cast<std::size_t>(a)];
  for (; *at >= 0; at = &zone.links_[static_cast<std::size_t>(*at)].next) {
    const typename Zone::Link& l = zone.links_[static_cast<std::size_t>(*at)];
    if (l.other_end != b) continue;
    const CgalCell other = zone.walls_[static_cast<std::size_t>(l.wall)].cell;
    w.cell->set_neighbor(side, other);
    other->set_neighbor(l.side, w.cell);
    *at = l.next;
    return;
  }
  *at = static_cast<std::int32_t>(zone.links_.size());
  zone.links_.push_back({b, static_cast<std::int32_t>(wall), -1, side});
}

template <int CellSlots, int FacetSlots>
auto Delaunay3<CellSlots, FacetSlots>::insert(Point3 point, Zone& zone) -> Vertex {
  auto& tds = cgal_.tds();
  build_walls(zone);
  for (const Cell c : zone.dying_) tds.delete_cell(c.handle);
  const CgalVertex v = tds.create_vertex();
  v->set_point(CgalPoint(point.x, point.y, point.z));
  v->index = next_index_++;

  zone.links_.clear();
  zone.first_link_.assign(zone.corners_.size(), -1);
  zone.new_.clear();
  for (std::size_t k = 0; k < zone.walls_.size(); ++k) {
    auto& w = zone.walls_[k];
    w.cell = tds.create_cell(w.corners[0], w.corners[1], w.corners[2], v);
    w.cell->forget();
    w.cell->set_region(w.region);
    w.cell->mark_face(3, w.marked);
    w.cell->share_facet_slots(3, *w.outside, w.index);
    for (int i = 0; i < 3; ++i) {
      w.cell->mark_edge((i + 1) % 3, (i + 2) % 3, w.marked_edges[static_cast<std::size_t>(i)]);
      w.corners[static_cast<std::size_t>(i)]->set_cell(w.cell);
    }
    w.cell->set_neighbor(3, w.outside);
    w.outside->set_neighbor(w.index, w.cell);
    for (int side = 0; side < 3; ++side) link(zone, k, side);
    zone.new_.push_back({w.cell});
  }
  v->set_cell(zone.walls_.front().cell);
  for (const CgalVertex corner : zone.corners_) corner->number_in_hole = -1;
  zone.dying_.clear();
  zone.boundary_.clear();
  return {v};
}

}  // namespace delref
