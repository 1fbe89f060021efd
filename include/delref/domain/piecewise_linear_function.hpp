// SPDX-License-Identifier: GPL-3.0-or-later
//
// A function that is linear on each tetrahedron of a Delaunay triangulation: its value at a point, and the connected pieces of its zero
// set, exactly. The tetrahedron of a point is found by a walk (Devillers, Pion, Teillaud 2002) whose start is looked up in a grid, so that
// an answer depends on the question alone, nothing is written, and walks are short wherever they begin.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/core/point.hpp>
#include <delref/domain/bounding_box_3.hpp>
#include <delref/domain/disjoint_sets.hpp>

namespace delref {

/// A tetrahedron by its corners, positively oriented, and the tetrahedra opposite them. The corner `infinite_corner` stands for infinity.
struct LinearCell {
  std::array<std::uint32_t, 4> corner{}, neighbour{};
};

/// The values at the corners of a triangulation of the convex hull of points, and linear between them. Outside the hull it is infinite.
class PiecewiseLinearFunction {
 public:
  static constexpr std::uint32_t infinite_corner = 0;
  struct Corner {
    Point3 place;
    double value;
  };

  PiecewiseLinearFunction() = default;
  /// The first corner is the infinite one, and has a value that is infinite. Every facet of the hull is in a cell with that corner.
  PiecewiseLinearFunction(std::vector<Corner> corners, std::vector<LinearCell> cells) : corners_(std::move(corners)), cells_(std::move(cells)) {}

  const std::vector<Corner>& corners() const { return corners_; }
  const std::vector<LinearCell>& cells() const { return cells_; }

  /// Prepares to be asked about points in a box; about others it is correct, and slow. Linear time.
  void prepare_for(const BoundingBox3& box, const Control& control) {
    starts_.clear();
    low_ = box.low;
    const Vector3 side = box.high - box.low;
    const double volume = side.x * side.y * side.z;
    const double wanted = std::clamp(static_cast<double>(cells_.size()) / 4, 1.0, 16e6);
    const double step = std::cbrt(volume / wanted);
    double* const per_length = &per_length_.x;
    for (int axis = 0; axis != 3; ++axis) {
      const double length = axis == 0 ? side.x : axis == 1 ? side.y : side.z;
      const double count = std::clamp(std::floor(length / step), 1.0, 1024.0);
      counts_[static_cast<std::size_t>(axis)] = static_cast<int>(count);
      per_length[axis] = count / length;
    }
    starts_.reserve(static_cast<std::size_t>(counts_[0]) * static_cast<std::size_t>(counts_[1]) * static_cast<std::size_t>(counts_[2]));
    std::uint32_t last = 0;
    const auto middle = [](double low, int i, double density) { return low + (i + 0.5) / density; };
    for (int z = 0; z != counts_[2]; ++z)
      for (int y = 0; y != counts_[1]; ++y) {
        throw_if_stopped(control);
        for (int x = 0; x != counts_[0]; ++x) {
          last = walk({middle(low_.x, x, per_length_.x), middle(low_.y, y, per_length_.y), middle(low_.z, z, per_length_.z)}, last).cell;
          starts_.push_back(last);
        }
      }
  }

  /// The value at a point; positive infinity outside the hull. Requires a finite point.
  double operator()(Point3 p) const {
    const Place place = walk(p, start_of(p));
    const LinearCell& cell = cells_[place.cell];
    if (is_infinite(cell)) return corners_[infinite_corner].value;
    double sum = 0, weights = 0;
    for (std::size_t i = 0; i != 4; ++i) {
      const double weight = std::max(0.0, place.volume[i]);  // rounding is all that could make it negative
      sum += weight * corners_[cell.corner[i]].value;
      weights += weight;
    }
    return weights > 0 ? sum / weights : corners_[cell.corner[0]].value;
  }

  /// The connected components of the boundary of { value < 0 }, the hull's part included: a point on each piece, which is what is in one
  /// tetrahedron or on one facet of the hull.
  std::vector<std::vector<Point3>> components() const {
    constexpr std::uint32_t none = 0xffffffff;
    std::vector<std::uint32_t> piece(cells_.size(), none), cell_of;
    DisjointSets sets;
    for (std::uint32_t c = 0; c != cells_.size(); ++c)
      if (is_mixed(cells_[c], 4)) piece[c] = sets.add(), cell_of.push_back(c);
    for (const std::uint32_t c : cell_of)
      for (std::size_t i = 0; i != 4; ++i)
        if (is_mixed(cells_[c], i)) sets.unite(piece[c], piece[cells_[c].neighbour[i]]);
    const DisjointSets::Groups groups = sets.groups();
    std::vector<std::vector<Point3>> out(groups.begin.size() - 1);
    for (std::size_t i = 0; i != out.size(); ++i)
      for (std::size_t j = groups.begin[i]; j != groups.begin[i + 1]; ++j) out[i].push_back(middle_of_piece(cells_[cell_of[groups.members[j]]]));
    return out;
  }

  /// The smallest box around all points where the function is negative.
  BoundingBox3 negative_box() const {
    BoundingBox3 box;
    for (std::size_t i = 1; i != corners_.size(); ++i)
      if (corners_[i].value < 0) box.extend(corners_[i].place);
    for (const LinearCell& cell : cells_)
      if (is_mixed(cell, 4)) for_each_crossing(cell, [&](Point3 p) { box.extend(p); });
    return box;
  }

