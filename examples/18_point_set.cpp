// SPDX-License-Identifier: MIT
//
// Shows how to put a surface through points, as a scanner gives them, and fill it.
#include <cmath>
#include <cstdio>
#include <random>
#include <string>

#include <delref/algorithms/smooth.hpp>
#include <delref/domain/point_set_domain.hpp>
#include <delref/io/tetrahedral_formats.hpp>

namespace {

/// Points of a ring, anywhere on it. `read_point_set` of <delref/io/point_set_reader.hpp> reads a file instead.
delref::PointSet scan(std::size_t count) {
  delref::PointSet set;
  std::mt19937 random(1);
  const double turn = 2 * std::acos(-1.0) / 4294967296.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double u = turn * static_cast<double>(random()), v = turn * static_cast<double>(random());
    const double out = 2 + 0.8 * std::cos(v);
    set.points.push_back({out * std::cos(u), out * std::sin(u), 0.8 * std::sin(v)});
  }
  return set;  // with `normals` too, where the scanner knows them
}

}  // namespace

int main() try {
  // Normals are estimated from the nearest points and turned outwards, and a function that is 0 about the points is made of them.
  const delref::PointSetDomain domain(scan(3000));
  for (const std::string& note : domain.notes()) std::printf("note: %s\n", note.c_str());

  delref::SmoothOptions options;
  options.facet_size = domain.default_facet_size();  // finer facets would show no more of the surface
  options.facet_distance = domain.default_facet_distance();
  const delref::SmoothResult result = delref::mesh_smooth_domain(domain, options);

  double farthest = 0;
  for (const auto& triangle : result.mesh.triangles)
    for (const auto v : triangle) {
      const delref::Point3 p = result.mesh.points[v];
      farthest = std::max(farthest, std::abs(std::hypot(std::hypot(p.x, p.y) - 2, p.z) - 0.8));
    }
  std::printf("%zu tetrahedra, %zu triangles; points are %.3f apart, and the surface is within %.3f of the ring\n",
              result.mesh.tetrahedra.size(), result.mesh.triangles.size(), domain.average_spacing(), farthest);
  delref::write_tetrahedral_mesh("scan.svg", result.mesh);
  return result.outcome.complete() && farthest < domain.average_spacing() ? 0 : 1;
} catch (const delref::InvalidInput& refused) {
  std::fprintf(stderr, "%s\n", refused.what());
  return 3;
}
