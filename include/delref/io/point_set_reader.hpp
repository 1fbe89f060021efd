// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads sets of points by CGAL: .xyz, that is three coordinates in a line or six with the normal, `#` starting a comment; and .ply, text and
// binary, whose element `vertex` has x, y, z and may have nx, ny, nz.
//
// CGAL takes a line of four or five numbers of an .xyz file for one of three or reports it on the error stream, and mixes lines
// with and without normals; so the lines are counted and looked at before. For .ply it stands behind the guard of ply_header.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <istream>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <CGAL/IO/read_ply_points.h>
#include <CGAL/IO/read_xyz_points.h>
#include <CGAL/property_map.h>
#include <fmt/format.h>

#include <delref/core/budget.hpp>
#include <delref/domain/invalid_input.hpp>
#include <delref/domain/point_set.hpp>
#include <delref/io/cgal_stream.hpp>
#include <delref/io/extension.hpp>
#include <delref/io/file.hpp>
#include <delref/io/node_records.hpp>
#include <delref/io/ply_header.hpp>
#include <delref/io/ply_reader.hpp>
#include <delref/io/text_scanner.hpp>

namespace delref {

inline constexpr std::string_view readable_point_sets = ".xyz and .ply";

namespace detail {

using PointAndNormal = std::pair<CgalPoint, CgalVector>;
using PointsAndNormals = WatchedSequence<PointAndNormal>;

/// What CGAL has read, as plain data. Throws `InvalidInput` for a set without points and for what is not finite.
inline PointSet to_point_set(const PointsAndNormals& rows, bool normals, const std::string& name, const Control& control) {
  if (rows.empty()) throw InvalidInput(fmt::format("{}: the file has no points", name));
  PointSet out;
  out.points.reserve(rows.size());
  if (normals) out.normals.reserve(rows.size());
  for (std::size_t i = 0; i != rows.size(); ++i) {
    ask_sometimes(control, i);
    out.points.push_back(to_point(rows[i].first));
    check_finite(out.points.back(), i, name, "point");
    if (!normals) continue;
    const CgalVector& normal = rows[i].second;
    check_finite({normal.x(), normal.y(), normal.z()}, i, name, "the normal of point");
    out.normals.push_back({normal.x(), normal.y(), normal.z()});
  }
  return out;
}

/// The width of the lines, 3 or 6, the same in all; 0 when there is none. Every field must be a finite number.
inline std::size_t guard_xyz(std::string& text, const std::string& name, const Control& control) {
  blank_comments(text);
  refuse_commas(text, name);
  TextScanner in(text, name, TextScanner::Layout::lines);
  std::size_t width = 0;
  for (std::size_t row = 0; in.next_line(); ++row) {
    ask_sometimes(control, row);
    std::size_t fields = 0;
    for (; in.has_field(); ++fields) {
      if (!std::isfinite(in.number("point", row))) in.fail(fmt::format("point {} has a coordinate that is not a finite number", row));
    }
    if (fields != 3 && fields != 6) in.fail(fmt::format("point {} has {} numbers; three are read, or six with a normal", row, fields));
    if (width != 0 && width != fields) in.fail(fmt::format("point {} has {} numbers, those before it {}; either all have normals or none", row, fields, width));
    width = fields;
  }
  return width;
}

/// Whether the points have normals. Compares the header with the file, and puts a plain one in its place.
inline bool guard_ply_points(std::string& bytes, const std::string& name, const Control& control) {
  const PlyHeader header = read_ply_header(bytes, name);
  PlyWanted wanted{"vertex", {"x", "y", "z"}};
  const auto vertex = std::ranges::find(header.elements, "vertex", &PlyElement::name);
  if (vertex == header.elements.end()) throw InvalidInput(fmt::format("{}: the file has no element \"vertex\"", name));
  if (std::ranges::count(header.elements, "vertex", &PlyElement::name) != 1) throw InvalidInput(fmt::format("{}: there are several elements \"vertex\"", name));
  const bool normals = vertex->find("nx") || vertex->find("ny") || vertex->find("nz");
  if (normals) wanted.properties.insert(wanted.properties.end(), {"nx", "ny", "nz"});
  for (const auto property : wanted.properties) check_ply_number(header, *vertex, property, name);
  if (header.layout != PlyLayout::text) check_ply_lengths(header, bytes, name, control);
  bytes.replace(0, header.size, plain_ply_header(header, bytes, {wanted}));
  return normals;
}

inline auto pair_maps() {
  return CGAL::parameters::point_map(CGAL::First_of_pair_property_map<PointAndNormal>()).normal_map(CGAL::Second_of_pair_property_map<PointAndNormal>());
}

}  // namespace detail

/// The points in the text of an .xyz file; `name` is what complaints call it.
/// Throws `InvalidInput` with the line and what was expected there, `Interrupted` when the control says stop.
inline PointSet parse_xyz(std::string text, const std::string& name, const Control& control = Control{}) {
  const std::size_t width = detail::guard_xyz(text, name, control);
  detail::PointsAndNormals rows(control);
  const auto read = [&](std::istream& in) { return CGAL::IO::read_XYZ<detail::PointAndNormal>(in, std::back_inserter(rows), detail::pair_maps()); };
  const auto end = detail::call_cgal_reader(std::move(text), name, false, read);
  if (!end.good) throw InvalidInput(fmt::format("{}, line {}: expected three numbers, or six, found \"{}\"", name, end.line, end.found));
  return detail::to_point_set(rows, width == 6, name, control);
}

/// The vertices in the bytes of a .ply file; `name` is what complaints call it. Faces are passed over.
/// Throws `InvalidInput` with the line or element and what was expected there, `Interrupted` when the control says stop.
inline PointSet parse_ply_points(std::string bytes, const std::string& name, const Control& control = Control{}) {
  const bool normals = detail::guard_ply_points(bytes, name, control);
  detail::PointsAndNormals rows(control);
  const auto read = [&](std::istream& in) { return CGAL::IO::read_PLY<detail::PointAndNormal>(in, std::back_inserter(rows), detail::pair_maps()); };
  const auto end = detail::call_cgal_reader(std::move(bytes), name, false, read);
  detail::check_ply_end(end, name, rows.size(), 0);
  return detail::to_point_set(rows, normals, name, control);
}

/// Reads a set of points by the extension of its file. Points may coincide.
/// Throws `InvalidInput`, also for an extension that is not in `readable_point_sets`, for an empty set and for numbers that are not
/// finite; `Interrupted` when the control says stop.
inline PointSet read_point_set(const std::filesystem::path& path, const Control& control = Control{}) {
  const std::string extension = detail::lower_extension(path);
  if (extension == ".xyz") return parse_xyz(read_file(path, control), path.string(), control);
  if (extension == ".ply") return parse_ply_points(read_file(path, control), path.string(), control);
  throw InvalidInput(detail::unknown_extension(path, "a set of points;", readable_point_sets));
}

}  // namespace delref
