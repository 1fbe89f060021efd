// SPDX-License-Identifier: MIT
//
// Shows how to mesh every region of a labelled image (a segmentation), each with a size of its own.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>

#include <delref/algorithms/smooth.hpp>
#include <delref/domain/labelled_image.hpp>
#include <delref/io/tetrahedral_formats.hpp>

namespace {

/// An egg: label 10 is the white, 20 the yolk, 0 the outside. `read_image` of <delref/images/image_reader.hpp> reads a file instead.
delref::Image<std::int32_t> egg() {
  delref::Image<std::int32_t> image;
  image.grid.size = {24, 24, 32};
  image.grid.spacing = {2, 2, 2};
  image.grid.origin = {-23, -23, -31};
  for (int z = 0; z < 32; ++z)
    for (int y = 0; y < 24; ++y)
      for (int x = 0; x < 24; ++x) {
        const delref::Point3 p = image.grid.world({double(x), double(y), double(z)});
        const bool is_yolk = std::hypot(p.x, p.y, p.z + 4) < 10, is_egg = std::hypot(p.x, p.y, 0.75 * p.z) < 20;
        image.values.push_back(is_yolk ? 20 : is_egg ? 10 : 0);
      }
  return image;
}

}  // namespace

int main() {
  // Voxels are boxes, and their borders a staircase. Smoothed over a voxel it becomes a smooth surface.
  delref::LabelOptions how;
  how.smoothing = 1;
  const delref::LabelledImage domain(egg(), how);

  delref::SmoothOptions options;
  options.facet_size = 4;
  options.facet_distance = 0.5;
  // Per region, in the order of `region_labels`: 10, 20. The yolk is to be finer.
  options.region_cell_sizes = {6, 3};
  const delref::SmoothResult result = delref::mesh_smooth_domain(domain, options);

  // Tetrahedra have the labels of the image.
  std::map<int, std::size_t> tetrahedra;
  for (const int label : result.mesh.regions) ++tetrahedra[label];
  for (const auto& [label, count] : tetrahedra) std::printf("label %d: %zu tetrahedra\n", label, count);

  // Triangles between two regions are shared by both; the marker of a triangle is 1 + the number of its patch.
  const auto& labels = domain.region_labels();
  const auto name = [&](int region) { return region == delref::outside ? 0 : labels[static_cast<std::size_t>(region)]; };
  for (const delref::SurfacePatch& patch : result.patches)
    std::printf("a surface between the labels %d and %d\n", name(patch.regions[0]), name(patch.regions[1]));

  // Had smoothing swallowed a small region, this would name its label.
  const bool nothing_is_lost = domain.lost_labels().empty();
  delref::write_tetrahedral_mesh("egg.vtu", result.mesh);
  delref::write_tetrahedral_mesh("egg.svg", result.mesh);
  return result.outcome.complete() && result.outcome.unmet.empty() && result.patches.size() == 2 && nothing_is_lost ? 0 : 1;
}
