// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include <delref/algorithms/planar.hpp>

#include "planar_run.hpp"

namespace delref::program {

PlanarRun run_mesher(Pslg input, const PlanarOptions& options, const Control& control, Progress& progress) {
  PlanarResult result = mesh_planar(std::move(input), options, control, progress);
  return {std::move(result.mesh), std::move(result.outcome), std::move(result.notes)};
}

}  // namespace delref::program
