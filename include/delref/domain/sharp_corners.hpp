// SPDX-License-Identifier: GPL-3.0-or-later
//
// The corners of a complex in space where segments meet at small angles, and how segments are split there: at distances from the
// corner that all of its segments share, so that their vertices do not encroach each other's subsegments (Ruppert 1995, section 6;
// in space Shewchuk 1998, section 4).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <span>
#include <vector>

#include <delref/core/carrier.hpp>
#include <delref/core/point.hpp>
#include <delref/domain/polyhedral_domain.hpp>

namespace delref {

/// What the segments of a domain are to each other at their ends. The domain must outlive it. Coplanar segments count whether their
/// facets are joined or not.
class SharpCorners {
 public:
  using Index = PolyhedralDomain::Index;

  explicit SharpCorners(const PolyhedralDomain& domain) : domain_(&domain), ends_(domain.segments.size()), facets_of_(domain.segments.size()) {
    index_segments();
    for (Index f = 0; f < domain.facets.size(); ++f)
      for (const Index s : domain.facets[f].segments) facets_of_[s].push_back(f);
    std::vector<Vector3> directions;
    for (Index v = 0; v < domain.points.size(); ++v) {
      directions.clear();
      for (const Index s : segments_at(v)) directions.push_back(direction(s, v));
      for (std::size_t i = 1; i < directions.size(); ++i)
        for (std::size_t j = 0; j < i && (j < 256 || i - j < 256); ++j) compare(v, i, j, directions);
    }
    for (std::size_t s = 0; s < ends_.size(); ++s) {
      const double golden = 0.6180339887498949 * static_cast<double>(s);
      for (End& end : ends_[s]) {
        const double angle = std::acos(std::clamp(end.cosine, -1.0, 1.0));
        if (end.is_crossed) end.stretch = 1 + std::min(0.04, 0.5 * angle * angle) * (golden - std::floor(golden) - 0.5);
      }
    }
  }

  /// Another segment meets this one at the end under 60 degrees.
  bool is_sharp(std::size_t segment, std::size_t end) const { return ends_[segment][end].cosine > 0.5 + 1e-9; }
  /// What the distances of split points from the end are multiplied with. Two segments of a corner that are split at exactly the same
  /// distances make four coplanar cocircular points, and so a flat cell, which is in the way unless it lies on a common facet: shells
  /// then differ by up to two parts in a hundred, and by less than the square of the angle, which is what keeps their vertices from
  /// encroaching.
  double stretch(std::size_t segment, std::size_t end) const { return ends_[segment][end].stretch; }

  /// The end from which all split points near `p` are measured, if the segment meets others there at a tiny angle: the end whose
  /// neighbours reach as far as `p`, and of two such the nearer.
  std::optional<std::size_t> shell_corner(std::size_t s, Point3 p) const {
    const double r0 = ends_[s][0].reach, r1 = ends_[s][1].reach;
    if (r0 == 0 && r1 == 0) return std::nullopt;
    if (r0 == 0 || r1 == 0) return r0 != 0 ? 0 : 1;
    const double d0 = squared_distance(p, corner(s, 0)), d1 = squared_distance(p, corner(s, 1));
    const bool reached0 = d0 < r0 * r0, reached1 = d1 < r1 * r1;
    return reached0 != reached1 ? (reached0 ? 0 : 1) : (d0 <= d1 ? 0 : 1);
  }

  /// Whether a vertex is on a segment that shares an end with `segment`, or is such an end.
  bool is_on_neighbour(Carrier a, std::size_t segment) const {
    const auto& ends = domain_->segments[segment].ends;
    if (a.dimension == 0) return a.index == ends[0] || a.index == ends[1];
    if (a.dimension != 1) return false;
    const auto& others = domain_->segments[a.index].ends;
    return others[0] == ends[0] || others[0] == ends[1] || others[1] == ends[0] || others[1] == ends[1];
  }

  /// Whether a vertex at `p` is on a sphere around a sharp corner of segment `s` together with `q`, a point of `s`, as far as
  /// rounding lets one tell. Such vertices would encroach each other's subsegments by nothing but rounding, for ever.
  bool are_on_one_shell(Carrier a, Point3 p, std::size_t s, Point3 q) const {
    for (std::size_t end = 0; end < 2; ++end) {
      if (!is_sharp(s, end)) continue;
      const double d = std::sqrt(squared_distance(corner(s, end), p));
      const double difference = std::abs(d - std::sqrt(squared_distance(corner(s, end), q)));
      if (difference <= 1e-12 * d + rounding_near(p) && is_on_segment_of(a, domain_->segments[s].ends[end])) return true;
    }
    return false;
  }

 private:
  /// Under 10 degrees all split points are measured from the corner.
  static constexpr double tiny_cosine = 0.98480775;

  struct End {
    double cosine = -1;  ///< of the smallest angle to another segment
    double reach = 0;    ///< the longest segment that meets this one at a tiny angle; 0 for none
    double stretch = 1;
    bool is_crossed = false;  ///< a segment of no common facet meets this one there
  };

  Point3 corner(std::size_t s, std::size_t end) const { return domain_->points[domain_->segments[s].ends[end]]; }
  std::size_t end_at(Index s, Index v) const { return domain_->segments[s].ends[0] == v ? 0 : 1; }
  Vector3 direction(Index s, Index v) const {
    const std::size_t end = end_at(s, v);
    return corner(s, 1 - end) - corner(s, end);
  }
  void compare(Index v, std::size_t i, std::size_t j, const std::vector<Vector3>& directions) {
    const double a = squared_length(directions[i]), b = squared_length(directions[j]);
    const double cosine = dot(directions[i], directions[j]) / std::sqrt(a * b);
    const auto at = segments_at(v);
    for (const auto& [k, other] : {std::pair(i, b), std::pair(j, a)}) {
      End& end = ends_[at[k]][end_at(at[k], v)];
      end.cosine = std::max(end.cosine, cosine);
      end.is_crossed = end.is_crossed || !share_facet(at[i], at[j]);
      if (cosine > tiny_cosine) end.reach = std::max(end.reach, std::sqrt(other));
    }
  }
  bool share_facet(Index s, Index t) const {
    return std::ranges::any_of(facets_of_[s], [&](Index f) { return std::ranges::find(facets_of_[t], f) != facets_of_[t].end(); });
  }
  bool is_on_segment_of(Carrier a, Index v) const {
    const auto joins = [&](Index t) {
      return (domain_->segments[t].ends[0] == v && is_sharp(t, 0)) || (domain_->segments[t].ends[1] == v && is_sharp(t, 1));
    };
    if (a.dimension == 1) return joins(a.index);
    return a.dimension == 0 && std::ranges::any_of(segments_at(a.index), joins);
  }
  std::span<const Index> segments_at(Index v) const { return {incident_.data() + first_[v], incident_.data() + first_[v + 1]}; }
  void index_segments() {
    first_.assign(domain_->points.size() + 1, 0);
    for (const auto& s : domain_->segments)
      for (const Index v : s.ends) ++first_[v + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    incident_.resize(2 * domain_->segments.size());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (Index s = 0; s < domain_->segments.size(); ++s)
      for (const Index v : domain_->segments[s].ends) incident_[next[v]++] = s;
  }

  const PolyhedralDomain* domain_;
  std::vector<std::array<End, 2>> ends_;
  std::vector<std::vector<Index>> facets_of_;  // by segment
  std::vector<std::size_t> first_;  // of the segments at each vertex
  std::vector<Index> incident_;
};

}  // namespace delref
