// SPDX-License-Identifier: GPL-3.0-or-later
//
// The labels of an image as regions numbered from 0, as small as can be in memory, and where a segment leaves a region of voxels.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/core/point.hpp>
#include <delref/domain/describe.hpp>
#include <delref/domain/image.hpp>
#include <delref/domain/invalid_input.hpp>
#include <delref/domain/oracle.hpp>

namespace delref::detail {

/// For each voxel its region. Voxels beyond the image are `outside`.
class VoxelLabels {
 public:
  VoxelLabels() = default;
  /// All outside.
  explicit VoxelLabels(std::array<int, 3> size)
      : size_(size), stored_(static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]) * static_cast<std::size_t>(size[2])) {}

  std::array<int, 3> size() const { return size_; }
  std::size_t place(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(size_[1]) + static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(size_[0]) +
           static_cast<std::size_t>(x);
  }
  bool contains(int x, int y, int z) const {
    return x >= 0 && y >= 0 && z >= 0 && x < size_[0] && y < size_[1] && z < size_[2];
  }
  int operator()(int x, int y, int z) const { return contains(x, y, z) ? stored_[place(x, y, z)] - 1 : outside; }
  int operator[](std::size_t place) const { return stored_[place] - 1; }
  void set(std::size_t place, int region) { stored_[place] = static_cast<std::uint16_t>(region + 1); }
  static constexpr std::size_t most_regions = std::numeric_limits<std::uint16_t>::max();

 private:
  std::array<int, 3> size_{0, 0, 0};
  std::vector<std::uint16_t> stored_;  // the region plus 1
};

/// The index of the voxel that a coordinate is nearest to. Requires one of less than 2^31.
inline int nearest_voxel(double coordinate) { return static_cast<int>(std::floor(coordinate + 0.5)); }

/// The fraction of the way along a segment of indices at which it first enters a voxel of another label than `label`; nothing when it
/// does not. Walks from voxel to voxel (Amanatides and Woo, "A fast voxel traversal algorithm for ray tracing", 1987).
inline std::optional<double> first_other_voxel(const VoxelLabels& labels, Point3 from, Vector3 way, int label) {
  const std::array<double, 3> p{from.x, from.y, from.z}, d{way.x, way.y, way.z};
  std::array<int, 3> voxel{}, step{}, left{};
  std::array<double, 3> next{}, stride{};
  for (std::size_t i = 0; i != 3; ++i) {
    voxel[i] = nearest_voxel(p[i]);
    left[i] = std::abs(nearest_voxel(p[i] + d[i]) - voxel[i]);
    step[i] = d[i] > 0 ? 1 : -1;
    next[i] = left[i] > 0 ? (voxel[i] + 0.5 * step[i] - p[i]) / d[i] : 2;
    stride[i] = left[i] > 0 ? 1 / std::abs(d[i]) : 0;
  }
  double at = 0;
  while (labels(voxel[0], voxel[1], voxel[2]) == label) {
    const std::size_t i = next[0] <= next[1] ? (next[0] <= next[2] ? 0 : 2) : (next[1] <= next[2] ? 1 : 2);
    if (left[i] == 0) return std::nullopt;
    at = next[i];
    voxel[i] += step[i];
    next[i] = --left[i] > 0 ? next[i] + stride[i] : 2;
  }
  return std::clamp(at, 0.0, 1.0);
}

/// The regions of an image, and the label in the image of each.
struct RegionNumbers {
  VoxelLabels voxels;
  std::vector<int> labels;
};

template <class Value>
bool is_label(Value value) {
  if constexpr (std::is_integral_v<Value>) {
    return std::in_range<int>(value);
  } else {
    return value >= -2147483648.0 && value <= 2147483647.0 && std::floor(value) == value;
  }
}

/// Numbers the labels other than `outside_label` in increasing order. Throws `InvalidInput` when a value is no whole number of 32 bits,
/// there are too many labels, or no label but that one; `Interrupted`. Requires a checked image.
template <class Value>
RegionNumbers number_regions(const Image<Value>& image, std::optional<int> outside_label, const Control& control) {
  std::vector<int> found;  // sorted
  const std::vector<Value>& values = image.values;
  StopCheck stop(control);
  for (std::size_t i = 0; i != values.size(); ++i) {
    stop();
    if (i > 0 && values[i] == values[i - 1]) continue;
    if (!is_label(values[i])) {
      throw InvalidInput("voxel number " + std::to_string(i) + " has the value " + describe(static_cast<double>(values[i])) +
                         ", which is no label: labels are whole numbers of 32 bits; is this a grey-level image?");
    }
    const int label = static_cast<int>(values[i]);
    const auto place = std::ranges::lower_bound(found, label);
    if (label == outside_label || (place != found.end() && *place == label)) continue;
    if (found.size() == VoxelLabels::most_regions) {
      throw InvalidInput("the image has more than " + std::to_string(VoxelLabels::most_regions) + " labels; is it a grey-level image?");
    }
    found.insert(place, label);
  }
  if (found.empty()) {
    throw InvalidInput("every voxel has the label " + describe(static_cast<double>(values.empty() ? Value{} : values[0])) +
                       ", which is the label of what is outside: there is no region");
  }
  RegionNumbers out{VoxelLabels(image.grid.size), std::move(found)};
  int region = outside;
  for (std::size_t i = 0; i != values.size(); ++i) {
    stop();
    if (i == 0 || values[i] != values[i - 1]) {
      const int label = static_cast<int>(values[i]);
      region = label == outside_label ? outside : static_cast<int>(std::ranges::lower_bound(out.labels, label) - out.labels.begin());
    }
    out.voxels.set(i, region);
  }
  return out;
}

}  // namespace delref::detail
