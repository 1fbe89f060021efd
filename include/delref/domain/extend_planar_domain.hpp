// SPDX-License-Identifier: GPL-3.0-or-later
//
// Adds vertices and segments to a domain that was refined already. The triangulation is made anew from the vertices of the old
// one, so that nothing is changed before all is known to be valid, and what was learnt of the old domain (regions, corners,
// clusters) is worked out again. A vertex that is there already is used, whoever inserted it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/domain/build_planar_domain.hpp>
#include <delref/domain/chain_line.hpp>
#include <delref/domain/insert_planar_graph.hpp>
#include <delref/domain/label_planar_domain.hpp>
#include <delref/domain/pair_table.hpp>
#include <delref/domain/planar_domain.hpp>
#include <delref/domain/pslg_scale.hpp>
#include <delref/domain/unite_pslg.hpp>
#include <delref/domain/walk_along.hpp>

namespace delref {

/// Fills the empty triangulation `tr` with the vertices of `before`, a refined triangulation of `domain`, and with what `united`
/// adds to its graph. Use once: the constructor does the work. `before` and `domain` are not changed.
///
///  - An input vertex with the coordinates of a Steiner vertex takes its place; if that was on a segment, or if the vertex is within
///    2 ulp (of the segment's largest coordinate) of a subsegment, the segment is cut there: `united()` has the parts.
///  - A new segment runs over the free Steiner vertices within 2 ulp of it, which are then on it, and is cut at such input vertices.
///  - Steiner vertices that would force tiny triangles are left out: those nearer to a new vertex, and the free ones nearer to a new
///    segment, than a quarter of the distance to their nearest neighbour, and those on two segments that newly meet under 2 degrees.
///
/// Throws `InvalidInput` when segments cross other than in an input vertex of the united graph, or when its seeds leave no
/// domain; `Interrupted`. O(n log n), and the faces along each new segment.
template <class Tr>
class PlanarDomainExtension {
  using Vertex = typename Tr::Vertex;
  using Index = Pslg::Index;

 public:
  PlanarDomainExtension(const Tr& before, const PlanarDomain& domain, UnitedPslg united, Tr& tr, const Control& control)
      : before_(before), old_(domain), united_(std::move(united)), tr_(tr), control_(control) {
    domain_.scale = scale_exponent(united_.checked.pslg);
    domain_.pslg = scaled(united_.checked.pslg, domain_.scale);
    cuts_.resize(old_.pslg.segments.size());
    chains_.resize(old_.pslg.segments.size());
    collect_steiner();
    find_new_vertices_on_segments();
    cut_old_segments();
    insert_points();
    cut_new_segments();
    drop_near_tiny_angles();
    drop_near_new_vertices();
    remove_dropped();
    insert_segments();
    notes_ = PlanarDomainLabeller<Tr>(tr_, domain_, united_.checked, std::span(vertices_).first(domain_.pslg.points.size()), control_).notes();
  }

  /// The domain, and its graph with the names of all that was given; the extension is then without it.
  PlanarDomain domain() && { return std::move(domain_); }
  CheckedPslg united() && { return std::move(united_.checked); }
  std::vector<std::string> notes() && { return std::move(notes_); }

 private:
  static constexpr auto none = std::numeric_limits<std::uint32_t>::max();
  /// A Steiner vertex of the old triangulation: in the new scale, with the old graph's segment that it is on, or none.
  struct Steiner {
    Point2 point;
    LevelIndex provenance;
    std::uint32_t on;
    bool dropped;
  };
  /// Part of a segment between two input vertices, and the Steiner vertices on it, in order.
  struct Piece {
    std::array<Index, 2> ends;
    std::size_t of;  ///< the united graph's segment
    std::vector<std::uint32_t> chain;
  };
  /// A vertex on the way of a segment: an input vertex, or a Steiner vertex, by its place in `steiner_`.
  struct Item {
    double order;
    std::uint32_t number;
    bool is_input;
  };

  Point2 point(Index i) const { return domain_.pslg.points[i]; }
  bool is_new_point(std::size_t i) const { return united_.point_source[i] >= old_.pslg.points.size(); }
  bool is_new_segment(std::size_t s) const { return united_.segment_source[s] >= old_.pslg.segments.size(); }

