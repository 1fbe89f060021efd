// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rooms into which the facets divide space, and which of them are the domain. The two sides of every triangle on a facet are
// united around their edges; what one room has in several pieces (a body inside another) lines through the pieces unite.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <fmt/format.h>

#include <delref/mesh/twofold.hpp>
#include <delref/mesh/verify_3/facet_cover.hpp>
#include <delref/mesh/verify_3/line_shooter.hpp>

namespace delref::verification_3 {

/// A connected part of space without the facets.
struct Room {
  bool inside = true;
  /// The regions whose seeds lie in it, by their index in the input.
  std::vector<Index> regions;
};

class Rooms {
 public:
  Rooms(const Subject& s, const InputComplex& complex, const Chains& chains, const std::vector<Index>& group_of,
        const std::vector<bool>& present)
      : s_(s), complex_(complex), triangles_(s.mesh.triangles), group_of_(group_of), sides_(0) {
    add_missing_facets(chains, present);
    sides_ = DisjointSets(2 * triangles_.size() + 1);
    unite_around_edges();
    shooter_.emplace(
        triangles_, [this](Index v) { return place(v); }, s_.control);
    unite_pieces();
    number_rooms();
    place_seeds();
  }

  /// Why the rooms could not be told; empty when they could.
  std::span<const std::string> problems() const { return problems_; }
  std::span<const Room> rooms() const { return rooms_; }
  /// The listed triangles, then those of facets of which the mesh lists none, with their group.
  std::span<const std::array<Index, 3>> triangles() const { return triangles_; }
  Index group_of(std::size_t triangle) const { return group_of_[triangle]; }
  /// The room on the side of a triangle that sees it counterclockwise, or on the other.
  Index room(std::size_t triangle, bool front) const { return room_of_side_[side(triangle, front)]; }
  /// The room that holds a scaled place; none for a place on a facet.
  Index room_at(Point3 scaled) const {
    const auto line = shooter_->line(scaled);
    if (!line) return none;
    for (const Crossing& c : *line)
      if (c.along > 0) return room(c.triangle, c.from_front);
    return room_of_side_.back();
  }
  Point3 place(Index v) const { return v < s_.points.size() ? s_.points[v] : s_.input_points[v - s_.points.size()]; }

 private:
  Index outer_space() const { return static_cast<Index>(2 * triangles_.size()); }
  static Index side(std::size_t triangle, bool front) { return static_cast<Index>(2 * triangle + (front ? 0 : 1)); }

  void add_missing_facets(const Chains& chains, const std::vector<bool>& present) {
    const auto vertex = [&](Index canonical) {
      const Index v = chains.vertex_of_input(canonical);
      return v != none ? v : static_cast<Index>(s_.points.size() + canonical);
    };
    for (Index g = 0; g < present.size(); ++g) {
      s_.breathe(g);
      if (present[g]) continue;
      const Group& group = complex_.groups()[g];
      const FacetRegion region(
          group, edges_of_group(complex_, chains, group, vertex), [this](Index v) { return place(v); },
          holes_of_group(s_, group));
      if (!region.usable()) problems_.push_back("the segments of " + s_.facet(group.facets.front()) + " cross each other");
      for (const auto& triangle : region.triangles()) {
        triangles_.push_back(triangle);
        group_of_.push_back(g);
      }
    }
  }

  /// A triangle at an edge from a to b, a < b.
  struct Leaf {
    Index triangle, apex;
    bool turned;  ///< the triangle goes from b to a
    int quarter = 0;
  };

  void unite_around_edges() {
    const std::vector<EdgeEntry> edges = edges_of_triangles(triangles_);
    std::vector<Leaf> leaves;
    std::size_t step = 0;
    for_each_edge(edges, [&](std::span<const EdgeEntry> run) {
      s_.breathe(step++);
      leaves.clear();
      for (const EdgeEntry& e : run) leaves.push_back(leaf(e));
      if (leaves.size() > 2) sort_around(run[0].a, run[0].b, leaves);
      for (std::size_t i = 0; i < leaves.size(); ++i) {
        const Leaf &here = leaves[i], &next = leaves[(i + 1) % leaves.size()];
        sides_.unite(side(here.triangle, !here.turned), side(next.triangle, next.turned));
      }
    });
  }

  Leaf leaf(const EdgeEntry& e) const {
    const auto& t = triangles_[e.value];
    std::size_t k = 0;
    while (t[k] == e.a || t[k] == e.b) ++k;
    return {e.value, t[k], t[(k + 1) % 3] == e.b};
  }

  CGAL::Orientation orientation(Index a, Index b, Index c, Index d) const {
    return CGAL::orientation(exact(place(a)), exact(place(b)), exact(place(c)), exact(place(d)));
  }

