// SPDX-License-Identifier: GPL-3.0-or-later
//
// One type for every oracle that the program makes, so that the mesher, which takes a compiler long, is compiled once. A call through
// it costs a pointer; points are asked many at a time.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/core/point.hpp>
#include <delref/domain/bounding_box_3.hpp>
#include <delref/domain/oracle.hpp>
#include <delref/domain/sampled_components.hpp>

namespace delref::program {

/// Any oracle, shared by its copies. Models `FindsComponents`: where the oracle itself does not find its components, by samples. They
/// are looked for once, by the first of the copies that is asked; only one thread may ask. An oracle that names its regions
/// (`region_labels()`) keeps them. As made without one it may only be assigned to.
class AnyOracle {
 public:
  AnyOracle() = default;
  template <Oracle O>
  explicit AnyOracle(O oracle) {
    static_assert(explain_oracle<O>());
    const auto object = std::make_shared<const O>(std::move(oracle));
    bounds_ = object->bounds();
    if constexpr (requires { object->region_labels(); }) region_labels_ = object->region_labels();
    label_ = [](const void* self, std::span<const Point3> points, std::span<int> labels) { static_cast<const O*>(self)->label(points, labels); };
    crossing_ = [](const void* self, Point3 a, Point3 b, int label_a, double tolerance) {
      return static_cast<const O*>(self)->crossing(a, b, label_a, tolerance);
    };
    components_ = [](const void* self, const Control& control) {
      const O& its = *static_cast<const O*>(self);
      if constexpr (FindsComponents<O>) return its.components(control);
      else return sample_components(its, its.bounds().extent() / 64, control);
    };
    object_ = object;
    found_ = std::make_shared<std::optional<SurfaceComponents>>();
  }

  BoundingBox3 bounds() const { return bounds_; }
  void label(std::span<const Point3> points, std::span<int> labels) const { label_(object_.get(), points, labels); }
  Point3 crossing(Point3 a, Point3 b, int label_a, double tolerance) const { return crossing_(object_.get(), a, b, label_a, tolerance); }
  SurfaceComponents components(const Control& control) const {
    if (!*found_) *found_ = components_(object_.get(), control);
    return **found_;
  }
  /// A box around the points that were found of them.
  BoundingBox3 surface_box(const Control& control) const {
    BoundingBox3 box;
    for (const auto& component : components(control).components)
      for (const Point3 p : component) box.extend(p);
    return box;
  }
  /// Empty when the oracle does not name its regions.
  const std::vector<int>& region_labels() const { return region_labels_; }

 private:
  std::shared_ptr<const void> object_;
  std::shared_ptr<std::optional<SurfaceComponents>> found_;
  BoundingBox3 bounds_;
  std::vector<int> region_labels_;
  void (*label_)(const void*, std::span<const Point3>, std::span<int>) = nullptr;
  Point3 (*crossing_)(const void*, Point3, Point3, int, double) = nullptr;
  SurfaceComponents (*components_)(const void*, const Control&) = nullptr;
};

static_assert(FindsComponents<AnyOracle>);

}  // namespace delref::program
