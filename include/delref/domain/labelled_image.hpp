// SPDX-License-Identifier: GPL-3.0-or-later
//
// The domain that a labelled image (a segmentation) stands for: every label a region. An `Oracle` that finds all connected components of
// the regions' boundaries.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/core/point.hpp>
#include <delref/domain/bounding_box_3.hpp>
#include <delref/domain/bracketed_root.hpp>
#include <delref/domain/describe.hpp>
#include <delref/domain/image.hpp>
#include <delref/domain/label_boundaries.hpp>
#include <delref/domain/label_smoothing.hpp>
#include <delref/domain/oracle.hpp>
#include <delref/domain/spread_points.hpp>
#include <delref/domain/voxel_labels.hpp>

namespace delref {

/// How a labelled image is read.
struct LabelOptions {
  /// The label of what is in no region. None: every label is a region, and only what is beyond the image is outside.
  std::optional<int> outside_label = 0;
  /// 0: a point has the label of the nearest voxel, and boundaries are staircases. Otherwise a point has the label that weighs the most
  /// around it, by a Gaussian of this width (standard deviation) in voxels, from 0.3 to 3; 1 gives smooth boundaries. What is about as
  /// small as the width is smoothed away: from 0.5 on, single voxels are (`LabelledImage::lost_labels`).
  double smoothing = 0;
};

/// Each label of an image is a region, numbered from 0 by increasing label. A voxel is the box of its spacing around its centre; beyond
/// the image is outside. Boundaries are shared by the regions on both sides.
class LabelledImage {
 public:
  /// Throws `InvalidInput` in words when the image is bad (`check_image`), a value is no whole number of 32 bits, there are more than
  /// 65,535 labels or none but that of what is outside, or the smoothing is out of range. Throws `Interrupted`.
  template <class Value>
  explicit LabelledImage(const Image<Value>& image, const LabelOptions& options = {}, const Control& control = Control{})
      : grid_(image.grid), to_index_((check_image(image), grid_)), regions_(detail::number_regions(image, options.outside_label, control)) {
    if (options.smoothing == 0) return;
    using detail::LabelSmoothing;
    if (!(options.smoothing >= LabelSmoothing::least_width && options.smoothing <= LabelSmoothing::greatest_width)) {
      throw InvalidInput("the smoothing of labels is " + describe(options.smoothing) + " voxels; it must be 0, or from " +
                         describe(LabelSmoothing::least_width) + " to " + describe(LabelSmoothing::greatest_width));
    }
    smoothing_.emplace(regions_.voxels, options.smoothing, control);
  }
  explicit LabelledImage(const AnyImage& image, const LabelOptions& options = {}, const Control& control = Control{})
      : LabelledImage(std::visit([&](const auto& i) { return LabelledImage(i, options, control); }, image)) {}

  const ImageGrid& grid() const { return grid_; }
  /// The label in the image of each region.
  const std::vector<int>& region_labels() const { return regions_.labels; }
  /// Half a voxel beyond the outermost voxels.
  BoundingBox3 bounds() const {
    const auto end = [&](std::size_t axis) { return double(grid_.size[axis]); };
    return grid_.world_box({-1, -1, -1}, {end(0), end(1), end(2)});
  }

  void label(std::span<const Point3> points, std::span<int> labels) const {
    if (smoothing_) {
      for (std::size_t i = 0; i != points.size(); ++i) labels[i] = (*smoothing_)(regions_.voxels, to_index_(points[i]));
    } else {
      for (std::size_t i = 0; i != points.size(); ++i) {
        const Point3 p = to_index_(points[i]);
        labels[i] = regions_.voxels(detail::nearest_voxel(p.x), detail::nearest_voxel(p.y), detail::nearest_voxel(p.z));
      }
    }
  }

  /// Without smoothing exactly where the segment first leaves the voxels of its first label, up to rounding; with it up to `tolerance`.
  Point3 crossing(Point3 a, Point3 b, int label_a, double tolerance) const {
    const Point3 from = to_index_(a);
    const Vector3 way = to_index_(b) - from;
    if (!smoothing_) {
      const std::optional<double> t = detail::first_other_voxel(regions_.voxels, from, way, label_a);
      return t && *t < 1 ? a + *t * (b - a) : b;
    }
    const auto lack = [&](double t) { return smoothing_->lack(regions_.voxels, from + t * way, label_a); };
    const double length = std::sqrt(squared_distance(a, b));
    const double t = length > 0 ? bracketed_root(lack, 0, lack(0), 1, lack(1), tolerance / length) : 0;
    return t >= 1 ? b : a + t * (b - a);
  }

