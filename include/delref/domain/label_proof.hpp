// SPDX-License-Identifier: GPL-3.0-or-later
//
// Proves over boxes on which side of a function they are; for parts of a box, with what is left of the function there, where the
// function can tell that.
#pragma once

#include <concepts>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>

#include <delref/domain/bounding_box_3.hpp>
#include <delref/domain/implicit_function.hpp>
#include <delref/domain/oracle.hpp>

namespace delref::detail {

/// Region 0 where the function is negative.
template <RangedFunction F>
class LabelProof {
 public:
  explicit LabelProof(const F& function) : function_(&function) {}

  std::optional<int> operator()(const BoundingBox3& box) const {
    const std::optional<bool> inside = proved_inside(function_->range(box));
    if (!inside) return std::nullopt;
    return *inside ? 0 : outside;
  }
  bool is_regular(const BoundingBox3& box) const requires RegularFunction<F> { return function_->is_regular(box); }
  /// For boxes within this one.
  LabelProof within(const BoundingBox3&) const { return *this; }

 private:
  const F* function_;
};

/// The same for a function that gets shorter within a box: `function.narrowed(box)`, perhaps a function of the same type.
template <RangedFunction F>
requires requires(const F& function, const BoundingBox3& box) {
  { function.narrowed(box) } -> std::same_as<std::optional<F>>;
}
class LabelProof<F> {
 public:
  explicit LabelProof(const F& function) : function_(std::make_shared<const F>(function)) {}

  std::optional<int> operator()(const BoundingBox3& box) const {
    const std::optional<bool> inside = proved_inside(function_->range(box));
    if (!inside) return std::nullopt;
    return *inside ? 0 : outside;
  }
  bool is_regular(const BoundingBox3& box) const requires RegularFunction<F> { return function_->is_regular(box); }
  LabelProof within(const BoundingBox3& box) const {
    std::optional<F> shorter = function_->narrowed(box);
    return shorter ? LabelProof(*std::move(shorter)) : *this;
  }

 private:
  std::shared_ptr<const F> function_;
};

}  // namespace delref::detail
