// SPDX-License-Identifier: GPL-3.0-or-later
//
// The Delaunay triangulation of the vertices of a domain in space, from which refinement starts.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/spatial_sort.h>

#include <delref/core/budget.hpp>
#include <delref/domain/polyhedral_domain.hpp>

namespace delref {

/// Inserts the points of a domain, all different, into an empty triangulation, in an order that keeps near points near in memory.
/// Gives the vertex of each, which has the point's number and carrier. Throws `Interrupted` when the control says stop.
template <class Tr>
std::vector<typename Tr::Vertex> insert_input_points(Tr& tr, const PolyhedralDomain& domain, const Control& control) {
  using CgalPoint = typename Tr::Cgal::Point;
  std::vector<CgalPoint> points;
  points.reserve(domain.points.size());
  for (const Point3 p : domain.points) points.emplace_back(p.x, p.y, p.z);
  std::vector<std::ptrdiff_t> order(points.size());
  std::iota(order.begin(), order.end(), std::ptrdiff_t{0});
  using Traits = CGAL::Spatial_sort_traits_adapter_3<typename Tr::Cgal::Geom_traits, const CgalPoint*>;
  CGAL::spatial_sort(order.begin(), order.end(), Traits(points.data()));

  std::vector<typename Tr::Vertex> vertices(points.size());
  typename Tr::CgalCell hint{};
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (k % 4096 == 0) throw_if_stopped(control);
    const auto i = static_cast<std::size_t>(order[k]);
    const auto v = tr.cgal().insert(points[i], hint);
    hint = v->cell();
    v->index = static_cast<std::uint32_t>(i);
    v->carrier = {0, v->index};
    vertices[i] = {v};
  }
  tr.number_from(points.size());
  return vertices;
}

}  // namespace delref
