// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes the Object File Format of Geomview, which most viewers of surfaces open. It carries neither labels nor markers.
#pragma once

#include <filesystem>

#include <delref/core/budget.hpp>
#include <delref/io/file.hpp>
#include <delref/mesh/planar_mesh.hpp>

namespace delref {

/// Writes vertices (z = 0) and triangles. Throws `OutputError`, and `Interrupted` when the control says stop.
inline void write_off(const std::filesystem::path& path, const PlanarMesh& mesh, const Control& control = Control{}) {
  const auto write = [&](TextSink& out) {
    out << "OFF\n" << mesh.points.size() << ' ' << mesh.triangles.size() << " 0\n";
    for (const Point2& p : mesh.points) out << p.x << ' ' << p.y << " 0\n";
    for (const auto& t : mesh.triangles) out << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
  };
  write_file(path, write, control);
}

}  // namespace delref
