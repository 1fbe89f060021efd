// SPDX-License-Identifier: GPL-3.0-or-later
//
// The edges level of polyhedral meshing: subsegments that are missing or encroached are split. After Shewchuk, "Tetrahedral mesh
// generation by Delaunay refinement" (1998), with concentric shells where segments meet under 60 degrees.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <delref/core/proposal.hpp>
#include <delref/core/queue/element_set.hpp>
#include <delref/core/queue/fifo_queue.hpp>
#include <delref/core/verdict.hpp>
#include <delref/domain/polyhedral_domain.hpp>
#include <delref/domain/sharp_corners.hpp>
#include <delref/domain/thin_places.hpp>
#include <delref/levels/split_point.hpp>
#include <delref/levels/subsegment_table.hpp>
#include <delref/triangulation/spatial_concept.hpp>

namespace delref {

/// What the levels that make a triangulation conform are asked for.
struct ConformingOptions {
  double smallest_edge = 0;  ///< what has no longer edge is not refined, in the unit of the domain
  /// Also split what has any vertex in its diametral ball, as Shewchuk's algorithm does; else only what is missing. Many more
  /// vertices on surfaces of many small triangles, for no better tetrahedra: points inside regions keep off all the same.
  bool gabriel = false;
};

/// Keeps every subsegment an edge of the triangulation, and the points of other levels out of its diametral ball. `domain` must
/// outlive the level.
///
/// An insertion makes edges at the new vertex only, so a subsegment that is missing stays missing until it is split, and one that
/// an insertion destroys is inside the conflict zone: tests there find all.
template <SpatialTriangulation Tr, class Queue = FifoQueue<std::uint32_t>>
class EdgesLevel3 {
  using Table = SubsegmentTable<Tr>;
  using Vertex = typename Tr::Vertex;
  using Cell = typename Tr::Cell;

 public:
  using Element = typename Table::Id;

  /// `vertices` are those of the domain, in its order.
  EdgesLevel3(const Tr& tr, const PolyhedralDomain& domain, std::span<const Vertex> vertices, ConformingOptions options = {})
      : domain_(&domain), corners_(domain), options_(options), thin_places_(domain) {
    for (std::uint32_t s = 0; s < domain.segments.size(); ++s)
      table_.add(tr, vertices[domain.segments[s].ends[0]], vertices[domain.segments[s].ends[1]], s);
  }

  std::string_view name() const { return "edges"; }
  const Table& subsegments() const { return table_; }

  void scan_triangulation(Tr& tr) {
    set_.clear();
    table_.clear_slots();
    table_.for_each([&](Element e) {
      tr.cells_around(table_[e].ends[0], table_[e].ends[1], around_);
      mark_and_test(tr, e, around_);
    });
  }

  bool empty() const { return set_.empty(); }
  std::size_t queued() const { return set_.size(); }
  Element next_element() { return set_.front(); }
  void pop_next_element(Tr&) { set_.pop(table_); }
  template <class F>
  void for_each_queued(F&& f) const { set_.for_each(f); }

  bool holds(const Tr& tr, std::span<const Vertex> v) const { return table_.find(tr, v[0], v[1]) != Table::none; }
  std::array<Vertex, 2> element_vertices(const Tr&, const Element& e) const { return table_[e].ends; }
  typename Tr::Hint hint(const Tr&, const Element& e) const { return table_[e].ends[0]; }
  Carrier carrier(const Tr&, const Element& e) const { return {1, table_[e].segment}; }

