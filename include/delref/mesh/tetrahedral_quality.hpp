// SPDX-License-Identifier: GPL-3.0-or-later
//
// The figures by which a tetrahedral mesh is judged: radius-edge ratios (Miller, Talmor, Teng, Walkington 1995), dihedral angles
// and slivers, which have good radius-edge ratios and no volume, edge lengths, volumes.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/core/point.hpp>
#include <delref/mesh/scaling.hpp>
#include <delref/mesh/tetrahedral_mesh.hpp>
#include <delref/mesh/tetrahedron_measures.hpp>
#include <delref/mesh/twofold.hpp>

namespace delref {

/// What `tetrahedral_quality` measures. Angles in degrees, lengths and volumes in the unit of the mesh. For a mesh without
/// tetrahedra every figure is 0.
struct TetrahedralQuality {
  static constexpr double degrees_per_bin = 5;
  /// Where the bins of `radius_edge` begin, and each ends where the next begins; the last has no end.
  static constexpr std::array<double, 20> radius_edge_bins{0.6, 0.7, 0.8, 0.9, 1.0, 1.1, 1.2, 1.3, 1.4, 1.5,
                                                           1.6, 1.7, 1.8, 1.9, 2.0, 2.5, 3.0, 4.0, 6.0, 10.0};
  struct Region {
    std::size_t tetrahedron_count = 0;
    double volume = 0;
  };

  std::size_t vertex_count = 0, tetrahedron_count = 0, triangle_count = 0, edge_count = 0;
  double smallest_volume = 0, largest_volume = 0, total_volume = 0;
  /// By label; all 0 when the mesh carries none.
  std::map<int, Region> regions;
  /// The largest circumradius divided by shortest edge; infinite for a flat tetrahedron.
  double worst_radius_edge = 0;
  std::array<std::size_t, radius_edge_bins.size()> radius_edge{};
  double smallest_dihedral = 0, largest_dihedral = 0;
  /// How many dihedral angles (six per tetrahedron) lie in [5 i, 5 i + 5) degrees; the last bin includes 180.
  std::array<std::size_t, 36> all_dihedrals{};
  /// How many tetrahedra have their smallest one there; the regular tetrahedron has 70.5.
  std::array<std::size_t, 15> smallest_dihedrals{};
  /// Tetrahedra whose smallest dihedral angle is under 5 and under 10 degrees, and those of no or negative volume.
  std::size_t under_5_degrees = 0, under_10_degrees = 0, flat_or_inverted = 0;
  double shortest_edge = 0, longest_edge = 0;
  /// The edges of all tetrahedra, so that an edge counts as often as it has tetrahedra: bin i holds the lengths from
  /// `first_length` times 2^(i/2) up to the next.
  std::vector<std::size_t> edge_lengths;
  double first_length = 0;
  /// The smallest plane angle of the triangles on input facets; 0 when the mesh lists none.
  double smallest_triangle_angle = 0;
};

namespace quality_detail {

/// Finds the bin of an angle by its cosine, with a table of fine steps in the cosine that leaves at most a few to try.
class CosineBins {
 public:
  CosineBins() {
    for (std::size_t i = 0; i < bound_.size(); ++i)
      bound_[i] = std::cos(TetrahedralQuality::degrees_per_bin * static_cast<double>(i + 1) / degrees_per_radian);
    bound_.back() = -std::numeric_limits<double>::infinity();
    for (std::size_t step = 0; step < first_.size(); ++step) {
      const double largest = 1 - static_cast<double>(step) * step_width;
      while (first_[step] + 1 < bound_.size() && largest <= bound_[first_[step]]) ++first_[step];
    }
  }
  std::size_t operator()(double cosine) const {
    std::size_t bin = first_[static_cast<std::size_t>((1 - cosine) / step_width)];
    while (cosine <= bound_[bin]) ++bin;
    return bin;
  }

 private:
  static constexpr double step_width = 1.0 / 256;
  std::array<double, 36> bound_{};        ///< the cosine where a bin ends
  std::array<std::size_t, 514> first_{};  ///< the first bin for the cosines of a step
};

/// Counts of edge lengths in steps of the square root of 2, over every exponent that a squared scaled length can have.
class LengthBins {
 public:
  void count(double squared_length) {
    if (squared_length > 0) ++bins_[static_cast<std::size_t>(std::ilogb(squared_length) + lowest)];
  }
  void give(TetrahedralQuality& q, const PowerOfTwoScaling& scaling) const {
    const auto is_filled = [](std::size_t n) { return n != 0; };
    const auto first = std::ranges::find_if(bins_, is_filled);
    if (first == bins_.end()) return;
    auto last = bins_.end();
    while (*(last - 1) == 0) --last;
    q.edge_lengths.assign(first, last);
    q.first_length = scaling.original_length(std::exp2(0.5 * static_cast<double>(first - bins_.begin() - lowest)));
  }

