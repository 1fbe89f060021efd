// SPDX-License-Identifier: GPL-3.0-or-later
//
// The staircase of a labelled image made smooth: a point has the label whose voxels around it weigh the most. Weights fall with the
// distance as a Gaussian; of two labels it is the boundary that a Gaussian filter of the label's indicator and the level 1/2 give,
// and with several labels no gaps come to be.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/core/point.hpp>
#include <delref/domain/oracle.hpp>
#include <delref/domain/voxel_labels.hpp>

namespace delref::detail {

/// Weighs the labels around indices. The labels are somebody else's, and stay where they are.
class LabelSmoothing {
 public:
  /// `width`: the standard deviation of the Gaussian, in voxels along each axis, from `least_width` to `greatest_width`. Weights end at
  /// three of them (but not before the next voxel), where they are 0 and continuous.
  LabelSmoothing(const VoxelLabels& labels, double width, const Control& control)
      : reach_(std::max(1.0, 3 * width)), factor_(-0.5 / (width * width)), floor_(std::exp(factor_ * reach_ * reach_)) {
    find_mixed(labels, control);
  }

  static constexpr double least_width = 0.3, greatest_width = 3;

  /// The label of an index: the one that weighs the most; of several the lowest, and `outside` before all.
  int operator()(const VoxelLabels& labels, Point3 index) const {
    const int x = nearest_voxel(index.x), y = nearest_voxel(index.y), z = nearest_voxel(index.z);
    if (!labels.contains(x, y, z)) return outside;
    if (!mixed_[labels.place(x, y, z)]) return labels(x, y, z);
    const Weights weights = weigh(labels, index);
    int best = outside;
    double greatest = -1;
    for (std::size_t i = 0; i != weights.count; ++i) {
      const auto [label, weight] = weights.of[i];
      if (weight > greatest || (weight == greatest && label < best)) best = label, greatest = weight;
    }
    return best;
  }

  /// By how much the greatest weight of any other label exceeds that of `label` at an index: negative where the index has the label.
  double lack(const VoxelLabels& labels, Point3 index, int label) const {
    const Weights weights = weigh(labels, index);
    double own = 0, other = 0;
    for (std::size_t i = 0; i != weights.count; ++i) {
      double& side = weights.of[i].first == label ? own : other;
      side = std::max(side, weights.of[i].second);
    }
    return other - own;
  }

 private:
  static constexpr std::size_t most_labels = 64;
  static constexpr std::size_t most_steps = 2 * static_cast<std::size_t>(3 * greatest_width) + 2;
  struct Weights {
    std::array<std::pair<int, double>, most_labels> of;
    std::size_t count = 0;

    void add(int label, double weight) {
      for (std::size_t i = 0; i != count; ++i) {
        if (of[i].first == label) return void(of[i].second += weight);
      }
      // More labels than that around one point are noise; the last one found weighs little and is left out.
      if (count != most_labels) of[count++] = {label, weight};
    }
  };
  struct Along {
    std::array<double, most_steps> weight;
    int first = 0, count = 0;
  };

  Along along(double coordinate) const {
    Along out;
    out.first = static_cast<int>(std::ceil(coordinate - reach_));
    const int last = static_cast<int>(std::floor(coordinate + reach_));
    for (int i = out.first; i <= last; ++i) {
      const double d = i - coordinate;
      out.weight[static_cast<std::size_t>(out.count++)] = std::max(0.0, std::exp(factor_ * d * d) - floor_);
    }
    return out;
  }

  Weights weigh(const VoxelLabels& labels, Point3 index) const {
    const Along x = along(index.x), y = along(index.y), z = along(index.z);
    const bool within = labels.contains(x.first, y.first, z.first) &&
                        labels.contains(x.first + x.count - 1, y.first + y.count - 1, z.first + z.count - 1);
    Weights out;
    for (int k = 0; k != z.count; ++k) {
      for (int j = 0; j != y.count; ++j) {
        const double row = z.weight[static_cast<std::size_t>(k)] * y.weight[static_cast<std::size_t>(j)];
        if (within) {
          const std::size_t first = labels.place(x.first, y.first + j, z.first + k);
          weigh_row(out, x, row, [&](int i) { return labels[first + static_cast<std::size_t>(i)]; });
        } else {
          weigh_row(out, x, row, [&](int i) { return labels(x.first + i, y.first + j, z.first + k); });
        }
      }
    }
    return out;
  }
  /// Voxels of one label after the other are added at once.
  template <class LabelOf>
  static void weigh_row(Weights& out, const Along& x, double row, LabelOf&& label_of) {
    int run = label_of(0);
    double weight = 0;
    for (int i = 0; i != x.count; ++i) {
      const int label = label_of(i);
      if (label != run) out.add(run, weight * row), run = label, weight = 0;
      weight += x.weight[static_cast<std::size_t>(i)];
    }
    out.add(run, weight * row);
  }

  /// Marks the voxels that are not surrounded by their own label as far as weights reach: a box filter, one axis after the other.
  void find_mixed(const VoxelLabels& labels, const Control& control) {
    const auto [nx, ny, nz] = labels.size();
    const int reach = static_cast<int>(std::ceil(reach_ + 0.5));
    mixed_.assign(static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny) * static_cast<std::size_t>(nz), false);
    std::vector<bool> boundary(mixed_.size());
    for (int z = 0; z != nz; ++z) {
      throw_if_stopped(control);
      for (int y = 0; y != ny; ++y) {
        for (int x = 0; x != nx; ++x) {
          const int own = labels(x, y, z);
          boundary[labels.place(x, y, z)] = labels(x + 1, y, z) != own || labels(x - 1, y, z) != own || labels(x, y + 1, z) != own ||
                                            labels(x, y - 1, z) != own || labels(x, y, z + 1) != own || labels(x, y, z - 1) != own;
        }
      }
    }
    const std::array<std::size_t, 3> stride{1, static_cast<std::size_t>(nx), static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny)};
    const std::array<std::size_t, 3> size{static_cast<std::size_t>(nx), static_cast<std::size_t>(ny), static_cast<std::size_t>(nz)};
    for (std::size_t axis = 0; axis != 3; ++axis) {
      throw_if_stopped(control);
      widen(boundary, stride[axis], size[axis], static_cast<std::size_t>(reach));
    }
    mixed_ = std::move(boundary);
  }

  /// Sets what is within `reach` of something set along one axis.
  static void widen(std::vector<bool>& marks, std::size_t stride, std::size_t size, std::size_t reach) {
    std::vector<std::size_t> ahead(size);  // steps to the next mark
    for (std::size_t start = 0; start != marks.size(); ++start) {
      if (start / stride % size != 0) continue;
      std::size_t steps = reach + 1;
      for (std::size_t i = size; i-- > 0;) {
        steps = marks[start + i * stride] ? 0 : std::min(steps + 1, reach + 1);
        ahead[i] = steps;
      }
      steps = reach + 1;
      for (std::size_t i = 0; i != size; ++i) {
        steps = ahead[i] == 0 ? 0 : std::min(steps + 1, reach + 1);
        marks[start + i * stride] = steps <= reach || ahead[i] <= reach;
      }
    }
  }

  double reach_, factor_, floor_;
  std::vector<bool> mixed_;
};

}  // namespace delref::detail
