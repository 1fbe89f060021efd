// SPDX-License-Identifier: GPL-3.0-or-later
//
// The elements of the input, worked out anew for verification: vertices at one place counted once, the sides of facets and
// explicit segments each once, and facets grouped as they are joined.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include <delref/mesh/verify/ulp.hpp>
#include <delref/mesh/verify_3/subject.hpp>

namespace delref::verification_3 {

/// Sets of numbers that are united by and by.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), Index{0}); }
  Index find(Index i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  /// The lower of the two representatives stays.
  void unite(Index i, Index j) {
    i = find(i), j = find(j);
    parent_[std::max(i, j)] = std::min(i, j);
  }

 private:
  std::vector<Index> parent_;
};

/// A straight line between two input vertices that is a segment of the complex.
struct Side {
  Index a, b;                 ///< canonical, a < b
  std::vector<Index> facets;  ///< the facets that it is a side of or lies in, as often as it is
  std::vector<int> markers;   ///< of the explicit segments that run over it
  bool required = true;       ///< false: it was joined away
};

/// A facet, less what is repeated or has no area.
struct Facet {
  struct Use {
    Index side;
    bool forward;  ///< the polygon goes from a to b
  };
  std::vector<Use> sides;
  Vector3 twice_area;    ///< of its largest polygon, counterclockwise around it
  Index same_as = none;  ///< an earlier facet with the same sides
  Index group = none;    ///< none for a facet without area
  bool simple = false;   ///< one polygon, which goes over no side twice, and no holes
};

/// Facets that are one: a facet of its own, or neighbours that were joined.
struct Group {
  std::vector<Index> facets;
  Point3 origin;
  Vector3 normal;
  /// How far from the plane a vertex of the mesh on it may be.
  double tolerance = 0;
  bool simple = true;  ///< all its facets are
  double height(Point3 p) const { return dot(p - origin, normal); }
  /// Whether a facet goes around counterclockwise as seen from the head of `normal`.
  bool agrees(const Facet& facet) const { return dot(facet.twice_area, normal) > 0; }
};

/// A vertex of the mesh on a facet lies within this many units in the last place of the largest coordinate of the facet of its
/// plane, beside three times what the facet's own vertices are off it.
inline constexpr double plane_tolerance_ulps = 16;

class InputComplex {
 public:
  explicit InputComplex(const Subject& subject) : s_(subject), canonical_(subject.input_points.size()) {
    find_canonical();
    find_sides();
    find_repeated_facets();
    join();
    find_planes();
  }

  Index canonical(Index vertex) const { return canonical_[vertex]; }
  std::span<const Side> sides() const { return sides_; }
  std::span<const Facet> facets() const { return facets_; }
  std::span<const Group> groups() const { return groups_; }
  /// The group of a facet, by any of its repetitions; none when it has no area.
  Index group_of(Index facet) const { return facets_[facets_[facet].same_as == none ? facet : facets_[facet].same_as].group; }
  /// Canonical vertices that are polygons of one point in a facet, with the facet's group.
  std::span<const std::pair<Index, Index>> points_in_facets() const { return points_in_facets_; }
  /// Whether a canonical vertex is the end of a side.
  bool on_side(Index vertex) const { return on_side_[vertex]; }

 private:
  void find_canonical() {
    std::iota(canonical_.begin(), canonical_.end(), Index{0});
    std::vector<Index> order = canonical_;
    const auto& p = s_.input_points;
    std::ranges::sort(order, [&](Index i, Index j) {
      return p[i].x != p[j].x ? p[i].x < p[j].x : p[i].y != p[j].y ? p[i].y < p[j].y : p[i].z != p[j].z ? p[i].z < p[j].z : i < j;
    });
    const double reach = s_.scaling.length(s_.criteria.input.merge_tolerance);
    DisjointSets same(p.size());
    for (std::size_t i = 0; i < order.size(); ++i)
      for (std::size_t j = i + 1; j < order.size() && p[order[j]].x - p[order[i]].x <= reach; ++j) {
        if (squared_distance(p[order[i]], p[order[j]]) <= reach * reach)
          same.unite(order[i], order[j]);
        else if (reach == 0 && p[order[i]] != p[order[j]])
          break;
      }
    for (Index v = 0; v < canonical_.size(); ++v) canonical_[v] = same.find(v);
  }