  /// Counterclockwise around the edge from a to b, from the first leaf on.
  void sort_around(Index a, Index b, std::vector<Leaf>& leaves) {
    const Leaf first = leaves.front();
    const Vector3 axis = place(b) - place(a);
    const auto across = [&](Index v) { return cross(axis, place(v) - place(a)); };
    for (Leaf& l : leaves) {
      const auto turn = orientation(a, b, first.apex, l.apex);
      const bool opposite = dot(across(first.apex), across(l.apex)) < 0;
      l.quarter = turn == CGAL::POSITIVE ? 1 : turn == CGAL::NEGATIVE ? 3 : opposite ? 2 : 0;
    }
    std::ranges::sort(leaves, [&](const Leaf& p, const Leaf& q) {
      if (p.quarter != q.quarter) return p.quarter < q.quarter;
      if (p.quarter % 2 == 0) return p.triangle < q.triangle;
      const auto turn = orientation(a, b, p.apex, q.apex);
      return turn == CGAL::ZERO ? p.triangle < q.triangle : turn == CGAL::POSITIVE;
    });
    for (std::size_t i = 1; i < leaves.size(); ++i)
      if (leaves[i].quarter == leaves[i - 1].quarter && orientation(a, b, leaves[i - 1].apex, leaves[i].apex) == CGAL::ZERO)
        problems_.push_back(
            fmt::format("{} and {} lie on top of each other", words(leaves[i - 1].triangle), words(leaves[i].triangle)));
  }
  std::string words(Index triangle) const {
    return triangle < s_.mesh.triangles.size() ? s_.triangle(triangles_[triangle])
                                               : s_.facet(complex_.groups()[group_of_[triangle]].facets.front());
  }

  /// What bounds a room from outside encloses a positive volume; whatever else there is lies in a room and is reached by a line
  /// through it.
  void unite_pieces() {
    struct Piece {
      PreciseSum volume;
      double size = 0, largest = -1;
      Index triangle = none;
    };
    std::map<Index, Piece> pieces;
    const Point3 centre = triangles_.empty() ? Point3{} : place(triangles_[0][0]);
    for (Index t = 0; t < triangles_.size(); ++t) {
      const auto& [a, b, c] = triangles_[t];
      const double volume = dot(place(a) - centre, cross(place(b) - centre, place(c) - centre));
      const double area = squared_length(cross(place(b) - place(a), place(c) - place(a)));
      for (const bool front : {true, false}) {
        Piece& piece = pieces[sides_.find(side(t, front))];
        piece.volume += front ? -volume : volume;
        piece.size += std::abs(volume);
        if (area > piece.largest) piece.largest = area, piece.triangle = t;
      }
    }
    std::set<Index> shot;
    for (const auto& [name, piece] : pieces) {
      const bool surely_outer = piece.volume.value() > 1e-9 * piece.size;
      if ((surely_outer && pieces.size() > 32) || !shot.insert(piece.triangle).second) continue;
      const auto& [a, b, c] = triangles_[piece.triangle];
      const Point3 middle = place(a) + (1.0 / 3) * ((place(b) - place(a)) + (place(c) - place(a)));
      const auto line = shooter_->line(middle, piece.triangle);
      if (!line) {
        problems_.push_back("no straight line through " + words(piece.triangle) + " keeps clear of all edges");
        continue;
      }
      Index before = outer_space();
      for (const Crossing& crossing : *line) {
        sides_.unite(before, side(crossing.triangle, crossing.from_front));
        before = side(crossing.triangle, !crossing.from_front);
      }
      sides_.unite(before, outer_space());
    }
  }

  void number_rooms() {
    std::map<Index, Index> number;
    for (Index i = 0; i <= outer_space(); ++i)
      room_of_side_.push_back(number.try_emplace(sides_.find(i), static_cast<Index>(number.size())).first->second);
    rooms_.resize(number.size());
    rooms_[room_of_side_.back()].inside = false;
  }

  void place_seeds() {
    const auto on_a_facet = [](const char* what, Point3 p) {
      return fmt::format("the {} seed at {} lies on a facet, so it marks neither side", what, Subject::place(p));
    };
    for (const Point3 hole : s_.input.holes) {
      const Index room = room_at(s_.scaling(hole));
      if (room == none)
        problems_.push_back(on_a_facet("hole", hole));
      else
        rooms_[room].inside = false;
    }
    for (Index r = 0; r < s_.input.regions.size(); ++r) {
      const Index room = room_at(s_.scaling(s_.input.regions[r].seed));
      if (room == none)
        problems_.push_back(on_a_facet("region", s_.input.regions[r].seed));
      else
        rooms_[room].regions.push_back(r);
    }
  }

  const Subject& s_;
  const InputComplex& complex_;
  std::vector<std::array<Index, 3>> triangles_;
  std::vector<Index> group_of_;
  DisjointSets sides_;
  std::optional<LineShooter> shooter_;
  std::vector<Index> room_of_side_;
  std::vector<Room> rooms_;
  std::vector<std::string> problems_;
};

}  // namespace delref::verification_3