  /// Those that have the coordinates of an input vertex become that vertex, and cut the segment that they are on.
  void collect_steiner() {
    PairTable input(domain_.pslg.points.size());
    for (Index i = 0; i < domain_.pslg.points.size(); ++i) input[PairTable::key(point(i))] = i;
    std::vector<Vertex> found;
    for (const Vertex v : before_.finite_vertices())
      if (before_.provenance(v) != input_level && before_.carrier(v).dimension > 0) found.push_back(v);
    std::ranges::sort(found, {}, [&](Vertex v) { return before_.index(v); });
    for (const Vertex v : found) {
      const Carrier c = before_.carrier(v);
      Steiner s{scaled(before_.point(v), domain_.scale - old_.scale), before_.provenance(v), none, false};
      if (c.dimension == 1) s.on = old_.segments[c.index].original;
      const Index same = input.find(PairTable::key(s.point));
      if (same == PairTable::none) {
        if (s.on != none) chains_[s.on].push_back(static_cast<std::uint32_t>(steiner_.size()));
        steiner_.push_back(s);
      } else if (s.on != none) {
        cuts_[s.on].push_back(same);
      }
    }
  }

  /// New vertices beside a subsegment cut its segment.
  void find_new_vertices_on_segments() {
    typename Tr::CgalFace near{};
    for (Index i = 0; i < domain_.pslg.points.size(); ++i) {
      if (!is_new_point(i)) continue;
      if (i % 4096 == 0) throw_if_stopped(control_);
      const Point2 p = scaled(point(i), old_.scale - domain_.scale);
      typename Tr::Cgal::Locate_type type;
      int k = 0;
      near = before_.cgal().locate({p.x, p.y}, type, k, near);
      if (type == Tr::Cgal::VERTEX) continue;
      double least = std::numeric_limits<double>::infinity();
      std::uint32_t on = none;
      const auto look_at = [&](typename Tr::CgalFace f) {
        for (int j = 0; j < 3; ++j) {
          const typename Tr::Edge e{f, j};
          if (!before_.is_constrained(e)) continue;
          const ChainLine line(before_.point(before_.source(e)), before_.point(before_.target(e)));
          if (!line.holds(p) || line.distance(p) >= least) continue;
          least = line.distance(p);
          on = old_.segments[before_.segment(e)].original;
        }
      };
      look_at(near);
      for (int j = 0; j < 3; ++j) look_at(near->neighbor(j));
      if (on != none) cuts_[on].push_back(i);
    }
  }

  /// The segments of the old graph with their Steiner vertices. What is on none of the parts any more is left out.
  void cut_old_segments() {
    for (std::size_t s = 0; s < domain_.pslg.segments.size(); ++s) {
      if (is_new_segment(s)) continue;
      if (s % 4096 == 0) throw_if_stopped(control_);
      const auto source = united_.segment_source[s];
      const auto [a, b] = domain_.pslg.segments[s];
      const ChainLine line(point(a), point(b));
      std::vector<Item> items;
      for (const std::uint32_t v : chains_[source])
        if (line.is_between(steiner_[v].point)) items.push_back({line.order(steiner_[v].point), v, false});
      for (const Index i : cuts_[source])
        if (line.is_between(point(i))) items.push_back({line.order(point(i)), i, true});
      add_pieces(s, std::move(items));
    }
    std::vector<bool> is_placed(steiner_.size());
    for (const Piece& piece : pieces_)
      for (const std::uint32_t v : piece.chain) is_placed[v] = true;
    for (std::size_t v = 0; v < steiner_.size(); ++v)
      if (steiner_[v].on != none && !is_placed[v]) steiner_[v].dropped = true;
    old_pieces_ = pieces_.size();
  }

  void add_pieces(std::size_t s, std::vector<Item> items) {
    std::ranges::sort(items, {}, &Item::order);
    const auto [first, last] = domain_.pslg.segments[s];
    Piece piece{{first, last}, s, {}};
    for (const Item& item : items) {
      if (!item.is_input) {
        piece.chain.push_back(item.number);
        continue;
      }
      if (item.number == piece.ends[0]) continue;  // found twice
      piece.ends[1] = item.number;
      add_piece(std::exchange(piece, {{item.number, last}, s, {}}));
    }
    add_piece(std::move(piece));
  }
  /// Cutting moves a segment a little: vertices that are then too far from their part are left out.
  void add_piece(Piece piece) {
    const ChainLine line(point(piece.ends[0]), point(piece.ends[1]));
    std::erase_if(piece.chain, [&](std::uint32_t v) { return !line.is_between(steiner_[v].point) || line.distance(steiner_[v].point) > 3.5 * line.ulp(); });
    pieces_.push_back(std::move(piece));
  }

