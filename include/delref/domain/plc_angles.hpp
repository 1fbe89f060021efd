// SPDX-License-Identifier: GPL-3.0-or-later
//
// The angles under 90 degrees between the elements of a complex. They limit what refinement can do (Shewchuk 1998): a segment and
// another, a segment and a facet at a vertex, two facets at a segment.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <tuple>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/domain/coplanar_groups.hpp>
#include <delref/domain/polyhedral_domain.hpp>
#include <delref/domain/segment_wedges.hpp>
#include <delref/domain/triangulated_plc.hpp>

namespace delref {

/// Angles not under this many degrees are right or obtuse up to rounding.
inline constexpr double small_angle_limit = 90 * (1 - 1e-6);

/// The angle between two directions, in degrees.
inline double angle_between(Vector3 a, Vector3 b) {
  return std::atan2(std::sqrt(squared_length(cross(a, b))), dot(a, b)) * (180 / std::numbers::pi);
}

namespace plc_angles {

using Index = Plc::Index;
using Kind = PolyhedralDomain::SmallAngle::Kind;

/// Numbers per vertex, in flat arrays.
struct Incidence {
  std::vector<Index> begin, items;

  std::span<const Index> operator[](std::size_t v) const { return std::span(items).subspan(begin[v], begin[v + 1] - begin[v]); }

  /// From elements with vertices.
  template <class Elements>
  Incidence(std::size_t vertex_count, const Elements& elements) : begin(vertex_count + 1, 0) {
    for (const auto& element : elements)
      for (const Index v : element) ++begin[v + 1];
    for (std::size_t v = 0; v < vertex_count; ++v) begin[v + 1] += begin[v];
    items.resize(begin.back());
    std::vector<Index> place(begin.begin(), begin.end() - 1);
    for (Index e = 0; e < elements.size(); ++e)
      for (const Index v : elements[e]) items[place[v]++] = e;
  }
};

/// Finds the angles and what follows from them for segments and facets.
class AngleSearch {
 public:
  AngleSearch(const TriangulatedPlc& plc, const SegmentWedges& wedges, PolyhedralDomain& domain)
      : plc_(plc), wedges_(wedges), groups_(plc, wedges), domain_(domain) {}

  void run(const Control& control) {
    for (Index s = 0; s < wedges_.size(); ++s) {
      if (s % 4096 == 0) throw_if_stopped(control);
      if (!groups_.is_flat(s)) look_around_segment(s);
    }
    const Incidence segments(plc_.points.size(), plc_.segments.all()), triangles(plc_.points.size(), plc_.triangles);
    facet_of_.resize(plc_.triangles.size());
    for (Index f = 0; f < plc_.size(); ++f)
      for (std::size_t t = plc_.first_triangle[f]; t < plc_.first_triangle[f + 1]; ++t) facet_of_[t] = f;
    for (Index v = 0; v < plc_.points.size(); ++v) {
      if (v % 256 == 0 || segments[v].size() > many) throw_if_stopped(control);
      if (!segments[v].empty()) look_around_vertex(v, segments[v], triangles[v]);
    }
    std::ranges::sort(domain_.small_angles, {},
                      [](const PolyhedralDomain::SmallAngle& a) { return std::tuple(a.degrees, a.kind, a.elements); });
  }

 private:
  /// At a vertex with more segments than this only the smallest angle of each is listed, and with more than `crowd` only
  /// neighbours in the order along one axis are compared: a fan of n has n^2 pairs, and the smallest angles say all.
  static constexpr std::size_t many = 64, crowd = 2048;

  void look_around_segment(Index s) {
    if (wedges_[s].size() < 2) return;
    const auto around = wedges_.around(s);
    const std::size_t pairs = around.size() == 2 ? 1 : around.size();
    for (std::size_t i = 0; i < pairs; ++i) {
      const auto& one = around[i];
      const auto& other = around[(i + 1) % around.size()];
      const double turn = other.angle - one.angle + (i + 1 == around.size() ? 2 * std::numbers::pi : 0);
      if (one.wedge.facet == other.wedge.facet || (pairs > 1 && turn > std::numbers::pi)) continue;
      const double degrees = angle_between(wedges_.into(s, one.wedge), wedges_.into(s, other.wedge));
      if (!(degrees < small_angle_limit)) continue;
      domain_.facets[one.wedge.facet].gabriel = domain_.facets[other.wedge.facet].gabriel = false;
      const auto [a, b] = plc_.segments[s];
      domain_.small_angles.push_back(
          {Kind::facets, ordered(one.wedge.facet, other.wedge.facet), degrees, midpoint(plc_.points[a], plc_.points[b])});
    }
  }

  static std::array<Index, 2> ordered(Index a, Index b) { return {std::min(a, b), std::max(a, b)}; }

  /// A segment as seen from one of its ends.
  struct Ray {
    Index segment = 0, other_end = 0;
    Vector3 direction;
    bool is_real = true;
    double nearest_apart = 4;  ///< the squared distance of its tip from that of the nearest real ray
    Index nearest = 0;         ///< the position of that ray
  };

