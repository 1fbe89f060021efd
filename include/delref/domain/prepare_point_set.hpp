// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes of points as they come from a file samples that a surface can be reconstructed from: all different and finite, in a frame in
// which they are some 1 apart, each with a unit normal that points out. Normals that are missing are estimated by planes through neighbours
// and turned along a minimum spanning tree (Hoppe, DeRose, Duchamp, McDonald, Stuetzle 1992), both by CGAL.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <CGAL/bilateral_smooth_point_set.h>
#include <CGAL/mst_orient_normals.h>
#include <CGAL/pca_estimate_normals.h>
#include <CGAL/property_map.h>

#include <delref/core/budget.hpp>
#include <delref/core/point.hpp>
#include <delref/domain/bounding_box_3.hpp>
#include <delref/domain/describe.hpp>
#include <delref/domain/invalid_input.hpp>
#include <delref/domain/point_neighbours.hpp>
#include <delref/domain/point_set.hpp>
#include <delref/domain/point_set_check.hpp>
#include <delref/domain/point_set_options.hpp>

namespace delref::detail {

/// A point in the frame, the normal there, and whether that is known to point out, so that others are turned after it.
using Sample = std::tuple<SpatialKernel::Point_3, SpatialKernel::Vector_3, bool>;

/// A change of coordinates without rotation.
struct Frame {
  Point3 centre;
  double scale = 1;
  Point3 into(Point3 p) const { return Point3{} + scale * (p - centre); }
  Point3 out_of(Point3 p) const { return centre + 1 / scale * (p - Point3{}); }
};

/// What `prepare_point_set` gives.
struct PreparedPoints {
  std::vector<Sample> samples;
  Frame frame;
  double average_spacing = 0;
  std::vector<std::string> notes;
};

inline auto sample_maps() {
  return CGAL::parameters::point_map(CGAL::Nth_of_tuple_property_map<0, Sample>())
      .normal_map(CGAL::Nth_of_tuple_property_map<1, Sample>())
      .point_is_constrained_map(CGAL::Nth_of_tuple_property_map<2, Sample>())
      .geom_traits(SpatialKernel());
}

/// Does the work of `prepare_point_set`, a step after the other.
class PointSetPreparation {
 public:
  PointSetPreparation(const PointSet& set, const PointSetOptions& options, const Control& control) : set_(set), options_(options), control_(control) {}

  PreparedPoints run() {
    check_options();
    check_numbers(set_);
    numbers_ = different_points(set_.points);
    if (const std::size_t more = set_.points.size() - numbers_.size(); more > 0 && numbers_.size() >= 4)
      out_.notes.push_back(count_of(more, "point is where another one is, and was", "points are where others are, and were") + " left out");
    gather_points();
    look_at_neighbours();
    leave_out_outliers();
    choose_frame();
    if (set_.normals.empty()) estimate_normals();
    else take_normals();
    smooth();
    return std::move(out_);
  }

 private:
  static constexpr double told_outliers = 10;

  void check_options() const {
    if (options_.neighbours < 6 || options_.neighbours > 1000)
      throw InvalidInput("the normal at a point cannot be estimated from " + count_of(options_.neighbours, "neighbour", "neighbours") + "; give 6 to 1000");
    if (!(options_.outlier_distance >= 0))
      throw InvalidInput("the distance of outliers is " + describe(options_.outlier_distance) + "; give a positive multiple of the distance of points, or 0 to keep all");
  }

  void gather_points() {
    points_.clear();
    for (const std::size_t i : numbers_) points_.push_back(set_.points[i]);
    check_extent(points_);
    throw_if_stopped(control_);
  }

  void look_at_neighbours() {
    neighbours_ = point_neighbours(points_, options_.neighbours, control_);
    std::vector<double> sorted = neighbours_.distance;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::ranges::nth_element(sorted, middle);
    usual_ = *middle;
    const double extent = bounding_box_3(points_).extent();
    if (!(usual_ > 1e-9 * extent))
      throw InvalidInput("half of the points are within " + describe(usual_) + " of their neighbours, though the set is " + describe(extent) +
                         " long: nothing sensible can be reconstructed; leave out what is far away");
    out_.average_spacing = std::accumulate(neighbours_.distance.begin(), neighbours_.distance.end(), 0.0) / static_cast<double>(points_.size());
  }

