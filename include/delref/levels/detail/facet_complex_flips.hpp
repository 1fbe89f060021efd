// SPDX-License-Identifier: GPL-3.0-or-later
//
// How `FacetComplex` finds points and changes its triangulations: walk, split, flip.
#pragma once

#include <cmath>

#include <delref/levels/facet_complex.hpp>

namespace delref {

template <class Tr>
auto FacetComplex<Tr>::locate(const Tr& tr, Id from, Point3 p) const -> Place {
  const PlaneFrame& frame = frame_of(from);
  const Point2 q = frame.project(p);
  Id at = from, before = none;
  // A walk between constraints may go in a circle where angles are extreme; the bound ends it, and the point is then not inserted.
  for (std::size_t steps = 0; steps < 16 + subfacets_.size(); ++steps) {
    int exit = -1;
    for (int i = 0; i < 3 && exit < 0; ++i) {
      const auto [a, b] = ends({at, i});
      const Id n = subfacets_[at].neighbours[place(i)];
      if (n != none && n == before) continue;
      if (orientation(project(tr, frame, a), project(tr, frame, b), q) < 0) exit = i;
    }
    if (exit < 0) return {at, std::nullopt};
    const Id next = subfacets_[at].neighbours[place(exit)];
    if (next == none) return {at, Side{at, exit}};
    before = at;
    at = next;
  }
  return {none, std::nullopt};
}

template <class Tr>
template <class F>
void FacetComplex<Tr>::split_subsegment(const Tr& tr, Vertex a, Vertex b, Vertex v, F&& removed, std::vector<Id>& created) {
  const auto k = SimplexTable<2>::key(tr.index(a), tr.index(b));
  created.clear();
  for (Id code = on_subsegments_.find(k); code != none; code = on_subsegments_.find(k)) {
    const Id t = code / 3;
    const int i = static_cast<int>(code % 3);
    removed(t);
    detach(tr, t);
    const std::array<Vertex, 3> c = subfacets_[t].corners;
    const Vertex top = c[place(i)], from = c[place(i + 1)], to = c[place(i + 2)];
    const Id across_from = subfacets_[t].neighbours[place(i + 1)];  // behind the edge top-to
    const Id across_to = subfacets_[t].neighbours[place(i + 2)];    // behind the edge top-from
    const Id u = allocate_part(t, {top, v, to});
    subfacets_[t].corners = {top, from, v};
    subfacets_[t].is_present = false;
    subfacets_[t].neighbours = {none, u, across_to};
    subfacets_[u].neighbours = {none, across_from, t};
    relink(across_from, t, u);
    attach(tr, t);
    attach(tr, u);
    created.push_back(t);
    created.push_back(u);
  }
  legalise(tr, v, removed, created);
}

template <class Tr>
template <class F>
void FacetComplex<Tr>::insert(const Tr& tr, Id t, Vertex v, F&& removed, std::vector<Id>& created) {
  created.clear();
  removed(t);
  detach(tr, t);
  const std::array<Vertex, 3> c = subfacets_[t].corners;
  const std::array<Id, 3> n = subfacets_[t].neighbours;
  const Id u = allocate_part(t, {v, c[1], c[2]}), w = allocate_part(t, {v, c[2], c[0]});
  subfacets_[t].corners = {v, c[0], c[1]};
  subfacets_[t].is_present = false;
  subfacets_[t].neighbours = {n[2], u, w};
  subfacets_[u].neighbours = {n[0], w, t};
  subfacets_[w].neighbours = {n[1], t, u};
  relink(n[0], t, u);
  relink(n[1], t, w);
  for (const Id id : {t, u, w}) {
    attach(tr, id);
    created.push_back(id);
  }
  legalise(tr, v, removed, created);
}

/// Whether the edge opposite to the new vertex is to be flipped: the corner behind it is inside the circle, or the new vertex is on the
/// edge or behind it by rounding; and both new triangles have an area.
template <class Tr>
bool FacetComplex<Tr>::is_illegal(const Tr& tr, Side s) const {
  const PlaneFrame& frame = frame_of(s.subfacet);
  const Id n = subfacets_[s.subfacet].neighbours[place(s.side)];
  const auto [va, vb] = ends(s);
  const Point2 p = project(tr, frame, subfacets_[s.subfacet].corners[place(s.side)]), a = project(tr, frame, va), b = project(tr, frame, vb);
  const Point2 d = project(tr, frame, subfacets_[n].corners[place(side_opposite(n, va, vb))]);
  if (orientation(p, a, b) > 0 && side_of_circle(p, a, b, d) <= 0) return false;
  return orientation(p, a, d) > 0 && orientation(p, d, b) > 0;
}

template <class Tr>
template <class F>
void FacetComplex<Tr>::legalise(const Tr& tr, Vertex v, F&& removed, std::vector<Id>& created) {
  stack_.assign(created.begin(), created.end());
  while (!stack_.empty()) {
    const Id t = stack_.back();
    int i = 0;
    while (i < 3 && !(subfacets_[t].corners[place(i)] == v)) ++i;
    const Id n = i < 3 ? subfacets_[t].neighbours[place(i)] : none;
    if (n == none || !is_illegal(tr, {t, i})) {
      stack_.pop_back();
      continue;
    }
    const bool is_new = std::ranges::find(created, n) != created.end();
    flip(tr, {t, i}, [&](Id id) {
      if (id == n && !is_new) removed(id);
    });
    if (!is_new) created.push_back(n);
    stack_.push_back(n);
  }
}

template <class Tr>
template <class F>
void FacetComplex<Tr>::flip(const Tr& tr, Side s, F&& removed) {
  const Id t = s.subfacet, n = subfacets_[t].neighbours[place(s.side)];
  removed(t);
  removed(n);
  detach(tr, t);
  detach(tr, n);
  const auto [a, b] = ends(s);
  const Vertex p = subfacets_[t].corners[place(s.side)];
  const int j = side_opposite(n, a, b);
  const Vertex d = subfacets_[n].corners[place(j)];
  // Around the quadrilateral p, a, d, b.
  const Id pa = subfacets_[t].neighbours[place(s.side + 2)], bp = subfacets_[t].neighbours[place(s.side + 1)];
  const Id ad = subfacets_[n].neighbours[place(j + 1)], db = subfacets_[n].neighbours[place(j + 2)];
  subfacets_[t].corners = {p, a, d};
  subfacets_[t].neighbours = {ad, n, pa};
  subfacets_[n].corners = {p, d, b};
  subfacets_[n].neighbours = {db, bp, t};
  subfacets_[t].is_present = subfacets_[n].is_present = false;
  relink(ad, n, t);
  relink(bp, t, n);
  attach(tr, t);
  attach(tr, n);
}

template <class Tr>
auto FacetComplex<Tr>::other_triangles(Side s) const -> std::array<std::array<Vertex, 3>, 2> {
  const Id n = subfacets_[s.subfacet].neighbours[place(s.side)];
  const auto [a, b] = ends(s);
  const Vertex p = subfacets_[s.subfacet].corners[place(s.side)], d = subfacets_[n].corners[place(side_opposite(n, a, b))];
  return {std::array{p, a, d}, std::array{p, d, b}};
}

template <class Tr>
bool FacetComplex<Tr>::is_convex(const Tr& tr, Side s) const {
  const PlaneFrame& frame = frame_of(s.subfacet);
  for (const auto& t : other_triangles(s))
    if (orientation(project(tr, frame, t[0]), project(tr, frame, t[1]), project(tr, frame, t[2])) <= 0) return false;
  return true;
}

template <class Tr>
auto FacetComplex<Tr>::tie(const Tr& tr, Side s) const -> std::optional<std::array<Id, 2>> {
  const Id n = subfacets_[s.subfacet].neighbours[place(s.side)];
  if (n == none) return std::nullopt;
  const PlaneFrame& frame = frame_of(s.subfacet);
  const auto [va, vb] = ends(s);
  const Point2 p = project(tr, frame, subfacets_[s.subfacet].corners[place(s.side)]), a = project(tr, frame, va), b = project(tr, frame, vb);
  const Point2 d = project(tr, frame, subfacets_[n].corners[place(side_opposite(n, va, vb))]);
  if (!is_convex(tr, s)) return std::nullopt;
  // Opposite angles of a quadrilateral on a circle add up to 180 degrees: the sine of their sum vanishes.
  const Vector2 u = a - p, v = b - p, w = a - d, x = b - d;
  const double c1 = dot(u, v), s1 = cross(u, v), c2 = dot(w, x), s2 = cross(x, w);
  const double sine = s1 * c2 + c1 * s2, scale = std::sqrt((c1 * c1 + s1 * s1) * (c2 * c2 + s2 * s2));
  if (std::abs(sine) > 1e-9 * scale) return std::nullopt;
  return std::array{s.subfacet, n};
}

}  // namespace delref
