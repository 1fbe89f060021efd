// SPDX-License-Identifier: MIT
//
// The smallest triangulation that a `Mesher` can refine: an interval of the line, cut into intervals by points. It has the members
// that `Triangulation` requires and those that make its intervals elements it stores, and no other; the argument of
// `LineWithout` takes one of them away.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

#include <delref/core/triangulation_concept.hpp>

namespace archetypes {

/// What is left out of an archetype triangulation.
enum class LinePart {
  none, point_type, is_finite, vertex_type, edge_type, hint_type, zone_type, dimension,
  conflict_zone, insert, vanishing,
  point, index, carrier, provenance, set_origin, number_of_vertices, is_simplex, barycentre,
  clear_slots,
  hint_from_element, vertices, dies
};

template <bool tells_finite>
struct Place {
  double x = 0;
  friend bool operator==(Place, Place) = default;
  friend bool is_finite(Place p) requires tells_finite { return std::isfinite(p.x); }
};

/// A vertex, by its number.
struct Knot {
  std::size_t number = 0;
  friend bool operator==(Knot, Knot) = default;
};

/// The element between two vertices.
struct Interval {
  Knot left, right;
  friend bool operator==(const Interval&, const Interval&) = default;
};

/// A hint that is no element.
struct Start {
  Knot left;
};

/// The interval that a point cuts, and the two that it makes.
template <bool lists_vanishing>
struct Cut {
  Interval dying;
  std::array<Interval, 2> made;
  std::span<const Knot> vanishing() const requires lists_vanishing { return {}; }
};

// A type or constant can be left out of a class only with a base that has or lacks it.
template <LinePart without> struct HasPoint { using Point = Place<without != LinePart::is_finite>; };
template <> struct HasPoint<LinePart::point_type> {};
template <LinePart> struct HasVertex { using Vertex = Knot; };
template <> struct HasVertex<LinePart::vertex_type> {};
template <LinePart> struct HasEdge { using Edge = Interval; };
template <> struct HasEdge<LinePart::edge_type> {};
template <LinePart without> struct HasHint { using Hint = std::conditional_t<without == LinePart::hint_from_element, Start, Interval>; };
template <> struct HasHint<LinePart::hint_type> {};
template <LinePart without> struct HasZone { using Zone = Cut<without != LinePart::vanishing>; };
template <> struct HasZone<LinePart::zone_type> {};
template <LinePart> struct HasDimension { static constexpr int dimension = 1; };
template <> struct HasDimension<LinePart::dimension> {};

/// An interval of the line, cut by points. `without` is the part that it lacks.
template <LinePart without>
class LineWithout : public HasPoint<without>, public HasVertex<without>, public HasEdge<without>, public HasHint<without>,
                    public HasZone<without>, public HasDimension<without> {
  using P = Place<without != LinePart::is_finite>;
  using Z = Cut<without != LinePart::vanishing>;
  using H = std::conditional_t<without == LinePart::hint_from_element, Start, Interval>;
  static constexpr bool has(LinePart part) { return without != part; }

 public:
  LineWithout(double from, double to) : records_{{{from}, {1}}, {{to}, {1}}} {}

  delref::Location<LineWithout> conflict_zone(const P& p, const H& hint, Z& zone) const requires (has(LinePart::conflict_zone)) {
    using Kind = delref::Location<LineWithout>::Kind;
    Knot left = hint.left;
    while (p.x < at(left).place.x && left.number != 0) left = {};
    if (p.x < at(left).place.x) return {Kind::outside};
    while (!is_last(left) && at(at(left).next).place.x <= p.x) left = at(left).next;
    if (p.x == at(left).place.x) return {Kind::on_vertex};
    if (is_last(left)) return {Kind::outside};
    zone.dying = {left, at(left).next};
    return {Kind::zone};
  }
  Knot insert(const P& p, Z& zone) requires (has(LinePart::insert)) {
    const Knot v{records_.size()};
    records_.push_back({p, zone.dying.right});
    records_[zone.dying.left.number].next = v;
    zone.made = {Interval{zone.dying.left, v}, Interval{v, zone.dying.right}};
    return v;
  }

  P point(Knot v) const requires (has(LinePart::point)) { return at(v).place; }
  std::size_t index(Knot v) const requires (has(LinePart::index)) { return v.number; }
  delref::Carrier carrier(Knot v) const requires (has(LinePart::carrier)) { return at(v).carrier; }
  delref::LevelIndex provenance(Knot v) const requires (has(LinePart::provenance)) { return at(v).level; }
  void set_origin(Knot v, delref::Carrier carrier, delref::LevelIndex level) requires (has(LinePart::set_origin)) {
    records_[v.number].carrier = carrier;
    records_[v.number].level = level;
  }
  std::size_t number_of_vertices() const requires (has(LinePart::number_of_vertices)) { return records_.size(); }
  bool is_simplex(std::span<const Knot> v) const requires (has(LinePart::is_simplex)) {
    return v.size() == 2 && !is_last(v[0]) && at(v[0]).next == v[1];
  }
  P barycentre(std::span<const Knot> v) const requires (has(LinePart::barycentre)) {
    return {0.5 * (at(v.front()).place.x + at(v.back()).place.x)};
  }
  void clear_slots() requires (has(LinePart::clear_slots)) {}

  std::array<Knot, 2> vertices(const Interval& e) const requires (has(LinePart::vertices)) { return {e.left, e.right}; }
  bool dies(const Interval& e, const Z& zone) const requires (has(LinePart::dies)) { return e == zone.dying; }

  /// For the levels that are written for this triangulation: its intervals, from left to right.
  friend std::vector<Interval> intervals_of(const LineWithout& line) {
    std::vector<Interval> intervals;
    for (Knot v; !line.is_last(v); v = line.at(v).next) intervals.push_back({v, line.at(v).next});
    return intervals;
  }

 private:
  struct Record {
    P place;
    Knot next;
    delref::Carrier carrier{};
    delref::LevelIndex level = delref::input_level;
  };
  const Record& at(Knot v) const { return records_[v.number]; }
  bool is_last(Knot v) const { return v.number == 1; }

  std::vector<Record> records_;
};

/// With all its parts.
using Line = LineWithout<LinePart::none>;

}  // namespace archetypes