  Point3 refinement_point(const Tr& tr, const Element& e) const {
    const PolyhedralDomain::Segment& s = domain_->segments[table_[e].segment];
    const Point3 a = tr.point(table_[e].ends[0]), b = tr.point(table_[e].ends[1]);
    const Point3 p = domain_->points[s.ends[0]], q = domain_->points[s.ends[1]];
    if (const auto foot = foot_of_cause(tr, e, p, q)) return *foot;
    if (const auto corner = shell_corner(tr, e)) {
      const double stretch = corners_.stretch(table_[e].segment, *corner);
      return *corner == 0 ? split_point_near_corner(a, b, p, q, stretch) : split_point_near_corner(a, b, q, p, stretch);
    }
    return split_point(a, b, p, q);
  }
  std::optional<Reason> give_up(const Tr& tr, const Element& e) const {
    if (options_.smallest_edge > 0 && squared_length(tr, e) <= options_.smallest_edge * options_.smallest_edge) return Reason::size_floor;
    const double rounding = rounding_near(tr.point(table_[e].ends[0]));
    if (squared_length(tr, e) <= 64 * rounding * rounding) return Reason::precision;
    return std::nullopt;
  }
  void on_rejected_forever(Tr&, const Element& e, Reason) { set_.give_up(table_, e); }
  std::string_view unmet_criterion(const Tr&, const Element&) const { return "missing or encroached subsegment"; }

  /// Rejects the point of another level when it encroaches subsegments of its zone, which are then to be split. A point on a segment
  /// is inserted nonetheless, and what it encroaches is split afterwards.
  Verdict check_refinement_point(Tr& tr, const Proposal<Tr>& proposal) {
    encroached_.clear();
    for (const Cell c : proposal.zone->dying_cells())
      if (tr.has_marked_edges(c)) collect_encroached(tr, c, proposal);
    if (proposal.carrier.dimension < 2 || encroached_.empty()) return Verdict::permitted;
    return split_instead(tr, proposal);
  }
  /// A subsegment hides the point from the element that it is to kill.
  std::optional<Verdict> check_blocked(Tr& tr, const typename Tr::Edge& edge, const Proposal<Tr>& proposal) {
    const Element e = table_.find(tr, edge.a, edge.b);
    if (e == Table::none) return std::nullopt;
    encroached_.assign(1, e);
    return split_instead(tr, proposal);
  }
  Reason rejection_reason() const { return reason_; }

  void before_insertion(Tr& tr, const Proposal<Tr>& proposal) {
    if (proposal.carrier.dimension != 1) return;
    const Element e = table_.find(tr, proposal.vertices[0], proposal.vertices[1]);
    set_.erase(table_, e);
    table_.remove(tr, e);
  }
  void after_insertion(Tr& tr, Vertex v, const Proposal<Tr>& proposal) {
    if (proposal.carrier.dimension >= 2) return;
    for (const Element e : encroached_)
      if (table_[e].segment != Table::none) queue(tr, e, v);
    if (proposal.carrier.dimension == 0) return;
    for (std::size_t i = 0; i < 2; ++i) {
      const Element half = table_.add(tr, v, proposal.vertices[i], proposal.carrier.index);
      around_.clear();
      for (const Cell c : proposal.zone->new_cells())
        if (place_of(tr, c, proposal.vertices[i]) >= 0) around_.push_back(c);
      mark_and_test(tr, half, around_);
    }
  }

