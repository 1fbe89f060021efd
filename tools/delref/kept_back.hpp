// SPDX-License-Identifier: GPL-3.0-or-later
//
// How much of the time limit is kept back for what comes after refinement, so that the whole program ends within the limit.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <delref/io/polyhedral_formats.hpp>

namespace delref::program {

/// For each vertex of a mesh that is to be written to `outputs`: taking it out, measuring it, and writing its part of each file.
///
/// The figures are about three times what was measured on an idle machine on meshes of one to two and a half million vertices, since
/// machines differ and have other things to do. Measured in microseconds per vertex, in the plane: 0.25 to take the mesh out and
/// measure it; to write .node with its companions 0.4, .vtu and .msh 0.4, .mesh and .off 0.3, .svg 0.7. In space, where a vertex has
/// about six tetrahedra: 2.6 to take the mesh out and measure it; to write .vtu and .msh 1.1, .node with its companions 0.9, .mesh 0.8.
inline std::chrono::duration<double> kept_back_per_vertex(const std::vector<std::string>& outputs, Dimension dimension) {
  using Microseconds = std::chrono::duration<double, std::micro>;
  struct Format {
    std::string_view name;
    double plane, space;
  };
  static constexpr Format formats[] = {{".node", 0.8, 3},   {".ele", 0.8, 3}, {".vtu", 0.8, 3.5}, {".msh", 0.8, 3.5},
                                       {".mesh", 0.6, 2.5}, {".off", 0.6, 0}, {".svg", 1.4, 0}};
  double total = dimension == Dimension::plane ? 0.5 : 6;
  for (const std::string& output : outputs) {
    const std::string extension = std::filesystem::path(output).extension().string();
    for (const Format& format : formats)
      if (extension == format.name) total += dimension == Dimension::plane ? format.plane : format.space;
  }
  return Microseconds(total);
}

}  // namespace delref::program
