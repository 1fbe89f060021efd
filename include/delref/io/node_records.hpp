// SPDX-License-Identifier: GPL-3.0-or-later
//
// The records that the .node and .poly files of Triangle and those of TetGen have in common, in two and three coordinates:
// vertices numbered from 0 or 1 with attributes and markers, holes, and regions with a label and a bound on the size of their
// elements. What they fill is a `Pslg` or a `Plc`.
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
#include <delref/core/point.hpp>
#include <delref/domain/invalid_input.hpp>
#include <delref/io/text_scanner.hpp>

namespace delref::detail {

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

template <class Graph>
using PointOf = typename decltype(Graph::points)::value_type;

template <class Graph>
inline constexpr bool in_space = std::same_as<PointOf<Graph>, Point3>;

/// What complaints call the coordinates of a kind of record: "the x coordinate of vertex".
struct CoordinateNames {
  explicit CoordinateNames(std::string_view of)
      : x(fmt::format("the x coordinate of {}", of)), y(fmt::format("the y coordinate of {}", of)), z(fmt::format("the z coordinate of {}", of)) {}

  std::string x, y, z;
};

/// A point of the plane or of space: two or three numbers.
template <class Point>
Point read_point(TextScanner& in, const CoordinateNames& names, std::size_t id) {
  Point p;
  p.x = in.number(names.x, id);
  p.y = in.number(names.y, id);
  if constexpr (std::same_as<Point, Point3>) p.z = in.number(names.z, id);
  return p;
}

/// The header line `vertices dimension attributes markers`, whose first number is `count`, and the vertices after it.
template <class Graph>
void read_vertex_records(TextScanner& in, std::size_t count, Graph& out, const Control& control) {
  constexpr std::uint32_t expected = in_space<Graph> ? 3 : 2;
  const auto dimension = in.has_field() ? in.integer<std::uint32_t>("the dimension") : expected;
  if (dimension != expected) {
    in.fail(fmt::format("the dimension is {}; {} files have {}", dimension, in_space<Graph> ? "polyhedral" : "planar", expected));
  }
  out.attribute_count = in.has_field() ? in.count("the number of attributes", 1) : 0;
  const bool marked = read_marker_count(in, "the number of vertex markers");
  if (count == 0) return;
  in.check_room(count, 2 * (1 + expected + out.attribute_count + (marked ? 1 : 0)), "the number of vertices");
  out.points.reserve(count);
  out.attributes.reserve(count * out.attribute_count);
  if (marked) out.point_markers.reserve(count);
  const CoordinateNames names("vertex");
  for (std::size_t i = 0; i != count; ++i) {
    ask_sometimes(control, i);
    in.need_line("vertex", i + out.first_index);
    const auto number = in.integer<std::uint64_t>("the number of a vertex");
    if (i == 0 && number > 1) in.fail(fmt::format("the first vertex has number {}; numbers start at 0 or 1", number));
    if (i == 0) out.first_index = static_cast<typename Graph::Index>(number);
    if (number != i + out.first_index) in.fail(fmt::format("expected vertex {}, found vertex {}", i + out.first_index, number));
    out.points.push_back(read_point<PointOf<Graph>>(in, names, number));
    for (std::size_t k = 0; k != out.attribute_count; ++k) out.attributes.push_back(in.number("an attribute of vertex", number));
    if (marked) out.point_markers.push_back(in.integer<int>("the marker of vertex", number));
  }
}

/// An index written in the file, counted from 0. Indices past the last vertex are kept: the check of the graph names them all together.
template <class Graph>
typename Graph::Index read_vertex_index(TextScanner& in, const Graph& out, std::string_view what, std::size_t id) {
  const auto written = in.integer<typename Graph::Index>(what, id);
  if (written < out.first_index) in.fail(fmt::format("{} {} is vertex 0, but vertices are numbered from 1", what, id));
  return written - out.first_index;
}

template <class Graph>
void read_hole_records(TextScanner& in, Graph& out) {
  in.need_line("the number of holes");
  const std::size_t count = in.count("the number of holes", 1);
  in.check_room(count, in_space<Graph> ? 8 : 6, "the number of holes");
  const CoordinateNames names("hole");
  for (std::size_t i = 0; i != count; ++i) {
    in.need_line("hole", i + out.first_index);
    const auto number = in.integer<std::uint32_t>("the number of a hole");
    out.holes.push_back(read_point<PointOf<Graph>>(in, names, number));
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

/// Regions, which may be absent. A bound that is 0, negative or infinite is none; a bound that is missing too.
template <class Graph>
void read_region_records(TextScanner& in, Graph& out) {
  if (!in.next_line()) return;
  const std::size_t count = in.count("the number of regions", 1);
  in.check_room(count, in_space<Graph> ? 10 : 8, "the number of regions");
  const CoordinateNames names("region");
  for (std::size_t i = 0; i != count; ++i) {
    in.need_line("region", i + out.first_index);
    const auto number = in.integer<std::uint32_t>("the number of a region");
    typename Graph::Region region;
    region.seed = read_point<PointOf<Graph>>(in, names, number);
    region.label = read_label(in, "the attribute of region", number);
    constexpr std::string_view measure = in_space<Graph> ? "volume" : "area";
    const double bound = in.has_field() ? in.number(fmt::format("the {} bound of region", measure), number) : 0.0;
    if (std::isnan(bound)) in.fail(fmt::format("the {} bound of region {} is not a number", measure, number));
    const double usable = bound > 0 && std::isfinite(bound) ? bound : 0.0;
    if constexpr (in_space<Graph>) region.max_volume = usable;
    else region.max_area = usable;
    out.regions.push_back(region);
  }
}

/// The whole text of a .node file: vertices and nothing else.
template <class Graph>
Graph parse_node_records(std::string_view text, const std::string& name, const Control& control) {
  TextScanner in(text, name, TextScanner::Layout::lines);
  Graph out;
  in.need_line("the number of vertices");
  read_vertex_records(in, in.count("the number of vertices", 1), out, control);
  if (in.next_line()) in.fail(fmt::format("more follows after the last of {} vertices", out.points.size()));
  return out;
}

/// The text of a .poly or .smesh file: vertices, or those of `separate_vertices()` when it has 0, then what `read_elements(in, out)`
/// reads, holes and regions.
template <class Graph, std::invocable SeparateVertices, class ReadElements>
Graph parse_poly_records(std::string_view text, const std::string& name, SeparateVertices&& separate_vertices, ReadElements&& read_elements,
                         const Control& control) {
  TextScanner in(text, name, TextScanner::Layout::lines);
  Graph out;
  in.need_line("the number of vertices");
  const std::size_t count = in.count("the number of vertices", 1);
  read_vertex_records(in, count, out, control);
  if (count == 0) out = separate_vertices();
  read_elements(in, out);
  read_hole_records(in, out);
  read_region_records(in, out);
  if (in.next_line()) in.fail("more follows after the last region; is one of the numbers of records too small?");
  return out;
}

/// The .node file of the same stem, which has the vertices that the file at `path` has not.
inline std::filesystem::path separate_node_file(const std::filesystem::path& path) {
  auto node_path = std::filesystem::path(path).replace_extension(".node");
  if (std::filesystem::exists(node_path)) return node_path;
  throw InvalidInput(fmt::format("{}: has no vertices, and there is no file {} that has them", path.string(), node_path.string()));
}

}  // namespace delref::detail
