// SPDX-License-Identifier: GPL-3.0-or-later
//
// The continuous function that an image of numbers stands for: linear along each axis between the centres of neighbouring voxels.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include <delref/core/point.hpp>
#include <delref/domain/image.hpp>

namespace delref::detail {

/// Interpolates in values that somebody else keeps.
template <class Value>
class Trilinear {
 public:
  /// Requires at least two voxels along each axis.
  Trilinear(const ImageGrid& grid, const Value* values)
      : values_(values),
        last_{grid.size[0] - 2, grid.size[1] - 2, grid.size[2] - 2},
        row_(static_cast<std::size_t>(grid.size[0])),
        plane_(row_ * static_cast<std::size_t>(grid.size[1])) {}

  /// Requires an index from (0, 0, 0) to the last voxel.
  double operator()(Point3 index) const {
    const int x = std::min(static_cast<int>(index.x), last_[0]);
    const int y = std::min(static_cast<int>(index.y), last_[1]);
    const int z = std::min(static_cast<int>(index.z), last_[2]);
    const Value* v = values_ + (static_cast<std::size_t>(z) * plane_ + static_cast<std::size_t>(y) * row_ + static_cast<std::size_t>(x));
    const double s = index.x - x, t = index.y - y, u = index.z - z;
    const double low = between(along(v, s), along(v + row_, s), t);
    const double high = between(along(v + plane_, s), along(v + plane_ + row_, s), t);
    return between(low, high, u);
  }

 private:
  // This form gives exactly `a` at 0 and `b` at 1, so that neighbouring cells agree at the voxels.
  static double between(double a, double b, double t) { return (1 - t) * a + t * b; }
  static double along(const Value* v, double s) { return between(static_cast<double>(v[0]), static_cast<double>(v[1]), s); }

  const Value* values_;
  std::array<int, 3> last_;
  std::size_t row_, plane_;
};

}  // namespace delref::detail
