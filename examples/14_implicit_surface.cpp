// SPDX-License-Identifier: MIT
//
// Shows how to mesh a surface that a function gives: triangles alone, with sizes of your choice, into a format of surfaces.
#include <cstdio>

#include <delref/algorithms/smooth.hpp>
#include <delref/domain/implicit_domain.hpp>
#include <delref/io/surface_formats.hpp>
#include <delref/mesh/surface_quality.hpp>

int main() try {
  // The tangle cube. Any callable of a point is a function: inside is where it is below 0, the surface where it is 0.
  const auto tangle = [](delref::Point3 p) {
    const double x = p.x * p.x, y = p.y * p.y, z = p.z * p.z;
    return x * (x - 5) + y * (y - 5) + z * (z - 5) + 11.8;
  };
  // Nobody asks about points out of the bounds. Inside there, each piece of the surface that samples can see is meshed.
  const delref::ImplicitDomain domain(tangle, delref::BoundingBox3{{-3, -3, -3}, {3, 3, 3}});

  delref::SmoothOptions options;
  options.surface_only = true;
  options.facet_angle = delref::AngleBound::degrees(30);  // no angle is smaller; 30 is proven to be reached on smooth surfaces
  options.facet_size = 0.2;       // no ball through the corners of a triangle, centred on the surface, has a greater radius
  options.facet_distance = 0.02;  // no triangle is further from the surface
  const delref::SmoothResult result = delref::mesh_smooth_domain(domain, options);

  // The triangles are a closed surface. Its Euler characteristic, -8, tells that it has five holes.
  const delref::SurfaceQuality quality = delref::surface_quality(result.mesh);
  std::printf("%zu triangles, angles of %.1f degrees and more, Euler characteristic %ld\n", quality.triangle_count, quality.smallest_angle,
              quality.euler_characteristic());
  // How many pieces of the surface there are, and how that is known.
  std::printf("%zu of %zu components, found %s\n", result.components.found - result.components.missed, result.components.found,
              result.components.method.c_str());

  delref::write_surface("tangle.stl", result.mesh);  // or .off, .ply, .obj
  const bool is_right = quality.border_edges == 0 && quality.euler_characteristic() == -8;
  return result.outcome.complete() && result.outcome.unmet.empty() && is_right ? 0 : 1;
} catch (const delref::InvalidInput& refused) {
  std::fprintf(stderr, "%s\n", refused.what());
  return 3;
}