 private:
  static constexpr int lowest = 1080;
  std::array<std::size_t, lowest + 8> bins_{};
};

inline double smallest_triangle_angle(const TetrahedralMesh& mesh, const PowerOfTwoScaling& scaling, const Control& control) {
  double smallest = mesh.triangles.empty() ? 0 : 180;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (t % 4096 == 0) throw_if_stopped(control);
    const auto& [i, j, k] = mesh.triangles[t];
    const Point3 a = scaling(mesh.points[i]), b = scaling(mesh.points[j]), c = scaling(mesh.points[k]);
    smallest = std::min({smallest, angle_degrees(b - a, c - a), angle_degrees(c - b, a - b), angle_degrees(a - c, b - c)});
  }
  return smallest;
}

}  // namespace quality_detail

/// Measures a mesh. Linear time, some 0.2 microseconds per tetrahedron; coordinates up to 1e100, with volumes up to the largest
/// double.
///
/// Requires the indices of tetrahedra and triangles to be valid. Volumes are signed: an inverted tetrahedron has a negative one.
/// Throws `Interrupted`.
inline TetrahedralQuality tetrahedral_quality(const TetrahedralMesh& mesh, const Control& control = Control{}) {
  TetrahedralQuality q;
  q.vertex_count = mesh.points.size();
  q.tetrahedron_count = mesh.tetrahedra.size();
  q.triangle_count = mesh.triangles.size();
  q.edge_count = mesh.edges.size();
  if (mesh.tetrahedra.empty()) return q;
  const PowerOfTwoScaling scaling(largest_absolute_coordinate(mesh.points));
  const std::vector<Point3> points = scaling(mesh.points);
  const auto shape_of = [&](std::size_t t) {
    const auto& [a, b, c, d] = mesh.tetrahedra[t];
    return TetrahedronMeasures(points[a], points[b], points[c], points[d]);
  };
  const quality_detail::CosineBins bin_of;
  quality_detail::LengthBins lengths;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double cosine_of_5 = std::cos(5 / degrees_per_radian), cosine_of_10 = std::cos(10 / degrees_per_radian);
  struct Extreme {
    double cosine;
    std::size_t tetrahedron = 0, edge = 0;
  } smallest{-2}, largest{2};
  double shortest = infinity, longest = 0, worst = 0;
  q.smallest_volume = infinity;
  q.largest_volume = -infinity;
  PreciseSum total;
  std::map<int, PreciseSum> sums;
  PreciseSum* sum = nullptr;
  TetrahedralQuality::Region* region = nullptr;
  int label = 0;
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    if (t % 4096 == 0) throw_if_stopped(control);
    const TetrahedronMeasures shape = shape_of(t);
    const double volume = shape.volume();
    if (const int its = mesh.regions.empty() ? 0 : mesh.regions[t]; region == nullptr || its != label) {
      label = its;
      region = &q.regions[label];
      sum = &sums[label];
    }
    ++region->tetrahedron_count;
    *sum += volume;
    total += volume;
    q.flat_or_inverted += !(volume > 0);
    q.smallest_volume = std::min(q.smallest_volume, volume);
    q.largest_volume = std::max(q.largest_volume, volume);
    for (std::size_t e = 0; e < 6; ++e) lengths.count(shape.squared_edge(e));
    shortest = std::min(shortest, shape.squared_shortest_edge());
    longest = std::max(longest, shape.squared_longest_edge());
    const double ratio = shape.squared_radius_edge();
    worst = std::max(worst, ratio);
    std::size_t bin = q.radius_edge_bins.size() - 1;
    while (bin > 0 && ratio < q.radius_edge_bins[bin] * q.radius_edge_bins[bin]) --bin;
    ++q.radius_edge[bin];
    double sharpest = -2;
    const std::array<double, 6> cosines = shape.dihedral_cosines();
    for (std::size_t e = 0; e < 6; ++e) {
      const double cosine = cosines[e];
      ++q.all_dihedrals[bin_of(cosine)];
      sharpest = std::max(sharpest, cosine);
      if (cosine > smallest.cosine) smallest = {cosine, t, e};
      if (cosine < largest.cosine) largest = {cosine, t, e};
    }
    ++q.smallest_dihedrals[std::min(bin_of(sharpest), q.smallest_dihedrals.size() - 1)];
    q.under_5_degrees += sharpest > cosine_of_5;
    q.under_10_degrees += sharpest > cosine_of_10;
  }
  q.smallest_dihedral = shape_of(smallest.tetrahedron).dihedral_angle(smallest.edge);
  q.largest_dihedral = shape_of(largest.tetrahedron).dihedral_angle(largest.edge);
  q.worst_radius_edge = std::sqrt(worst);
  q.total_volume = scaling.original_volume(total.value());
  for (auto& [name, its] : q.regions) its.volume = scaling.original_volume(sums[name].value());
  for (double* volume : {&q.smallest_volume, &q.largest_volume}) *volume = scaling.original_volume(*volume);
  q.shortest_edge = scaling.original_length(std::sqrt(shortest));
  q.longest_edge = scaling.original_length(std::sqrt(longest));
  lengths.give(q, scaling);
  q.smallest_triangle_angle = quality_detail::smallest_triangle_angle(mesh, scaling, control);
  return q;
}

}  // namespace delref
