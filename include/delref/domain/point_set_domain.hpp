// SPDX-License-Identifier: GPL-3.0-or-later
//
// What points on a surface enclose, as a domain for the meshers of smooth surfaces and volumes: the inside of the surface that a Poisson
// reconstruction puts through them (Kazhdan, Bolitho, Hoppe, "Poisson surface reconstruction", 2006; the function is CGAL's).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/core/point.hpp>
#include <delref/domain/bounding_box_3.hpp>
#include <delref/domain/box_questions.hpp>
#include <delref/domain/describe.hpp>
#include <delref/domain/invalid_input.hpp>
#include <delref/domain/oracle.hpp>
#include <delref/domain/piecewise_linear_function.hpp>
#include <delref/domain/point_set.hpp>
#include <delref/domain/point_set_options.hpp>
#include <delref/domain/poisson_function.hpp>
#include <delref/domain/prepare_point_set.hpp>
#include <delref/domain/sign_search.hpp>
#include <delref/domain/spread_points.hpp>

namespace delref {

namespace detail {

/// Where a sample is in the frame, or what is some way along its normal.
inline Point3 place_of(const Sample& sample, double along_normal = 0) {
  const auto p = std::get<0>(sample) + along_normal * std::get<1>(sample);
  return {p.x(), p.y(), p.z()};
}

/// The samples, and corners of a box around them that say nothing of the surface. CGAL refines where circumcentres are, and around points that
/// are all on one sphere there are none: without the corners the function has no vertices outside, and is noise.
inline std::vector<Sample> surrounded(std::vector<Sample> samples) {
  BoundingBox3 box;
  for (const Sample& sample : samples) box.extend(place_of(sample));
  const double margin = 0.05 * box.extent();
  const auto side = [&](bool is_high, double low, double high) { return is_high ? high + margin : low - margin; };
  for (const bool x : {false, true})
    for (const bool y : {false, true})
      for (const bool z : {false, true})
        samples.emplace_back(SpatialKernel::Point_3(side(x, box.low.x, box.high.x), side(y, box.low.y, box.high.y), side(z, box.low.z, box.high.z)),
                             SpatialKernel::Vector_3(0, 0, 0), false);
  return samples;
}

/// At how many samples there is no surface between what their normals say is inside and what they say is outside, at `reach` from
/// them or at a half, a quarter or an eighth of it (sheets may be near each other). Normals that all point inwards are as good.
inline std::size_t lost_samples(const PiecewiseLinearFunction& function, std::span<const Sample> samples, double reach, const Control& control) {
  StopCheck check(control);
  std::size_t outwards = 0, inwards = 0;
  for (const Sample& sample : samples) {
    check();
    bool is_outwards = false, is_inwards = false;
    for (double step = reach; step >= reach / 8 && !is_outwards; step /= 2) {
      const bool is_behind_in = function(place_of(sample, -step)) < 0, is_before_in = function(place_of(sample, step)) < 0;
      is_outwards |= is_behind_in && !is_before_in;
      is_inwards |= is_before_in && !is_behind_in;
    }
    outwards += is_outwards;
    inwards += is_inwards;
  }
  return samples.size() - std::max(outwards, inwards);
}

/// Whether the function is negative at the hull of its tetrahedra, so that these end what is inside, not the function.
inline bool is_cut_off(const PiecewiseLinearFunction& function) {
  return std::ranges::any_of(function.cells(), [&](const LinearCell& cell) {
    return std::ranges::find(cell.corner, PiecewiseLinearFunction::infinite_corner) != cell.corner.end() &&
           std::ranges::any_of(cell.corner, [&](std::uint32_t corner) { return function.corners()[corner].value < 0; });
  });
}

}  // namespace detail

/// One region, number 0: what the reconstructed surface encloses. Models `FindsComponents`; constant calls may be made from several
/// threads. The surface is closed even where the points leave holes, and made of flat pieces about as long as points are apart.
class PointSetDomain {
 public:
  /// Reconstructs the surface. Takes some 100 microseconds per point, most of them CGAL's, and twice that for sets that are difficult.
  /// Throws `InvalidInput` when there are fewer than four different points, when all are in one plane, when coordinates or normals are not
  /// finite, when no surface comes out, and when it misses more than half of the points; `Interrupted` when the control says stop.
  explicit PointSetDomain(const PointSet& set, const PointSetOptions& options = {}, const Control& control = Control{}) {
    detail::PreparedPoints prepared = detail::prepare_point_set(set, options, control);
    notes_ = std::move(prepared.notes);
    average_spacing_ = prepared.average_spacing;
    frame_ = prepared.frame;
    Attempt attempt = reconstruct(prepared.samples, prepared.samples, control);
    if (attempt.fault() >= told_lost) {
      Attempt second = reconstruct(detail::surrounded(prepared.samples), prepared.samples, control);
      if (second.fault() < attempt.fault()) attempt = std::move(second);
    }
    tell_of(attempt);
    function_ = std::move(attempt.function);
    bounds_ = {frame_.out_of(attempt.bounds.low), frame_.out_of(attempt.bounds.high)};
  }