  void leave_out_outliers() {
    const double factor = options_.outlier_distance > 0 ? options_.outlier_distance : told_outliers;
    ExampleList examples;
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i != points_.size(); ++i) {
      if (neighbours_.distance[i] > factor * usual_) examples.full() ? examples.add() : examples.add(describe_sample(numbers_[i], points_[i]));
      else kept.push_back(numbers_[i]);
    }
    if (examples.count() == 0) return;
    const std::string found = count_of(examples.count(), "point is", "points are") + " more than " + describe(factor) + " times as far from the nearest other points as is usual in the set";
    if (options_.outlier_distance == 0) {
      out_.notes.push_back(found + " (" + examples.text() + "); they may draw the surface to them, and can be left out by an outlier distance");
      return;
    }
    out_.notes.push_back(found + " and left out (" + examples.text() + ")");
    numbers_ = std::move(kept);
    gather_points();
    look_at_neighbours();
  }

  /// The scale is a power of two, so that nothing but the shift is rounded.
  void choose_frame() {
    const BoundingBox3 box = bounding_box_3(points_);
    out_.frame = {midpoint(box.low, box.high), std::ldexp(1.0, -std::ilogb(usual_))};
  }
  SpatialKernel::Point_3 place(std::size_t i) const { return to_cgal_point(out_.frame.into(points_[i])); }

  void take_normals() {
    std::size_t without = 0;
    for (std::size_t i = 0; i != points_.size(); ++i) {
      const Vector3 n = set_.normals[numbers_[i]];
      const double length = std::hypot(n.x, n.y, n.z);
      const Vector3 unit = 1 / length * n;
      if (std::isfinite(1 / length) && std::isfinite(length)) out_.samples.emplace_back(place(i), SpatialKernel::Vector_3(unit.x, unit.y, unit.z), false);
      else ++without;
    }
    if (out_.samples.size() < 4) throw InvalidInput("the normals of " + (out_.samples.empty() ? std::string("all") : "nearly all") + " points are zero; give normals with a direction, or none, and they will be estimated");
    if (without > 0) out_.notes.push_back(count_of(without, "point has", "points have") + " a normal of no length, and " + (without == 1 ? "was" : "were") + " left out");
  }

  /// The highest point of each group is taken to be seen from above.
  void estimate_normals() {
    for (std::size_t i = 0; i != points_.size(); ++i) out_.samples.emplace_back(place(i), SpatialKernel::Vector_3(0, 0, 0), false);
    const auto k = static_cast<unsigned>(options_.neighbours);
    CGAL::pca_estimate_normals<CGAL::Sequential_tag>(out_.samples, k, sample_maps());
    throw_if_stopped(control_);
    const DisjointSets::Groups groups = neighbours_.groups.groups();
    for (std::size_t g = 0; g + 1 != groups.begin.size(); ++g) {
      const auto members = std::span(groups.members).subspan(groups.begin[g], groups.begin[g + 1] - groups.begin[g]);
      auto& [top, normal, is_turned] = out_.samples[std::ranges::max(members, {}, [&](std::uint32_t i) { return std::get<0>(out_.samples[i]).z(); })];
      if (normal.z() < 0) normal = -normal;
      is_turned = true;
    }
    const auto unturned = CGAL::mst_orient_normals(out_.samples, k, sample_maps());
    const auto lost = static_cast<std::size_t>(out_.samples.end() - unturned);
    out_.samples.erase(unturned, out_.samples.end());
    throw_if_stopped(control_);
    tell_of_normals(groups.begin.size() - 1, lost);
  }
  void tell_of_normals(std::size_t groups, std::size_t lost) {
    std::string note = "the points have no normals: they were estimated from the " + std::to_string(options_.neighbours) + " nearest points each, and turned outwards";
    if (groups > 1) note += "; the points fall into " + std::to_string(groups) + " groups, each of which is taken to be seen from outside, so give normals if one lies within another";
    out_.notes.push_back(std::move(note));
    if (lost > 0) out_.notes.push_back(count_of(lost, "point was", "points were") + " left out, for it could not be told which side of the surface is outside there");
  }

  void smooth() {
    constexpr double kept_edges = 25;  // degrees between normals of one smooth surface
    const auto k = static_cast<unsigned>(std::min(options_.neighbours, out_.samples.size() - 1));
    for (std::size_t pass = 0; pass != options_.smoothing_passes; ++pass) {
      CGAL::bilateral_smooth_point_set<CGAL::Sequential_tag>(out_.samples, k, sample_maps().sharpness_angle(kept_edges));
      throw_if_stopped(control_);
    }
  }

  const PointSet& set_;
  const PointSetOptions& options_;
  const Control& control_;
  std::vector<std::size_t> numbers_;  // of the points that are left, in the set
  std::vector<Point3> points_;
  PointNeighbours neighbours_;
  double usual_ = 0;
  PreparedPoints out_;
};

/// The samples of a point set. Throws `InvalidInput` in words for what bounds no volume or is not finite, `Interrupted` when the control
/// says stop.
inline PreparedPoints prepare_point_set(const PointSet& set, const PointSetOptions& options, const Control& control) {
  return PointSetPreparation(set, options, control).run();
}

}  // namespace delref::detail
