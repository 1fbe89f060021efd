// SPDX-License-Identifier: GPL-3.0-or-later
//
// One type for every domain that the property tests make, so that the mesher and the verification are compiled once; and a count of
// the questions that it was asked.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/core/point.hpp>
#include <delref/domain/oracle.hpp>

namespace delref::property_smooth {

/// Any oracle that finds its components, behind plain functions. Copies share it and the counts.
class Domain {
 public:
  struct Counts {
    std::size_t labels = 0, crossings = 0;
    std::size_t evaluations = 0;  ///< of the function behind it, where that counts them
  };

  template <FindsComponents O>
    requires(!std::same_as<O, Domain>)
  explicit Domain(O oracle) {
    const auto shared = std::make_shared<const O>(std::move(oracle));
    bounds_ = shared->bounds();
    label_ = [shared](std::span<const Point3> points, std::span<int> labels) { shared->label(points, labels); };
    crossing_ = [shared](Point3 a, Point3 b, int label_a, double tolerance) { return shared->crossing(a, b, label_a, tolerance); };
    components_ = [shared](const Control& control) { return shared->components(control); };
    if constexpr (requires { shared->region_labels(); }) region_labels_ = shared->region_labels();
  }

  BoundingBox3 bounds() const { return bounds_; }
  void label(std::span<const Point3> points, std::span<int> labels) const {
    counts_->labels += points.size();
    label_(points, labels);
  }
  Point3 crossing(Point3 a, Point3 b, int label_a, double tolerance) const {
    ++counts_->crossings;
    return crossing_(a, b, label_a, tolerance);
  }
  SurfaceComponents components(const Control& control) const { return components_(control); }
  const std::vector<int>& region_labels() const { return region_labels_; }

  int label_at(Point3 p) const {
    int label_of_p = outside;
    label(std::span<const Point3>(&p, 1), std::span<int>(&label_of_p, 1));
    return label_of_p;
  }
  Counts counts() const {
    Counts counts = *counts_;
    if (evaluations_) counts.evaluations = *evaluations_;
    return counts;
  }
  /// The function behind it counts its evaluations there.
  void counts_evaluations(std::shared_ptr<const std::size_t> count) { evaluations_ = std::move(count); }

 private:
  BoundingBox3 bounds_;
  std::function<void(std::span<const Point3>, std::span<int>)> label_;
  std::function<Point3(Point3, Point3, int, double)> crossing_;
  std::function<SurfaceComponents(const Control&)> components_;
  std::vector<int> region_labels_;
  std::shared_ptr<const std::size_t> evaluations_;
  std::shared_ptr<Counts> counts_ = std::make_shared<Counts>();
};
static_assert(FindsComponents<Domain>);

}  // namespace delref::property_smooth
