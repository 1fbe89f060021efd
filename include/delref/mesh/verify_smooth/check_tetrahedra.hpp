// SPDX-License-Identifier: GPL-3.0-or-later
//
// The checks of the tetrahedra against the oracle and the criteria.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <delref/mesh/tetrahedron_measures.hpp>
#include <delref/mesh/verify/report.hpp>
#include <delref/mesh/verify_smooth/excuses.hpp>
#include <delref/mesh/verify_smooth/subject.hpp>
#include <delref/mesh/verify_smooth/surface_probe.hpp>

namespace delref::verification_smooth {

/// The circumcentre of a tetrahedron with what rounding can have done to it: the flatter, the more. Scaled.
struct Circumcentre {
  Point3 place;
  double radius = 0;
  double relative_error = 0;  ///< of the radius, and of how far the place may be off over the radius

  Circumcentre(Point3 p, Point3 q, Point3 r, Point3 s) {
    const Vector3 a = q - p, b = r - p, c = s - p;
    const Vector3 bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
    const double aa = squared_length(a), bb = squared_length(b), cc = squared_length(c), six_volumes = dot(a, bc);
    const Vector3 to_it = (0.5 / six_volumes) * (aa * bc + bb * ca + cc * ab);
    place = p + to_it;
    radius = std::sqrt(squared_length(to_it));
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    const double flatness = std::sqrt(aa * bb * cc) / std::abs(six_volumes);
    relative_error = 16 * epsilon * flatness;
    if (!(relative_error < 1)) relative_error = 1;
  }
};

inline Circumcentre circumcentre(const Subject& s, std::size_t t) {
  const auto& [a, b, c, d] = s.mesh.tetrahedra[t];
  return {s.points[a], s.points[b], s.points[c], s.points[d]};
}

/// A tetrahedron that is so flat that its circumcentre is noise. What is known of it is that it must not stay.
inline bool is_flat(const Circumcentre& c) { return c.relative_error > 1e-3; }

/// Tetrahedra have the label of the region that their circumcentre is in.
template <Oracle O>
void check_labels(const Subject& s, Questions<O>& questions, const std::vector<int>& regions, Finding& finding) {
  constexpr std::size_t batch = 4096;
  SurfaceProbe<O> probe(questions);
  std::vector<Point3> places;
  std::vector<int> found;
  std::size_t rounded = 0, flat = 0;
  for (std::size_t first = 0; first < regions.size(); first += batch) {
    throw_if_stopped(s.control);
    places.clear();
    const std::size_t last = std::min(first + batch, regions.size());
    for (std::size_t t = first; t < last; ++t) places.push_back(circumcentre(s, t).place);
    found.resize(places.size());
    questions.regions(places, found);
    for (std::size_t t = first; t < last; ++t) {
      ++finding.examined;
      if (found[t - first] == regions[t]) continue;
      const Circumcentre centre = circumcentre(s, t);
      const double uncertain = 4 * centre.relative_error * centre.radius + 4e-16;
      if (is_flat(centre)) ++flat;
      else if (probe.finds_region(centre.place, uncertain, regions[t])) ++rounded;
      else
        finding.fail([&] {
          return fmt::format("{} has the label of {}, its circumcentre {} is in {}", s.tetrahedron(t), questions.words(regions[t]),
                             s.place(s.original(centre.place)), questions.words(found[t - first]));
        });
    }
  }
  if (rounded != 0) finding.note = fmt::format("{} have the circumcentre on the surface, as far as can be told", rounded);
  if (flat != 0) finding.note += fmt::format("{}{} are so flat that they have none", finding.note.empty() ? "" : ", ", flat);
}

inline void check_radius_edge(const Subject& s, Excuses& excuses, VerifyReport& report, Finding& finding) {
  finding.examined = s.mesh.tetrahedra.size();
  for (std::size_t t = 0; t < s.mesh.tetrahedra.size(); ++t) {
    s.breathe(t);
    const TetrahedronMeasures shape = s.shape(t);
    const double ratio = std::sqrt(shape.squared_radius_edge());
    report.worst_radius_edge = std::max(report.worst_radius_edge, ratio);
    if (ratio > s.options.radius_edge * (1 + 1e-9) && ratio > s.options.radius_edge * (1 + circumcentre(s, t).relative_error)) {
      if (excuses.settle_tetrahedron(t)) continue;
      finding.fail([&] { return fmt::format("{} has a radius-edge ratio of {}", s.tetrahedron(t), ratio); });
    }
    report.worst_radius_edge_in_force = std::max(report.worst_radius_edge_in_force, ratio);
  }
}

/// No circumradius is greater than the bound, than that of the region, and than the field says at the circumcentre.
inline void check_cell_sizes(const Subject& s, const std::vector<int>& regions, Excuses& excuses, Finding& finding) {
  finding.examined = s.mesh.tetrahedra.size();
  for (std::size_t t = 0; t < s.mesh.tetrahedra.size(); ++t) {
    s.breathe(t);
    const Circumcentre centre = circumcentre(s, t);
    double size = s.options.cell_size;
    const auto region = static_cast<std::size_t>(regions[t]);
    if (regions[t] >= 0 && region < s.options.region_cell_sizes.size() && s.options.region_cell_sizes[region] > 0)
      size = std::min(size, s.options.region_cell_sizes[region]);
    if (s.options.cell_size_field && is_finite(centre.place)) size = std::min(size, s.options.cell_size_field(s.original(centre.place)));
    if (centre.radius <= s.scaling.length(size) * (1 + 1e-9 + centre.relative_error) || excuses.settle_tetrahedron(t)) continue;
    finding.fail([&] {
      return fmt::format("{} has a circumradius of {}, the size is {}", s.tetrahedron(t), s.scaling.original_length(centre.radius), size);
    });
  }
}

}  // namespace delref::verification_smooth
