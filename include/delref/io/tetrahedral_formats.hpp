// SPDX-License-Identifier: GPL-3.0-or-later
//
// The formats of tetrahedral meshes by the extension of a path.
#pragma once

#include <algorithm>
#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/domain/invalid_input.hpp>
#include <delref/domain/plc.hpp>
#include <delref/io/cut_svg.hpp>
#include <delref/io/extension.hpp>
#include <delref/io/file.hpp>
#include <delref/io/medit.hpp>
#include <delref/io/medit_reader.hpp>
#include <delref/io/msh.hpp>
#include <delref/io/msh_reader.hpp>
#include <delref/io/output_check.hpp>
#include <delref/io/tetgen_mesh.hpp>
#include <delref/io/vtu.hpp>
#include <delref/io/vtu_reader.hpp>
#include <delref/mesh/tetrahedral_mesh.hpp>

namespace delref {

inline constexpr std::string_view tetrahedral_formats = ".node, .ele, .vtu, .msh and .mesh";
inline constexpr std::string_view writable_tetrahedral_formats = ".node, .ele, .vtu, .msh, .mesh and .svg";

/// Reads a tetrahedral mesh. What the file does not carry is empty in it. Throws `InvalidInput`, also for an extension that is not in
/// `tetrahedral_formats`; `Interrupted` when the control says stop.
inline TetrahedralMesh read_tetrahedral_mesh(const std::filesystem::path& path, const Control& control = Control{}) {
  const std::string extension = detail::lower_extension(path);
  if (extension == ".node" || extension == ".ele") return read_tetgen_mesh(path, control);
  if (extension == ".vtu") return read_vtu<TetrahedralMesh>(path, control);
  if (extension == ".msh") return read_msh<TetrahedralMesh>(path, control);
  if (extension == ".mesh") return read_medit<TetrahedralMesh>(path, control);
  throw InvalidInput(detail::unknown_extension(path, "a tetrahedral mesh that can be read;", tetrahedral_formats));
}

/// What some formats tell beyond the mesh. All of it may be left out.
struct TetrahedralFileContext {
  /// .node: the first number and the attributes.
  const Plc* input = nullptr;
  /// .node: per vertex of the polyhedral domain its index in `input`; empty: they are the same.
  std::span<const Plc::Index> original_point;
  /// Never overwritten, for this is where the input came from.
  std::filesystem::path input_file;
  /// .svg: the cut, the view, the title.
  CutSvgOptions picture{};
};

/// Every file that `write_tetrahedral_mesh` writes for a path. Throws `OutputError` for an extension that is not in
/// `writable_tetrahedral_formats`.
inline std::vector<std::filesystem::path> tetrahedral_mesh_files(const std::filesystem::path& path) {
  const std::string extension = detail::lower_extension(path);
  if (extension == ".node" || extension == ".ele") {
    const auto files = tetgen_mesh_files(path);
    return {files.begin(), files.end()};
  }
  constexpr std::array<std::string_view, 4> single{".vtu", ".msh", ".mesh", ".svg"};
  if (std::ranges::find(single, extension) != single.end()) return {path};
  throw OutputError(detail::unknown_extension(path, "a tetrahedral mesh that can be written;", writable_tetrahedral_formats));
}

/// Throws `OutputError` when writing a tetrahedral mesh to the path cannot work: the extension is not known, or a file would be
/// written over the input. Call it before meshing, so that no work is lost.
inline void check_tetrahedral_output(const std::filesystem::path& path, const std::filesystem::path& input_file = {}) {
  detail::refuse_to_write_over(input_file, tetrahedral_mesh_files(path));
}

/// Writes a mesh in the format of the path's extension; `.node` and `.ele` write the whole set of TetGen's files. Either all files are
/// complete or, when anything throws, none is there that was not before. Throws `OutputError`, and `Interrupted` when the control says
/// stop: a run whose time is up writes with a control of its own.
inline void write_tetrahedral_mesh(const std::filesystem::path& path, const TetrahedralMesh& mesh, const TetrahedralFileContext& context = {},
                                   const Control& control = Control{}) {
  check_tetrahedral_output(path, context.input_file);
  const std::string extension = detail::lower_extension(path);
  if (extension == ".vtu") return write_vtu(path, mesh, control);
  if (extension == ".msh") return write_msh(path, mesh, control);
  if (extension == ".mesh") return write_medit(path, mesh, control);
  if (extension == ".svg") return write_cut_svg(path, mesh, context.picture, control);
  const Plc none;
  write_tetgen_mesh(path, mesh, context.input != nullptr ? *context.input : none, context.original_point, control);
}

}  // namespace delref
