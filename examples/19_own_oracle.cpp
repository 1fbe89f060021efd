// SPDX-License-Identifier: MIT
//
// Shows how to mesh a domain of your own: all that the mesher asks is the region of points, and where a segment leaves a region.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <span>

#include <delref/algorithms/smooth.hpp>
#include <delref/io/tetrahedral_formats.hpp>

namespace {

/// A planet of three layers: region 0 is the core, 1 the mantle, 2 the crust.
struct Planet {
  std::array<double, 3> radii{0.4, 0.8, 1};

  /// Points that are not in here are outside, and never asked about.
  delref::BoundingBox3 bounds() const { return {{-1.1, -1.1, -1.1}, {1.1, 1.1, 1.1}}; }

  /// The regions of many points in one call: nearly all the time of an oracle is spent here.
  void label(std::span<const delref::Point3> points, std::span<int> labels) const {
    std::ranges::transform(points, labels.begin(), [&](delref::Point3 p) {
      const auto layer = std::ranges::find_if(radii, [&](double r) { return p.x * p.x + p.y * p.y + p.z * p.z < r * r; });
      return layer == radii.end() ? delref::outside : static_cast<int>(layer - radii.begin());
    });
  }
  int label(delref::Point3 p) const {
    int found = delref::outside;
    label(std::span<const delref::Point3>(&p, 1), std::span<int>(&found, 1));
    return found;
  }

  /// Where the segment from a to b leaves the region of a, to a tolerance: by halving here, which any domain can do. A formula, or a
  /// root finder such as `delref::bracketed_root`, is quicker.
  delref::Point3 crossing(delref::Point3 a, delref::Point3 b, int label_a, double tolerance) const {
    while (squared_distance(a, b) > tolerance * tolerance) {
      const delref::Point3 m = midpoint(a, b);
      if (m == a || m == b) break;
      (label(m) == label_a ? a : b) = m;
    }
    return midpoint(a, b);
  }

  /// Not required. Points on each piece of the surfaces, if the domain knows them; otherwise samples look for the pieces.
  delref::SurfaceComponents components(const delref::Control&) const {
    delref::SurfaceComponents found{{}, "from the radii, exactly", true};
    for (const double r : radii) found.components.push_back({{r, 0, 0}, {-r, 0, 0}, {0, r, 0}, {0, -r, 0}, {0, 0, r}, {0, 0, -r}});
    return found;
  }
};
static_assert(delref::explain_oracle<Planet>());  // a missing member is told in a sentence
static_assert(delref::FindsComponents<Planet>);

}  // namespace

int main() {
  delref::SmoothOptions options;
  options.facet_size = 0.15;
  options.facet_distance = 0.01;
  const delref::SmoothResult result = delref::mesh_smooth_domain(Planet{}, options);

  std::map<int, std::size_t> tetrahedra;  // the label of a region is 1 + its number, unless the oracle has `region_labels()`
  for (const int label : result.mesh.regions) ++tetrahedra[label];
  for (const auto& [label, count] : tetrahedra) std::printf("layer %d: %zu tetrahedra\n", label, count);
  delref::write_tetrahedral_mesh("planet.svg", result.mesh);
  return result.outcome.complete() && result.outcome.unmet.empty() && result.patches.size() == 3 && tetrahedra.size() == 3 ? 0 : 1;
}
