// SPDX-License-Identifier: GPL-3.0-or-later
//
// From the plane to the pixels of a picture, and paths of many small pieces in little text.
#pragma once

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <span>
#include <string>

#include <fmt/compile.h>
#include <fmt/format.h>

#include <delref/core/point.hpp>

namespace delref {

/// Fits points into a picture, with y upwards in the plane and downwards in the picture. Places are integers, ten to a pixel.
class SvgFrame {
 public:
  static constexpr double steps_per_pixel = 10;

  /// A place in the picture.
  struct Corner {
    std::int32_t x = 0, y = 0;

    friend auto operator<=>(const Corner&, const Corner&) = default;
  };

  /// `size` is the longer side in pixels, margins included.
  SvgFrame(std::span<const Point2> points, double size) {
    if (points.empty()) return;
    low_ = high_ = points.front();
    for (const Point2& p : points) {
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
      high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
    }
    // Halves, so that a box from -1e308 to 1e308 has a size.
    const double half_width = 0.5 * high_.x - 0.5 * low_.x, half_height = 0.5 * high_.y - 0.5 * low_.y, longest = std::max(half_width, half_height);
    unit_ = longest > 0 ? longest : 1;
    half_size_ = (size - 2 * margin) / 2;
    width_ = std::max(2 * half_size_ * (half_width / unit_) + 2 * margin, least_width);
    height_ = 2 * half_size_ * (half_height / unit_) + 2 * margin;
    left_ = (width_ - 2 * half_size_ * (half_width / unit_)) / 2;
  }

  double width() const { return width_; }
  double height() const { return height_; }
  Corner operator()(Point2 p) const {
    const double x = left_ + 2 * half_size_ * ((0.5 * p.x - 0.5 * low_.x) / unit_);
    const double y = margin + 2 * half_size_ * ((0.5 * high_.y - 0.5 * p.y) / unit_);
    return {round(x), round(y)};
  }
  /// Twice the area of a triangle, in steps.
  static double doubled_area(Corner a, Corner b, Corner c) {
    return static_cast<double>(b.x - a.x) * static_cast<double>(c.y - a.y) - static_cast<double>(b.y - a.y) * static_cast<double>(c.x - a.x);
  }

 private:
  static constexpr double margin = 20, least_width = 420;

  /// Places far outside, of unmet elements that are not in the mesh, stay outside.
  std::int32_t round(double pixels) const { return static_cast<std::int32_t>(std::lround(std::clamp(pixels, -1e4, 1e5) * steps_per_pixel)); }

  Point2 low_, high_;
  double unit_ = 1, half_size_ = 0, width_ = least_width, height_ = 2 * margin, left_ = margin;
};

/// The text of a path of polylines, in relative coordinates.
class SvgPath {
 public:
  void add(std::initializer_list<SvgFrame::Corner> corners, bool closed) {
    SvgFrame::Corner at = start_;
    bool first = true;
    for (const SvgFrame::Corner& corner : corners) {
      put(corner.x - at.x, corner.y - at.y, first);
      at = corner;
      if (first) start_ = corner;
      first = false;
    }
    if (closed) text_ += 'z';
    else start_ = at;
  }
  const std::string& text() const { return text_; }

 private:
  /// A pair after the first of a polyline is a line to it, without a letter of its own.
  void put(std::int32_t x, std::int32_t y, bool first) {
    if (first) text_ += 'm';
    fmt::format_to(std::back_inserter(text_), FMT_COMPILE("{}{}{}{}"), first || x < 0 ? "" : " ", x, y < 0 ? "" : " ", y);
  }

  std::string text_;
  /// Where the next piece starts from: the start of the last closed piece, or the end of the last open one.
  SvgFrame::Corner start_;
};

}  // namespace delref
