// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the .poly and .node files of Triangle (Shewchuk, www.cs.cmu.edu/~quake/triangle.poly.html): vertices numbered from 0 or
// 1 with attributes and markers, segments with markers, holes, and regions with a label and a bound on the area.
//
// What is looser than Triangle: nothing. What is stricter: vertices must be numbered one after the other, every announced number
// must be there, a region's attribute must be an integer since it is a label, and nothing may follow the last record.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include <delref/core/budget.hpp>
#include <delref/domain/pslg.hpp>
#include <delref/io/file.hpp>
#include <delref/io/node_records.hpp>
#include <delref/io/text_scanner.hpp>

namespace delref {

namespace detail {

inline void read_segment_records(TextScanner& in, Pslg& out, const Control& control) {
  in.need_line("the number of segments");
  const std::size_t count = in.count("the number of segments", 1);
  const bool marked = read_marker_count(in, "the number of segment markers");
  in.check_room(count, marked ? 8 : 6, "the number of segments");
  out.segments.reserve(count);
  if (marked) out.segment_markers.reserve(count);
  for (std::size_t i = 0; i != count; ++i) {
    ask_sometimes(control, i);
    in.need_line("segment", i + out.first_index);
    const auto number = in.integer<std::uint32_t>("the number of a segment");
    const auto a = read_vertex_index(in, out, "the first end of segment", number);
    const auto b = read_vertex_index(in, out, "the second end of segment", number);
    out.segments.push_back({a, b});
    if (marked) out.segment_markers.push_back(in.integer<int>("the marker of segment", number));
  }
}

}  // namespace detail

/// A .node file as a planar straight line graph without segments. `name` is what complaints call it.
/// Throws `InvalidInput` with the line and what was expected there, `Interrupted` when the control says stop.
inline Pslg parse_triangle_node(std::string_view text, const std::string& name, const Control& control = Control{}) {
  return detail::parse_node_records<Pslg>(text, name, control);
}

/// A .poly file. `separate_vertices()` is called when the file says that it has none itself, and gives those of the .node file.
/// An area bound that is 0, negative or infinite is none; a bound that is missing too. Indices of vertices that do not exist are
/// kept for `check_pslg`. Throws as `parse_triangle_node`.
template <std::invocable SeparateVertices>
Pslg parse_triangle_poly(std::string_view text, const std::string& name, SeparateVertices&& separate_vertices,
                         const Control& control = Control{}) {
  const auto segments = [&](TextScanner& in, Pslg& out) { detail::read_segment_records(in, out, control); };
  return detail::parse_poly_records<Pslg>(text, name, std::forward<SeparateVertices>(separate_vertices), segments, control);
}

/// Reads a .node file: vertices, no segments. Throws as `read_file` and `parse_triangle_node`.
inline Pslg read_triangle_node(const std::filesystem::path& path, const Control& control = Control{}) {
  return parse_triangle_node(read_file(path, control), path.string(), control);
}

/// Reads a .poly file, and the .node file of the same stem when the .poly file says that it has 0 vertices.
inline Pslg read_triangle_poly(const std::filesystem::path& path, const Control& control = Control{}) {
  const auto separate_vertices = [&] { return read_triangle_node(detail::separate_node_file(path), control); };
  return parse_triangle_poly(read_file(path, control), path.string(), separate_vertices, control);
}

}  // namespace delref
