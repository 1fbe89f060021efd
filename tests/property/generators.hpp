// SPDX-License-Identifier: GPL-3.0-or-later
//
// Planar straight line graphs by seed, for property tests: the same seed gives the same graph, and every graph is valid (no two
// segments cross or overlap, no vertex lies inside a segment unless the generator says so, a bounded region is left).
// tests/unit/mesh/generators_test.cpp asserts that with exact predicates.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include <delref/domain/pslg.hpp>

namespace delref::property {

/// Vigna's splitmix64 (public domain; Steele, Lea, Flood 2014). The distributions of <random> differ between libraries; these do not.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }
  /// In [0, 1), with 53 random bits.
  double uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  double uniform(double from, double to) { return from + (to - from) * uniform(); }
  /// From `least` to `most`, both possible.
  int integer(int least, int most) { return least + static_cast<int>(next() % static_cast<std::uint64_t>(most - least + 1)); }
  bool chance(double probability) { return uniform() < probability; }

 private:
  std::uint64_t state_;
};

/// A star-shaped polygon with spikes, 5 to 60 corners.
Pslg star(std::uint64_t seed);
/// Teeth down to a thousandth of the width.
Pslg comb(std::uint64_t seed);
/// A band wound up 1 to 5 times.
Pslg spiral(std::uint64_t seed);
/// Segments from one vertex in a box, with angles between them from tens of degrees down to 1e-9.
Pslg fan(std::uint64_t seed);
/// A triangle with an angle from 30 down to 1e-9 degrees.
Pslg needle(std::uint64_t seed);
/// A polygon whose edges were broken up by displaced midpoints, with islands: to some 300 edges.
Pslg coast(std::uint64_t seed);
/// Rings in rings, every second one a hole.
Pslg nested_holes(std::uint64_t seed);
/// Segments in a square, apart from each other by at least a thousandth of its side.
Pslg disjoint_segments(std::uint64_t seed);
/// Open polylines in a square, some hanging from its boundary.
Pslg slits(std::uint64_t seed);
/// Holes that touch the outer boundary at a vertex, with their angles there.
Pslg touching_holes(std::uint64_t seed);
/// A square with vertices that no segment uses.
Pslg isolated_vertices(std::uint64_t seed);
/// A star-shaped coast with segments of 1e-14 and spikes of 1e-11 degrees.
Pslg dirty_coast(std::uint64_t seed);
/// A jittered grid of cells with labels and area bounds; some cells are holes, some have no seed.
Pslg region_grid(std::uint64_t seed);
/// A square with segments that end in the inside of other segments.
Pslg tees(std::uint64_t seed);

struct Generator {
  const char* name;
  Pslg (*make)(std::uint64_t seed);
  /// Vertices inside segments are part of it (`tees`).
  bool has_vertices_in_segments = false;
};

/// All of the above.
std::span<const Generator> generators();

struct NamedPslg {
  std::string name;  ///< the generator and the seed
  Pslg pslg;
};

/// The generators by turns: number `seed % generators().size()`, with that seed.
NamedPslg generate(std::uint64_t seed);

}  // namespace delref::property
