// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a vertex on one facet has its counterpart on another: turned about their common segment, or else straight below. Facets
// near each other that have their vertices at counterparts do not encroach each other, as segments of a sharp corner do not
// that are split on common shells; without that their vertices would come as near to each other as the facets are.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include <delref/core/carrier.hpp>
#include <delref/core/point.hpp>
#include <delref/domain/polyhedral_domain.hpp>
#include <delref/triangulation/simplex_table.hpp>

namespace delref {

/// The common segments of the facets of a domain, which must outlive it.
class FacetHinges {
 public:
  using Index = PolyhedralDomain::Index;

  explicit FacetHinges(const PolyhedralDomain& domain) : domain_(&domain), facets_of_(domain.segments.size()) {
    for (Index f = 0; f < domain.facets.size(); ++f)
      for (const Index s : domain.facets[f].segments) {
        for (const Index g : facets_of_[s])
          if (g != f) hinges_.set(SimplexTable<2>::key(f, g), s);
        if (facets_of_[s].size() < crowd) facets_of_[s].push_back(f);
      }
    sharp_.resize(domain.facets.size());
    for (const PolyhedralDomain::SmallAngle& angle : domain.small_angles) {
      if (angle.kind != PolyhedralDomain::SmallAngle::Kind::facets) continue;
      const Index s = hinges_.find(SimplexTable<2>::key(angle.elements[0], angle.elements[1]));
      if (s == hinges_.none) continue;
      for (const Index f : angle.elements) sharp_[f].push_back({s, std::sin(angle.degrees * (3.14159265358979324 / 180))});
    }
  }

  /// How far a point of `facet` is from the nearest facet that meets it under 90 degrees, about; infinite when there is none.
  double squared_distance_to_sharp(Index facet, Point3 p) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Sharp& sharp : sharp_[facet]) {
      const Point3 a = domain_->points[domain_->segments[sharp.hinge].ends[0]], b = domain_->points[domain_->segments[sharp.hinge].ends[1]];
      const double t = std::clamp(dot(p - a, b - a) / squared_distance(a, b), 0.0, 1.0);
      nearest = std::min(nearest, sharp.sine * sharp.sine * squared_distance(p, a + t * (b - a)));
    }
    return nearest;
  }

  /// The counterpart on the plane of `facet` of a vertex at `p` that lies on `carrier`. Nothing when their facets meet at a right
  /// angle, or nearly: the vertex is then over no point of the facet.
  std::optional<Point3> counterpart(Carrier carrier, Point3 p, Index facet) const {
    if (carrier.dimension == 2) {
      if (const Index s = hinges_.find(SimplexTable<2>::key(carrier.index, facet)); s != hinges_.none) return turned(p, s, facet);
    } else if (carrier.dimension == 1) {
      for (const Index f : facets_of_[carrier.index])
        if (const Index s = hinges_.find(SimplexTable<2>::key(f, facet)); s != hinges_.none) return turned(p, s, facet);
    }
    // Not by the coordinates in the plane: for facets side by side that are upright, this rounds in one coordinate only, and the
    // counterpart is exactly opposite.
    const PlaneFrame& frame = domain_->facets[facet].frame;
    return p + -frame.height(p) * frame.normal;
  }

 private:
  static constexpr std::size_t crowd = 256;  // of the facets at one segment, more than these have no counterparts

  /// `p` turned about segment `s` into the plane of `facet`, on the side where the facet is nearer to it.
  std::optional<Point3> turned(Point3 p, Index s, Index facet) const {
    const PlaneFrame& frame = domain_->facets[facet].frame;
    const Point3 a = domain_->points[domain_->segments[s].ends[0]], b = domain_->points[domain_->segments[s].ends[1]];
    const Vector3 axis = b - a;
    const Point3 foot = a + (dot(p - a, axis) / squared_length(axis)) * axis;
    const Vector3 arm = p - foot;
    const Vector3 below = arm - dot(arm, frame.normal) * frame.normal;
    const double length = squared_length(below);
    if (!(length > 0.05 * squared_length(arm))) return std::nullopt;
    return frame.lift(frame.project(foot + std::sqrt(squared_length(arm) / length) * below));
  }

  struct Sharp {
    Index hinge = 0;
    double sine = 1;
  };

  const PolyhedralDomain* domain_;
  std::vector<std::vector<Sharp>> sharp_;  // by facet
  std::vector<std::vector<Index>> facets_of_;  // by segment
  SimplexTable<2> hinges_;
};

}  // namespace delref
