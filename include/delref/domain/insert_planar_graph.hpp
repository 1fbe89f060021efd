// SPDX-License-Identifier: GPL-3.0-or-later
//
// Puts the vertices and the segments of a planar straight line graph into a triangulation, with the vertices that an earlier
// refinement made, if there was one: the steps that building a domain and extending one have in common.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include <CGAL/hilbert_sort.h>

#include <delref/core/budget.hpp>
#include <delref/domain/bounding_box.hpp>
#include <delref/domain/planar_domain.hpp>

namespace delref {

namespace detail {

/// What CGAL's Hilbert sort asks of two points, given their indices; a stop request ends it.
struct IndexTraits {
  using Point_2 = std::size_t;
  template <double Point2::* coordinate>
  struct Less {
    const IndexTraits* traits;
    bool operator()(std::size_t i, std::size_t j) const {
      (*traits->check)();
      return traits->points[i].*coordinate < traits->points[j].*coordinate;
    }
  };
  using Less_x_2 = Less<&Point2::x>;
  using Less_y_2 = Less<&Point2::y>;
  Less_x_2 less_x_2_object() const { return {this}; }
  Less_y_2 less_y_2_object() const { return {this}; }

  std::span<const Point2> points;
  StopCheck* check;
};

/// The indices of the points, along a Hilbert curve. Throws `Interrupted`.
inline std::vector<std::size_t> along_hilbert_curve(std::span<const Point2> points, const Control& control) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  StopCheck check(control);
  CGAL::hilbert_sort(order.begin(), order.end(), IndexTraits{points, &check}, CGAL::Hilbert_sort_median_policy());
  return order;
}

}  // namespace detail

/// Inserts points that are all different into an empty triangulation, along a Hilbert curve; gives their vertices. The first
/// `input_count` are input vertices, of which point i has the number i and the carrier {0, i}; the others are numbered after
/// them, in their order, and lie inside the domain as far as their carrier says.
///
/// Four vertices of a box around them, at three times their extent, keep infinite faces away from every segment; they have the
/// carrier {2, none} and the provenance of input. Throws `Interrupted`.
template <class Tr>
std::vector<typename Tr::Vertex> insert_planar_points(Tr& tr, std::span<const Point2> points, std::size_t input_count,
                                                      const Control& control) {
  using Cgal = typename Tr::Cgal;
  using CgalPoint = typename Cgal::Point;
  const BoundingBox2 box = bounding_box(points);
  const std::vector<std::size_t> order = detail::along_hilbert_curve(points, control);
  const double margin = 3 * box.extent();
  std::vector<typename Tr::Vertex> corners;
  for (const CgalPoint& corner :
       {CgalPoint(box.low.x - margin, box.low.y - margin), CgalPoint(box.high.x + margin, box.low.y - margin),
        CgalPoint(box.high.x + margin, box.high.y + margin), CgalPoint(box.low.x - margin, box.high.y + margin)})
    corners.push_back({tr.cgal().insert(corner)});
  std::vector<typename Tr::Vertex> vertices(points.size());
  typename Tr::CgalFace near{};
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (k % 4096 == 0) throw_if_stopped(control);
    const Point2 p = points[order[k]];
    vertices[order[k]] = {tr.cgal().insert(CgalPoint(p.x, p.y), near)};
    near = vertices[order[k]].handle->face();
  }
  constexpr Carrier inside{2, Carrier::none};
  const auto number = [&](typename Tr::Vertex v, Carrier carrier) {
    v.handle->index = tr.take_index();
    tr.set_origin(v, carrier, input_level);
  };
  for (std::size_t i = 0; i < input_count; ++i) number(vertices[i], {0, static_cast<std::uint32_t>(i)});
  for (const auto v : corners) number(v, inside);
  for (std::size_t i = input_count; i < points.size(); ++i) number(vertices[i], inside);
  return vertices;
}

/// Constrains the edges between each two successive vertices of a chain, which run through any vertices in between that are
/// exactly on them. Throws CGAL's exception when a constraint is crossed.
template <class Tr>
void insert_planar_chain(Tr& tr, std::span<const typename Tr::Vertex> chain) {
  for (std::size_t k = 1; k < chain.size(); ++k) tr.cgal().insert_constraint(chain[k - 1].handle, chain[k].handle);
}

/// Names the constrained edges of a chain from one input vertex to another, whose interior vertices are Steiner vertices on the
/// graph's segment `original`: the domain gets a segment for each two successive input vertices on it, and the Steiner vertices
/// that segment as carrier. False, with some of it done, where an edge or a Steiner vertex is of another segment already.
template <class Tr>
bool name_planar_chain(Tr& tr, PlanarDomain& domain, std::span<const typename Tr::Vertex> chain, Pslg::Index original) {
  constexpr auto unnamed = std::numeric_limits<std::int32_t>::max();
  typename Tr::Vertex from = chain.front();
  domain.segments.push_back({{tr.carrier(from).index, 0}, original, {}, {}, false});
  for (std::size_t k = 1; k < chain.size(); ++k) {
    while (!(from == chain[k])) {
      typename Tr::CgalVertex next;
      typename Tr::CgalFace f;
      int i = 0;
      if (!tr.cgal().includes_edge(from.handle, chain[k].handle, next, f, i) || f->segment(i) != unnamed) return false;
      tr.set_segment(typename Tr::Edge{f, i}, domain.segments.size() - 1);
      from = {next};
      const Carrier carrier = tr.carrier(from);
      if (carrier.dimension == 0) {
        domain.segments.back().ends[1] = carrier.index;
        if (!(from == chain.back())) domain.segments.push_back({{carrier.index, 0}, original, {}, {}, false});
      } else {
        if (carrier.dimension == 1) return false;
        tr.set_origin(from, {1, static_cast<std::uint32_t>(domain.segments.size() - 1)}, tr.provenance(from));
      }
    }
  }
  return true;
}

}  // namespace delref
