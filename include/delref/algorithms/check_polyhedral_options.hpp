// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bounds that no refinement can meet are refused before any work is done.
#pragma once

#include <string>

#include <delref/algorithms/polyhedral_options.hpp>
#include <delref/domain/describe.hpp>
#include <delref/domain/invalid_input.hpp>

namespace delref {

/// Throws `InvalidInput` when the radius-edge bound is under 1, a size is not greater than 0, or either is not a number. How the
/// complex is read (`PolyhedralOptions::input`) is checked by `check_plc`, and the sizing field where it is asked.
inline void check_polyhedral_options(const PolyhedralOptions& options) {
  if (!(options.radius_edge >= 1))
    throw InvalidInput("the bound on the radius-edge ratio is " + describe(options.radius_edge) +
                       ": give a number of at least 1, for refinement under that bound would never end; 2 is reached where no input angle is " +
                       "under 90 degrees, 1.4 nearly always, infinity is no bound");
  const auto check_size = [](double bound, const char* what, const char* unit) {
    if (!(bound > 0))
      throw InvalidInput(std::string(what) + " is " + describe(bound) + ": give a number greater than 0 in " + unit +
                         " of the input, or infinity for no bound");
  };
  check_size(options.max_volume, "the bound on the volume of a tetrahedron", "the cubed unit");
  check_size(options.cell_size, "the bound on the circumradius of a tetrahedron", "the unit");
}

}  // namespace delref
