// SPDX-License-Identifier: GPL-3.0-or-later
//
// The surface ball of every triangle (Boissonnat and Oudot 2005), found again from the vertices and the oracle alone: the balls with
// the corners on their sphere have their centres on the axis of the triangle; where no vertex is inside is its dual edge, and there the
// oracle is asked for the region, place by place, until the crossing nearest to the triangle is known.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include <delref/mesh/verify/nearest_point.hpp>
#include <delref/mesh/verify_smooth/subject.hpp>
#include <delref/mesh/verify_smooth/surface_probe.hpp>

namespace delref::verification_smooth {

/// What was found on the axis of a triangle. Scaled.
struct SurfaceBall {
  enum class Kind : unsigned char {
    found,
    touching,     ///< the dual edge is on the surface somewhere, but does not go through it
    flat,         ///< the triangle has no axis
    not_empty,    ///< every ball through its corners has a vertex inside
    no_crossing,  ///< the surface, or the one between the regions of the triangle, does not meet the dual edge
    turned        ///< it does, but the triangle is turned the other way
  };
  Kind kind = Kind::flat;
  Point3 centre{};
  double radius = 0, distance = 0;  ///< the second between the centre and the circumcentre of the triangle
  Sides sides{};                    ///< the regions on the two sides of the surface there

  bool is_known() const { return kind == Kind::found || kind == Kind::touching; }
};

/// Finds surface balls; the oracle must outlive it.
template <Oracle O>
class SurfaceBallFinder {
  static constexpr std::size_t most_samples = 256;
  static constexpr double rounding = 2e-15;  // of places that are computed; scaled coordinates are below 1

 public:
  SurfaceBallFinder(const Subject& s, Questions<O>& questions)
      : s_(&s), questions_(&questions), probe_(questions), vertices_(s.points), bounds_(questions.bounds()), diagonal_(bounds_.diagonal()) {}

  /// The ball of a triangle. Where `wanted` names known regions the surface must be one that bounds one of these on its side.
  SurfaceBall operator()(const std::array<Point3, 3>& corners, double shortest_edge, Sides wanted) {
    SurfaceBall ball;
    if (!set_axis(corners)) return ball;
    const double tolerance = s_->options.surface_tolerance * shortest_edge / 16;
    // Near the triangle first, where most balls have their centre; the whole dual edge is dear.
    if (ball = nearest_crossing(-2 * radius_, 2 * radius_, wanted, tolerance); ball.kind == SurfaceBall::Kind::found && is_empty(ball)) return ball;
    const auto edge = dual_edge();
    if (!edge) return {SurfaceBall::Kind::not_empty};
    ball = nearest_crossing(edge->from, edge->to, wanted, tolerance);
    return ball.kind == SurfaceBall::Kind::found ? ball : touching(ball, wanted);
  }

  /// The regions at the two ends of the dual edge of a triangle; unknown ones when there is none.
  Sides at_ends(const std::array<Point3, 3>& corners) {
    if (!set_axis(corners)) return {};
    const auto edge = dual_edge();
    return edge ? Sides{questions_->region(at(edge->from)), questions_->region(at(edge->to))} : Sides{};
  }

 private:
  /// A part of the axis.
  struct Part {
    double from, to;
  };
  /// The part where no vertex is in the ball, made longer by what rounding may have taken.
  std::optional<Part> dual_edge() const {
    const auto high = end(1, reach(normal_)), low = end(-1, reach(Vector3{} - normal_));
    if (!high || !low) return std::nullopt;
    const double slack = uncertainty(std::max(std::abs(*high), std::abs(*low)));
    return -*low <= *high + slack ? std::optional(Part{-*low - slack, *high + slack}) : std::nullopt;
  }
  /// The crossing between two places of the axis that is nearest to the triangle, whatever is in its ball.
  SurfaceBall nearest_crossing(double from, double to, Sides wanted, double tolerance) {
    sample(from, to);
    SurfaceBall ball{SurfaceBall::Kind::no_crossing};
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < places_.size(); ++i) {
      const Sides change{regions_[i], regions_[i + 1]};
      if (change.behind == change.front) continue;
      if (is_turned(change, wanted)) {
        if (ball.kind != SurfaceBall::Kind::found) ball.kind = SurfaceBall::Kind::turned;
        continue;
      }
      if (!is_wanted(change, wanted)) continue;
      const double t = crossing(places_[i], places_[i + 1], change.behind, tolerance);
      if (std::abs(t) >= nearest) continue;
      nearest = std::abs(t);
      ball = {SurfaceBall::Kind::found, at(t), std::sqrt(radius_ * radius_ + t * t), nearest, change};
    }
    return ball;
  }
  /// Of a dual edge that was sampled and has no crossing: the place nearest to the triangle that is on the surface as far as rounding
  /// lets it be told. An edge may run along the surface, or be a point of it.
  SurfaceBall touching(const SurfaceBall& without, Sides wanted) {
    std::ranges::sort(places_, {}, [](double t) { return std::abs(t); });
    const double uncertain = 4 * uncertainty(std::abs(places_.back())) + 1e-15;  // more than the dual edge was made longer
    for (const double t : places_) {
      const bool is_there = wanted.behind == unknown_region ? probe_.finds_change(at(t), normal_, uncertain)
                                                            : probe_.finds_region(at(t), uncertain, wanted.behind) &&
                                                                  probe_.finds_region(at(t), uncertain, wanted.front);
      if (is_there) return {SurfaceBall::Kind::touching, at(t), std::sqrt(radius_ * radius_ + t * t), std::abs(t), wanted};
    }
    return without;
  }
  bool is_empty(const SurfaceBall& ball) const {
    return vertices_.closer_than(ball.centre, depth_squared(ball.radius)) == nullptr;
  }
  /// The squared distance from its centre within which a vertex is in a ball for certain: far from the origin, the centre is rounded by
  /// what may be much of the radius.
  static double depth_squared(double radius) {
    const double least = std::max(0.0, radius * (1 - 5e-12) - rounding);
    return least * least;
  }
  /// How far the end of a dual edge, so far from the circumcentre, may be from where it was computed.
  double uncertainty(double distance) const { return (1e-9 + 16 * rounding / radius_) * (radius_ + distance); }
  static bool is_wanted(Sides change, Sides wanted) {
    return wanted.behind == unknown_region || change.behind == wanted.behind || change.front == wanted.front;
  }
  static bool is_turned(Sides change, Sides wanted) {
    return wanted.behind == unknown_region ? change.behind < change.front : change.behind == wanted.front && change.front == wanted.behind;
  }

