// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the .poly and .node files of Triangle (Shewchuk, www.cs.cmu.edu/~quake/triangle.poly.html): vertices numbered from 0 or
// 1 with attributes and markers, segments with markers, holes, and regions with a label and a bound on the area.
//
// What is looser than Triangle: nothing. What is stricter: vertices must be numbered one after the other, every announced number
// must be there, a region's attribute must be an integer since it is a label, and nothing may follow the last record.
#pragma once

#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include <delref/core/budget.hpp>
#include <delref/domain/invalid_input.hpp>
#include <delref/domain/pslg.hpp>
#include <delref/io/file.hpp>
#include <delref/io/text_scanner.hpp>

namespace delref {

namespace detail {

/// Records between two questions to the control.
inline constexpr std::size_t control_stride = 8192;

inline void ask_sometimes(const Control& control, std::size_t i) {
  if (i % control_stride == control_stride - 1) throw_if_stopped(control);
}

/// The number of marker columns, which may be absent from its header line.
inline bool read_marker_count(TextScanner& in, std::string_view what) {
  if (!in.has_field()) return false;
  const auto count = in.integer<std::uint32_t>(what);
  if (count > 1) in.fail(fmt::format("{} is {}; it can be 0 or 1", what, count));
  return count == 1;
}

/// The header line `vertices dimension attributes markers`, whose first number is `count`, and the vertices after it.
inline void read_vertex_records(TextScanner& in, std::size_t count, Pslg& out, const Control& control) {
  if (in.has_field()) {
    if (const auto dimension = in.integer<std::uint32_t>("the dimension"); dimension != 2) {
      in.fail(fmt::format("the dimension is {}; planar files have 2", dimension));
    }
  }
  out.attribute_count = in.has_field() ? in.count("the number of attributes", 1) : 0;
  const bool marked = read_marker_count(in, "the number of vertex markers");
  if (count == 0) return;
  in.check_room(count, 2 * (3 + out.attribute_count + (marked ? 1 : 0)), "the number of vertices");
  out.points.reserve(count);
  out.attributes.reserve(count * out.attribute_count);
  if (marked) out.point_markers.reserve(count);
  for (std::size_t i = 0; i != count; ++i) {
    ask_sometimes(control, i);
    in.need_line("vertex", i + out.first_index);
    const auto number = in.integer<std::uint64_t>("the number of a vertex");
    if (i == 0 && number > 1) in.fail(fmt::format("the first vertex has number {}; numbers start at 0 or 1", number));
    if (i == 0) out.first_index = static_cast<Pslg::Index>(number);
    if (number != i + out.first_index) in.fail(fmt::format("expected vertex {}, found vertex {}", i + out.first_index, number));
    const double x = in.number("the x coordinate of vertex", number);
    const double y = in.number("the y coordinate of vertex", number);
    out.points.push_back({x, y});
    for (std::size_t k = 0; k != out.attribute_count; ++k) out.attributes.push_back(in.number("an attribute of vertex", number));
    if (marked) out.point_markers.push_back(in.integer<int>("the marker of vertex", number));
  }
}

/// An index written in the file, counted from 0. Indices past the last vertex are kept: `check_pslg` names them all together.
inline Pslg::Index read_vertex_index(TextScanner& in, const Pslg& out, std::string_view what, std::size_t id) {
  const auto written = in.integer<Pslg::Index>(what, id);
  if (written < out.first_index) in.fail(fmt::format("{} {} is vertex 0, but vertices are numbered from 1", what, id));
  return written - out.first_index;
}

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

inline void read_hole_records(TextScanner& in, Pslg& out) {
  in.need_line("the number of holes");
  const std::size_t count = in.count("the number of holes", 1);
  in.check_room(count, 6, "the number of holes");
  for (std::size_t i = 0; i != count; ++i) {
    in.need_line("hole", i + out.first_index);
    const auto number = in.integer<std::uint32_t>("the number of a hole");
    const double x = in.number("the x coordinate of hole", number);
    out.holes.push_back({x, in.number("the y coordinate of hole", number)});
  }
}

/// A label of this file: a number that must be an integer.
inline int read_label(TextScanner& in, std::string_view what, std::size_t id) {
  const double value = in.number(what, id);
  if (!(value >= std::numeric_limits<int>::min() && value <= std::numeric_limits<int>::max()) || value != std::floor(value)) {
    in.fail(fmt::format("{} {} is {}; it is the label of the region and must be an integer of 32 bits", what, id, value));
  }
  return static_cast<int>(value);
}

inline void read_region_records(TextScanner& in, Pslg& out) {
  if (!in.next_line()) return;
  const std::size_t count = in.count("the number of regions", 1);
  in.check_room(count, 8, "the number of regions");
  for (std::size_t i = 0; i != count; ++i) {
    in.need_line("region", i + out.first_index);
    const auto number = in.integer<std::uint32_t>("the number of a region");
    Pslg::Region region;
    region.seed.x = in.number("the x coordinate of region", number);
    region.seed.y = in.number("the y coordinate of region", number);
    region.label = read_label(in, "the attribute of region", number);
    const double bound = in.has_field() ? in.number("the area bound of region", number) : 0.0;
    if (std::isnan(bound)) in.fail(fmt::format("the area bound of region {} is not a number", number));
    region.max_area = bound > 0 && std::isfinite(bound) ? bound : 0.0;
    out.regions.push_back(region);
  }
}

}  // namespace detail

/// A .node file as a planar straight line graph without segments. `name` is what complaints call it.
/// Throws `InvalidInput` with the line and what was expected there, `Interrupted` when the control says stop.
inline Pslg parse_triangle_node(std::string_view text, const std::string& name, const Control& control = Control{}) {
  TextScanner in(text, name, TextScanner::Layout::lines);
  Pslg out;
  in.need_line("the number of vertices");
  detail::read_vertex_records(in, in.count("the number of vertices", 1), out, control);
  if (in.next_line()) in.fail(fmt::format("more follows after the last of {} vertices", out.points.size()));
  return out;
}

/// A .poly file. `separate_vertices()` is called when the file says that it has none itself, and gives those of the .node file.
/// An area bound that is 0, negative or infinite is none; a bound that is missing too. Indices of vertices that do not exist are
/// kept for `check_pslg`. Throws as `parse_triangle_node`.
template <std::invocable SeparateVertices>
Pslg parse_triangle_poly(std::string_view text, const std::string& name, SeparateVertices&& separate_vertices,
                         const Control& control = Control{}) {
  TextScanner in(text, name, TextScanner::Layout::lines);
  Pslg out;
  in.need_line("the number of vertices");
  const std::size_t count = in.count("the number of vertices", 1);
  detail::read_vertex_records(in, count, out, control);
  if (count == 0) out = separate_vertices();
  detail::read_segment_records(in, out, control);
  detail::read_hole_records(in, out);
  detail::read_region_records(in, out);
  if (in.next_line()) in.fail("more follows after the last region; is one of the numbers of records too small?");
  return out;
}

/// Reads a .node file: vertices, no segments. Throws as `read_file` and `parse_triangle_node`.
inline Pslg read_triangle_node(const std::filesystem::path& path, const Control& control = Control{}) {
  return parse_triangle_node(read_file(path, control), path.string(), control);
}

/// Reads a .poly file, and the .node file of the same stem when the .poly file says that it has 0 vertices.
inline Pslg read_triangle_poly(const std::filesystem::path& path, const Control& control = Control{}) {
  const auto separate_vertices = [&] {
    const auto node_path = std::filesystem::path(path).replace_extension(".node");
    if (!std::filesystem::exists(node_path)) {
      throw InvalidInput(fmt::format("{}: has no vertices, and there is no file {} that has them", path.string(), node_path.string()));
    }
    return read_triangle_node(node_path, control);
  };
  return parse_triangle_poly(read_file(path, control), path.string(), separate_vertices, control);
}

}  // namespace delref
