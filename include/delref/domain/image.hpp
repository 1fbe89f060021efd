// SPDX-License-Identifier: GPL-3.0-or-later
//
// Images of three dimensions: a regular grid of voxels, anywhere in space, with one value each. A voxel stands for its centre, whose
// index is a triple of whole numbers; indices between them are places between centres.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include <delref/core/point.hpp>
#include <delref/domain/bounding_box_3.hpp>
#include <delref/domain/describe.hpp>
#include <delref/domain/invalid_input.hpp>

namespace delref {

/// Where the voxels of an image are.
struct ImageGrid {
  /// Voxels along each axis of the image.
  std::array<int, 3> size{0, 0, 0};
  /// From one voxel's centre to the next, along each axis of the image, in the unit of the world.
  std::array<double, 3> spacing{1, 1, 1};
  /// The centre of voxel (0, 0, 0).
  Point3 origin{};
  /// The directions of the image's axes in the world: unit vectors, at right angles, right-handed or not.
  std::array<Vector3, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

  friend bool operator==(const ImageGrid&, const ImageGrid&) = default;

  std::size_t voxels() const {
    return static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]) * static_cast<std::size_t>(size[2]);
  }
  /// The place of a voxel among all, x running fastest.
  std::size_t voxel(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(size[1]) + static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(size[0]) +
           static_cast<std::size_t>(x);
  }
  /// The point at an index, which need not be whole.
  Point3 world(Point3 index) const {
    return origin + (((index.x * spacing[0]) * axes[0]) + ((index.y * spacing[1]) * axes[1]) + ((index.z * spacing[2]) * axes[2]));
  }
  /// The box around the points whose indices are in an upright box of indices.
  BoundingBox3 world_box(Point3 low, Point3 high) const {
    BoundingBox3 box;
    for (int corner = 0; corner != 8; ++corner) {
      box.extend(world({(corner & 1) != 0 ? high.x : low.x, (corner & 2) != 0 ? high.y : low.y, (corner & 4) != 0 ? high.z : low.z}));
    }
    return box;
  }
};

/// The inverse of `ImageGrid::world`, up to rounding, made once for many points.
class WorldToIndex {
 public:
  /// Requires a grid that `check_grid` accepts.
  explicit WorldToIndex(const ImageGrid& grid) : origin_(grid.origin) {
    const auto& [a, b, c] = grid.axes;
    const double determinant = dot(a, cross(b, c));  // 1 or -1 but for what directions from a file lack in digits
    rows_ = {(1 / (determinant * grid.spacing[0])) * cross(b, c), (1 / (determinant * grid.spacing[1])) * cross(c, a),
             (1 / (determinant * grid.spacing[2])) * cross(a, b)};
  }
  Point3 operator()(Point3 p) const {
    const Vector3 v = p - origin_;
    return {dot(rows_[0], v), dot(rows_[1], v), dot(rows_[2], v)};
  }

 private:
  Point3 origin_;
  std::array<Vector3, 3> rows_;
};

/// An image with values of one type, x running fastest, then y, then z.
template <class Value>
struct Image {
  ImageGrid grid;
  std::vector<Value> values;

  /// Requires a voxel of the grid.
  const Value& at(int x, int y, int z) const { return values[grid.voxel(x, y, z)]; }
  Value& at(int x, int y, int z) { return values[grid.voxel(x, y, z)]; }
};

/// An image as it comes out of a file: whole numbers of up to 32 bits, or floating-point numbers.
using AnyImage = std::variant<Image<std::int32_t>, Image<float>, Image<double>>;

inline const ImageGrid& grid_of(const AnyImage& image) {
  return std::visit([](const auto& i) -> const ImageGrid& { return i.grid; }, image);
}

/// More voxels along an axis than this are refused.
inline constexpr int longest_image_axis = 1'000'000;

/// Throws `InvalidInput` saying everything that is wrong with a grid: sizes that are not positive, spacings that are not positive
/// numbers, axes that are not at right angles (up to 1e-3) or not of length 1 (likewise), an origin that is no point.
inline void check_grid(const ImageGrid& grid) {
  DefectList defects;
  constexpr std::array<char, 3> axis_name{'x', 'y', 'z'};
  for (std::size_t i = 0; i != 3; ++i) {
    const std::string along = std::string(" along ") + axis_name[i];
    if (grid.size[i] < 1) defects.add("the image has " + std::to_string(grid.size[i]) + " voxels" + along);
    if (grid.size[i] > longest_image_axis) {
      defects.add("the image has " + std::to_string(grid.size[i]) + " voxels" + along + "; more than " +
                  std::to_string(longest_image_axis) + " are not supported");
    }
    const double spacing = grid.spacing[i];
    if (!(spacing >= 1e-100 && spacing <= 1e100)) {
      defects.add("the spacing of the voxels" + along + " is " + describe(spacing) + "; it must be positive, from 1e-100 to 1e100");
    }
    for (std::size_t j = 0; j <= i; ++j) {
      const double product = dot(grid.axes[i], grid.axes[j]);
      if (std::abs(product - (i == j ? 1 : 0)) <= 1e-3) continue;
      if (i == j) {
        defects.add(std::string("the direction of the image's axis ") + axis_name[i] + " is not of length 1 but " +
                    describe(std::sqrt(product)));
      } else {
        defects.add(std::string("the image's axes ") + axis_name[j] + " and " + axis_name[i] +
                    " are not at right angles (cosine " + describe(product) + "); resample the image on an upright grid");
      }
    }
  }
  const Point3 o = grid.origin;
  if (!is_finite(o) || std::abs(o.x) > 1e100 || std::abs(o.y) > 1e100 || std::abs(o.z) > 1e100) {
    defects.add("the origin of the image is " + describe(o) + ", which is no place");
  }
  if (!defects.empty()) throw InvalidInput(defects.take());
}

/// Throws `InvalidInput` when the grid is bad (`check_grid`) or the number of values is not that of voxels.
template <class Value>
void check_image(const Image<Value>& image) {
  check_grid(image.grid);
  if (image.values.size() == image.grid.voxels()) return;
  throw InvalidInput("the image has " + count_of(image.grid.voxels(), "voxel", "voxels") + " but " +
                     count_of(image.values.size(), "value", "values"));
}

}  // namespace delref