  void insert_points() {
    std::vector<Point2> points = domain_.pslg.points;
    for (std::uint32_t v = 0; v < steiner_.size(); ++v)
      if (!steiner_[v].dropped) place_.push_back(points.size()), points.push_back(steiner_[v].point);
      else place_.push_back(0);
    vertices_ = insert_planar_points(tr_, std::span<const Point2>(points), domain_.pslg.points.size(), control_);
    std::size_t numbers = 0;  // also of the vertices of the box, which may be the last
    for (const Vertex v : tr_.finite_vertices()) numbers = std::max(numbers, tr_.index(v) + 1);
    steiner_at_.assign(numbers, none);
    for (std::uint32_t v = 0; v < steiner_.size(); ++v) {
      if (steiner_[v].dropped) continue;
      tr_.set_origin(vertices_[place_[v]], Carrier{2, Carrier::none}, steiner_[v].provenance);
      steiner_at_[tr_.index(vertices_[place_[v]])] = v;
    }
  }

  /// The way of each new segment. A part that is there already is dropped.
  void cut_new_segments() {
    std::vector<std::uint32_t> beside;
    for (std::size_t s = 0; s < domain_.pslg.segments.size(); ++s) {
      if (!is_new_segment(s)) continue;
      throw_if_stopped(control_);
      add_pieces(s, vertices_on_way(s, beside));
    }
    for (std::size_t k = old_pieces_; k < pieces_.size(); ++k)
      for (const std::uint32_t v : pieces_[k].chain) steiner_[v].on = static_cast<std::uint32_t>(pieces_[k].of);
    for (const std::uint32_t v : beside)
      if (steiner_[v].on == none) steiner_[v].dropped = true;
    PairTable known(pieces_.size());
    std::size_t kept = 0;
    for (Piece& piece : pieces_) {
      auto& first = known[{std::min(piece.ends[0], piece.ends[1]), std::max(piece.ends[0], piece.ends[1])}];
      if (first != PairTable::none) {
        for (const std::uint32_t v : piece.chain) steiner_[v].dropped = true;
        auto& markers = united_.checked.pslg.segment_markers;
        if (!markers.empty() && markers[pieces_[first].of] == 0) markers[pieces_[first].of] = markers[piece.of];
        continue;
      }
      first = static_cast<std::uint32_t>(kept);
      if (&pieces_[kept] != &piece) pieces_[kept] = std::move(piece);
      ++kept;
    }
    pieces_.resize(kept);
  }

  /// The vertices on the way of a new segment; adds the free ones that are beside it and too near.
  std::vector<Item> vertices_on_way(std::size_t s, std::vector<std::uint32_t>& beside) {
    const auto [a, b] = domain_.pslg.segments[s];
    const ChainLine line(point(a), point(b));
    std::vector<Item> items;
    for (const Vertex v : vertices_along(tr_, vertices_[a], vertices_[b])) {
      const Point2 p = tr_.point(v);
      if (!line.is_between(p)) continue;
      const bool is_input = tr_.carrier(v).dimension == 0;
      const std::uint32_t number = is_input ? tr_.carrier(v).index : steiner_at_[tr_.index(v)];
      if (!is_input && (number == none || steiner_[number].on != none)) continue;
      const double distance = line.distance(p);
      if (distance <= line.tolerance()) items.push_back({line.order(p), number, is_input});
      else if (!is_input && 16 * distance * distance < squared_space(v)) beside.push_back(number);
    }
    return items;
  }
  /// The squared distance from `v` to its nearest neighbour that is no new input vertex.
  double squared_space(Vertex v) const {
    double least = std::numeric_limits<double>::infinity();
    auto around = tr_.cgal().incident_vertices(v.handle);
    const auto first = around;
    do {
      const Vertex w{around};
      if (tr_.cgal().is_infinite(w.handle) || (tr_.carrier(w).dimension == 0 && is_new_point(tr_.carrier(w).index))) continue;
      least = std::min(least, squared_distance(tr_.point(v), tr_.point(w)));
    } while (++around != first);
    return least;
  }

