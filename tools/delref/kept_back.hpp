// SPDX-License-Identifier: GPL-3.0-or-later
//
// How much of the time limit is kept back for what comes after refinement, so that the whole program ends within the limit.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "input_kind.hpp"

namespace delref::program {

/// For each vertex of a mesh that is to be written to `outputs`: taking it out, measuring it, and writing its part of each file.
///
/// The figures are about three times what was measured on an idle machine on meshes of one to two and a half million vertices, since
/// machines differ and have other things to do. Measured in microseconds per vertex, in the plane: 0.25 to take the mesh out and
/// measure it; to write .node with its companions 0.4, .vtu and .msh 0.4, .mesh and .off 0.3, .svg 0.7. In space, where a vertex has
/// about six tetrahedra: 2.6 to take the mesh out and measure it; to write .vtu and .msh 1.1, .node with its companions 0.9, .mesh 0.8,
/// and .svg 8, since the whole mesh is searched for what is seen of its cut.
inline std::chrono::duration<double> kept_back_per_vertex(const std::vector<std::string>& outputs, InputKind kind) {
  using Microseconds = std::chrono::duration<double, std::micro>;
  struct Format {
    std::string_view name;
    double plane, space;
  };
  static constexpr Format formats[] = {{".node", 0.8, 3},   {".ele", 0.8, 3}, {".vtu", 0.8, 3.5}, {".msh", 0.8, 3.5},
                                       {".mesh", 0.6, 2.5}, {".off", 0.6, 3},  {".svg", 1.4, 24},  {".ply", 0, 3},
                                       {".obj", 0, 3},      {".stl", 0, 12}};
  const bool is_planar = kind == InputKind::plane;
  double total = is_planar ? 0.5 : is_smooth(kind) ? 9 : 6;
  for (const std::string& output : outputs) {
    const std::string extension = std::filesystem::path(output).extension().string();
    for (const Format& format : formats)
      if (extension == format.name) total += is_planar ? format.plane : format.space;
  }
  return Microseconds(total);
}

}  // namespace delref::program
