// SPDX-License-Identifier: MIT
//
// A triangulation of dimension one with everything that the frame can meet in one: slots, walls that hide what is behind them,
// vertices that vanish, points that cannot be inserted. Refining it is quick enough, and simple enough, to check each step by hand.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <delref/core/queue/refinement_queue.hpp>
#include <delref/core/triangulation_concept.hpp>

namespace track {

struct Place {
  double x = 0;
  friend bool operator==(Place, Place) = default;
  friend bool is_finite(Place p) { return std::isfinite(p.x); }
};

/// A vertex, by its number.
struct Knot {
  std::size_t number = 0;
  friend bool operator==(Knot, Knot) = default;
};

/// The element between two neighbouring vertices.
struct Piece {
  Knot left, right;
  friend bool operator==(const Piece&, const Piece&) = default;
};

/// An interval of the line cut into pieces, with `Slots` slots in each. Vertices 0 and 1 are its ends.
template <std::size_t Slots = 2>
class Track {
 public:
  using Point = Place;
  using Vertex = Knot;
  using Edge = Knot;  // a wall
  using Hint = Piece;
  struct Zone {
    Knot left, right;         // the ends of the hole
    std::vector<Piece> dying;
    std::array<Piece, 2> made;
    std::vector<Knot> gone;
    std::span<const Knot> vanishing() const { return gone; }
  };
  using Location = delref::Location<Track>;
  using Kind = typename Location::Kind;
  static constexpr int dimension = 1;
  template <class Element>
  static constexpr std::size_t slot_count = Slots;

  Track(double from, double to) {
    records_.push_back({.place = {from}, .next = {1}});
    records_.push_back({.place = {to}, .previous = {0}});
  }

  // -- the scene
  /// Adds an input vertex. A wall stops every search for a point that would cross it.
  Knot add(double x, bool wall = false) {
    Zone zone;
    conflict_zone({x}, {{0}, {1}}, zone, true);
    const Knot v = insert({x}, zone);
    records_[v.number].wall = wall;
    return v;
  }
  /// There is no valid star of a point at `x`.
  void make_degenerate(double x) { degenerate_ = x; }

  std::vector<Piece> pieces() const {
    std::vector<Piece> result;
    for (Knot v{0}; v.number != 1; v = at(v).next) result.push_back({v, at(v).next});
    return result;
  }
  std::vector<double> coordinates() const {
    std::vector<double> result{at({0}).place.x};
    for (const Piece& e : pieces()) result.push_back(at(e.right).place.x);
    return result;
  }
  double length(const Piece& e) const { return at(e.right).place.x - at(e.left).place.x; }
  Piece piece_from(Knot left) const { return {left, at(left).next}; }

  // -- what the frame asks
  Location conflict_zone(const Place& p, const Piece& hint, Zone& zone, bool through_walls = false) const {
    Knot left = hint.left;
    while (p.x < at(left).place.x) {
      if (left.number == 0) return {Kind::outside, {}};
      if (at(left).wall && !through_walls) return {Kind::blocked, left};
      left = at(left).previous;
    }
    while (p.x >= at(at(left).next).place.x) {
      const Knot next = at(left).next;
      if (next.number == 1 && p.x > at(next).place.x) return {Kind::outside, {}};
      if (p.x == at(next).place.x) return {Kind::on_vertex, {}};
      if (at(next).wall && !through_walls) return {Kind::blocked, next};
      left = next;
    }
    if (p.x == at(left).place.x) return {Kind::on_vertex, {}};
    if (degenerate_ == p.x) return {Kind::degenerate, {}};
    zone.left = left;
    zone.right = at(left).next;
    zone.gone.clear();
    zone.dying.assign(1, Piece{zone.left, zone.right});
    return {Kind::zone, {}};
  }
  /// Widens a zone, so that the vertices at its ends vanish as long as `vanishes(v)`.
  template <class F>
  void widen(Zone& zone, F&& vanishes) const {
    for (; zone.left.number != 0 && vanishes(zone.left); zone.left = at(zone.left).previous) {
      zone.gone.push_back(zone.left);
      zone.dying.push_back({at(zone.left).previous, zone.left});
    }
    for (; zone.right.number != 1 && vanishes(zone.right); zone.right = at(zone.right).next) {
      zone.gone.push_back(zone.right);
      zone.dying.push_back({zone.right, at(zone.right).next});
    }
  }
  Knot insert(const Place& p, Zone& zone) {
    for (const Knot gone : zone.gone) records_[gone.number].alive = false;
    const Knot v{records_.size()};
    records_.push_back({.place = p, .next = zone.right, .previous = zone.left});
    records_[zone.left.number].next = v;
    records_[zone.left.number].slots = no_slots();
    records_[zone.right.number].previous = v;
    zone.made = {Piece{zone.left, v}, Piece{v, zone.right}};
    return v;
  }

  Place point(Knot v) const { return at(v).place; }
  std::size_t index(Knot v) const { return v.number; }
  delref::Carrier carrier(Knot v) const { return at(v).carrier; }
  delref::LevelIndex provenance(Knot v) const { return at(v).level; }
  void set_origin(Knot v, delref::Carrier carrier, delref::LevelIndex level) {
    records_[v.number].carrier = carrier;
    records_[v.number].level = level;
  }
  std::size_t number_of_vertices() const {
    return static_cast<std::size_t>(std::ranges::count(records_, true, &Record::alive));
  }
  bool is_simplex(std::span<const Knot> v) const {
    return v.size() == 2 && at(v[0]).alive && at(v[1]).alive && v[0].number != 1 && at(v[0]).next == v[1];
  }
  Place barycentre(std::span<const Knot> v) const { return {0.5 * (point(v.front()).x + point(v.back()).x)}; }
  std::array<Knot, 2> vertices(const Piece& e) const { return {e.left, e.right}; }
  bool dies(const Piece& e, const Zone& zone) const { return std::ranges::find(zone.dying, e) != zone.dying.end(); }

  delref::QueuePosition slot(const Piece& e, std::size_t k) const { return at(e.left).slots[k]; }
  void set_slot(const Piece& e, std::size_t k, delref::QueuePosition position) { records_[e.left.number].slots[k] = position; }
  void clear_slots() {
    for (Record& r : records_) r.slots = no_slots();
  }

 private:
  using Marks = std::array<delref::QueuePosition, Slots>;
  static Marks no_slots() {
    Marks marks;
    marks.fill(-1);
    return marks;
  }
  struct Record {
    Place place{};
    Knot next{}, previous{};
    bool alive = true, wall = false;
    delref::Carrier carrier{};
    delref::LevelIndex level = delref::input_level;
    Marks slots = no_slots();
  };
  const Record& at(Knot v) const { return records_[v.number]; }

  std::vector<Record> records_;
  std::optional<double> degenerate_;
};

}  // namespace track
