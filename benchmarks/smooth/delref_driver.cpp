// SPDX-License-Identifier: GPL-3.0-or-later
//
// Times delref's refinement of one smooth domain, with the search for the components of its surface and apart from reading and
// writing: a line of figures that benchmarks/smooth/run.py reads.
// Usage: delref_driver DOMAIN FACET_ANGLE FACET_SIZE FACET_DISTANCE RADIUS_EDGE CELL_SIZE OUT (benchmarks/smooth/surfaces.hpp)
#include <cstddef>
#include <exception>
#include <stdexcept>
#include <string>

#include <CGAL/Image_3.h>
#include <fmt/format.h>

#include <delref/algorithms/smooth_refinement.hpp>
#include <delref/domain/grey_level_image.hpp>
#include <delref/domain/image.hpp>
#include <delref/domain/implicit_domain.hpp>
#include <delref/io/medit.hpp>

#include "../processor.hpp"
#include "surfaces.hpp"

namespace {

using benchmark::CommandLine;

delref::SmoothOptions options(const CommandLine& line) {
  delref::SmoothOptions result;
  result.facet_angle = delref::AngleBound::degrees(line.facet_angle);
  if (line.facet_size > 0) result.facet_size = line.facet_size;
  if (line.facet_distance > 0) result.facet_distance = line.facet_distance;
  if (line.radius_edge > 0) result.radius_edge = line.radius_edge;
  if (line.cell_size > 0) result.cell_size = line.cell_size;
  result.surface_only = line.surface_only();
  return result;
}

template <class Oracle>
void mesh(const Oracle& oracle, const CommandLine& line) {
  const double before_seeding = benchmark::processor_seconds();
  delref::SmoothRefinement refinement(oracle, options(line));
  const double start = benchmark::processor_seconds();
  const auto outcome = refinement.refine();
  const double end = benchmark::processor_seconds(), megabytes = benchmark::peak_megabytes();
  fmt::print("seconds {:.6f} seeding_seconds {:.6f} megabytes {:.1f} complete {} unmet {} ", end - before_seeding,
             start - before_seeding, megabytes, outcome.complete() ? 1 : 0, outcome.unmet.size());
  fmt::print("components_found {} components_missed {}", refinement.components().found, refinement.components().missed);
  if (line.out != "-") delref::write_medit(line.out, refinement.mesh());
}

/// A named surface as delref takes one; counts how often it is asked.
template <class Surface>
struct Counted {
  std::size_t* evaluations;
  double operator()(delref::Point3 p) const {
    ++*evaluations;
    return Surface::value({p.x, p.y, p.z});
  }
};

delref::Image<float> read_image(const std::string& path) {
  CGAL::Image_3 file;
  if (!file.read(path.c_str())) throw std::runtime_error("cannot read " + path);
  delref::Image<float> image;
  image.grid.size = {static_cast<int>(file.xdim()), static_cast<int>(file.ydim()), static_cast<int>(file.zdim())};
  image.grid.spacing = {file.vx(), file.vy(), file.vz()};
  image.grid.origin = {static_cast<double>(file.tx()), static_cast<double>(file.ty()), static_cast<double>(file.tz())};
  for (std::size_t k = 0; k != file.zdim(); ++k)
    for (std::size_t j = 0; j != file.ydim(); ++j)
      for (std::size_t i = 0; i != file.xdim(); ++i) image.values.push_back(file.value(i, j, k));
  return image;
}

void run(const CommandLine& line) {
  std::size_t evaluations = 0;
  const bool is_named = benchmark::visit_surface(line.domain, [&]<class Surface>(Surface) {
    const double w = Surface::half_width;
    mesh(delref::ImplicitDomain(Counted<Surface>{&evaluations}, {{-w, -w, -w}, {w, w, w}}), line);
    fmt::print(" evaluations {}", evaluations);
  });
  if (!is_named) {
    const auto [path, value] = benchmark::level_set(line.domain);
    delref::GreyLevelOptions closed;
    closed.close_at_border = true;  // as CGAL does
    mesh(delref::GreyLevelImage(read_image(path), static_cast<double>(value), closed), line);
  }
  fmt::print("\n");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 8) return 2;
  try {
    run(CommandLine(argv));
  } catch (const std::exception& e) {
    fmt::print(stderr, "delref_driver: {}\n", e.what());
    return 1;
  }
}
