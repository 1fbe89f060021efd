// SPDX-License-Identifier: GPL-3.0-or-later

#include "domains.hpp"

#include <cmath>
#include <stdexcept>

#include <delref/algorithms/smooth.hpp>
#include <delref/domain/sampled_components.hpp>

namespace delref::testing_mesh_smooth {

namespace {

double length(Point3 p) { return std::hypot(p.x, p.y, p.z); }

}  // namespace

void Domain::label(std::span<const Point3> points, std::span<int> labels) const {
  for (std::size_t i = 0; i < points.size(); ++i) labels[i] = region(points[i]);
}

Point3 Domain::crossing(Point3 a, Point3 b, int label_a, double tolerance) const {
  while (squared_distance(a, b) > tolerance * tolerance) {
    const Point3 middle = midpoint(a, b);
    if (middle == a || middle == b) break;
    (region(middle) == label_a ? a : b) = middle;
  }
  return midpoint(a, b);
}

SurfaceComponents Domain::components(const Control& control) const { return sample_components(*this, box.extent() / 26, control); }

Domain ball() {
  return {[](Point3 p) { return length(p) < 1 ? 0 : outside; }};
}
Domain ring() {
  return {[](Point3 p) { return std::hypot(std::hypot(p.x, p.y) - 0.8, p.z) < 0.35 ? 0 : outside; }};
}
Domain two_balls() {
  return {[](Point3 p) { return length({std::abs(p.x) - 0.7, p.y, p.z}) < 0.4 ? 0 : outside; }};
}
Domain halves() {
  return {[](Point3 p) { return length(p) >= 1 ? outside : p.z > 0.1 ? 1 : 0; }};
}

SmoothOptions usual_options() {
  SmoothOptions options;
  options.facet_size = 0.2;
  options.smallest_facet = 0.02;
  return options;
}
SmoothOptions surface_options() {
  SmoothOptions options = usual_options();
  options.surface_only = true;
  return options;
}

Refined refined(const Domain& domain, const SmoothOptions& options) {
  SmoothResult result = mesh_smooth_domain(domain, options);
  if (!result.outcome.complete()) throw std::runtime_error("a mesh of the tests is not complete");
  return {std::move(result.mesh), std::move(result.outcome.unmet)};
}

TetrahedralMesh meshed(const Domain& domain, const SmoothOptions& options) {
  Refined result = refined(domain, options);
  if (!result.unmet.empty()) throw std::runtime_error("a mesh of the tests does not meet every criterion");
  return std::move(result.mesh);
}

}  // namespace delref::testing_mesh_smooth
