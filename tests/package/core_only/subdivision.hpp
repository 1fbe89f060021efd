// SPDX-License-Identifier: MIT
//
// A triangulation of dimension one: an interval cut into edges. The least that a `Mesher` can refine, and a level that halves
// its edges until none is longer than asked. To be included after delref's core, by header or by import.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace consumer {

struct Position {
  double x = 0;
  friend bool is_finite(const Position& p) { return std::isfinite(p.x); }
};

/// The edge from `left` to the vertex after it, while that is `right`.
struct Piece {
  std::size_t left = 0, right = 0;
  friend bool operator==(const Piece&, const Piece&) = default;
};

class Subdivision {
 public:
  using Point = Position;
  using Vertex = std::size_t;
  using Edge = Piece;
  using Hint = Piece;
  struct Zone {
    Piece dying;
    std::array<Vertex, 0> vanishing() const { return {}; }
  };
  static constexpr int dimension = 1;

  Subdivision(double from, double to) : vertices_{{{from}, 1, {0, 0}, delref::input_level}, {{to}, 0, {0, 1}, delref::input_level}} {}

  delref::Location<Subdivision> conflict_zone(const Point& p, const Hint& hint, Zone& zone) {
    using Kind = delref::Location<Subdivision>::Kind;
    zone.dying = hint;
    if (p.x == point(hint.left).x || p.x == point(hint.right).x) return {Kind::on_vertex, hint};
    if (p.x < point(hint.left).x || p.x > point(hint.right).x) return {Kind::outside, hint};
    return {Kind::zone, hint};
  }
  Vertex insert(const Point& p, Zone& zone) {
    vertices_.push_back({p, zone.dying.right, {}, 0});
    vertices_[zone.dying.left].next = vertices_.size() - 1;
    return vertices_.size() - 1;
  }

  Point point(Vertex v) const { return vertices_[v].point; }
  std::size_t index(Vertex v) const { return v; }
  delref::Carrier carrier(Vertex v) const { return vertices_[v].carrier; }
  delref::LevelIndex provenance(Vertex v) const { return vertices_[v].level; }
  void set_origin(Vertex v, delref::Carrier carrier, delref::LevelIndex level) {
    vertices_[v].carrier = carrier;
    vertices_[v].level = level;
  }
  std::size_t number_of_vertices() const { return vertices_.size(); }
  bool is_simplex(std::span<const Vertex> v) const { return v.size() == 2 && vertices_[v[0]].next == v[1]; }
  Point barycentre(std::span<const Vertex> v) const { return {(point(v.front()).x + point(v.back()).x) / 2}; }
  void clear_slots() {}

  std::array<Vertex, 2> vertices(const Piece& e) const { return {e.left, e.right}; }
  bool dies(const Piece& e, const Zone& zone) const { return e == zone.dying; }
  double length(const Piece& e) const { return point(e.right).x - point(e.left).x; }
  Vertex next(Vertex v) const { return vertices_[v].next; }

 private:
  struct Record {
    Point point;
    Vertex next;
    delref::Carrier carrier;
    delref::LevelIndex level;
  };
  std::vector<Record> vertices_;
};

/// Halves every edge that is longer than `longest`.
class LengthLevel {
 public:
  using Element = Piece;
  explicit LengthLevel(double longest) : longest_(longest) {}

  void scan_triangulation(Subdivision& tr) {
    queue_.clear();
    for (std::size_t v = 0; v != 1; v = tr.next(v)) consider(tr, {v, tr.next(v)});
  }
  bool empty() const { return queue_.empty(); }
  Element next_element() { return queue_.back(); }
  void pop_next_element(Subdivision&) { queue_.pop_back(); }
  Position refinement_point(const Subdivision& tr, const Element& e) {
    return {(tr.point(e.left).x + tr.point(e.right).x) / 2};
  }
  delref::Verdict check_refinement_point(Subdivision&, const delref::Proposal<Subdivision>&) { return delref::Verdict::permitted; }
  void before_insertion(Subdivision&, const delref::Proposal<Subdivision>& p) { std::erase(queue_, p.zone->dying); }
  void after_insertion(Subdivision& tr, std::size_t v, const delref::Proposal<Subdivision>& p) {
    consider(tr, {p.zone->dying.left, v});
    consider(tr, {v, p.zone->dying.right});
  }

 private:
  void consider(const Subdivision& tr, const Piece& e) {
    if (tr.length(e) > longest_) queue_.push_back(e);
  }

  double longest_;
  std::vector<Element> queue_;
};

}  // namespace consumer