  void find_sides() {
    struct Record {
      Index a, b, facet, position;  ///< facet: none for an explicit segment, then position is its index
      bool forward;
    };
    std::vector<Record> records;
    facets_.resize(s_.input.facets.size());
    on_side_.assign(canonical_.size(), false);
    std::vector<std::pair<Index, Index>> points;
    for (Index f = 0; f < s_.input.facets.size(); ++f) {
      s_.breathe(f);
      const Plc::Facet& facet = s_.input.facets[f];
      for (const auto& polygon : facet.polygons) {
        if (polygon.size() == 1) points.push_back({canonical_[polygon[0]], f});
        const std::size_t count = polygon.size() == 2 ? 1 : polygon.size() < 2 ? 0 : polygon.size();
        for (std::size_t i = 0; i < count; ++i) {
          const Index v = canonical_[polygon[i]], w = canonical_[polygon[(i + 1) % polygon.size()]];
          if (v == w) continue;
          records.push_back({std::min(v, w), std::max(v, w), f, static_cast<Index>(facets_[f].sides.size()), v < w});
          facets_[f].sides.push_back({none, v < w});
        }
        const Vector3 area = twice_area(polygon);
        if (squared_length(area) > squared_length(facets_[f].twice_area)) facets_[f].twice_area = area;
      }
    }
    for (Index i = 0; i < s_.input.segments.size(); ++i) {
      const Index v = canonical_[s_.input.segments[i][0]], w = canonical_[s_.input.segments[i][1]];
      if (v != w) records.push_back({std::min(v, w), std::max(v, w), none, i, v < w});
    }
    std::ranges::sort(records, [](const Record& p, const Record& q) {
      return p.a != q.a ? p.a < q.a : p.b != q.b ? p.b < q.b : p.facet != q.facet ? p.facet < q.facet : p.position < q.position;
    });
    for (const Record& r : records) {
      if (sides_.empty() || sides_.back().a != r.a || sides_.back().b != r.b) sides_.push_back({r.a, r.b, {}, {}});
      Side& side = sides_.back();
      if (r.facet == none)
        side.markers.push_back(s_.input.segment_marker(r.position));
      else
        facets_[r.facet].sides[r.position].side = static_cast<Index>(sides_.size() - 1);
      on_side_[r.a] = on_side_[r.b] = true;
    }
    for (const auto& [v, f] : points) points_in_facets_.push_back({v, f});
  }

  Vector3 twice_area(const std::vector<Index>& polygon) const {
    Vector3 sum;
    const Point3 first = s_.input_points[canonical_[polygon.front()]];
    for (std::size_t i = 2; i < polygon.size(); ++i)
      sum = sum + cross(s_.input_points[canonical_[polygon[i - 1]]] - first, s_.input_points[canonical_[polygon[i]]] - first);
    return sum;
  }

  void find_repeated_facets() {
    std::map<std::vector<Index>, Index> known;
    for (Index f = 0; f < facets_.size(); ++f) {
      s_.breathe(f);
      std::vector<Index> key;
      for (const Facet::Use& use : facets_[f].sides) key.push_back(use.side);
      std::ranges::sort(key);
      facets_[f].simple = s_.input.facets[f].polygons.size() == 1 && s_.input.facets[f].holes.empty() &&
                          std::ranges::adjacent_find(key) == key.end();
      if (key.empty()) continue;
      const auto [entry, is_new] = known.emplace(std::move(key), f);
      if (!is_new) facets_[f].same_as = entry->second;
    }
  }

  bool counts(const Facet& f) const { return f.same_as == none && squared_length(f.twice_area) > 0; }

  void join() {
    for (Index f = 0; f < facets_.size(); ++f)
      if (counts(facets_[f]))
        for (const Facet::Use& use : facets_[f].sides) sides_[use.side].facets.push_back(f);
    DisjointSets joined(facets_.size());
    const double bound = s_.criteria.input.join_coplanar_degrees;
    for (Side& side : sides_) {
      if (bound < 0 || !side.markers.empty() || side.facets.size() != 2 || side.facets[0] == side.facets[1]) continue;
      const Index f = side.facets[0], g = side.facets[1];
      const double angle = angle_degrees(facets_[f].twice_area, facets_[g].twice_area);
      if (s_.input.facets[f].marker != s_.input.facets[g].marker || std::min(angle, 180 - angle) > bound + 1e-6) continue;
      joined.unite(f, g);
      side.required = false;
    }
    for (Index f = 0; f < facets_.size(); ++f) {
      if (!counts(facets_[f])) continue;
      const Index first = joined.find(f);
      if (first == f) {
        facets_[f].group = static_cast<Index>(groups_.size());
        groups_.emplace_back();
      }
      facets_[f].group = facets_[first].group;
      groups_[facets_[f].group].facets.push_back(f);
      groups_[facets_[f].group].simple &= facets_[f].simple;
    }
    for (auto& [vertex, facet] : points_in_facets_) facet = group_of(facet);
  }

  void find_planes() {
    for (Group& g : groups_) {
      Vector3 sum, first = facets_[g.facets.front()].twice_area;
      std::vector<Index> vertices;
      for (const Index f : g.facets) {
        sum = sum + (dot(facets_[f].twice_area, first) < 0 ? -1.0 : 1.0) * facets_[f].twice_area;
        for (const Facet::Use& use : facets_[f].sides) vertices.insert(vertices.end(), {sides_[use.side].a, sides_[use.side].b});
      }
      g.normal = (1 / std::sqrt(squared_length(sum))) * sum;
      g.origin = s_.input_points[vertices.front()];
      Vector3 mean;
      double largest = 0;
      for (const Index v : vertices) {
        const Point3 p = s_.input_points[v];
        mean = mean + (p - g.origin);
        largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
      }
      g.origin = g.origin + (1 / static_cast<double>(vertices.size())) * mean;
      for (const Index v : vertices) g.tolerance = std::max(g.tolerance, 3 * std::abs(g.height(s_.input_points[v])));
      g.tolerance += plane_tolerance_ulps * verification::ulp(largest);
    }
  }

  const Subject& s_;
  std::vector<Index> canonical_;
  std::vector<Side> sides_;
  std::vector<Facet> facets_;
  std::vector<Group> groups_;
  std::vector<std::pair<Index, Index>> points_in_facets_;
  std::vector<bool> on_side_;
};

}  // namespace delref::verification_3
