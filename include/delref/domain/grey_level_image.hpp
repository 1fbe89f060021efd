// SPDX-License-Identifier: GPL-3.0-or-later
//
// The domain that a grey-level image stands for: where its trilinear interpolation is at least an iso value. An `Oracle` that finds all
// connected components of its surface.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/core/point.hpp>
#include <delref/domain/bounding_box_3.hpp>
#include <delref/domain/bracketed_root.hpp>
#include <delref/domain/grey_level_check.hpp>
#include <delref/domain/image.hpp>
#include <delref/domain/index_box.hpp>
#include <delref/domain/level_set_components.hpp>
#include <delref/domain/oracle.hpp>
#include <delref/domain/trilinear.hpp>

namespace delref {

/// Region 0 is where the trilinear interpolation of an image is at least the iso value (or at most, `inside_is_below`), the iso value
/// itself included; all else is outside, and so is all that is not between the centres of voxels. Values are kept as `float` where that
/// loses nothing, as `double` otherwise. Its surface is piecewise smooth only: the slopes jump between voxels.
class GreyLevelImage {
  // Before its uses, for its type is deduced.
  template <class Do>
  auto with_values(Do&& act) const {
    return floats_.empty() ? act(detail::Trilinear(grid_, doubles_.data())) : act(detail::Trilinear(grid_, floats_.data()));
  }

 public:
  /// Throws `InvalidInput` in words when the image is bad (`check_image`), fewer than two voxels thick, has a value that is infinite or
  /// not a number, has nothing inside or all of it, or has voxels inside at its border while `close_at_border` is off. Throws `Interrupted`.
  template <class Value>
  GreyLevelImage(Image<Value> image, double iso, GreyLevelOptions options = {}, const Control& control = Control{})
      : grid_(image.grid), to_index_((check_image(image), grid_)), iso_(options.inside_is_below ? -iso : iso) {
    last_ = {double(grid_.size[0] - 1), double(grid_.size[1] - 1), double(grid_.size[2] - 1)};
    detail::check_grey_levels(image, iso, options, control);
    store(std::move(image.values), options.inside_is_below);
  }
  GreyLevelImage(AnyImage image, double iso, GreyLevelOptions options = {}, const Control& control = Control{})
      : GreyLevelImage(std::visit([&](auto& i) { return GreyLevelImage(std::move(i), iso, options, control); }, image)) {}

  const ImageGrid& grid() const { return grid_; }
  /// Half a voxel beyond the centres of the outermost voxels.
  BoundingBox3 bounds() const {
    return grid_.world_box({-0.5, -0.5, -0.5}, {last_.x + 0.5, last_.y + 0.5, last_.z + 0.5});
  }

  void label(std::span<const Point3> points, std::span<int> labels) const {
    with_values([&](const auto& f) {
      for (std::size_t i = 0; i != points.size(); ++i) {
        const Point3 index = to_index_(points[i]);
        labels[i] = detail::in_index_box(index, last_) && f(index) >= iso_ ? 0 : outside;
      }
    });
  }

  /// On the surface up to `tolerance` along the segment. Where the surface closes the border, exactly on it up to rounding.
  Point3 crossing(Point3 a, Point3 b, int, double tolerance) const {
    // From the end in the image. Both may be: their order matters only to which of several crossings is found.
    Point3 from = to_index_(a), to = to_index_(b);
    if (!detail::in_index_box(from, last_)) std::swap(a, b), std::swap(from, to);
    if (!detail::in_index_box(from, last_)) return a;
    const Vector3 way = to - from;
    const double reach = detail::last_fraction_in_index_box(from, way, last_);
    return with_values([&](const auto& f) {
      const auto lack = [&](double t) { return iso_ - f(detail::into_index_box(from + t * way, last_)); };
      const double at_start = lack(0), at_reach = lack(reach);
      if (reach < 1 && at_reach <= 0) return a + reach * (b - a);
      const double length = std::sqrt(squared_distance(a, b));
      const double t = length > 0 ? bracketed_root(lack, 0, at_start, reach, at_reach, tolerance / length) : 0;
      return t >= 1 ? b : a + t * (b - a);
    });
  }

  SurfaceComponents components(const Control& control) const {
    SurfaceComponents out{{}, "from the grid of the image, exactly", true};
    for (LevelSetComponent& c : level_set(control)) out.components.push_back(std::move(c.seeds));
    return out;
  }
  /// The components with what else is known of them.
  std::vector<LevelSetComponent> level_set(const Control& control = Control{}) const {
    const auto find = [&](const auto& values) { return level_set_components(grid_, std::span(values), iso_, control); };
    return floats_.empty() ? find(doubles_) : find(floats_);
  }

 private:
  template <class Value>
  void store(std::vector<Value> values, bool turned) {
    const auto fits = [](Value v) { return static_cast<double>(static_cast<float>(v)) == static_cast<double>(v); };
    if (std::is_same_v<Value, float> || std::ranges::all_of(values, fits)) keep(std::move(values), floats_, turned);
    else keep(std::move(values), doubles_, turned);
  }
  template <class From, class To>
  static void keep(std::vector<From> values, std::vector<To>& kept, bool turned) {
    if constexpr (std::is_same_v<From, To>) {
      kept = std::move(values);
    } else {
      kept.resize(values.size());
      std::ranges::transform(values, kept.begin(), [](From v) { return static_cast<To>(v); });
    }
    if (turned) std::ranges::transform(kept, kept.begin(), [](To v) { return -v; });
  }

  ImageGrid grid_;
  WorldToIndex to_index_;
  double iso_;
  Vector3 last_;  // the index of the last voxel
  std::vector<float> floats_;
  std::vector<double> doubles_;
};

static_assert(FindsComponents<GreyLevelImage>);

}  // namespace delref
