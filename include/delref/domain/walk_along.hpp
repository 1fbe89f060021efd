// SPDX-License-Identifier: GPL-3.0-or-later
//
// The vertices next to a straight line through a triangulation.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <delref/core/point.hpp>

namespace delref {

/// The vertices of all finite faces of `tr` that the segment from `from` to `to` meets, but for its ends: among them are those that
/// lie on it or next to it. In the order of their numbers. Takes time in proportion to the faces.
template <class Tr>
std::vector<typename Tr::Vertex> vertices_along(Tr& tr, typename Tr::Vertex from, typename Tr::Vertex to) {
  using CgalFace = typename Tr::CgalFace;
  const Point2 a = tr.point(from);
  const Vector2 along = tr.point(to) - a;
  const double length = std::sqrt(squared_length(along)), slack = 1e-14 * (length + std::abs(a.x) + std::abs(a.y));
  const auto meets_edge = [&](Point2 p, Point2 q) {
    const double side_p = cross(along, p - a) / length, side_q = cross(along, q - a) / length;
    if (std::min(side_p, side_q) > slack || std::max(side_p, side_q) < -slack) return false;
    const double p_at = dot(along, p - a) / length, q_at = dot(along, q - a) / length;
    return std::max(p_at, q_at) >= -slack && std::min(p_at, q_at) <= length + slack;
  };
  std::vector<CgalFace> faces;
  const auto take = [&](CgalFace f) {
    if (f->dying() || tr.cgal().is_infinite(f)) return;
    f->set_dying(true);
    faces.push_back(f);
  };
  auto around = tr.cgal().incident_faces(from.handle);
  const auto first = around;
  do take(around);
  while (++around != first);
  for (std::size_t k = 0; k < faces.size(); ++k)
    for (int i = 0; i < 3; ++i) {
      const typename Tr::Edge e{faces[k], i};
      if (meets_edge(tr.point(tr.source(e)), tr.point(tr.target(e)))) take(faces[k]->neighbor(i));
    }
  std::vector<typename Tr::Vertex> found;
  for (const CgalFace f : faces) {
    f->set_dying(false);
    for (int i = 0; i < 3; ++i)
      if (const typename Tr::Vertex v{f->vertex(i)}; !(v == from) && !(v == to)) found.push_back(v);
  }
  std::ranges::sort(found, {}, [&](typename Tr::Vertex v) { return tr.index(v); });
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace delref
