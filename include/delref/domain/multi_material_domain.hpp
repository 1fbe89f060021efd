// SPDX-License-Identifier: GPL-3.0-or-later
//
// Several functions together as one domain of several regions: the region of a point is told by the vector of their signs there.
// Used for multi-material domains since Pons, Segonne, Boissonnat, Rineau, Yvinec and Keriven, "High-quality consistent meshing
// of multi-label datasets" (2007).
#pragma once

#include <algorithm>
#include <array>
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
#include <delref/domain/box_questions.hpp>
#include <delref/domain/bracketed_root.hpp>
#include <delref/domain/describe.hpp>
#include <delref/domain/implicit_domain.hpp>
#include <delref/domain/implicit_function.hpp>
#include <delref/domain/interval_components.hpp>
#include <delref/domain/invalid_input.hpp>
#include <delref/domain/oracle.hpp>
#include <delref/domain/sampled_components.hpp>
#include <delref/domain/sign_search.hpp>

namespace delref {

/// The functions in which a point is inside: bit i for function i.
using SignVector = std::uint32_t;

/// Regions told by the signs of functions of one type (for different callables, `std::function<double(Point3)>`). Models
/// `FindsComponents`.
///
/// Without a list of regions, a point has the region `signs - 1`, where `signs` is its `SignVector`: inside function 0 alone is
/// region 0, inside function 1 alone region 1, inside both region 2; inside none is outside. With a list, the region is the place
/// in the list of the first entry equal to the point's signs, and all others are outside.
template <ImplicitFunction F>
class MultiMaterialDomain {
 public:
  static constexpr std::size_t most_functions = 16;

  /// Throws `InvalidInput` when there is no function or more than 16, when a listed sign vector names a function that is not
  /// there, is 0 or comes twice, and when the bounds or the sampling distance cannot be used (see `ImplicitDomain`). The domain
  /// is closed at its bounds.
  MultiMaterialDomain(std::vector<F> materials, const BoundingBox3& box, const std::vector<SignVector>& regions = {},
                      double sampling_distance = 0)
      : functions_(std::move(materials)), bounds_(box), sampling_distance_(sampling_distance) {
    require_box(box);
    require_sampling_distance(sampling_distance);
    if (functions_.empty() || functions_.size() > most_functions)
      throw InvalidInput("a domain of several materials needs 1 to 16 functions, not " + std::to_string(functions_.size()));
    number_regions(regions);
  }

  const BoundingBox3& bounds() const { return bounds_; }
  const std::vector<F>& functions() const { return functions_; }

  void label(std::span<const Point3> points, std::span<int> labels) const {
    std::array<double, 256> values;
    std::array<SignVector, 256> signs;
    for (std::size_t from = 0; from < points.size(); from += values.size()) {
      const auto block = points.subspan(from, std::min(values.size(), points.size() - from));
      signs.fill(0);
      for (std::size_t f = 0; f < functions_.size(); ++f) {
        function_values(functions_[f], block, std::span(values).first(block.size()));
        for (std::size_t i = 0; i < block.size(); ++i) signs[i] |= SignVector{is_inside(values[i])} << f;
      }
      for (std::size_t i = 0; i < block.size(); ++i)
        labels[from + i] = contains(bounds_, block[i]) ? region_of_[signs[i]] : outside;
    }
  }

  /// See `Oracle`: of the places where a function changes sign, the first from `a` behind which the label is another. When
  /// functions change sign more often than their ends show, a bisection by label takes over.
  Point3 crossing(Point3 a, Point3 b, int label_a, double tolerance) const {
    if (!contains(bounds_, a)) return crossing(b, a, label_at(b), tolerance);
    if (!contains(bounds_, b)) {
      const Point3 end = last_point_in(bounds_, a, b);
      if (label_at(end) == label_a) return end;
      b = end;
    }
    const double length = std::sqrt(squared_distance(a, b));
    if (!(length > 0)) return a;
    const double within = tolerance / length;
    const auto label_from = [&](double t) { return label_at(point_between(a, b, t)); };
    for (const double t : sign_changes(a, b, within))
      if (label_from(std::min(1.0, t + within)) != label_a && label_from(std::max(0.0, t - within)) == label_a)
        return point_between(a, b, t);
    const auto same = [&](double t) { return label_from(t) == label_a ? -1.0 : 1.0; };
    return point_between(a, b, bracketed_root(same, 0, -1, 1, 1, within));
  }

  /// The components of all surfaces together; surfaces that meet at a junction are one component. By intervals where the
  /// functions bound their ranges over boxes, otherwise by samples. Throws as `ImplicitDomain::components`.
  SurfaceComponents components(const Control& control) const {
    SurfaceComponents found = search(control);
    if (found.components.empty())
      throw InvalidInput("the functions have no surface in their bounds, " + found.method + ": no point is in a region");
    return found;
  }

 private:
  void number_regions(const std::vector<SignVector>& regions) {
    const SignVector count = SignVector{1} << functions_.size();
    region_of_.assign(count, outside);
    if (regions.empty())
      for (SignVector signs = 1; signs < count; ++signs) region_of_[signs] = static_cast<int>(signs) - 1;
    for (std::size_t i = 0; i < regions.size(); ++i) {
      const std::string name = "region " + std::to_string(i) + " has the signs " + std::to_string(regions[i]);
      if (regions[i] == 0) throw InvalidInput(name + ": inside no function is outside the domain");
      if (regions[i] >= count)
        throw InvalidInput(name + ", but there are only " + count_of(functions_.size(), "function", "functions"));
      if (region_of_[regions[i]] != outside)
        throw InvalidInput(name + ", as region " + std::to_string(region_of_[regions[i]]) + " has");
      region_of_[regions[i]] = static_cast<int>(i);
    }
  }

  int label_at(Point3 p) const {
    int label_of_p = outside;
    label(std::span<const Point3>(&p, 1), std::span(&label_of_p, 1));
    return label_of_p;
  }

  /// Where functions whose signs differ at the ends change sign, in increasing order.
  std::vector<double> sign_changes(Point3 a, Point3 b, double within) const {
    std::vector<double> places;
    for (const F& function : functions_) {
      const double fa = function_value(function, a), fb = function_value(function, b);
      if (is_inside(fa) == is_inside(fb)) continue;
      places.push_back(
          bracketed_root([&](double t) { return function_value(function, point_between(a, b, t)); }, 0, fa, 1, fb, 0.5 * within));
    }
    std::ranges::sort(places);
    return places;
  }

  SurfaceComponents search(const Control& control) const {
    const double distance = sampling_distance_ > 0 ? sampling_distance_ : bounds_.extent() / default_samples;
    if constexpr (RangedFunction<F>)
      return interval_components(*this, distance, control, [this](const BoundingBox3& box) { return uniform_label(box); });
    else
      return sample_components(*this, distance, control);
  }

  std::optional<int> uniform_label(const BoundingBox3& box) const requires RangedFunction<F> {
    SignVector signs = 0;
    for (std::size_t f = 0; f < functions_.size(); ++f) {
      const std::optional<bool> inside = proved_inside(functions_[f].range(box));
      if (!inside) return std::nullopt;
      signs |= SignVector{*inside} << f;
    }
    return region_of_[signs];
  }

  std::vector<F> functions_;
  BoundingBox3 bounds_;
  double sampling_distance_;
  /// Per sign vector.
  std::vector<int> region_of_;
};

}  // namespace delref
