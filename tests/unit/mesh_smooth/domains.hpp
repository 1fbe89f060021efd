// SPDX-License-Identifier: GPL-3.0-or-later
//
// Domains for the tests of verify_smooth, and their meshes.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include <delref/algorithms/smooth_options.hpp>
#include <delref/core/budget.hpp>
#include <delref/core/outcome.hpp>
#include <delref/domain/oracle.hpp>
#include <delref/mesh/tetrahedral_mesh.hpp>

namespace delref::testing_mesh_smooth {

/// A domain by the region that each point is in; all else is by bisection and samples.
struct Domain {
  std::function<int(Point3)> region;
  BoundingBox3 box{{-1.3, -1.3, -1.3}, {1.3, 1.3, 1.3}};

  BoundingBox3 bounds() const { return box; }
  void label(std::span<const Point3> points, std::span<int> labels) const;
  Point3 crossing(Point3 a, Point3 b, int label_a, double tolerance) const;
  SurfaceComponents components(const Control& control) const;
};
static_assert(FindsComponents<Domain>);

/// A ball of radius 1.
Domain ball();
/// A ring of radii 0.8 and 0.35.
Domain ring();
/// Two balls of radius 0.4.
Domain two_balls();
/// A ball of radius 1 in two halves: region 1 above z = 0.1, region 0 below.
Domain halves();

/// Facets of size 0.2, and else the defaults.
SmoothOptions usual_options();
SmoothOptions surface_options();
/// What `mesh_smooth_domain` makes.
struct Refined {
  TetrahedralMesh mesh;
  std::vector<Unmet<Point3>> unmet;
};
/// The run must come to its end.
Refined refined(const Domain& domain, const SmoothOptions& options);
/// Every criterion must be met.
TetrahedralMesh meshed(const Domain& domain, const SmoothOptions& options = usual_options());

}  // namespace delref::testing_mesh_smooth
