// SPDX-License-Identifier: GPL-3.0-or-later
//
// Facets and segments of a complex that meet elsewhere than in the vertices and segments that they have in common. Pairs with
// intersecting boxes come from CGAL's box intersection (Zomorodian, Edelsbrunner 2000); each is decided exactly.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>

#include <delref/core/budget.hpp>
#include <delref/domain/contact_places.hpp>
#include <delref/domain/describe.hpp>
#include <delref/domain/plc_names.hpp>
#include <delref/domain/triangle_contact.hpp>
#include <delref/domain/triangulated_plc.hpp>

namespace delref {

namespace plc_intersections {

using Index = Plc::Index;
using Ends = SegmentTable::Ends;

/// Finds pairs of elements that meet. Elements are numbered: the triangles of the complex, then its loose segments.
class PairSearch {
 public:
  using Pair = std::array<Index, 2>;
  /// Looked for no further: an input with so many crossings is beyond repair by hand.
  static constexpr std::size_t most_pairs = 10'000;

  PairSearch(const TriangulatedPlc& plc, const Control& control) : plc_(plc), control_(control), facet_of_(plc.triangles.size()) {
    for (Index f = 0; f < plc.size(); ++f)
      std::fill(facet_of_.begin() + static_cast<std::ptrdiff_t>(plc.first_triangle[f]),
                facet_of_.begin() + static_cast<std::ptrdiff_t>(plc.first_triangle[f + 1]), f);
    find_loose_segments();
  }

  /// The pairs, sorted; the first `most_pairs` that are found when there are more.
  std::vector<Pair> run() {
    std::vector<Box> boxes = boxes_of_all();
    throw_if_stopped(control_);
    try {
      CGAL::box_self_intersection_d(boxes.begin(), boxes.end(),
                                    [this](const Box& a, const Box& b) { look_at(a.info(), b.info()); });
    } catch (const Enough&) {
    }
    std::ranges::sort(pairs_);
    return std::move(pairs_);
  }

  bool is_triangle(Index element) const { return element < plc_.triangles.size(); }
  const TriangulatedPlc::Triangle& triangle(Index element) const { return plc_.triangles[element]; }
  Index facet_of(Index element) const { return facet_of_[element]; }
  Ends segment(Index element) const { return loose_[element - plc_.triangles.size()]; }

 private:
  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, Index>;
  struct Enough {};

  /// Listed segments that are no side of a facet.
  void find_loose_segments() {
    if (plc_.listed.empty()) return;
    std::vector<bool> is_side(plc_.segments.size(), false), seen(plc_.segments.size(), false);
    for (const auto& [a, b] : plc_.outlines.all_sides) is_side[plc_.segments.find(a, b)] = true;
    for (const auto& [a, b] : plc_.listed) {
      const Index s = plc_.segments.find(a, b);
      if (!is_side[s] && !seen[s]) loose_.push_back({a, b});
      seen[s] = true;
    }
  }

  std::vector<Box> boxes_of_all() const {
    std::vector<Box> boxes;
    boxes.reserve(plc_.triangles.size() + loose_.size());
    const auto add = [&](auto vertices) {
      BoundingBox3 box;
      for (const Index v : vertices) box.extend(plc_.points[v]);
      std::array low{box.low.x, box.low.y, box.low.z}, high{box.high.x, box.high.y, box.high.z};
      boxes.emplace_back(low.data(), high.data(), static_cast<Index>(boxes.size()));
    };
    for (const auto& t : plc_.triangles) add(t);
    for (const Ends& ends : loose_) add(ends);
    return boxes;
  }

  void look_at(Index a, Index b) {
    if (++steps_ % 4096 == 0) throw_if_stopped(control_);
    if (b < a) std::swap(a, b);
    if (!meet(a, b)) return;
    pairs_.push_back({a, b});
    if (pairs_.size() >= most_pairs) throw Enough{};
  }

  bool meet(Index a, Index b) const {
    if (is_triangle(b)) return facet_of_[a] != facet_of_[b] && triangles_meet(plc_.points, plc_.triangles[a], plc_.triangles[b]);
    if (is_triangle(a)) return segment_meets_triangle(plc_.points, segment(b), plc_.triangles[a]);
    return segments_meet(plc_.points, segment(a), segment(b));
  }

  const TriangulatedPlc& plc_;
  const Control& control_;
  std::vector<Index> facet_of_;
  std::vector<Ends> loose_;
  std::vector<Pair> pairs_;
  std::size_t steps_ = 0;
};

/// What two facets have in common.
struct CommonElements {
  std::vector<Index> vertices;
  std::vector<Ends> sides;

  CommonElements(const FacetOutlines& outlines, std::size_t f, std::size_t g) {
    const std::vector<Index> of_f = outlines.vertices(f), of_g = outlines.vertices(g);
    std::ranges::set_intersection(of_f, of_g, std::back_inserter(vertices));
    if (vertices.size() < 2) return;
    const auto sides_f = plc_duplicates::elements(outlines, f), sides_g = plc_duplicates::elements(outlines, g);
    std::ranges::set_intersection(sides_f, sides_g, std::back_inserter(sides));
  }

