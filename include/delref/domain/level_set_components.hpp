// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every connected component of the level set of a trilinear image, with its Euler characteristic and points on it. The nodes are the
// edges of the grid that the level set crosses; each cube joins those that it connects (trilinear_cube.hpp). The image is taken to be
// surrounded by voxels that are outside, so that a level set which leaves it is closed at its border.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/core/point.hpp>
#include <delref/domain/disjoint_sets.hpp>
#include <delref/domain/image.hpp>
#include <delref/domain/invalid_input.hpp>
#include <delref/domain/spread_points.hpp>
#include <delref/domain/trilinear_cube.hpp>

namespace delref {

/// One connected component of a level set: a closed surface.
struct LevelSetComponent {
  /// On the surface up to rounding, spread widely (`spread_points`).
  std::vector<Point3> seeds;
  /// Edges of the grid that it crosses.
  std::size_t crossings = 0;
  /// 2 for a sphere, 0 for a torus, and so on.
  std::int64_t euler_characteristic = 0;
};

namespace detail {

/// Walks over all cubes once, layer by layer; memory is proportional to a layer and to the crossings.
template <class Value>
class LevelSetWalk {
 public:
  LevelSetWalk(const ImageGrid& grid, std::span<const Value> values, double iso, const Control& control)
      : grid_(grid), values_(values), iso_(iso), control_(control), columns_(extent(0) + 2), rows_(extent(1) + 2) {}

  std::vector<LevelSetComponent> components(std::size_t seeds) {
    for (auto& plane : flags_) plane.assign(columns_ * rows_, 0);
    for (auto& plane : along_plane_) plane.assign(2 * columns_ * rows_, 0);
    upright_.assign(columns_ * rows_, 0);
    // Padded coordinates: voxel (x, y, z) is at (x + 1, y + 1, z + 1).
    for (int z = 0; z <= grid_.size[2]; ++z) {
      throw_if_stopped(control_);
      std::swap(flags_[0], flags_[1]);
      std::swap(along_plane_[0], along_plane_[1]);
      fill_flags(z + 1);
      first_of_layer_ = {first_of_layer_[1], sets_.size()};
      walk_layer(z);
    }
    return gather(seeds);
  }

 private:
  struct Crossing {
    std::uint32_t x, y, z_and_axis;  // padded, of the lower end; the axis in the two lowest bits
  };

  std::size_t extent(std::size_t axis) const { return static_cast<std::size_t>(grid_.size[axis]); }
  bool in_image(int x, int y, int z) const {
    return x > 0 && y > 0 && z > 0 && x <= grid_.size[0] && y <= grid_.size[1] && z <= grid_.size[2];
  }
  /// The value less the iso value; any negative number will do beyond the border, where no two signs are ambiguous.
  double value(int x, int y, int z) const {
    return in_image(x, y, z) ? static_cast<double>(values_[grid_.voxel(x - 1, y - 1, z - 1)]) - iso_ : -1;
  }

  void fill_flags(int z) {
    std::vector<unsigned char>& plane = flags_[1];
    if (z > grid_.size[2]) {
      std::ranges::fill(plane, static_cast<unsigned char>(0));
      return;
    }
    for (std::size_t y = 0; y != extent(1); ++y) {
      const Value* row = values_.data() + grid_.voxel(0, static_cast<int>(y), z - 1);
      unsigned char* flag = plane.data() + (y + 1) * columns_ + 1;
      for (std::size_t x = 0; x != extent(0); ++x) flag[x] = static_cast<double>(row[x]) >= iso_;
    }
  }

  void walk_layer(int z) {
    for (int y = 0; y <= grid_.size[1]; ++y) {
      const std::size_t row = static_cast<std::size_t>(y) * columns_;
      const unsigned char *a = flags_[0].data() + row, *b = a + columns_, *c = flags_[1].data() + row, *d = c + columns_;
      unsigned before = 0;  // the column's four flags
      for (std::size_t x = 1; x != columns_; ++x) {
        const auto here = static_cast<unsigned>(a[x] | b[x] << 1 | c[x] << 2 | d[x] << 3);
        if (here != before || (here != 0 && here != 15)) walk_cube(static_cast<int>(x) - 1, y, z);
        before = here;
      }
    }
  }

  void walk_cube(int x, int y, int z) {
    std::array<double, 8> corner{};
    for (int i = 0; i != 8; ++i) corner[static_cast<std::size_t>(i)] = value(x + (i & 1), y + (i >> 1 & 1), z + (i >> 2));
    const TrilinearCube cube(corner);
    std::array<std::uint32_t, 12> node{};
    for (int e = 0; e != 12; ++e) {
      const auto i = static_cast<std::size_t>(e);
      if (cube.piece[i] < 0) continue;
      node[i] = node_of(e, x, y, z);
      // Each crossing is shared by four cubes and each curve between two by two cubes: 1/4 - 1/2 of the characteristic.
      --fourfold_characteristic_[node[i]];
      if (cube.piece[i] != e) sets_.unite(node[i], node[static_cast<std::size_t>(cube.piece[i])]);
    }
    for (std::size_t e = 0; e != 12; ++e) {
      if (cube.curves_of[e] == 0) continue;
      const int characteristic = 2 - cube.curves_of[e];  // of a sphere with so many holes
      fourfold_characteristic_[node[e]] = static_cast<std::int16_t>(fourfold_characteristic_[node[e]] + 4 * characteristic);
    }
  }

