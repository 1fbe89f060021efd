// SPDX-License-Identifier: GPL-3.0-or-later
//
// Small piecewise linear complexes for tests, and how a test reads a refusal.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <delref/domain/check_plc.hpp>

namespace complexes {

using delref::Control;
using delref::Plc;
using delref::PlcOptions;
using delref::Point3;
using delref::PolyhedralDomain;
using delref::Vector3;

inline Plc::Facet facet(std::vector<std::vector<Plc::Index>> polygons, int marker = 0) {
  return {std::move(polygons), {}, marker};
}

/// Adds a box as eight vertices and six facets, marked from `first_marker` on.
inline void add_box(Plc& plc, Point3 low, Point3 high, int first_marker = 1) {
  const auto v = static_cast<Plc::Index>(plc.points.size());
  for (const double z : {low.z, high.z})
    for (const auto& [x, y] :
         {std::pair(low.x, low.y), std::pair(high.x, low.y), std::pair(high.x, high.y), std::pair(low.x, high.y)})
      plc.points.push_back({x, y, z});
  for (const std::array<Plc::Index, 4>& side :
       {std::array<Plc::Index, 4>{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}})
    plc.facets.push_back(facet({{v + side[0], v + side[1], v + side[2], v + side[3]}}, first_marker++));
}

inline Plc box(Point3 low = {0, 0, 0}, Point3 high = {1, 1, 1}) {
  Plc plc;
  add_box(plc, low, high);
  return plc;
}

/// The same with every polygon cut into triangles from its first corner.
inline Plc in_triangles(const Plc& plc) {
  Plc result = plc;
  result.facets.clear();
  for (const Plc::Facet& f : plc.facets)
    for (const auto& polygon : f.polygons)
      for (std::size_t k = 2; k < polygon.size(); ++k)
        result.facets.push_back(facet({{polygon[0], polygon[k - 1], polygon[k]}}, f.marker));
  return result;
}

/// The complex turned at random, then scaled, then moved.
inline Plc moved(Plc plc, unsigned seed, double scale, double offset) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  const auto random_unit = [&] { return delref::unit({normal(generator), normal(generator), normal(generator)}); };
  const Vector3 u = random_unit(), w = delref::unit(cross(u, random_unit())), v = cross(w, u);
  const auto move = [&](Point3& p) { p = Point3{offset, offset, offset} + scale * (p.x * u + p.y * v + p.z * w); };
  for (Point3& p : plc.points) move(p);
  for (Point3& p : plc.holes) move(p);
  for (Plc::Facet& f : plc.facets)
    for (Point3& p : f.holes) move(p);
  return plc;
}

/// What the refusal of a complex says; empty when it is accepted.
inline std::string refusal(const Plc& plc, const PlcOptions& options = {}) {
  try {
    delref::check_plc(plc, options, Control{});
  } catch (const delref::InvalidInput& invalid) {
    return invalid.what();
  }
  return {};
}

/// The area of a facet's triangles, each counted positive where it is counterclockwise in the facet's frame.
inline double area(const PolyhedralDomain& domain, const PolyhedralDomain::Facet& f) {
  double sum = 0;
  for (const auto& [a, b, c] : f.triangles) {
    const delref::Point2 p = f.frame.project(domain.points[a]);
    sum += 0.5 * cross(f.frame.project(domain.points[b]) - p, f.frame.project(domain.points[c]) - p);
  }
  return sum;
}

inline std::string notes(const PolyhedralDomain& domain) {
  std::string text;
  for (const std::string& note : domain.notes) text += note + "\n";
  return text;
}

}  // namespace complexes
