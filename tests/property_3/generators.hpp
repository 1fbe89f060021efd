// SPDX-License-Identifier: GPL-3.0-or-later
//
// Piecewise linear complexes by seed, for property tests: the same seed gives the same complex, and every complex is valid.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <delref/domain/plc.hpp>

namespace delref::property_3 {

/// A complex, and the volume of its domain where that is known without a mesh.
struct Complex {
  Plc plc;
  std::optional<double> volume;
};

/// The convex hull of 4 to 24 points, in triangles.
Complex hull(std::uint64_t seed);
/// A star-shaped polygon, extruded.
Complex prism(std::uint64_t seed);
/// The same, cut into wedges by facets from its axis to its corners, each a region.
Complex divided_prism(std::uint64_t seed);
/// A pyramid over a star-shaped polygon, from flat to a spike.
Complex pyramid(std::uint64_t seed);
/// A prism over a triangle with an angle of 5 to 60 degrees.
Complex wedge(std::uint64_t seed);
/// Boxes in boxes; what is between two is a region, a hole or nothing said.
Complex nested_boxes(std::uint64_t seed);
/// A grid of boxes with labels and volume bounds; some are holes.
Complex grid(std::uint64_t seed);
/// A box with a rectangle in it that floats, or stands on the bottom, or is tilted.
Complex slit(std::uint64_t seed);
/// Rectangles that share an edge, at 5 degrees or more, in a box.
Complex fan(std::uint64_t seed);
/// A box with a thickness of a tenth or so of its width, in triangles or not.
Complex plate(std::uint64_t seed);
/// A sphere in triangles, each of those of an icosahedron cut up to twice.
Complex sphere(std::uint64_t seed);
/// A box with vertices and segments in it that no facet has.
Complex loose_parts(std::uint64_t seed);

struct NamedComplex {
  std::string name;  ///< the generator and the seed
  Complex complex;
};

/// The generators by turns, each time with another seed; most results are turned, scaled by 1e-6 to 1e6, and some moved a million
/// times their size away.
NamedComplex generate(std::uint64_t seed);
/// How many generators there are.
std::size_t generator_count();

// Parts, for complexes made by hand.

/// Adds the facet of one polygon; vertices that are there already are used again.
void add_facet(Plc& plc, const std::vector<Point3>& polygon, int marker = 0);
/// Adds a box of six facets, marked 1 to 6 more than `marker`.
void add_box(Plc& plc, Point3 low, Point3 high, int marker = 0);
/// Every polygon of three or more corners cut into triangles from its first corner; for convex facets of one polygon.
Plc in_triangles(const Plc& plc);
/// An icosahedron's triangles, each cut into four so many times, on the sphere of radius 1.
Plc icosphere(int cuts);
/// The volume that triangles enclose when they are seen counterclockwise from outside.
double enclosed_volume(const Plc& plc);
/// Turned by a rotation that the seed gives, then scaled, then moved.
Plc moved(Plc plc, std::uint64_t seed, double scale, Vector3 shift);

}  // namespace delref::property_3