  /// The number of the crossing of a cube's edge, new when no cube before has seen it.
  std::uint32_t node_of(int edge, int x, int y, int z) {
    const int axis = edge / 4, low = edge & 1, high = edge >> 1 & 1;
    if (axis == 0) y += low;
    else x += low;
    if (axis == 2) y += high;
    const std::size_t place = static_cast<std::size_t>(y) * columns_ + static_cast<std::size_t>(x);
    if (axis == 2) return node_in(upright_[place], first_of_layer_[1], x, y, z, axis);
    // What is left in a plane's table from two layers before has a lower number than any that belongs there.
    const auto side = static_cast<std::size_t>(high);
    return node_in(along_plane_[side][2 * place + static_cast<std::size_t>(axis)], first_of_layer_[side], x, y, z + high, axis);
  }

  std::uint32_t node_in(std::uint32_t& entry, std::size_t first, int x, int y, int z, int axis) {
    if (entry > first) return entry - 1;
    if (sets_.size() >= std::numeric_limits<std::uint32_t>::max() - 1) {
      throw InvalidInput("the level set crosses more than 4 billion edges of the grid; smooth or cut the image");
    }
    entry = sets_.add() + 1;
    crossings_.push_back({static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), static_cast<std::uint32_t>(z * 4 + axis)});
    fourfold_characteristic_.push_back(0);
    return entry - 1;
  }

  Point3 point_of(const Crossing& crossing) const {
    const auto x = static_cast<int>(crossing.x), y = static_cast<int>(crossing.y), z = static_cast<int>(crossing.z_and_axis / 4);
    const unsigned axis = crossing.z_and_axis % 4;
    const int dx = axis == 0, dy = axis == 1, dz = axis == 2;
    double t = 0;
    if (!in_image(x, y, z)) {
      t = 1;
    } else if (in_image(x + dx, y + dy, z + dz)) {
      const double from = value(x, y, z), to = value(x + dx, y + dy, z + dz);
      t = from / (from - to);
    }
    return grid_.world({x - 1 + dx * t, y - 1 + dy * t, z - 1 + dz * t});
  }

  std::vector<LevelSetComponent> gather(std::size_t seeds) {
    const DisjointSets::Groups groups = sets_.groups();
    std::vector<LevelSetComponent> out(groups.begin.size() - 1);
    std::vector<Point3> points;
    for (std::size_t i = 0; i != out.size(); ++i) {
      if (i % 1024 == 0) throw_if_stopped(control_);
      points.clear();
      std::int64_t fourfold = 0;
      for (std::size_t j = groups.begin[i]; j != groups.begin[i + 1]; ++j) {
        const std::uint32_t node = groups.members[j];
        points.push_back(point_of(crossings_[node]));
        fourfold += fourfold_characteristic_[node];
      }
      out[i] = {spread_points(points, seeds), points.size(), fourfold / 4};
    }
    return out;
  }

  const ImageGrid& grid_;
  std::span<const Value> values_;
  double iso_;
  const Control& control_;
  std::size_t columns_, rows_;                        // of a padded plane
  std::array<std::vector<unsigned char>, 2> flags_;   // of the lower and the upper plane: inside
  std::array<std::vector<std::uint32_t>, 2> along_plane_;  // the crossings of their edges along x and y, plus 1
  std::vector<std::uint32_t> upright_;                // the crossings of the edges between them, plus 1
  std::array<std::size_t, 2> first_of_layer_{0, 0};   // crossings before the layer below, and before this one
  DisjointSets sets_;
  std::vector<Crossing> crossings_;
  std::vector<std::int16_t> fourfold_characteristic_;
};

}  // namespace detail

/// The components of the boundary of { value >= iso }, in the order in which the grid comes to them, each with at most `seeds` points.
/// Beyond the image all is outside. Exact but for rounding: where a saddle's value comes within rounding of the iso value, or is equal to
/// it, one of the two ways is taken. Requires finite values, as many as voxels, and at least two voxels along each axis. Linear time: some
/// ten nanoseconds per voxel and some hundred per crossing. Throws `Interrupted`.
template <class Value>
std::vector<LevelSetComponent> level_set_components(const ImageGrid& grid, std::span<const Value> values, double iso,
                                                    const Control& control = Control{}, std::size_t seeds = 32) {
  return detail::LevelSetWalk<Value>(grid, values, iso, control).components(seeds);
}

}  // namespace delref
