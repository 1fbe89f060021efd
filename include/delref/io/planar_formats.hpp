// SPDX-License-Identifier: GPL-3.0-or-later
//
// The file formats by the extension of a path.
#pragma once

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include <delref/core/budget.hpp>
#include <delref/domain/convex_hull.hpp>
#include <delref/core/outcome.hpp>
#include <delref/domain/pslg.hpp>
#include <delref/io/extension.hpp>
#include <delref/io/geojson.hpp>
#include <delref/io/medit.hpp>
#include <delref/io/msh.hpp>
#include <delref/io/msh_reader.hpp>
#include <delref/io/off.hpp>
#include <delref/io/output_check.hpp>
#include <delref/io/svg.hpp>
#include <delref/io/triangle_mesh.hpp>
#include <delref/io/triangle_poly.hpp>
#include <delref/io/vtu.hpp>
#include <delref/io/vtu_reader.hpp>
#include <delref/mesh/planar_mesh.hpp>

namespace delref {

inline constexpr std::string_view readable_domains = ".poly, .node, .geojson and .json";
inline constexpr std::string_view readable_meshes = ".node, .ele, .vtu and .msh";
inline constexpr std::string_view writable_meshes = ".node, .ele, .vtu, .msh, .mesh, .off and .svg";

/// Reads a domain, with notes about what was passed over. Throws `InvalidInput`, also for an extension that is not in
/// `readable_domains`; `Interrupted` when the control says stop.
inline PslgFile read_pslg(const std::filesystem::path& path, const Control& control = Control{}) {
  const std::string extension = detail::lower_extension(path);
  if (extension == ".poly") return {read_triangle_poly(path, control), {}};
  if (extension == ".node")
    return {with_convex_hull(read_triangle_node(path, control), control), {"the file has no segments: the domain is the convex hull of its vertices"}};
  if (extension == ".geojson" || extension == ".json") return read_geojson(path, control);
  throw InvalidInput(detail::unknown_extension(path, "a domain;", readable_domains));
}

/// Reads a mesh. What the file does not carry is empty in it. Throws `InvalidInput`, also for an extension that is not in
/// `readable_meshes`; `Interrupted` when the control says stop.
inline PlanarMesh read_planar_mesh(const std::filesystem::path& path, const Control& control = Control{}) {
  const std::string extension = detail::lower_extension(path);
  if (extension == ".node" || extension == ".ele") return read_triangle_mesh(path, control);
  if (extension == ".vtu") return read_vtu(path, control);
  if (extension == ".msh") return read_msh(path, control);
  throw InvalidInput(detail::unknown_extension(path, "a mesh that can be read;", readable_meshes));
}

/// What some formats tell beyond the mesh. All of it may be left out.
struct PlanarFileContext {
  /// .node: the first number, holes, regions and attributes.
  const Pslg* input = nullptr;
  /// .svg: what is unmet, the title, the colouring.
  SvgOptions picture;
  /// Never overwritten, for this is where the input came from.
  std::filesystem::path input_file;
};

/// Every file that `write_planar_mesh` writes for a path. Throws `OutputError` for an extension that is not in `writable_meshes`.
inline std::vector<std::filesystem::path> planar_mesh_files(const std::filesystem::path& path) {
  const std::string extension = detail::lower_extension(path);
  if (extension == ".node" || extension == ".ele") {
    const auto files = triangle_mesh_files(path);
    return {files.begin(), files.end()};
  }
  constexpr std::array<std::string_view, 5> single{".vtu", ".msh", ".mesh", ".off", ".svg"};
  if (std::ranges::find(single, extension) != single.end()) return {path};
  throw OutputError(detail::unknown_extension(path, "a mesh that can be written;", writable_meshes));
}

/// Throws `OutputError` when writing a mesh to the path cannot work: the extension is not known, or a file would be written over
/// the input. Call it before meshing, so that no work is lost.
inline void check_planar_output(const std::filesystem::path& path, const std::filesystem::path& input_file = {}) {
  detail::refuse_to_write_over(input_file, planar_mesh_files(path));
}

/// Writes a mesh in the format of the path's extension; `.node` and `.ele` write the whole set of Triangle's files.
/// Throws `OutputError`, and `Interrupted` when the control says stop: a run whose time is up writes with a control of its own.
inline void write_planar_mesh(const std::filesystem::path& path, const PlanarMesh& mesh, const PlanarFileContext& context = {},
                              const Control& control = Control{}) {
  check_planar_output(path, context.input_file);
  const std::string extension = detail::lower_extension(path);
  if (extension == ".vtu") return write_vtu(path, mesh, control);
  if (extension == ".msh") return write_msh(path, mesh, control);
  if (extension == ".mesh") return write_medit(path, mesh, control);
  if (extension == ".off") return write_off(path, mesh, control);
  if (extension == ".svg") return write_svg(path, mesh, context.picture, control);
  write_triangle_mesh(path, mesh, context.input ? *context.input : Pslg{}, control);
}

}  // namespace delref