  /// Turns the sign of each connected set of corners of one sign that fits into a cube of such a side: there it is noise. How many there were.
  std::size_t fill_bubbles(double side) {
    DisjointSets sets(corners_.size());
    for (const LinearCell& cell : cells_)
      for (std::size_t i = 0; i != 4; ++i)
        for (std::size_t j = 0; j != i; ++j)
          if (is_negative(cell, i) == is_negative(cell, j)) sets.unite(cell.corner[i], cell.corner[j]);
    std::vector<BoundingBox3> box(corners_.size());  // of each set, at its smallest member
    for (std::uint32_t i = 1; i != corners_.size(); ++i) box[sets.find(i)].extend(corners_[i].place);
    std::size_t bubbles = 0;
    for (std::uint32_t i = 1; i != corners_.size(); ++i) {
      const std::uint32_t set = sets.find(i);
      if (set == sets.find(infinite_corner) || box[set].extent() > side) continue;
      bubbles += set == i;
      double& value = corners_[i].value;
      value = value < 0 ? 0 : -std::max(value, std::numeric_limits<double>::min());
    }
    return bubbles;
  }

  /// Sets the value of one corner.
  void set_value(std::uint32_t corner, double value) { corners_[corner].value = value; }

 private:
  static bool is_infinite(const LinearCell& cell) {
    return cell.corner[0] == infinite_corner || cell.corner[1] == infinite_corner || cell.corner[2] == infinite_corner || cell.corner[3] == infinite_corner;
  }
  bool is_negative(const LinearCell& cell, std::size_t i) const { return corners_[cell.corner[i]].value < 0; }
  /// Whether the corners, but for one, have both signs.
  bool is_mixed(const LinearCell& cell, std::size_t but) const {
    bool any = false, all = true;
    for (std::size_t i = 0; i != 4; ++i)
      if (i != but) any |= is_negative(cell, i), all &= is_negative(cell, i);
    return any && !all;
  }

  template <class Use>
  void for_each_crossing(const LinearCell& cell, Use use) const {
    for (std::size_t i = 0; i != 4; ++i)
      for (std::size_t j = 0; j != 4; ++j) {
        if (!is_negative(cell, i) || is_negative(cell, j)) continue;
        const Corner &a = corners_[cell.corner[i]], &b = corners_[cell.corner[j]];
        use(cell.corner[j] == infinite_corner ? a.place : a.place + a.value / (a.value - b.value) * (b.place - a.place));
      }
  }
  /// The piece of a cell is flat and convex, so that the mean of the ends of its sides is on it.
  Point3 middle_of_piece(const LinearCell& cell) const {
    Vector3 sum;
    double count = 0;
    Point3 first;
    for_each_crossing(cell, [&](Point3 p) {
      if (count == 0) first = p;
      sum = sum + (p - first), ++count;
    });
    return first + 1 / count * sum;
  }

  /// Six times the signed volumes of the cell with `p` in place of each corner in turn: positive where `p` is on the inner side of the facet
  /// opposite it.
  std::array<double, 4> volumes(const LinearCell& cell, Point3 p) const {
    const auto to = [&](std::size_t i) { return corners_[cell.corner[i]].place - p; };
    const Vector3 a = to(0), b = to(1), c = to(2), d = to(3), ab = cross(a, b), cd = cross(c, d);
    return {dot(b, cd), -dot(a, cd), dot(ab, d), -dot(ab, c)};
  }

  static std::size_t infinite_place(const LinearCell& cell) { return static_cast<std::size_t>(std::ranges::find(cell.corner, infinite_corner) - cell.corner.begin()); }

  /// A cell near a point, found without a walk.
  std::uint32_t start_of(Point3 p) const {
    if (starts_.empty()) return 0;
    const auto at = [](double offset, double density, int count) { return static_cast<std::size_t>(std::clamp(offset * density, 0.0, count - 1.0)); };
    const std::size_t x = at(p.x - low_.x, per_length_.x, counts_[0]), y = at(p.y - low_.y, per_length_.y, counts_[1]),
                      z = at(p.z - low_.z, per_length_.z, counts_[2]);
    return starts_[(z * static_cast<std::size_t>(counts_[1]) + y) * static_cast<std::size_t>(counts_[0]) + x];
  }

  /// A cell and the `volumes` of it with a point.
  struct Place {
    std::uint32_t cell;
    std::array<double, 4> volume;
  };
  /// The cell that the point is in, one with the infinite corner when it is outside the hull. On Delaunay triangulations the walk ends; where
  /// rounding lets it turn in a circle of cells that the point is on the border of, one of them is as good as another.
  Place walk(Point3 p, std::uint32_t at) const {
    if (is_infinite(cells_[at])) at = cells_[at].neighbour[infinite_place(cells_[at])];
    Place place{at, {}};
    std::uint32_t from = at;
    for (std::size_t steps = 0; steps < cells_.size(); ++steps) {
      const LinearCell& cell = cells_[place.cell];
      place.volume = volumes(cell, p);
      std::size_t side = 0;
      while (side != 4 && (place.volume[side] >= 0 || cell.neighbour[side] == from)) ++side;
      if (side == 4) break;
      from = std::exchange(place.cell, cell.neighbour[side]);
      if (is_infinite(cells_[place.cell])) break;
    }
    return place;
  }

  std::vector<Corner> corners_;
  std::vector<LinearCell> cells_;
  std::vector<std::uint32_t> starts_;  // of walks, per cell of a grid
  std::array<int, 3> counts_{};
  Point3 low_;
  Vector3 per_length_;
};

}  // namespace delref
