// SPDX-License-Identifier: GPL-3.0-or-later
//
// What an oracle says of a triangulation: every cell has the label of its circumcentre, asked once and many at a time, and a facet
// between different labels has a point where its dual edge meets the surface.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include <delref/criteria/tetrahedron_shape.hpp>
#include <delref/domain/oracle.hpp>
#include <delref/triangulation/spatial_concept.hpp>

namespace delref {

/// Labels the cells of `Tr` as `O` says. The oracle must outlive it.
template <SpatialTriangulation Tr, Oracle O>
class CellLabels {
  using Cell = typename Tr::Cell;
  using Facet = typename Tr::Facet;
  static constexpr std::size_t batch = 4096;

 public:
  explicit CellLabels(const O& oracle) : oracle_(&oracle), bounds_(oracle.bounds()) {}

  /// Gives each cell the region of its circumcentre; infinite ones, and those whose circumcentre is out of bounds, are outside.
  void label(Tr& tr, std::span<const Cell> cells) {
    points_.clear(), asked_.clear();
    for (const Cell c : cells) {
      tr.set_region(c, outside);
      if (tr.is_infinite(c)) continue;
      const Point3 p = dual(tr, c);
      if (!is_in_bounds(p)) continue;
      points_.push_back(p);
      asked_.push_back(c);
    }
    regions_.resize(points_.size());
    oracle_->label(std::span<const Point3>(points_), std::span<int>(regions_));
    for (std::size_t i = 0; i < asked_.size(); ++i) tr.set_region(asked_[i], regions_[i]);
  }
  void label_all(Tr& tr) {
    std::vector<Cell> cells;
    for (const Cell c : tr.all_cells()) {
      cells.push_back(c);
      if (cells.size() < batch) continue;
      label(tr, cells);
      cells.clear();
    }
    label(tr, cells);
  }

  /// A point where the dual edge of a facet meets the surface. The facet is seen from the side of the greater region.
  Point3 surface_centre(const Tr& tr, const Facet& f, double tolerance) const {
    const Cell c = tr.cell(f);
    const Point3 a = dual(tr, c);
    const Facet m = tr.mirror(f);
    const Cell n = tr.cell(m);
    Point3 b;
    if (tr.is_infinite(n)) {
      const auto v = tr.vertices(f);
      const Vector3 inwards = cross(tr.point(v[1]) - tr.point(v[0]), tr.point(v[2]) - tr.point(v[0]));
      b = a + (-2 * bounds_.diagonal() / std::sqrt(squared_length(inwards))) * inwards;
    } else {
      b = dual(tr, n);
    }
    if (!is_in_bounds(b)) {
      // Beyond the bounds is outside: a region that reaches them ends there.
      b = clipped(a, b);
      int at_border = outside;
      oracle_->label(std::span<const Point3>(&b, 1), std::span<int>(&at_border, 1));
      if (at_border == tr.region(c)) return b;
    }
    return oracle_->crossing(a, b, tr.region(c), tolerance);
  }

 private:
  /// The dual vertex of a cell. That of a flat one is noise, for which the centre of the circle that its corners are on stands in.
  /// Always computed by this function, so that one cell has one.
  static Point3 dual(const Tr& tr, const Cell& c) {
    const auto v = tr.vertices(c);
    const TetrahedronShape t({tr.point(v[0]), tr.point(v[1]), tr.point(v[2]), tr.point(v[3])});
    return t.is_flat() ? t.centre_of_largest_face() : t.circumcentre;
  }
  bool is_in_bounds(Point3 p) const {
    const auto& [low, high] = bounds_;
    return p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y && p.z >= low.z && p.z <= high.z;
  }
  /// Where the way from `a`, in bounds, to `b`, which is not, leaves them.
  Point3 clipped(Point3 a, Point3 b) const {
    const auto& [low, high] = bounds_;
    double t = 1;
    const auto cut = [&t](double from, double to, double least, double most) {
      if (to > most) t = std::min(t, (most - from) / (to - from));
      if (to < least) t = std::min(t, (least - from) / (to - from));
    };
    cut(a.x, b.x, low.x, high.x), cut(a.y, b.y, low.y, high.y), cut(a.z, b.z, low.z, high.z);
    return {std::clamp(a.x + t * (b.x - a.x), low.x, high.x), std::clamp(a.y + t * (b.y - a.y), low.y, high.y),
            std::clamp(a.z + t * (b.z - a.z), low.z, high.z)};
  }

  const O* oracle_;
  BoundingBox3 bounds_;
  std::vector<Point3> points_;  // scratch, as are these two
  std::vector<Cell> asked_;
  std::vector<int> regions_;
};

}  // namespace delref
