// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where input elements meet under 90 degrees, which may force large radius-edge ratios (Shewchuk 1998): segments and facets at a
// vertex, facets at a segment. Measured on the mesh, whose triangles show which way each facet goes from there.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <delref/mesh/verify/nearest_point.hpp>
#include <delref/mesh/verify_3/elements.hpp>

namespace delref::verification_3 {

inline constexpr double small_angle_degrees = 90 - 1e-6;

class SmallAngles {
 public:
  SmallAngles(const Subject& s, const InputComplex& complex, const Chains& chains, const std::vector<Index>& group_of,
              const ElementsOfVertices& elements)
      : s_(s), complex_(complex), chains_(chains), group_of_(group_of), elements_(elements), vertices_on_(elements.size()), places_({}) {
    std::vector<Point3> places;
    facets_at_segments(places);
    elements_at_vertices(places);
    std::ranges::sort(pairs_);
    pairs_.erase(std::ranges::unique(pairs_).begin(), pairs_.end());
    places_ = verification::NearestPoint<Point3>(std::move(places));
  }

  /// Whether a small input angle may force the shape of a tetrahedron: a corner of it is within twice its longest edge of the place of
  /// such an angle, or lies on one of the two elements that make one and is within that distance of a vertex on the other.
  bool excuse(std::size_t tetrahedron) {
    const double reach = 2 * s_.shape(tetrahedron).longest_edge();
    const auto& corners = s_.mesh.tetrahedra[tetrahedron];
    for (const Index v : corners)
      if (places_.squared_distance_from(s_.points[v]) <= reach * reach) return true;
    return std::ranges::any_of(corners, [&](Index v) { return is_beside_other(v, reach); });
  }

 private:
  using Pair = std::pair<Index, Index>;

  bool is_beside_other(Index v, double reach) {
    for (const Index e : elements_[v])
      for (const auto& [first, other] : std::ranges::equal_range(pairs_, e, {}, &Pair::first))
        if (vertices_on(other).squared_distance_from(s_.points[v]) <= reach * reach) return true;
    return false;
  }
  const verification::NearestPoint<Point3>& vertices_on(Index element) {
    auto& found = vertices_on_[element];
    if (!found) found.emplace(elements_.points_of(element, s_.points));
    return *found;
  }
  void meet(Index e, Index f) {
    pairs_.push_back({e, f});
    pairs_.push_back({f, e});
  }

  /// The part of a vector that is orthogonal to an axis.
  static Vector3 across(Vector3 v, Vector3 axis) { return v - (dot(v, axis) / squared_length(axis)) * axis; }

  void facets_at_segments(std::vector<Point3>& places) {
    std::vector<std::pair<Vector3, Index>> leaves;
    for_each_edge(edges_of_triangles(s_.mesh.triangles), [&](std::span<const EdgeEntry> run) {
      if (run.size() < 2) return;
      const Index a = run[0].a, b = run[0].b;
      leaves.clear();
      for (const EdgeEntry& e : run)
        for (const Index v : s_.mesh.triangles[e.value])
          if (v != a && v != b)
            leaves.push_back({across(s_.points[v] - s_.points[a], s_.points[b] - s_.points[a]), group_of_[e.value]});
      bool is_small = false;
      for (std::size_t i = 0; i < leaves.size(); ++i)
        for (std::size_t j = i + 1; j < leaves.size(); ++j) {
          if (leaves[i].second == leaves[j].second || angle_degrees(leaves[i].first, leaves[j].first) >= small_angle_degrees)
            continue;
          is_small = true;
          meet(elements_.of_group(leaves[i].second), elements_.of_group(leaves[j].second));
        }
      if (is_small)
        for (const double step : {0.0, 0.25, 0.5, 0.75, 1.0})
          places.push_back(s_.points[a] + step * (s_.points[b] - s_.points[a]));
    });
  }

  /// The angle between a direction and the corner of a triangle.
  static double angle_to_corner(Vector3 direction, Vector3 u, Vector3 v) {
    const Vector3 normal = cross(u, v), foot = across(direction, normal);
    const bool above = dot(cross(u, foot), normal) >= 0 && dot(cross(foot, v), normal) >= 0;
    const double to_sides = std::min(angle_degrees(direction, u), angle_degrees(direction, v));
    return above && squared_length(foot) > 0 ? std::min(to_sides, angle_degrees(direction, foot)) : to_sides;
  }

  /// Segments that meet each other, or a facet that they are not in, at an input vertex.
  void elements_at_vertices(std::vector<Point3>& places) {
    struct Spoke {
      Index vertex, side;
      Vector3 direction;
    };
    std::vector<Spoke> spokes;
    for (Index i = 0; i < complex_.sides().size(); ++i) {
      const auto chain = chains_.chain(i);
      if (!complex_.sides()[i].required || chain.empty()) continue;
      const Vector3 d = s_.points[chain.back()] - s_.points[chain.front()];
      spokes.push_back({chain.front(), i, d});
      spokes.push_back({chain.back(), i, Vector3{} - d});
    }
    std::ranges::sort(spokes, {}, [](const Spoke& p) { return std::pair(p.vertex, p.side); });
    const auto at = [&](Index v) { return std::ranges::equal_range(spokes, v, {}, &Spoke::vertex); };
    for (const Spoke& p : spokes)
      for (const Spoke& q : at(p.vertex))
        if (p.side < q.side && angle_degrees(p.direction, q.direction) < small_angle_degrees) {
          meet(p.side, q.side);
          places.push_back(s_.points[p.vertex]);
        }
    for (std::size_t t = 0; t < s_.mesh.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto& triangle = s_.mesh.triangles[t];
        const Index v = triangle[k];
        if (chains_.input_of_vertex(v) == none) continue;
        for (const Spoke& p : at(v)) {
          const Vector3 u = s_.points[triangle[(k + 1) % 3]] - s_.points[v], w = s_.points[triangle[(k + 2) % 3]] - s_.points[v];
          if (lies_in(p.side, group_of_[t]) || angle_to_corner(p.direction, u, w) >= small_angle_degrees) continue;
          meet(p.side, elements_.of_group(group_of_[t]));
          places.push_back(s_.points[v]);
        }
      }
  }
  bool lies_in(Index side, Index group) const {
    return std::ranges::any_of(complex_.sides()[side].facets, [&](Index f) { return complex_.group_of(f) == group; });
  }

  const Subject& s_;
  const InputComplex& complex_;
  const Chains& chains_;
  const std::vector<Index>& group_of_;
  const ElementsOfVertices& elements_;
  std::vector<Pair> pairs_;  // each both ways round
  std::vector<std::optional<verification::NearestPoint<Point3>>> vertices_on_;  // by element, made when asked for
  verification::NearestPoint<Point3> places_;
};

}  // namespace delref::verification_3