  void look_around_vertex(Index v, std::span<const Index> segments, std::span<const Index> triangles) {
    rays_.clear();
    for (const Index s : segments) {
      const auto [a, b] = plc_.segments[s];
      const Index other = a == v ? b : a;
      rays_.push_back({s, other, unit(plc_.points[other] - plc_.points[v]), !groups_.is_flat(s)});
    }
    if (rays_.size() > crowd) sort_along_axis();
    compare_rays(v);
    if (rays_.size() <= crowd || triangles.size() <= crowd)
      for (const Index t : triangles) compare_with_triangle(v, t);
  }

  void sort_along_axis() {
    Vector3 spread{0, 0, 0}, mean{0, 0, 0};
    for (const Ray& ray : rays_) mean = mean + (1.0 / static_cast<double>(rays_.size())) * ray.direction;
    for (const Ray& ray : rays_) {
      const Vector3 d = ray.direction - mean;
      spread = spread + Vector3{d.x * d.x, d.y * d.y, d.z * d.z};
    }
    const Vector3 axis = spread.x >= spread.y && spread.x >= spread.z ? Vector3{1, 0, 0}
                         : spread.y >= spread.z                       ? Vector3{0, 1, 0}
                                                                      : Vector3{0, 0, 1};
    std::ranges::sort(rays_, {}, [&](const Ray& ray) { return std::tuple(dot(ray.direction, axis), ray.segment); });
  }

  /// Compares by the distance of the tips of the rays, which is as precise for tiny angles and much faster than the angle.
  void compare_rays(Index v) {
    const bool list_all = rays_.size() <= many;
    const std::size_t reach = rays_.size() <= crowd ? rays_.size() : crowd;
    constexpr double under_90 = 2;
    for (Index i = 0; i < rays_.size(); ++i)
      for (Index j = i + 1; j < std::min<std::size_t>(rays_.size(), i + reach); ++j) {
        Ray &one = rays_[i], &other = rays_[j];
        const double apart = squared_length(one.direction - other.direction);
        if (apart >= under_90) continue;
        if (!one.is_real || !other.is_real) continue;
        if (list_all) list_segments(v, one, other);
        if (apart < one.nearest_apart) one.nearest_apart = apart, one.nearest = j;
        if (apart < other.nearest_apart) other.nearest_apart = apart, other.nearest = i;
      }
    for (Index i = 0; i < rays_.size(); ++i) {
      const Ray& ray = rays_[i];
      if (!list_all && ray.nearest_apart < under_90 && (rays_[ray.nearest].nearest != i || i < ray.nearest))
        list_segments(v, ray, rays_[ray.nearest]);
    }
  }

  void list_segments(Index v, const Ray& one, const Ray& other) {
    const double degrees = angle_between(one.direction, other.direction);
    if (degrees < small_angle_limit)
      domain_.small_angles.push_back({Kind::segments, ordered(one.segment, other.segment), degrees, plc_.points[v]});
  }

  /// A segment over the inside of a facet; one over its border is nearest to the segment there, and is listed with that.
  void compare_with_triangle(Index v, Index t) {
    const auto& corners = plc_.triangles[t];
    const std::size_t at = corners[0] == v ? 0 : corners[1] == v ? 1 : 2;
    const Index b = corners[(at + 1) % 3], c = corners[(at + 2) % 3], facet = facet_of_[t];
    const Vector3 normal = plc_.frames[facet].normal;
    const Vector3 left_of_b = cross(normal, unit(plc_.points[b] - plc_.points[v]));
    const Vector3 right_of_c = cross(unit(plc_.points[c] - plc_.points[v]), normal);
    // A ray over an edge inside the facet belongs to the triangle to the left of that edge.
    const double from_b = is_border(v, b) ? border_slack : -border_slack, from_c = border_slack;
    for (const Ray& ray : rays_) {
      if (!ray.is_real || ray.other_end == b || ray.other_end == c) continue;
      if (dot(left_of_b, ray.direction) < from_b || dot(right_of_c, ray.direction) < from_c) continue;
      const double height = std::abs(dot(ray.direction, normal));
      const double degrees = std::atan2(height, std::sqrt(std::max(0.0, 1 - height * height))) * (180 / std::numbers::pi);
      if (!(degrees < small_angle_limit) || contains(facet, ray.segment)) continue;
      domain_.small_angles.push_back({Kind::segment_and_facet, {ray.segment, facet}, degrees, plc_.points[v]});
    }
  }

  static constexpr double border_slack = 1e-9;

  bool is_border(Index v, Index other) const {
    const Index s = plc_.segments.find(v, other);
    return s != SegmentTable::none && !groups_.is_flat(s);
  }

  /// True when the segment lies in the facet or in one that is coplanar with it.
  bool contains(Index facet, Index segment) const {
    return std::ranges::any_of(wedges_[segment],
                               [&](const auto& wedge) { return groups_.group(wedge.facet) == groups_.group(facet); });
  }

  const TriangulatedPlc& plc_;
  const SegmentWedges& wedges_;
  CoplanarGroups groups_;
  PolyhedralDomain& domain_;
  std::vector<Index> facet_of_;
  std::vector<Ray> rays_;
};

}  // namespace plc_angles

/// Fills `small_angles` and `gabriel` of facets of a domain whose segments and facets are those of
/// the complex. O(n log n) where vertices have few segments.
inline void find_small_angles(const TriangulatedPlc& plc, const SegmentWedges& wedges, PolyhedralDomain& domain,
                              const Control& control) {
  plc_angles::AngleSearch(plc, wedges, domain).run(control);
}

}  // namespace delref
