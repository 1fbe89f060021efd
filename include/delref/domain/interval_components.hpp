// SPDX-License-Identifier: GPL-3.0-or-later
//
// The connected components of the surfaces of a domain whose label can be proved over boxes: an octree throws away every box over
// which the label does not change, down to a stated size; the surface is in what is left. After Snyder, "Interval analysis for
// computer graphics" (1992), and Plantinga and Vegter, "Isotopic meshing of implicit surfaces" (2007).
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/core/point.hpp>
#include <delref/domain/bounding_box_3.hpp>
#include <delref/domain/describe.hpp>
#include <delref/domain/invalid_input.hpp>
#include <delref/domain/leaf_surface.hpp>
#include <delref/domain/oracle.hpp>

namespace delref {

namespace detail {

/// An octree over a box, halved along every axis that is longer than `size` until none is.
class LabelOctree {
 public:
  LabelOctree(const BoundingBox3& box, double size)
      : box_(box),
        depth_{depth(box.high.x - box.low.x, size), depth(box.high.y - box.low.y, size), depth(box.high.z - box.low.z, size)} {
    if (std::max({depth_.x, depth_.y, depth_.z}) > 12)
      throw InvalidInput("boxes of size " + describe(size) + " are too small: the bounds are " + describe(box.extent() / size) +
                         " times as long");
  }

  /// The boxes of the last level that are not proved to have one label, or reach the bounds and are not proved outside: the
  /// surface is in them, or between them and what is beyond the bounds.
  template <class UniformLabel>
  std::vector<GridCell> leaves(const UniformLabel& uniform_label, const Control& control) {
    std::vector<GridCell> found;
    all_regular_ = true, reaches_bounds_ = false;
    descend({0, 0, 0}, {1U << depth_.x, 1U << depth_.y, 1U << depth_.z}, uniform_label, found, control);
    return found;
  }
  /// In every box of the last `leaves` the surface is proved to be simple, and none reaches the bounds.
  bool all_regular() const { return all_regular_; }
  /// A box of the last `leaves` is at the bounds: no smaller boxes will prove more.
  bool reaches_bounds() const { return reaches_bounds_; }

  CellGrid grid() const { return {box_, {1U << depth_.x, 1U << depth_.y, 1U << depth_.z}}; }

 private:
  static std::uint32_t depth(double side, double size) {
    return static_cast<std::uint32_t>(std::clamp(std::ceil(std::log2(side / size * (1 - 1e-9))), 0.0, 99.0));
  }
  BoundingBox3 box_of(GridCell low, GridCell size) const {
    const CellGrid all = grid();
    return {all.node(low), all.node({low.x + size.x, low.y + size.y, low.z + size.z})};
  }
  bool reaches_bounds(GridCell low, GridCell size) const {
    const auto at_end = [](std::uint32_t from, std::uint32_t length, std::uint32_t levels) {
      return from == 0 || from + length == 1U << levels;
    };
    return at_end(low.x, size.x, depth_.x) || at_end(low.y, size.y, depth_.y) || at_end(low.z, size.z, depth_.z);
  }
  /// The longest axes are halved first, so that boxes become cubes as far as they can.
  template <class UniformLabel>
  void descend(GridCell low, GridCell size, const UniformLabel& uniform_label, std::vector<GridCell>& found,
               const Control& control) {
    const BoundingBox3 box = box_of(low, size);
    const std::optional<int> label = uniform_label(box);
    if (label && (*label == outside || !reaches_bounds(low, size))) return;
    const std::uint32_t most = std::max({size.x, size.y, size.z});
    if (most == 1) {
      found.push_back(low);
      if (reaches_bounds(low, size)) reaches_bounds_ = true, all_regular_ = false;
      if (all_regular_) all_regular_ = is_regular(uniform_label, box);
      return;
    }
    if (most >= 8) throw_if_stopped(control);
    const auto half = [most](std::uint32_t length) { return length == most ? length / 2 : length; };
    const GridCell part{half(size.x), half(size.y), half(size.z)};
    const auto descend_into_parts = [&](const auto& proof) {
      for (std::uint32_t z = 0; z < size.z; z += part.z)
        for (std::uint32_t y = 0; y < size.y; y += part.y)
          for (std::uint32_t x = 0; x < size.x; x += part.x)
            descend({low.x + x, low.y + y, low.z + z}, part, proof, found, control);
    };
    if constexpr (requires { uniform_label.within(box); })
      descend_into_parts(uniform_label.within(box));
    else
      descend_into_parts(uniform_label);
  }

  template <class UniformLabel>
  static bool is_regular(const UniformLabel& uniform_label, const BoundingBox3& box) {
    if constexpr (requires { uniform_label.is_regular(box); })
      return uniform_label.is_regular(box);
    else
      return false;
  }

  BoundingBox3 box_;
  GridCell depth_;
  bool all_regular_ = true, reaches_bounds_ = false;
};

}  // namespace detail

/// The components of the surfaces of an oracle, down to boxes no longer than `size`. `uniform_label(box)` gives the label when it
/// is proved to be the same all over a `BoundingBox3`, and nothing otherwise; `uniform_label.within(box)`, if there is such a
/// member, a shorter proof for parts of the box. No surface is outside the boxes that are left. Those whose corners differ give
/// the components, each with up to `most_seeds` points of the surface; connected boxes whose corners all agree may hold a
/// component that is smaller than a box, or nothing, and are told of in `method`. Throws `InvalidInput` when the size is not
/// positive or the bounds are more than 4,096 times as long, `Interrupted` when the control says stop.
template <Oracle O, class UniformLabel>
SurfaceComponents interval_components(const O& oracle, double size, const Control& control, const UniformLabel& uniform_label) {
  if (!(size > 0)) throw InvalidInput("the size of boxes " + describe(size) + " is no positive length");
  double now = size;
  if constexpr (requires { uniform_label.is_regular(oracle.bounds()); })
    while (32 * now < oracle.bounds().extent()) now *= 2;
  for (;; now = std::max(size, now / 2)) {
    detail::LabelOctree tree(oracle.bounds(), now);
    std::vector<detail::GridCell> leaves = tree.leaves(uniform_label, control);
    if (!tree.all_regular() && now > size) {
      if (tree.reaches_bounds()) now = 2 * size;
      continue;
    }
    SurfaceComponents found = detail::LeafSurface<O>(oracle, tree.grid(), std::move(leaves)).components(now, control);
    found.is_exact = tree.all_regular();
    if (found.is_exact) found.method += ", with proof";
    return found;
  }
}

}  // namespace delref
