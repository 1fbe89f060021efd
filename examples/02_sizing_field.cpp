// SPDX-License-Identifier: MIT
//
// Shows how to say how large triangles may be, from place to place.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include <delref/algorithms/planar.hpp>
#include <delref/criteria/point_sizing.hpp>
#include <delref/io/planar_formats.hpp>

namespace {

delref::Pslg rectangle(double width, double height) {
  delref::Pslg pslg;
  pslg.points = {{0, 0}, {width, 0}, {width, height}, {0, height}};
  pslg.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  return pslg;
}

/// The largest ratio of a triangle's longest edge to the size that was asked for at its centroid.
template <class Size>
double worst_ratio(const delref::PlanarMesh& mesh, const Size& size) {
  double worst = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const delref::TriangleShape triangle(mesh.points[a], mesh.points[b], mesh.points[c]);
    worst = std::max(worst, std::sqrt(triangle.longest_squared()) / size(triangle.centroid()));
  }
  return worst;
}

}  // namespace

int main() {
  delref::PlanarOptions options;

  // Any callable of a point is a sizing field: here a wave of small triangles across a rectangle of 4 by 1.
  options.size = [](delref::Point2 p) { return 0.02 + 0.1 * std::abs(p.y - 0.5 - 0.3 * std::sin(3 * p.x)); };
  const auto wave = delref::mesh_planar(rectangle(4, 1), options);
  std::printf("wave:   %zu triangles\n", wave.mesh.triangles.size());
  delref::write_planar_mesh("wave.svg", wave.mesh);

  // Sizes at points: each is kept there, and may grow by 0.2 over a unit of length away from it.
  const std::vector<delref::Point2> points{{1, 0.5}, {3, 0.5}};
  const std::vector<double> sizes{0.01, 0.05};
  const delref::PointSizing2 at_points(points, sizes, 0.2);
  options.size = at_points;
  const auto spots = delref::mesh_planar(rectangle(4, 1), options);
  std::printf("points: %zu triangles\n", spots.mesh.triangles.size());
  delref::write_planar_mesh("points.svg", spots.mesh);

  // One size for all, and an area, are options of their own, and hold together with a field.
  options.size = nullptr;
  options.max_edge = 0.1;
  options.max_area = 0.002;
  const auto even = delref::mesh_planar(rectangle(4, 1), options);
  std::printf("even:   %zu triangles\n", even.mesh.triangles.size());

  // A size must be positive everywhere; if not, the error names the point.
  options.size = [](delref::Point2 p) { return p.x - 2; };
  try {
    delref::mesh_planar(rectangle(4, 1), options);
    return 1;
  } catch (const delref::InvalidInput& refused) {
    std::printf("refused: %s\n", refused.what());
  }
  return worst_ratio(spots.mesh, at_points) <= 1 ? 0 : 1;
}
