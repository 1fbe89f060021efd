// SPDX-License-Identifier: GPL-3.0-or-later
//
// The points where a function is negative, as a domain for the meshers of smooth surfaces and volumes. The function is any
// callable of C++, asked many points at a time when it can answer so. After the implicit functions of Boissonnat and Oudot,
// "Provably good sampling and meshing of surfaces" (2005), section 5.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
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
#include <delref/domain/implicit_function.hpp>
#include <delref/domain/interval_components.hpp>
#include <delref/domain/invalid_input.hpp>
#include <delref/domain/label_proof.hpp>
#include <delref/domain/oracle.hpp>
#include <delref/domain/sampled_components.hpp>
#include <delref/domain/sign_search.hpp>

namespace delref {

/// What becomes of a domain that reaches the box given as its bounds.
enum class AtBounds : unsigned char {
  /// It ends there: the faces of the box become part of its surface.
  closed,
  /// It is refused with `InvalidInput`, as far as samples on the faces of the box tell.
  refused
};

/// The longest side of the bounds over this is the default distance of samples, and size of the smallest boxes.
inline constexpr double default_samples = 64;

/// How an implicit domain is looked at.
struct ImplicitOptions {
  AtBounds at_bounds = AtBounds::closed;
  /// The distance of the samples by which components of the surface are found, or the size of the smallest boxes where the
  /// function bounds its range over boxes (`RangedFunction`). 0: the longest side of the box over 64.
  double sampling_distance = 0;
};

/// One region, number 0: where the function is below 0 and the point in the box. Zero and NaN are outside. Models
/// `FindsComponents`.
template <class F>
class ImplicitDomain {
 public:
  /// Throws `InvalidInput` when the bounds are no box with positive finite sides, when the sampling distance is negative or not
  /// finite, and when the domain reaches the bounds but may not. Asks the function at some 6,000 points on the faces of the box.
  ImplicitDomain(F f, const BoundingBox3& box, const ImplicitOptions& options = {})
      : function_(std::move(f)), bounds_(box), options_(options) {
    static_assert(explain_implicit_function<F>());
    require_box(box);
    require_sampling_distance(options.sampling_distance);
    const std::vector<Point3> faces = box_face_samples(box, 32);
    std::vector<int> labels(faces.size());
    label(faces, labels);
    for (std::size_t i = 0; i < faces.size() && !reaches_bounds_; ++i)
      if (labels[i] != outside) reaches_bounds_ = true, where_ = faces[i];
    if (reaches_bounds_ && options.at_bounds == AtBounds::refused)
      throw InvalidInput(reaching_text() + "; give larger bounds, or let the domain be closed at its bounds");
  }

  const BoundingBox3& bounds() const { return bounds_; }
  const F& function() const { return function_; }
  /// The domain ends at a face of its box somewhere, as far as samples tell.
  bool reaches_bounds() const { return reaches_bounds_; }

  /// What a person should know about the domain: a sentence each.
  std::vector<std::string> notes() const {
    if (!reaches_bounds_) return {};
    return {reaching_text() + "; it is closed there by the faces of the box"};
  }

  /// 0 for the points inside, `outside` for the others.
  void label(std::span<const Point3> points, std::span<int> labels) const {
    std::array<double, 256> values;
    for (std::size_t from = 0; from < points.size(); from += values.size()) {
      const auto block = points.subspan(from, std::min(values.size(), points.size() - from));
      function_values(function_, block, std::span(values).first(block.size()));
      for (std::size_t i = 0; i < block.size(); ++i)
        labels[from + i] = is_inside(values[i]) && contains(bounds_, block[i]) ? 0 : outside;
    }
  }

  /// See `Oracle`. An end outside the bounds is outside the domain; the function is not asked beyond them.
  Point3 crossing(Point3 a, Point3 b, int, double tolerance) const {
    return sign_change([this](Point3 p) { return function_value(function_, p); }, bounds_, a, b, tolerance);
  }

  /// The components of the surface: by intervals where the function bounds its range over boxes, otherwise by samples. Throws
  /// `InvalidInput` when there is no surface, `Interrupted` when the control says stop.
  SurfaceComponents components(const Control& control) const {
    SurfaceComponents found = search(control);
    if (!found.components.empty() && !(is_on_bounds(found) && fills_bounds())) return found;
    const Point3 centre = midpoint(bounds_.low, bounds_.high);
    throw InvalidInput("the function has no surface in its bounds, " + found.method +
                       ": its sign is the same everywhere (at the centre " + describe(centre) + " its value is " +
                       describe(function_value(function_, centre)) +
                       "); negative values are inside, so perhaps the sign, the bounds or the sampling distance must be changed");
  }

 private:
  bool is_on_bounds(const SurfaceComponents& found) const {
    const auto on_face = [&](Point3 p) {
      return p.x == bounds_.low.x || p.x == bounds_.high.x || p.y == bounds_.low.y || p.y == bounds_.high.y ||
             p.z == bounds_.low.z || p.z == bounds_.high.z;
    };
    return std::ranges::all_of(found.components, [&](const auto& seeds) { return std::ranges::all_of(seeds, on_face); });
  }
  /// True when the function is inside everywhere, as far as samples tell: the only surface would be the box.
  bool fills_bounds() const {
    if (!reaches_bounds_) return false;
    constexpr std::size_t count = 33;
    std::vector<Point3> row(count);
    std::vector<int> labels(count);
    const auto at = [](double low, double high, std::size_t i) {
      return low + (static_cast<double>(i) + 0.5) * ((high - low) / static_cast<double>(count));
    };
    for (std::size_t jk = 0; jk < count * count; ++jk) {
      for (std::size_t i = 0; i < count; ++i)
        row[i] = {at(bounds_.low.x, bounds_.high.x, i), at(bounds_.low.y, bounds_.high.y, jk % count),
                  at(bounds_.low.z, bounds_.high.z, jk / count)};
      label(row, labels);
      if (std::ranges::count(labels, outside) > 0) return false;
    }
    return true;
  }

  SurfaceComponents search(const Control& control) const {
    const double distance = options_.sampling_distance > 0 ? options_.sampling_distance : bounds_.extent() / default_samples;
    if constexpr (RangedFunction<F>)
      return interval_components(*this, distance, control, detail::LabelProof<F>(function_));
    else
      return sample_components(*this, distance, control);
  }
  std::string reaching_text() const { return "the domain reaches its bounds, as at the point " + describe(where_); }

  F function_;
  BoundingBox3 bounds_;
  ImplicitOptions options_;
  bool reaches_bounds_ = false;
  Point3 where_{};
};

}  // namespace delref
