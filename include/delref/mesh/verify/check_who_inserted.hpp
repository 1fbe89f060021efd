// SPDX-License-Identifier: GPL-3.0-or-later
//
// The check of who inserted the vertices, of triangles and of tetrahedra alike.
#pragma once

#include <cstdint>

#include <delref/core/carrier.hpp>
#include <delref/mesh/verify/report.hpp>

namespace delref::verification {

/// Input vertices say that they are, all others name a level. `is_used(v)` tells whether the mesh has cells at a vertex, `is_input(v)`
/// whether it is one of the input's.
template <class Subject, class IsUsed, class IsInput>
void check_who_inserted(const Subject& s, IsUsed&& is_used, IsInput&& is_input, Finding& finding) {
  for (std::uint32_t v = 0; v < s.points.size(); ++v) {
    if (!is_used(v)) continue;
    ++finding.examined;
    const LevelIndex level = s.mesh.provenance[v];
    const bool of_input = is_input(v);
    if (of_input != (level == input_level) || (!of_input && level >= s.mesh.level_names.size()))
      finding.fail([&] {
        return s.vertex(v) + (of_input ? " is an input vertex and says that a level inserted it"
                                       : " is no input vertex and names no level that inserted it");
      });
  }
}

}  // namespace delref::verification
