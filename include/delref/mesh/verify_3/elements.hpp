// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which segments and facets each vertex of the mesh lies on, by the chains and the listed triangles.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include <delref/mesh/verify_3/facet_cover.hpp>

namespace delref::verification_3 {

/// An element is numbered by its side, or by its group after all sides.
class ElementsOfVertices {
 public:
  ElementsOfVertices(const Subject& s, const InputComplex& complex, const Chains& chains, const std::vector<Index>& group_of)
      : sides_(static_cast<Index>(complex.sides().size())) {
    std::vector<std::pair<Index, Index>> pairs;
    for (const EdgeEntry& e : chains.edges())
      if (complex.sides()[e.value].required)
        for (const Index v : {e.a, e.b}) pairs.push_back({v, e.value});
    for (std::size_t t = 0; t < s.mesh.triangles.size(); ++t)
      for (const Index v : s.mesh.triangles[t]) pairs.push_back({v, sides_ + group_of[t]});
    std::ranges::sort(pairs);
    pairs.erase(std::ranges::unique(pairs).begin(), pairs.end());
    begin_.assign(s.points.size() + 1, 0);
    for (const auto& [v, element] : pairs) {
      ++begin_[v + 1];
      elements_.push_back(element);
    }
    for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
    std::ranges::sort(pairs, {}, [](const auto& p) { return std::pair(p.second, p.first); });
    begin_of_element_.assign(sides_ + complex.groups().size() + 1, 0);
    for (const auto& [v, element] : pairs) {
      ++begin_of_element_[element + 1];
      vertices_.push_back(v);
    }
    for (std::size_t i = 1; i < begin_of_element_.size(); ++i) begin_of_element_[i] += begin_of_element_[i - 1];
  }

  /// Sorted: segments come first.
  std::span<const Index> operator[](Index vertex) const {
    return std::span(elements_).subspan(begin_[vertex], begin_[vertex + 1] - begin_[vertex]);
  }
  /// How many elements there are.
  std::size_t size() const { return begin_of_element_.size() - 1; }
  /// Where the vertices on an element are.
  std::vector<Point3> points_of(Index element, const std::vector<Point3>& points) const {
    std::vector<Point3> found;
    for (std::size_t k = begin_of_element_[element]; k < begin_of_element_[element + 1]; ++k) found.push_back(points[vertices_[k]]);
    return found;
  }
  bool is_side(Index element) const { return element < sides_; }
  Index group(Index element) const { return element - sides_; }
  Index of_group(Index group) const { return sides_ + group; }

 private:
  Index sides_;
  std::vector<std::size_t> begin_, begin_of_element_;
  std::vector<Index> elements_, vertices_;
};

}  // namespace delref::verification_3
