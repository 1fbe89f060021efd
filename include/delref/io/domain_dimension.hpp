// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether the domain in a file lies in the plane or in space.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include <fmt/format.h>

#include <delref/core/budget.hpp>
#include <delref/domain/invalid_input.hpp>
#include <delref/io/extension.hpp>
#include <delref/io/file.hpp>
#include <delref/io/tetgen_poly.hpp>
#include <delref/io/text_scanner.hpp>

namespace delref {

/// What a domain lies in.
enum class Dimension : unsigned char { plane = 2, space = 3 };

namespace detail {

/// The header line of a .node or .poly file says the dimension, or leaves it to the separate .node file; where none does, the file is
/// planar, as Triangle takes it.
inline Dimension node_dimension(const std::filesystem::path& path, const Control& control) {
  const std::string text = read_file(path, control);
  TextScanner in(text, path.string(), TextScanner::Layout::lines);
  in.need_line("the number of vertices");
  const auto count = in.integer<std::uint64_t>("the number of vertices");
  if (in.has_field()) {
    const auto dimension = in.integer<std::uint32_t>("the dimension");
    if (dimension != 2 && dimension != 3) in.fail(fmt::format("the dimension is {}; it can be 2 or 3", dimension));
    return static_cast<Dimension>(dimension);
  }
  if (count == 0 && lower_extension(path) != ".node") return node_dimension(separate_node_file(path), control);
  return Dimension::plane;
}

}  // namespace detail

/// Whether the domain in a file is planar or polyhedral: .poly and .node say it in their first line, the other formats have one kind.
/// Throws `InvalidInput` when that line is broken, or for an extension that is no domain's; `Interrupted` when the control says stop.
inline Dimension domain_dimension(const std::filesystem::path& path, const Control& control = Control{}) {
  const std::string extension = detail::lower_extension(path);
  if (extension == ".poly" || extension == ".node") return detail::node_dimension(path, control);
  if (extension == ".geojson" || extension == ".json") return Dimension::plane;
  if (extension == ".smesh" || extension == ".off" || extension == ".obj" || extension == ".ply" || extension == ".stl") return Dimension::space;
  throw InvalidInput(detail::unknown_extension(
      path, "a domain;", ".poly, .node, .geojson and .json (planar), .poly, .smesh, .node, .off, .obj, .ply and .stl (polyhedral)"));
}

}  // namespace delref
