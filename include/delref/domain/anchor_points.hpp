// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points that make a triangulation see a surface where it is thin: a cell has its circumcentre between two sheets only if its corners are
// on both, no further apart than the sheets are.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include <delref/domain/box_questions.hpp>
#include <delref/domain/oracle.hpp>

namespace delref {

namespace detail {

/// The 26 directions to the neighbours of a cell in a grid, as unit vectors, those along axes first.
inline std::vector<Vector3> grid_directions() {
  std::vector<Vector3> directions;
  for (int axes = 1; axes <= 3; ++axes)
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        for (int z = -1; z <= 1; ++z)
          if (std::abs(x) + std::abs(y) + std::abs(z) == axes) directions.push_back((1 / std::sqrt(double(axes))) * Vector3{double(x), double(y), double(z)});
  return directions;
}

}  // namespace detail

/// Points of surfaces, and how far apart they should be at least.
struct AnchorPoints {
  std::vector<Point3> points;
  double distance = 0;
};

/// Finds the points of an oracle's surfaces around a point of one of them.
template <Oracle O>
class AnchorFinder {
 public:
  /// Looks from `least` to `most` around a point, and finds regions that are at least `thinnest` thick.
  AnchorFinder(const O& oracle, double least, double thinnest, double most)
      : oracle_(&oracle), bounds_(oracle.bounds()), least_(least), thinnest_(thinnest), most_(most) {}

  /// Points of the surfaces around the thinner of the regions that meet at `p`: some twenty, as far apart as the region is thick there.
  /// None when no two regions meet near `p`, or the region is too thin.
  AnchorPoints around(Point3 p) const { return at_side(p, thinner_side(p)); }
  /// The same around the region that `q` is in, where it is thinnest at `q`.
  AnchorPoints inside(Point3 q) const {
    const int kind = label(q);
    Side best;
    Point3 from = q;
    for (const Vector3 d : directions_) {
      const double behind = thickness_along(q, -1.0 * d, kind, least_), ahead = thickness_along(q, d, kind, least_);
      if (best.thickness > 0 && behind + ahead >= best.thickness) continue;
      best = {kind, d, behind + ahead};
      from = q + -behind * d;
    }
    return at_side(from, best);
  }

 private:
  struct Side {
    int label = outside;
    Vector3 direction{};
    double thickness = 0;
  };

  /// The points around the middle of a region that begins at `p`.
  AnchorPoints at_side(Point3 p, const Side& side) const {
    if (!(side.thickness >= thinnest_)) return {};
    const Point3 q = p + (0.5 * side.thickness) * side.direction;
    if (label(q) != side.label) return {};
    AnchorPoints found{{}, 0.25 * side.thickness};
    const std::array<Vector3, 3> frame = frame_of(side.direction);
    for (const Vector3 d : directions_) {
      const Vector3 turned = (d.x * frame[0]) + (d.y * frame[1]) + (d.z * frame[2]);
      const Point3 end = q + side.thickness * turned;
      if (label(end) != side.label) found.points.push_back(end_of_region(q, end, side.label, 1e-6 * side.thickness));
    }
    return found;
  }
  int label(Point3 p) const {
    if (!contains(bounds_, p)) return outside;
    int found = outside;
    oracle_->label(std::span<const Point3>(&p, 1), std::span<int>(&found, 1));
    return found;
  }
  /// Where the region that `a` is in ends on the way to `b`: at the bounds at the latest, beyond which nobody asks.
  Point3 end_of_region(Point3 a, Point3 b, int label_a, double tolerance) const {
    if (!contains(bounds_, a)) return end_of_region(b, a, label(b), tolerance);  // only one of the two is out of bounds
    if (!contains(bounds_, b)) {
      b = last_point_in(bounds_, a, b);
      if (label(b) == label_a) return b;
    }
    return oracle_->crossing(a, b, label_a, tolerance);
  }
  /// What is on the sides of the surface at `p`, seen from as near as shows two labels, and the one that ends first.
  Side thinner_side(Point3 p) const {
    std::vector<int> labels(directions_.size());
    double r = least_;
    for (; r <= most_; r *= 2) {
      std::ranges::transform(directions_, labels.begin(), [&](Vector3 d) { return label(p + r * d); });
      if (std::ranges::any_of(labels, [&](int l) { return l != labels[0]; })) break;
    }
    Side best;
    if (r > most_) return best;
    std::vector<int> kinds = labels;
    std::ranges::sort(kinds, std::greater<>{});
    kinds.erase(std::ranges::unique(kinds).begin(), kinds.end());
    for (const int kind : kinds) {
      Vector3 sum{};
      for (std::size_t i = 0; i < labels.size(); ++i)
        if (labels[i] == kind) sum = sum + directions_[i];
      const double length = std::sqrt(squared_length(sum));
      if (!(length > 1e-6)) continue;
      const Vector3 direction = (1 / length) * sum;
      const double thickness = thickness_along(p, direction, kind, r);
      if (thickness > 0 && (best.thickness == 0 || thickness < best.thickness)) best = {kind, direction, thickness};
    }
    return best;
  }
  /// How far the region goes on from `p`; `most` at most, and 0 when it does not begin.
  double thickness_along(Point3 p, Vector3 direction, int kind, double r) const {
    if (label(p + r * direction) != kind) return 0;
    for (double s = r; s < most_; s *= 1.5) {
      const double next = std::min(1.5 * s, most_);
      if (label(p + next * direction) == kind) continue;
      const Point3 end = end_of_region(p + s * direction, p + next * direction, kind, 1e-3 * s);
      return std::sqrt(squared_distance(p, end));
    }
    return most_;
  }
  static std::array<Vector3, 3> frame_of(Vector3 n) {
    const Vector3 other = std::abs(n.x) < 0.7 ? Vector3{1, 0, 0} : Vector3{0, 1, 0};
    Vector3 u = cross(n, other);
    u = (1 / std::sqrt(squared_length(u))) * u;
    return {u, cross(n, u), n};
  }

  const O* oracle_;
  BoundingBox3 bounds_;
  double least_, thinnest_, most_;
  std::vector<Vector3> directions_ = detail::grid_directions();
};

}  // namespace delref
