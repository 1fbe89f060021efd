// SPDX-License-Identifier: GPL-3.0-or-later
//
// The check of the volume of the regions against that of the domain, which is counted in samples. It is rough, and finds what no look
// at single facets can: a part of the domain of which the mesh knows nothing.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <span>
#include <vector>

#include <fmt/format.h>

#include <delref/mesh/verify/report.hpp>
#include <delref/mesh/verify_smooth/subject.hpp>
#include <delref/mesh/verify_smooth/surface_balls.hpp>

namespace delref::verification_smooth {

/// The volume of each region of the domain, by the samples of a lattice with so many to the longest side of the bounds.
template <Oracle O>
std::map<int, double> sampled_volumes(const Subject& s, Questions<O>& questions, const BoundingBox3& bounds, double spacing) {
  std::map<int, std::size_t> counts;
  const auto steps = [&](double low, double high) { return static_cast<std::size_t>(std::ceil((high - low) / spacing)); };
  const std::size_t nx = steps(bounds.low.x, bounds.high.x), ny = steps(bounds.low.y, bounds.high.y), nz = steps(bounds.low.z, bounds.high.z);
  const auto at = [&](double low, std::size_t i) { return low + spacing * (static_cast<double>(i) + 0.5); };
  std::vector<Point3> line(nx);
  std::vector<int> regions(nx);
  for (std::size_t k = 0; k < nz; ++k) {
    throw_if_stopped(s.control);
    for (std::size_t j = 0; j < ny; ++j) {
      for (std::size_t i = 0; i < nx; ++i) line[i] = {at(bounds.low.x, i), at(bounds.low.y, j), at(bounds.low.z, k)};
      questions.regions(line, regions);
      for (const int r : regions) ++counts[r];
    }
  }
  std::map<int, double> volumes;
  for (const auto& [region, count] : counts) volumes[region] = static_cast<double>(count) * spacing * spacing * spacing;
  return volumes;
}

/// The surface around each region encloses the volume that the region has in the domain: the difference is at most what twice the
/// distance of the facets to the surface and one spacing of the samples can make.
template <Oracle O>
void check_volumes(const Subject& s, Questions<O>& questions, std::span<const Sides> sides, std::span<const SurfaceBall> balls,
                   const std::vector<SurfacePiece>& surfaces, Finding& finding) {
  constexpr double samples_per_side = 64;
  const BoundingBox3 bounds = questions.bounds();
  const double spacing = bounds.extent() / samples_per_side;
  std::map<int, double> of_domain, of_mesh, tolerance;
  for (const auto& [region, volume] : sampled_volumes(s, questions, bounds, spacing))
    if (region != outside) of_domain[questions.label(region)] = volume;
  for (const SurfacePiece& piece : surfaces) {
    of_mesh[piece.region] += s.scaling.volume(piece.volume);
    tolerance[piece.region] += 8 * spacing * spacing * spacing;
  }
  for (std::size_t t = 0; t < sides.size(); ++t) {
    const auto [a, b, c] = s.corners(t);
    const double area = 0.5 * std::sqrt(squared_length(cross(b - a, c - a)));
    for (const int region : {sides[t].behind, sides[t].front})
      if (region != outside) tolerance[questions.label(region)] += area * (2 * balls[t].distance + spacing);
  }
  for (const auto& [region, volume] : of_domain) of_mesh[region];
  for (const auto& [region, volume] : of_mesh) {
    ++finding.examined;
    const double difference = std::abs(volume - of_domain[region]), most = tolerance[region] + 8 * spacing * spacing * spacing;
    if (difference <= most) continue;
    finding.fail([&, its = region, its_volume = volume] {
      return fmt::format("region {} has a volume of {}, that of the domain is {} up to {}", its, s.scaling.original_volume(its_volume),
                         s.scaling.original_volume(of_domain[its]), s.scaling.original_volume(most));
    });
  }
}

}  // namespace delref::verification_smooth