  /// Where a new segment meets another at a tiny angle both are to be split at the same distances from the corner.
  void drop_near_tiny_angles() {
    std::vector<std::pair<Index, std::size_t>> at;
    for (std::size_t k = 0; k < pieces_.size(); ++k)
      for (const Index end : pieces_[k].ends) at.emplace_back(end, k);
    std::ranges::sort(at);
    const auto arm = [&](const Piece& piece, Index corner) { return point(piece.ends[piece.ends[0] == corner ? 1 : 0]) - point(corner); };
    const auto drop = [&](const Piece& piece, Index corner, double squared_reach) {
      for (const std::uint32_t v : piece.chain)
        if (squared_distance(steiner_[v].point, point(corner)) <= squared_reach) steiner_[v].dropped = true;
    };
    for (std::size_t k = 0; k < pieces_.size(); ++k) {
      if (!is_new_segment(pieces_[k].of)) continue;
      for (const Index corner : pieces_[k].ends)
        for (auto other = std::ranges::lower_bound(at, std::pair(corner, std::size_t{0})); other != at.end() && other->first == corner; ++other) {
          if (other->second == k) continue;
          const Vector2 u = arm(pieces_[k], corner), w = arm(pieces_[other->second], corner);
          if (dot(u, w) < PlanarDomain::tiny_angle_cosine * std::sqrt(squared_length(u) * squared_length(w))) continue;
          drop(pieces_[k], corner, squared_length(w)), drop(pieces_[other->second], corner, squared_length(u));
        }
    }
  }

  void drop_near_new_vertices() {
    for (Index i = 0; i < domain_.pslg.points.size(); ++i) {
      if (!is_new_point(i)) continue;
      auto around = tr_.cgal().incident_vertices(vertices_[i].handle);
      const auto first = around;
      do {
        const Vertex w{around};
        if (tr_.cgal().is_infinite(w.handle) || tr_.carrier(w).dimension == 0) continue;
        const std::uint32_t v = steiner_at_[tr_.index(w)];
        if (v != none && 16 * squared_distance(tr_.point(w), point(i)) < squared_space(w)) steiner_[v].dropped = true;
      } while (++around != first);
    }
  }

  void remove_dropped() {
    for (std::size_t v = 0; v < steiner_.size(); ++v)
      if (steiner_[v].dropped && place_[v] != 0) tr_.cgal().remove(vertices_[place_[v]].handle);
    for (Piece& piece : pieces_) std::erase_if(piece.chain, [&](std::uint32_t v) { return steiner_[v].dropped; });
  }

  std::vector<Vertex> chain(const Piece& piece) const {
    std::vector<Vertex> result{vertices_[piece.ends[0]]};
    for (const std::uint32_t v : piece.chain) result.push_back(vertices_[place_[v]]);
    result.push_back(vertices_[piece.ends[1]]);
    return result;
  }

  void insert_segments() {
    write_pieces();
    try {
      for (std::size_t k = 0; k < pieces_.size(); ++k) {
        if (k % 4096 == 0) throw_if_stopped(control_);
        insert_planar_chain<Tr>(tr_, chain(pieces_[k]));
      }
    } catch (const typename Tr::Cgal::Intersection_of_constraints_exception&) {
      refuse_crossings(united_.checked, control_);
    }
    for (std::size_t k = 0; k < pieces_.size(); ++k)
      if (!name_planar_chain<Tr>(tr_, domain_, chain(pieces_[k]), static_cast<Index>(k))) refuse_crossings(united_.checked, control_);
    domain_.index_segments();
  }

  /// The graph's segments become the pieces.
  void write_pieces() {
    CheckedPslg& checked = united_.checked;
    const std::vector<int> markers = std::exchange(checked.pslg.segment_markers, {});
    const std::vector<Index> originals = std::exchange(checked.original_segment, {});
    checked.pslg.segments.clear();
    for (const Piece& piece : pieces_) {
      checked.pslg.segments.push_back(piece.ends);
      if (!markers.empty()) checked.pslg.segment_markers.push_back(markers[piece.of]);
      checked.original_segment.push_back(originals[piece.of]);
    }
    domain_.pslg.segments = checked.pslg.segments;
    domain_.pslg.segment_markers = checked.pslg.segment_markers;
  }

  const Tr& before_;
  const PlanarDomain& old_;
  UnitedPslg united_;
  Tr& tr_;
  const Control& control_;
  PlanarDomain domain_;
  std::vector<Steiner> steiner_;
  std::vector<std::vector<std::uint32_t>> chains_;  // the Steiner vertices on each segment of the old graph
  std::vector<std::vector<Index>> cuts_;            // the input vertices that cut it
  std::vector<Piece> pieces_;                       // of old segments, then of new ones
  std::size_t old_pieces_ = 0;
  std::vector<Vertex> vertices_;                    // input, then those of `steiner_` that were kept
  std::vector<std::size_t> place_;                  // of those of `steiner_` in `vertices_`
  std::vector<std::uint32_t> steiner_at_;           // the place in `steiner_` by vertex number
  std::vector<std::string> notes_;
};

}  // namespace delref