  /// True when a point is no farther from one of them than the tolerance.
  bool near(std::span<const Point3> points, Point3 p, double tolerance) const {
    const auto close = [&](Point3 q) { return squared_distance(p, q) <= tolerance * tolerance; };
    for (const Index v : vertices)
      if (close(points[v])) return true;
    for (const auto& [a, b] : sides) {
      const Vector3 along = points[b] - points[a];
      const double t = std::clamp(dot(p - points[a], along) / squared_length(along), 0.0, 1.0);
      if (close(points[a] + t * along)) return true;
    }
    return false;
  }
};

/// Says how pairs of elements meet.
class PairWords {
 public:
  PairWords(const TriangulatedPlc& plc, const PairSearch& search, const PlcNames& names)
      : plc_(plc), search_(search), names_(names), tolerance_(16 * rounding_of(plc.points)) {}

  /// A sentence; empty when two facets only seem to cross, where the vertices that they share were rounded.
  std::string describe_pair(Index a, Index b) const {
    if (!search_.is_triangle(a)) return segment(a) + " and " + segment(b) + " cross or overlap; cut both at a common vertex";
    if (!search_.is_triangle(b))
      return segment(b) + " meets " + facet(a) +
             " elsewhere than in a common vertex; make the point a vertex of the facet, or the segment one in it";
    return describe_facets(a, b);
  }

 private:
  std::string facet(Index element) const {
    const Index f = search_.facet_of(element);
    return names_.facet(plc_.outlines.facets[f].original, plc_.outlines.vertices(f));
  }
  std::string segment(Index element) const {
    const auto [a, b] = search_.segment(element);
    return names_.placed_segment(a, b);
  }
  std::array<Point3, 3> corners(Index element) const {
    const auto& t = search_.triangle(element);
    return {plc_.points[t[0]], plc_.points[t[1]], plc_.points[t[2]]};
  }

  std::string describe_facets(Index a, Index b) const {
    const std::array s = corners(a), t = corners(b);
    const std::vector<Point3> places = contact_places_of(s, t);
    const CommonElements common(plc_.outlines, search_.facet_of(a), search_.facet_of(b));
    const auto is_common = [&](Point3 p) { return common.near(plc_.points, p, tolerance_); };
    if (!places.empty() && std::ranges::all_of(places, is_common)) return {};
    const auto real = std::ranges::find_if_not(places, is_common);
    const Point3 place = real != places.end() ? *real : s[0] + (1.0 / 3) * ((s[1] - s[0]) + (s[2] - s[0]));
    for (const auto& [vertex_of, in] : {std::pair(a, b), std::pair(b, a)})
      for (const Index v : search_.triangle(vertex_of))
        if (plc_.points[v] == place && !lie_in_one_plane(s, t))
          return names_.placed_vertex(v) + " of " + facet(vertex_of) + " lies in " + facet(in) +
                 ", which does not list it: make it a vertex of that facet, or move it";
    return facet(a) + " and " + facet(b) + (lie_in_one_plane(s, t) ? " overlap near " : " cross at ") + names_.place(place) +
           "; facets may meet only in vertices and segments that both have";
  }

  static bool lie_in_one_plane(const std::array<Point3, 3>& s, const std::array<Point3, 3>& t) {
    return std::ranges::all_of(t, [&](Point3 p) { return exact_side(s[0], s[1], s[2], p) == 0; });
  }

  const TriangulatedPlc& plc_;
  const PairSearch& search_;
  const PlcNames& names_;
  double tolerance_;
};

}  // namespace plc_intersections

/// Adds a defect for every two facets, facet and segment, or two segments that meet where they should not. O(n log^2 n) plus the
/// number of pairs whose boxes intersect.
inline void find_intersections(const TriangulatedPlc& plc, const PlcNames& names, const Control& control, DefectList& defects) {
  using namespace plc_intersections;
  PairSearch search(plc, control);
  const std::vector<PairSearch::Pair> pairs = search.run();
  const PairWords words(plc, search, names);
  std::vector<std::array<Index, 2>> told;  // facets of which a pair of triangles was told
  for (const auto& [a, b] : pairs) {
    throw_if_stopped(control);
    std::array<Index, 2> facets{};
    if (search.is_triangle(b)) {
      facets = {search.facet_of(a), search.facet_of(b)};
      if (const auto place = std::ranges::lower_bound(told, facets); place != told.end() && *place == facets) continue;
    }
    // Beyond the words that are kept, pairs are only counted.
    const std::string message = defects.full() ? std::string(1, ' ') : words.describe_pair(a, b);
    if (message.empty()) continue;
    defects.add(message);
    if (search.is_triangle(b)) told.insert(std::ranges::lower_bound(told, facets), facets);
  }
  if (pairs.size() >= PairSearch::most_pairs)
    defects.add("more than " + std::to_string(PairSearch::most_pairs) +
                " places of this kind were found, and no more looked for");
}

}  // namespace delref
