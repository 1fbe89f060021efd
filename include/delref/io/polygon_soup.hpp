// SPDX-License-Identifier: GPL-3.0-or-later
//
// From the points and polygons that CGAL's readers of surfaces (.off, .obj, .ply, .stl) give to a complex of which each polygon is a
// facet: indices, coordinates and numbers of corners are compared here, since not all of those readers do.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <delref/core/budget.hpp>
#include <delref/domain/invalid_input.hpp>
#include <delref/domain/plc.hpp>
#include <delref/io/cgal_stream.hpp>
#include <delref/io/node_records.hpp>

namespace delref::detail {

/// Corners are indices into `points`, once `soup_to_plc` has compared them.
struct PolygonSoup {
  explicit PolygonSoup(const Control& control) : points(control), polygons(control) {}

  WatchedSequence<CgalPoint> points;
  WatchedSequence<std::vector<std::size_t>> polygons;
};

/// The points of a soup; throws `InvalidInput` for one that is not finite, or when there is none.
inline std::vector<Point3> soup_points(const PolygonSoup& soup, const std::string& name, std::size_t first_index, const Control& control) {
  if (soup.points.empty()) throw InvalidInput(fmt::format("{}: the file has no vertices", name));
  if (soup.points.size() >= std::size_t{Plc::Index(-1)}) throw InvalidInput(fmt::format("{}: has more vertices than 32 bits can count", name));
  std::vector<Point3> points;
  points.reserve(soup.points.size());
  for (const CgalPoint& p : soup.points) {
    ask_sometimes(control, points.size());
    points.push_back(to_point(p));
    check_finite(points.back(), points.size() - 1 + first_index, name, "vertex");
  }
  return points;
}

/// The corners of a polygon, each of which must be one of the points.
inline std::vector<Plc::Index> soup_corners(const std::vector<std::size_t>& polygon, std::size_t points, const std::string& name, std::string_view what,
                                            std::size_t id, std::size_t first_index) {
  std::vector<Plc::Index> corners;
  corners.reserve(polygon.size());
  for (const std::size_t corner : polygon) {
    if (corner >= points) {
      throw InvalidInput(fmt::format("{}: a corner of {} {} is vertex {}, but the vertices are numbered from {} and there are {}", name, what, id,
                                     static_cast<std::int64_t>(corner + first_index), first_index, points));
    }
    corners.push_back(static_cast<Plc::Index>(corner));
  }
  return corners;
}

/// The complex of the polygons. Those whose places in the soup are in `lines` (ascending) are no facets: their pieces become segments.
/// Throws `InvalidInput` for an empty surface, an index that is no point's, a coordinate that is not finite, and a polygon of fewer
/// than three corners.
inline Plc soup_to_plc(const PolygonSoup& soup, const std::string& name, Plc::Index first_index, const Control& control,
                       const std::vector<std::size_t>& lines = {}) {
  Plc out;
  out.first_index = first_index;
  out.points = soup_points(soup, name, first_index, control);
  if (soup.polygons.empty()) throw InvalidInput(fmt::format("{}: the file has no faces", name));
  out.facets.reserve(soup.polygons.size() - lines.size());
  auto line = lines.begin();
  for (std::size_t i = 0; i != soup.polygons.size(); ++i) {
    ask_sometimes(control, i);
    const auto& polygon = soup.polygons[i];
    if (line != lines.end() && *line == i) {
      const auto corners = soup_corners(polygon, out.points.size(), name, "line", static_cast<std::size_t>(line - lines.begin()) + first_index, first_index);
      for (std::size_t k = 1; k < corners.size(); ++k) out.segments.push_back({corners[k - 1], corners[k]});
      ++line;
      continue;
    }
    const std::size_t face = out.facets.size() + first_index;
    if (polygon.size() < 3) throw InvalidInput(fmt::format("{}: face {} has {} corners; a polygon has three or more", name, face, polygon.size()));
    out.facets.emplace_back();
    out.facets.back().polygons.push_back(soup_corners(polygon, out.points.size(), name, "face", face, first_index));
  }
  return out;
}

}  // namespace delref::detail
