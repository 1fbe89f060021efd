// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which triangles and tetrahedra the run has said, or its options say, that it leaves as they are.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <delref/mesh/verify/nearest_point.hpp>
#include <delref/mesh/verify/report.hpp>
#include <delref/mesh/verify_smooth/subject.hpp>
#include <delref/mesh/verify_smooth/surface_balls.hpp>

namespace delref::verification_smooth {

/// Decides about what misses a criterion: listed, at the size floor, not finished, or a failure.
class Excuses {
 public:
  Excuses(const Subject& s, VerifyReport& report)
      : s_(&s), report_(&report), facets_(places(s, 3)), cells_(places(s, 4)), is_covered_(s.mesh.triangles.size(), false),
        floor_(s.scaling.length(s.options.smallest_facet) * (1 + 1e-6)) {
    if (s.expected.strict) return;
    for (std::size_t t = 0; t < is_covered_.size(); ++t) is_covered_[t] = is_listed(facets_, s.barycentre(t), longest_edge(s.corners(t)));
  }

  /// The balls are known from now on.
  void set_balls(std::span<const SurfaceBall> balls) { balls_ = balls; }

  /// The run says that it left the facet as it is.
  bool is_listed(std::size_t triangle) const { return is_covered_[triangle]; }
  /// The same, or its ball is so small that the run had to.
  bool is_left(std::size_t triangle) const { return is_covered_[triangle] || is_at_floor(triangle); }

  /// Counts a facet that misses a criterion; false: it is a failure.
  bool settle_facet(std::size_t triangle) {
    if (s_->expected.strict) return false;
    if (is_covered_[triangle]) return ++report_->listed_unmet, true;
    if (is_at_floor(triangle)) return ++at_floor_, true;
    return settle_unfinished();
  }
  bool settle_tetrahedron(std::size_t t) {
    if (s_->expected.strict) return false;
    const TetrahedronMeasures shape = s_->shape(t);
    if (is_listed(cells_, shape.barycentre(), shape.longest_edge())) return ++report_->listed_unmet, true;
    return settle_unfinished();
  }
  /// Counts anything else that refinement would have mended.
  bool settle_unfinished() { return !s_->expected.complete && !s_->expected.strict && (++report_->unfinished, true); }

  /// What was excused by the size floor since this was asked last, as a note.
  std::string floor_note() {
    const std::size_t count = std::exchange(at_floor_, 0);
    return count == 0 ? "" : fmt::format("{} more have a surface ball no larger than the size floor", count);
  }

 private:
  using Places = verification::NearestPoint<Point3>;

  /// The listed places of elements with so many vertices; reports do not keep how many these were.
  static Places places(const Subject& s, std::size_t vertex_count) {
    std::vector<Point3> found;
    for (const Unmet<Point3>& u : s.expected.listed)
      if (is_finite(u.place) && (u.vertex_count == 0 || u.vertex_count == vertex_count)) found.push_back(s.scaling(u.place));
    return Places(std::move(found));
  }
  static double longest_edge(const std::array<Point3, 3>& c) {
    return std::sqrt(std::max({squared_distance(c[0], c[1]), squared_distance(c[0], c[2]), squared_distance(c[1], c[2])}));
  }
  static bool is_listed(const Places& listed, Point3 barycentre, double longest_edge) {
    const double tolerance = 1e-6 * longest_edge + 2e-15;  // scaled coordinates are below 1: a few roundings of them
    return listed.closer_than(barycentre, tolerance * tolerance) != nullptr;
  }
  bool is_at_floor(std::size_t triangle) const {
    return !s_->expected.strict && triangle < balls_.size() && balls_[triangle].is_known() &&
           balls_[triangle].radius <= floor_;
  }

  const Subject* s_;
  VerifyReport* report_;
  Places facets_, cells_;
  std::vector<bool> is_covered_;
  std::span<const SurfaceBall> balls_;
  double floor_;
  std::size_t at_floor_ = 0;
};

}  // namespace delref::verification_smooth