 private:
  /// `cause` is the vertex that encroaches it, if that is in the triangulation.
  void queue(Tr& tr, const Element& e, Vertex cause = {}) {
    if (set_.add(table_, e, squared_length(tr, e))) table_.set_cause(e, cause);
  }
  /// The foot of the encroaching vertex on the subsegment, when that vertex is on an element beside it and far nearer than its ends:
  /// elements side by side are so split side by side, and not until their pieces are as short as they are near.
  std::optional<Point3> foot_of_cause(const Tr& tr, const Element& e, Point3 p, Point3 q) const {
    const Vertex w = table_[e].cause;
    if (w == Vertex{} || corners_.is_on_neighbour(tr.carrier(w), table_[e].segment)) return std::nullopt;
    const Point3 a = tr.point(table_[e].ends[0]), b = tr.point(table_[e].ends[1]), at = tr.point(w);
    const double length = squared_distance(a, b), t = dot(at - a, b - a) / length;
    if (!(t > 0.1 && t < 0.9)) return std::nullopt;
    const Point3 near = a + t * (b - a);
    // Straight across, when that is across one of the axes, the foot is exactly opposite.
    const auto k = main_coordinate(q - p);
    const Point3 foot = onto_line(std::abs(near.*k - at.*k) <= rounding_near(at) ? at : near, p, q);
    if (squared_distance(at, foot) > 0.01 * length || !is_between(foot, a, b, q - p)) return std::nullopt;
    return foot;
  }
  static int place_of(const Tr& tr, Cell c, Vertex v) {
    for (int i = 0; i < 4; ++i)
      if (tr.vertex(c, i) == v) return i;
    return -1;
  }
  double squared_length(const Tr& tr, const Element& e) const {
    return squared_distance(tr.point(table_[e].ends[0]), tr.point(table_[e].ends[1]));
  }
  /// The cosine, times the squared length, of the angle under which `p` sees a subsegment; negative inside the diametral ball.
  static double depth(Point3 p, Point3 a, Point3 b) { return dot(a - p, b - p); }
  /// Strictly inside the diametral ball, by more than rounding makes of a right angle.
  static bool encroaches(Point3 p, Point3 a, Point3 b) { return depth(p, a, b) < -tolerance * squared_distance(a, b); }
  /// Whether the insertion destroys the edge between the vertices `i` and `j` of a cell that dies: so do all cells around it.
  static bool is_destroyed(const Tr& tr, const typename Tr::Zone& zone, Cell first, int i, int j) {
    Cell c = first;
    int ahead = 0;
    while (ahead == i || ahead == j) ++ahead;
    Vertex behind = tr.vertex(first, 6 - i - j - ahead);
    do {
      // Out through the face opposite to `ahead`; the vertex that was behind is on it and is the next to be opposite.
      const auto out = tr.mirror(tr.facet(c, ahead));
      c = tr.cell(out);
      if (!tr.dies(c, zone)) return false;
      const Vertex entered = tr.apex(out);
      for (ahead = 0; !(tr.vertex(c, ahead) == behind);) ++ahead;
      behind = entered;
    } while (!(c == first));
    return true;
  }
  static constexpr double tolerance = 1e-12;