  const BoundingBox3& bounds() const { return bounds_; }
  /// The mean distance of points from their six nearest, of the points that were used.
  double average_spacing() const { return average_spacing_; }
  /// Sizes that suit the points, where the user names none: finer facets show no more of the surface.
  double default_facet_size() const { return 3 * average_spacing_; }
  double default_facet_distance() const { return average_spacing_ / 4; }
  /// What a person should know: a sentence each.
  const std::vector<std::string>& notes() const { return notes_; }

  /// The function that was reconstructed: negative inside, of no particular unit, continuous, and linear on tetrahedra.
  double value(Point3 p) const { return function_(frame_.into(p)); }

  /// 0 for the points inside, `outside` for the others.
  void label(std::span<const Point3> points, std::span<int> labels) const {
    for (std::size_t i = 0; i < points.size(); ++i) labels[i] = contains(bounds_, points[i]) && value(points[i]) < 0 ? 0 : outside;
  }

  /// See `Oracle`.
  Point3 crossing(Point3 a, Point3 b, int, double tolerance) const {
    return sign_change([this](Point3 p) { return value(p); }, bounds_, a, b, tolerance);
  }

  /// The components of the surface, from the tetrahedra: all of them. Throws `Interrupted`.
  SurfaceComponents components(const Control& control) const {
    SurfaceComponents found{{}, "from the tetrahedra on which the reconstructed function is linear, exactly", true};
    for (std::vector<Point3>& component : function_.components()) {
      throw_if_stopped(control);
      for (Point3& p : component) p = frame_.out_of(p);
      found.components.push_back(spread_points(component, most_seeds));
    }
    return found;
  }

 private:
  static constexpr std::size_t most_seeds = 32;

  static constexpr double told_lost = 0.05;
  static constexpr double refused_lost = 0.5;

  /// A function, prepared for its box, at how many samples it has no surface, and whether the inside reaches the end of the tetrahedra.
  struct Attempt {
    PiecewiseLinearFunction function;
    BoundingBox3 bounds;
    std::size_t bubbles = 0, samples = 0, lost = 0;
    bool is_cut_off = false;
    double share_lost() const { return static_cast<double>(lost) / static_cast<double>(samples); }
    double fault() const { return share_lost() + (is_cut_off ? told_lost : 0); }
  };

  /// Judged by `samples`, whatever else the function is made from. Nothing smaller than the distance of points can be meant by them: such
  /// bubbles are filled. The box has a margin, so that no surface is on its faces, and is empty when there is no surface.
  Attempt reconstruct(const std::vector<detail::Sample>& from, std::span<const detail::Sample> samples, const Control& control) const {
    const double spacing = frame_.scale * average_spacing_;
    Attempt made{detail::poisson_function(from, control), {}, 0, samples.size(), samples.size(), false};
    made.bubbles = made.function.fill_bubbles(spacing);
    const BoundingBox3 box = made.function.negative_box();
    if (box.empty()) return made;
    const double margin = 0.02 * box.extent();
    const Vector3 outwards{margin, margin, margin};
    made.bounds = {box.low + -1.0 * outwards, box.high + outwards};
    made.function.prepare_for(made.bounds, control);
    made.is_cut_off = detail::is_cut_off(made.function);
    made.lost = detail::lost_samples(made.function, samples, 1.5 * spacing, control);
    return made;
  }

  void tell_of(const Attempt& attempt) {
    if (attempt.bounds.empty())
      throw InvalidInput("no surface was found through the points: the reconstructed function has the same sign everywhere; look at whether "
                         "the normals point to one side of the surface");
    const std::string lost = std::to_string(attempt.lost) + " of " + count_of(attempt.samples, "point", "points");
    if (attempt.share_lost() > refused_lost)
      throw InvalidInput("no surface was found through the points: the reconstructed one misses " + lost +
                         ", or has its inside on the wrong side there; give more points, normals that point to one side of the surface, or smooth "
                         "points that are noisy");
    if (attempt.share_lost() > told_lost)
      notes_.push_back("the reconstructed surface misses " + lost +
                       ", or has its inside on the wrong side there; look at it, and give more points, normals when there were none, or smooth "
                       "points that are noisy");
    if (attempt.bubbles > 0)
      notes_.push_back(count_of(attempt.bubbles, "bubble", "bubbles") + " in the reconstructed surface, smaller than the average distance of points, " +
                       (attempt.bubbles == 1 ? "was" : "were") + " filled");
  }

  PiecewiseLinearFunction function_;
  detail::Frame frame_;
  BoundingBox3 bounds_;
  double average_spacing_ = 0;
  std::vector<std::string> notes_;
};

}  // namespace delref
