// SPDX-License-Identifier: GPL-3.0-or-later
//
// Regions of cells while a facet has a gap. A cell that is made when a subfacet was destroyed may reach to both sides of its facet:
// its region is unsure until the facet is whole again, and then what the facets and the cells around it say.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include <delref/domain/polyhedral_domain.hpp>
#include <delref/triangulation/spatial_concept.hpp>

namespace delref {

/// The cells of `Tr` whose region is unsure. Shared by the facets level, which finds and settles them, and the levels that look at
/// cells of the domain, which take those that were settled.
template <SpatialTriangulation Tr>
class RegionRepair {
  using Cell = typename Tr::Cell;

 public:
  /// Whether a cell may be on both sides of a facet. Its region number tells so, and which region it was thought to be in.
  static bool is_unsure(const Tr& tr, Cell c) { return tr.region(c) <= unsure_from; }

  void add(Tr& tr, Cell c) {
    if (is_unsure(tr, c) || tr.is_infinite(c)) return;
    tr.set_region(c, unsure_from - 1 - tr.region(c));
    cells_.push_back(c);
  }
  bool empty() const { return cells_.empty(); }
  /// Cells are about to die: they are forgotten. True when one of them was unsure.
  bool remove(Tr& tr, std::span<const Cell> dying) {
    bool found = false;
    for (const Cell c : dying)
      if (is_unsure(tr, c)) {
        tr.set_region(c, thought(tr, c));
        found = true;
      }
    if (found) std::erase_if(cells_, [&](Cell c) { return !is_unsure(tr, c); });
    return found;
  }

  /// A cell with so little volume that rounding may have put it on either side of a facet.
  static bool is_flat(const Tr& tr, Cell c) {
    if (tr.is_infinite(c)) return false;
    const auto v = tr.vertices(c);
    const Point3 o = tr.point(v[0]);
    const Vector3 a = tr.point(v[1]) - o, b = tr.point(v[2]) - o, d = tr.point(v[3]) - o;
    const double volume = dot(a, cross(b, d)), longest = std::max({squared_length(a), squared_length(b), squared_length(d)});
    double rounding = 0;
    for (const auto w : v) rounding = std::max(rounding, 8 * rounding_near(tr.point(w)) * longest);
    return volume * volume <= std::max(1e-18 * squared_length(a) * squared_length(b) * squared_length(d), rounding * rounding);
  }

  /// To be called when no facet has a gap: unsure cells, and the flat ones that they are connected to, take the region that most of the
  /// area around them says. `beside(f)` is the region at a marked facet, on the side of its cell. The settled cells are listed until
  /// the next call of `settle` or `forget`.
  template <class Beside>
  void settle(Tr& tr, Beside&& beside) {
    settled_.clear();
    for (const Cell first : cells_) {
      if (!is_unsure(tr, first)) continue;  // it was settled with another
      group_.clear();
      votes_.clear();
      visit(tr, first);
      for (std::size_t k = 0; k < group_.size(); ++k)
        for (int i = 0; i < 4; ++i) {
          const auto f = tr.facet(group_[k], i);
          if (tr.is_marked(f)) {
            vote(tr, beside(f), f);
            continue;
          }
          const Cell next = tr.cell(tr.mirror(f));
          if (tr.region(next) == visited) continue;
          if (is_unsure(tr, next) || is_flat(tr, next)) visit(tr, next);
          else vote(tr, tr.region(next), f);
        }
      const int region = votes_.empty() ? -1 : std::ranges::max_element(votes_, {}, &Vote::area)->region;
      for (const Cell c : group_) tr.set_region(c, region);
      settled_.insert(settled_.end(), group_.begin(), group_.end());
    }
    cells_.clear();
  }
  /// A cell whose region was changed otherwise.
  void add_settled(Cell c) { settled_.push_back(c); }
  const std::vector<Cell>& settled() const { return settled_; }
  void forget() { settled_.clear(); }

  /// Whether the tetrahedron proposed for last is too large: what its point encroaches is then to be refined in any case.
  bool is_for_size() const { return is_for_size_; }
  void set_for_size(bool is_for_size) { is_for_size_ = is_for_size; }

 private:
  static constexpr int visited = -3, unsure_from = -10;
  struct Vote {
    int region = -1;
    double area = 0;
  };

  static int thought(const Tr& tr, Cell c) { return is_unsure(tr, c) ? unsure_from - 1 - tr.region(c) : tr.region(c); }
  void visit(Tr& tr, Cell c) {
    tr.set_region(c, visited);
    group_.push_back(c);
  }
  void vote(const Tr& tr, int region, const typename Tr::Facet& f) {
    auto vote = std::ranges::find(votes_, region, &Vote::region);
    if (vote == votes_.end()) vote = votes_.insert(vote, {region, 0});
    const auto [a, b, c] = tr.vertices(f);
    vote->area += std::sqrt(squared_length(cross(tr.point(b) - tr.point(a), tr.point(c) - tr.point(a))));
  }

  std::vector<Vote> votes_;
  bool is_for_size_ = true;
  std::vector<Cell> cells_, settled_, group_;
};

}  // namespace delref
