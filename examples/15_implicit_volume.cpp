// SPDX-License-Identifier: MIT
//
// Shows how to fill what a surface bounds with tetrahedra, small ones where a field says so, and how to check the mesh against the function.
#include <cmath>
#include <cstdio>
#include <span>

#include <delref/algorithms/smooth.hpp>
#include <delref/domain/implicit_domain.hpp>
#include <delref/io/tetrahedral_formats.hpp>
#include <delref/mesh/tetrahedral_quality.hpp>
#include <delref/mesh/verify_smooth.hpp>

namespace {

/// A ring. One call answers many points, which is quicker where a call costs much; `double operator()(delref::Point3) const` would do.
struct Ring {
  double radius = 1, thickness = 0.4;
  void operator()(std::span<const delref::Point3> points, std::span<double> values) const {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double out = std::hypot(points[i].x, points[i].y) - radius;
      values[i] = out * out + points[i].z * points[i].z - thickness * thickness;
    }
  }
};

}  // namespace

int main() {
  const delref::ImplicitDomain domain(Ring{}, delref::BoundingBox3{{-1.6, -1.6, -0.6}, {1.6, 1.6, 0.6}});

  // Facets and tetrahedra of half the size at one end of the ring.
  const auto size = [](delref::Point3 p) { return 0.05 + 0.025 * (p.x + 1.6); };
  delref::SmoothOptions options;
  options.facet_size_field = size;
  options.cell_size_field = size;
  options.radius_edge = 2;  // no circumradius over twice the shortest edge; proven to be reached
  delref::SmoothRefinement refinement(domain, options);  // `mesh_smooth_domain` as an object
  const delref::Outcome<delref::Point3> outcome = refinement.refine();
  const delref::TetrahedralMesh mesh = refinement.mesh();

  const delref::TetrahedralQuality quality = delref::tetrahedral_quality(mesh);
  const double pi = std::acos(-1.0), volume = 2 * pi * pi * 0.4 * 0.4;
  std::printf("%zu tetrahedra, radius-edge ratio at most %.3f, volume %.4f of %.4f\n", quality.tetrahedron_count,
              quality.worst_radius_edge, quality.total_volume, volume);

  // Everything is looked at again, without the mesher's code: Delaunay, closed, complete, on the surface, and every bound.
  delref::SmoothExpectations expected;
  expected.components = 1;
  expected.euler_characteristic = 0;
  const delref::VerifyReport report = delref::verify_smooth(domain, mesh, refinement.options(), expected);
  std::printf("%s", delref::verify_table(report).c_str());

  delref::write_tetrahedral_mesh("ring.vtu", mesh);
  delref::write_tetrahedral_mesh("ring.svg", mesh);  // cut open
  const bool is_near = std::abs(quality.total_volume - volume) < 0.02 * volume;
  return outcome.complete() && outcome.unmet.empty() && report.ok() && is_near ? 0 : 1;
}
