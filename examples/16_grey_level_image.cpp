// SPDX-License-Identifier: MIT
//
// Shows how to mesh what is at least so bright in an image of grey levels.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>

#include <delref/algorithms/smooth.hpp>
#include <delref/domain/grey_level_image.hpp>
#include <delref/io/tetrahedral_formats.hpp>

namespace {

/// A shell with a kernel in it, in slices that are farther apart than the voxels of a slice. `read_image` of
/// <delref/images/image_reader.hpp> reads a file instead.
delref::Image<std::int32_t> scan() {
  delref::Image<std::int32_t> image;
  image.grid.size = {40, 40, 20};
  image.grid.spacing = {1, 1, 2};  // millimetres
  image.grid.origin = {-19.5, -19.5, -19};
  for (int z = 0; z < 20; ++z)
    for (int y = 0; y < 40; ++y)
      for (int x = 0; x < 40; ++x) {
        const delref::Point3 p = image.grid.world({double(x), double(y), double(z)});
        const double r = std::hypot(p.x, p.y, p.z);
        const double shell = 100 - 15 * std::abs(r - 13), kernel = 120 - 15 * r;
        image.values.push_back(static_cast<std::int32_t>(std::lround(std::max({shell, kernel, 0.0}))));
      }
  return image;
}

}  // namespace

int main() try {
  // Between the centres of voxels values are interpolated, and inside is where they are at least 60.
  const delref::GreyLevelImage domain(scan(), 60);

  // An image tells all about its surface beforehand: every piece, exactly.
  for (const delref::LevelSetComponent& piece : domain.level_set())
    std::printf("a piece with the Euler characteristic %d\n", static_cast<int>(piece.euler_characteristic));

  delref::SmoothOptions options;
  options.facet_distance = 0.3;  // in the unit of the spacing
  options.facet_size = 3;
  options.cell_size = 3;
  const delref::SmoothResult result = delref::mesh_smooth_domain(domain, options);
  std::printf("%zu tetrahedra, %zu triangles; %zu components, found %s\n", result.mesh.tetrahedra.size(), result.mesh.triangles.size(),
              result.components.found, result.components.method.c_str());
  delref::write_tetrahedral_mesh("scan.vtu", result.mesh);
  delref::write_tetrahedral_mesh("scan.svg", result.mesh);

  // What no mesh can be made of is refused in words.
  try {
    const delref::GreyLevelImage nothing(scan(), 500);
  } catch (const delref::InvalidInput& refused) {
    std::printf("refused: %s\n", refused.what());
  }
  const bool is_whole = result.components.found == 3 && result.components.missed == 0;
  return result.outcome.complete() && result.outcome.unmet.empty() && is_whole ? 0 : 1;
} catch (const delref::InvalidInput& refused) {
  std::fprintf(stderr, "%s\n", refused.what());
  return 3;
}
