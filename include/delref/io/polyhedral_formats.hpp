// SPDX-License-Identifier: GPL-3.0-or-later
//
// The formats of polyhedral domains by the extension of a path. Whoever needs no more than the dimension of one includes
// `domain_dimension.hpp`, which compiles faster: the readers of surfaces are CGAL's.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <delref/core/budget.hpp>
#include <delref/domain/invalid_input.hpp>
#include <delref/io/domain_dimension.hpp>
#include <delref/io/extension.hpp>
#include <delref/io/obj_reader.hpp>
#include <delref/io/off_reader.hpp>
#include <delref/io/plc_file.hpp>
#include <delref/io/ply_reader.hpp>
#include <delref/io/stl_reader.hpp>
#include <delref/io/tetgen_poly.hpp>

namespace delref {

inline constexpr std::string_view readable_polyhedra = ".poly, .smesh, .node, .off, .obj, .ply and .stl";

/// Reads a polyhedral domain, with notes about what was passed over. A .node file has vertices alone, which `check_plc` refuses.
/// Throws `InvalidInput`, also for an extension that is not in `readable_polyhedra`; `Interrupted` when the control says stop.
inline PlcFile read_plc(const std::filesystem::path& path, const Control& control = Control{}) {
  const std::string extension = detail::lower_extension(path);
  if (extension == ".poly") return {read_tetgen_poly(path, TetgenFile::poly, control), {}};
  if (extension == ".smesh") return {read_tetgen_poly(path, TetgenFile::smesh, control), {}};
  if (extension == ".node") return {read_tetgen_node(path, control), {}};
  if (extension == ".off") return {read_off(path, control), {}};
  if (extension == ".stl") return {read_stl(path, control), {}};
  if (extension == ".obj") return read_obj(path, control);
  if (extension == ".ply") return read_ply(path, control);
  throw InvalidInput(detail::unknown_extension(path, "a polyhedral domain;", readable_polyhedra));
}

}  // namespace delref