  /// `cells` are those around the subsegment: none when it is missing.
  void mark_and_test(Tr& tr, const Element& e, std::span<const Cell> cells) {
    const auto [a, b] = table_[e].ends;
    bool is_free = !cells.empty();
    Vertex cause{};
    for (const Cell c : cells) {
      const int i = place_of(tr, c, a), j = place_of(tr, c, b);
      tr.mark_edge(c, i, j, true);
      for (int k = 0; k < 4; ++k)
        if (const Vertex w = tr.vertex(c, k); k != i && k != j && !tr.is_infinite(w))
          if (options_.gabriel && encroaches(tr.point(w), tr.point(a), tr.point(b)) && !is_on_shell(tr, e, w)) cause = w, is_free = false;
    }
    if (!is_free) queue(tr, e, cause);
  }
  /// Whether a vertex is beside an end of the subsegment, on the shell of a sharp corner.
  bool is_on_shell(const Tr& tr, const Element& e, Vertex w) const {
    for (const Vertex end : table_[e].ends)
      if (corners_.are_on_one_shell(tr.carrier(w), tr.point(w), table_[e].segment, tr.point(end))) return true;
    return false;
  }
  void collect_encroached(const Tr& tr, Cell c, const Proposal<Tr>& proposal) {
    const Point3 p = proposal.point;
    for (int i = 0; i < 3; ++i)
      for (int j = i + 1; j < 4; ++j) {
        if (!tr.is_edge_marked(c, i, j)) continue;
        const Vertex a = tr.vertex(c, i), b = tr.vertex(c, j);
        if (proposal.carrier.dimension == 1 && is_split(proposal, a, b)) continue;
        const bool keeps_off = options_.gabriel || proposal.carrier.dimension >= 2;
        const bool encroached = keeps_off && encroaches(p, tr.point(a), tr.point(b));
        if (!encroached && !is_destroyed(tr, *proposal.zone, c, i, j)) continue;
        const Element e = table_.find(tr, a, b);
        if (e == Table::none || std::ranges::find(encroached_, e) != encroached_.end()) continue;
        if (encroached && proposal.carrier.dimension == 1 && is_beside(tr, e, proposal) && !is_destroyed(tr, *proposal.zone, c, i, j)) continue;
        encroached_.push_back(e);
      }
  }
  /// Whether the point is to split the subsegment between `a` and `b`.
  static bool is_split(const Proposal<Tr>& proposal, Vertex a, Vertex b) {
    const Vertex u = proposal.vertices[0], v = proposal.vertices[1];
    return (a == u && b == v) || (a == v && b == u);
  }
  /// The same for a point on its way to a segment.
  bool is_beside(const Tr& tr, const Element& e, const Proposal<Tr>& proposal) const {
    return std::ranges::any_of(table_[e].ends, [&](Vertex end) {
      return corners_.are_on_one_shell(proposal.carrier, proposal.point, table_[e].segment, tr.point(end));
    });
  }
  /// In a thin place, the corner of the tetrahedron that is on another element beside the subsegment.
  Vertex cause(const Tr& tr, const Element& e, const Proposal<Tr>& proposal) const {
    const Point3 a = tr.point(table_[e].ends[0]), b = tr.point(table_[e].ends[1]);
    for (const Vertex v : proposal.element_vertices()) {
      const Point3 p = tr.point(v);
      const Vector3 n = cross(b - a, p - a);
      const double apart = dot(n, n) / squared_distance(a, b), noise = 64 * rounding_near(p);
      if (apart > noise * noise && thin_places_.has_edge(tr.carrier(v), Carrier{1, table_[e].segment}, apart)) return v;
    }
    return {};
  }
  Verdict split_instead(Tr& tr, const Proposal<Tr>& proposal) {
    for (const Element e : encroached_)
      if (const auto obstacle = this->obstacle(tr, e)) return reason_ = *obstacle, Verdict::rejected_forever;
    for (const Element e : encroached_) queue(tr, e, proposal.carrier.dimension == 3 ? cause(tr, e, proposal) : Vertex{});
    return Verdict::rejected;
  }
  std::optional<Reason> obstacle(const Tr& tr, const Element& e) const {
    if (const auto reason = give_up(tr, e)) return reason;
    if (set_.is_given_up(table_, e)) return Reason::precision;
    return std::nullopt;
  }
  /// The end of its segment from which a subsegment is split on shells: the sharp one at which it ends, or the one of tiny angles
  /// that reach to it.
  std::optional<std::size_t> shell_corner(const Tr& tr, const Element& e) const {
    const std::size_t s = table_[e].segment;
    std::array<bool, 2> ends_there{};
    for (std::size_t end = 0; end < 2; ++end)
      for (const Vertex v : table_[e].ends)
        if (corners_.is_sharp(s, end) && tr.carrier(v) == Carrier{0, domain_->segments[s].ends[end]}) ends_there[end] = true;
    if (ends_there[0] != ends_there[1]) return ends_there[0] ? 0 : 1;
    const auto corner = corners_.shell_corner(s, midpoint(tr.point(table_[e].ends[0]), tr.point(table_[e].ends[1])));
    if (!corner && ends_there[0]) return 0;
    return corner;
  }

  const PolyhedralDomain* domain_;
  SharpCorners corners_;
  ConformingOptions options_;
  ThinPlaces thin_places_;
  Table table_;
  ElementSet<Element, Queue> set_;
  Reason reason_ = Reason::size_floor;
  std::vector<Element> encroached_;
  std::vector<Cell> around_;
};

}  // namespace delref
