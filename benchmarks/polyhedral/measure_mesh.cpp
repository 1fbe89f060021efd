// SPDX-License-Identifier: GPL-3.0-or-later
//
// Counts and quality of a mesh that TetGen wrote. Usage: measure_mesh MESH.ele RADIUS_EDGE
#include <cstdlib>
#include <exception>

#include <fmt/format.h>

#include <delref/io/tetgen_mesh.hpp>

#include "figures.hpp"

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  try {
    benchmark::print_figures(delref::read_tetgen_mesh(argv[1]), std::atof(argv[2]));
  } catch (const std::exception& e) {
    fmt::print(stderr, "measure_mesh: {}\n", e.what());
    return 1;
  }
}