  bool set_axis(const std::array<Point3, 3>& corners) {
    const Vector3 u = corners[1] - corners[0], v = corners[2] - corners[0], n = cross(u, v);
    const double squared = squared_length(n);
    if (!(squared > 1e-28 * squared_length(u) * squared_length(v))) return false;
    const Vector3 r = (0.5 / squared) * (squared_length(v) * cross(n, u) + squared_length(u) * cross(v, n));
    centre_ = corners[0] + r;
    radius_ = std::sqrt(squared_length(r));
    normal_ = (1 / std::sqrt(squared)) * n;
    return true;
  }
  Point3 at(double t) const { return centre_ + t * normal_; }

  /// How far it is along the axis until the bounds are left behind for good; less than 0 when the axis comes from there.
  double reach(Vector3 way) const {
    const double margin = 1e-6 * diagonal_;
    double furthest = 4 * (diagonal_ + radius_);
    const auto cut = [&](double from, double direction, double low, double high) {
      if (direction > 0) furthest = std::min(furthest, (high + margin - from) / direction);
      if (direction < 0) furthest = std::min(furthest, (low - margin - from) / direction);
    };
    const auto& [low, high] = bounds_;
    cut(centre_.x, way.x, low.x, high.x), cut(centre_.y, way.y, low.y, high.y), cut(centre_.z, way.z, low.z, high.z);
    return furthest;
  }
  /// How far the centre of an empty ball may be in a direction of the axis, at most `reach`; nothing when a vertex is in all balls up to
  /// there.
  std::optional<double> end(double sign, double reach) const {
    double t = std::min(4 * radius_, reach);
    for (bool is_cut = false;;) {
      const double squared = radius_ * radius_ + t * t;
      const Point3* inside = vertices_.closer_than(at(sign * t), depth_squared(std::sqrt(squared)));
      if (inside == nullptr) {
        if (is_cut || t >= reach) return t;
        t = std::min(16 * t, reach);
        continue;
      }
      const Vector3 to_it = *inside - centre_;
      const double along = sign * dot(normal_, to_it);
      if (!(along > 0)) {  // a vertex behind the triangle: the dual edge, if there is one, begins further away
        if (is_cut || t >= reach) return std::nullopt;
        t = std::min(16 * t, reach);
        continue;
      }
      const double touches = (squared_length(to_it) - radius_ * radius_) / (2 * along);
      if (!(touches < t)) return t;
      t = touches;
      is_cut = true;
    }
  }

  /// Asks for the region along the axis, at a 16th of the circumradius near the triangle and at growing distances away from it.
  void sample(double from, double to) {
    const double first = std::asinh(from / radius_), last = std::asinh(to / radius_);
    const std::size_t n = std::clamp<std::size_t>(static_cast<std::size_t>(std::ceil(16 * (last - first))), 8, most_samples);
    places_.resize(n + 1);
    for (std::size_t i = 0; i <= n; ++i)
      places_[i] = radius_ * std::sinh(first + (last - first) * static_cast<double>(i) / static_cast<double>(n));
    places_.front() = from, places_.back() = to;
    ask(places_, regions_);
  }
  void ask(std::span<const double> places, std::vector<int>& regions) {
    asked_.clear();
    for (const double t : places) asked_.push_back(at(t));
    regions.resize(asked_.size());
    questions_->regions(asked_, regions);
  }
  /// Where, between two places, the region that is at the first of them ends.
  double crossing(double from, double to, int region, double tolerance) {
    constexpr std::size_t parts = 16;
    const double least = std::max(tolerance, 1e-15);  // scaled coordinates are below 1
    while (to - from > least) {
      inner_.resize(parts - 1);
      for (std::size_t i = 1; i < parts; ++i) inner_[i - 1] = from + (to - from) * (static_cast<double>(i) / parts);
      ask(inner_, inner_regions_);
      const auto change = std::ranges::find_if(inner_regions_, [&](int r) { return r != region; });
      const auto k = static_cast<std::size_t>(change - inner_regions_.begin());
      const double left = k == 0 ? from : inner_[k - 1], right = k == inner_.size() ? to : inner_[k];
      if (left == from && right == to) break;
      from = left, to = right;
    }
    return 0.5 * (from + to);
  }

  const Subject* s_;
  Questions<O>* questions_;
  SurfaceProbe<O> probe_;
  verification::NearestPoint<Point3> vertices_;
  BoundingBox3 bounds_;
  double diagonal_;
  Point3 centre_;
  Vector3 normal_;
  double radius_ = 0;
  std::vector<double> places_, inner_;  // scratch, as are these
  std::vector<int> regions_, inner_regions_;
  std::vector<Point3> asked_;
};

}  // namespace delref::verification_smooth
