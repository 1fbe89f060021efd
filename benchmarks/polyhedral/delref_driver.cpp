// SPDX-License-Identifier: GPL-3.0-or-later
//
// Times delref's refinement of one polyhedral input, apart from reading, checking, building the Delaunay triangulation of the
// input's vertices, and writing: a line of figures that benchmarks/polyhedral/run.py reads. The time includes making the
// triangulation conform to the input.
// Usage: delref_driver IN RADIUS_EDGE VOLUME CELL_SIZE VERTICES (0 for no bound; VERTICES is the budget)
#include <cstdlib>
#include <exception>
#include <utility>

#include <fmt/format.h>

#include <delref/algorithms/polyhedral_refinement.hpp>
#include <delref/io/polyhedral_formats.hpp>

#include "figures.hpp"

namespace {

void run(char** a) {
  delref::PolyhedralOptions options;
  options.radius_edge = std::atof(a[2]);
  if (std::atof(a[3]) > 0) options.max_volume = std::atof(a[3]);
  if (std::atof(a[4]) > 0) options.cell_size = std::atof(a[4]);
  delref::Budget budget;
  if (std::atof(a[5]) > 0) budget.max_vertices = static_cast<std::size_t>(std::atof(a[5]));

  const double before_check = benchmark::processor_seconds();
  delref::PolyhedralRefinement refinement(delref::read_plc(a[1]).plc, options);
  const double start = benchmark::processor_seconds();
  const auto outcome = refinement.refine(delref::Control(budget));
  const double end = benchmark::processor_seconds(), megabytes = benchmark::peak_megabytes();
  fmt::print("seconds {:.6f} check_seconds {:.6f} megabytes {:.1f} complete {} stopped {} unmet {} ", end - start, start - before_check,
             megabytes, outcome.complete() ? 1 : 0, outcome.stopped ? 1 : 0, outcome.unmet.size());
  benchmark::print_figures(refinement.mesh(), options.radius_edge);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 6) return 2;
  try {
    run(argv);
  } catch (const std::exception& e) {
    fmt::print(stderr, "delref_driver: {}\n", e.what());
    return 1;
  }
}
