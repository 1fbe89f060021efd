// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which edges of a mesh are as short as an input angle under 90 degrees makes them: those between two input elements that meet at
// such an angle. Refining next to them would go on for ever (Shewchuk 1998, section 4; Shewchuk and Si 2014).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <delref/core/carrier.hpp>
#include <delref/core/point.hpp>
#include <delref/domain/polyhedral_domain.hpp>
#include <delref/domain/thin_places.hpp>
#include <delref/triangulation/simplex_table.hpp>

namespace delref {

/// The pairs of input elements of a domain that meet under less than 90 degrees, found by the elements that two vertices lie on. The
/// domain must outlive it.
class SmallAngleGuard {
 public:
  using Index = PolyhedralDomain::Index;

  explicit SmallAngleGuard(const PolyhedralDomain& domain) : domain_(&domain), thin_places_(domain) {
    for (const PolyhedralDomain::SmallAngle& angle : domain.small_angles) {
      using Kind = PolyhedralDomain::SmallAngle::Kind;
      const bool first_is_facet = angle.kind == Kind::facets, second_is_facet = angle.kind != Kind::segments;
      pairs_.set(key(angle.elements[0], first_is_facet, angle.elements[1], second_is_facet), 1);
    }
    collect_incidence(domain);
  }

  const ThinPlaces& thin_places() const { return thin_places_; }
  /// Whether two vertices lie on two input elements that meet under a small angle.
  bool meet(Carrier a, Carrier b) const {
    if (a == b || std::max(a.dimension, b.dimension) == 3) return false;
    if (a.dimension == 1 && b.dimension == 1 && meet_sharply(a.index, b.index)) return true;
    if (pairs_.size() == 0) return false;
    for (const Element x : elements_of(a))
      for (const Element y : elements_of(b))
        if (pairs_.find(SimplexTable<2>::key(x, y)) != SimplexTable<2>::none) return true;
    return false;
  }

 private:
  using Element = std::uint32_t;  // twice the index, plus one for a facet
  static Element element(Index i, bool is_facet) { return 2 * i + (is_facet ? 1 : 0); }
  static SimplexTable<2>::Key key(Index i, bool i_is_facet, Index j, bool j_is_facet) {
    return SimplexTable<2>::key(element(i, i_is_facet), element(j, j_is_facet));
  }

  /// Whether two segments share an end, under less than 90 degrees. Those between coplanar facets count: they are kept apart too.
  bool meet_sharply(Index s, Index t) const {
    const auto &a = domain_->segments[s].ends, &b = domain_->segments[t].ends;
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t j = 0; j < 2; ++j) {
        if (a[i] != b[j]) continue;
        const Point3 corner = domain_->points[a[i]];
        const Vector3 u = domain_->points[a[1 - i]] - corner, v = domain_->points[b[1 - j]] - corner;
        const double d = dot(u, v);
        return d > 0 && d * d > 1e-12 * squared_length(u) * squared_length(v);
      }
    return false;
  }
  /// A segment and the facets that contain it; a facet alone.
  std::vector<Element> elements_of(Carrier c) const {
    if (c.dimension == 2) return {element(c.index, true)};
    if (c.dimension == 0) return {};
    std::vector<Element> result{element(c.index, false)};
    for (std::size_t k = first_facet_[c.index]; k < first_facet_[c.index + 1]; ++k) result.push_back(element(facets_[k], true));
    return result;
  }
  void collect_incidence(const PolyhedralDomain& domain) {
    first_facet_.assign(domain.segments.size() + 1, 0);
    for (const auto& f : domain.facets)
      for (const Index s : f.segments) ++first_facet_[s + 1];
    for (std::size_t s = 0; s < domain.segments.size(); ++s) first_facet_[s + 1] += first_facet_[s];
    facets_.resize(first_facet_.back());
    std::vector<std::size_t> next(first_facet_.begin(), first_facet_.end() - 1);
    for (Index f = 0; f < domain.facets.size(); ++f)
      for (const Index s : domain.facets[f].segments) facets_[next[s]++] = f;
  }

  const PolyhedralDomain* domain_;
  ThinPlaces thin_places_;
  SimplexTable<2> pairs_;
  std::vector<std::size_t> first_facet_;
  std::vector<Index> facets_;
};

}  // namespace delref
