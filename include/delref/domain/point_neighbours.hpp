// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the nearest neighbours of points tell: how far apart points are, and which groups they fall into.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/property_map.h>

#include <delref/core/budget.hpp>
#include <delref/core/point.hpp>
#include <delref/domain/disjoint_sets.hpp>

namespace delref {

/// How far the points of a set are from their neighbours, and what they hang together in.
struct PointNeighbours {
  /// For each point the mean distance to its nearest points, at most six.
  std::vector<double> distance;
  /// The points that are joined by steps from a point to one of its nearest.
  DisjointSets groups;
};

namespace detail {

using SpatialKernel = CGAL::Exact_predicates_inexact_constructions_kernel;

inline SpatialKernel::Point_3 to_cgal_point(Point3 p) { return {p.x, p.y, p.z}; }

}  // namespace detail

/// Looks for the `count` nearest neighbours of each point. O(n log n) where points are not much denser in one place than in another.
/// Requires different finite points. Throws `Interrupted` when the control says stop.
inline PointNeighbours point_neighbours(std::span<const Point3> points, std::size_t count, const Control& control) {
  using Base = CGAL::Search_traits_3<detail::SpatialKernel>;
  using Place = CGAL::Pointer_property_map<detail::SpatialKernel::Point_3>::type;
  using Traits = CGAL::Search_traits_adapter<std::size_t, Place, Base>;
  using Search = CGAL::Orthogonal_k_neighbor_search<Traits>;
  using Tree = Search::Tree;

  std::vector<detail::SpatialKernel::Point_3> places;
  std::vector<std::size_t> numbers;
  for (const Point3 p : points) {
    numbers.push_back(places.size());
    places.push_back(detail::to_cgal_point(p));
  }
  const Place place(places.data());
  Tree tree(numbers.begin(), numbers.end(), Tree::Splitter(), Traits(place));
  const Search::Distance metric(place);
  PointNeighbours out{std::vector<double>(points.size()), DisjointSets(points.size())};
  for (std::size_t i = 0; i != points.size(); ++i) {
    if (i % 4096 == 0) throw_if_stopped(control);
    Search search(tree, places[i], static_cast<unsigned>(count + 1), 0, true, metric);
    std::size_t near = 0;
    for (const auto& [j, squared] : search) {
      if (j == i) continue;
      if (near < 6) out.distance[i] += std::sqrt(squared), ++near;
      out.groups.unite(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j));
    }
    out.distance[i] /= static_cast<double>(std::max<std::size_t>(near, 1));
  }
  return out;
}

}  // namespace delref