  /// Each boundary surface of each connected part of each region; where two parts have one in common it comes once. Without smoothing
  /// that is exact; with it, from the smoothed labels of the voxels' centres.
  SurfaceComponents components(const Control& control) const {
    SurfaceComponents out;
    out.is_exact = !smoothing_;
    out.method = smoothing_ ? "from the smoothed labels at the voxels' centres" : "from the voxels of the image, exactly";
    const detail::VoxelLabels smoothed = smoothing_ ? labels_at_centres(control) : detail::VoxelLabels();
    const detail::VoxelLabels& labels = smoothing_ ? smoothed : regions_.voxels;
    detail::LabelBoundaries boundaries(labels, control);
    StopCheck stop(control);
    std::vector<Point3> points;
    boundaries.for_each_surface([&](std::span<const detail::VoxelSide> surface) {
      points.clear();
      for (const detail::VoxelSide& side : surface) stop(), points.push_back(middle_of(side));
      std::vector<Point3> seeds = spread_points(points, 32);
      if (smoothing_) {
        for (Point3& seed : seeds) seed = onto_smooth_boundary(seed, labels);
      }
      out.components.push_back(std::move(seeds));
    });
    return out;
  }

  /// The labels of which smoothing leaves no voxel's centre: too small to be seen.
  std::vector<int> lost_labels(const Control& control = Control{}) const {
    if (!smoothing_) return {};
    std::vector<bool> seen(regions_.labels.size());
    const detail::VoxelLabels smoothed = labels_at_centres(control);
    for (std::size_t i = 0; i != grid_.voxels(); ++i) {
      if (smoothed[i] != outside) seen[static_cast<std::size_t>(smoothed[i])] = true;
    }
    std::vector<int> out;
    for (std::size_t i = 0; i != seen.size(); ++i) {
      if (!seen[i]) out.push_back(regions_.labels[i]);
    }
    return out;
  }

 private:
  detail::VoxelLabels labels_at_centres(const Control& control) const {
    detail::VoxelLabels out(grid_.size);
    for (int z = 0; z != grid_.size[2]; ++z) {
      for (int y = 0; y != grid_.size[1]; ++y) {
        throw_if_stopped(control);
        for (int x = 0; x != grid_.size[0]; ++x) out.set(out.place(x, y, z), (*smoothing_)(regions_.voxels, {double(x), double(y), double(z)}));
      }
    }
    return out;
  }

  Point3 middle_of(const detail::VoxelSide& side) const {
    std::array<double, 3> p{double(side.voxel[0]), double(side.voxel[1]), double(side.voxel[2])};
    p[static_cast<std::size_t>(side.direction % 3)] += side.direction < 3 ? 0.5 : -0.5;
    return grid_.world({p[0], p[1], p[2]});
  }

  /// The boundary between the centres of the two voxels that a face is between, given its middle.
  Point3 onto_smooth_boundary(Point3 middle, const detail::VoxelLabels& labels) const {
    const Point3 p = to_index_(middle);
    std::array<double, 3> low{p.x, p.y, p.z}, high = low;
    for (std::size_t i = 0; i != 3; ++i) {
      const double nearest = std::round(2 * low[i]) / 2;
      low[i] = std::floor(nearest), high[i] = std::ceil(nearest);
    }
    const Point3 a = grid_.world({low[0], low[1], low[2]}), b = grid_.world({high[0], high[1], high[2]});
    const int label_a = labels(static_cast<int>(low[0]), static_cast<int>(low[1]), static_cast<int>(low[2]));
    return crossing(a, b, label_a, 1e-6 * std::sqrt(squared_distance(a, b)));
  }

  ImageGrid grid_;
  WorldToIndex to_index_;
  detail::RegionNumbers regions_;
  std::optional<detail::LabelSmoothing> smoothing_;
};

static_assert(FindsComponents<LabelledImage>);

}  // namespace delref
