// SPDX-License-Identifier: GPL-3.0-or-later
//
// Smooth domains by seed, for property tests: the same seed gives the same domain, and every one has a surface.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <delref/core/point.hpp>

#include "domain.hpp"

namespace delref::property_smooth {

/// A domain with what is known about it before it is meshed.
struct Input {
  std::string name;  ///< the generator, the seed, and what was done to its result
  Domain domain;
  double extent = 0;  ///< the longest side of the bounds
  /// A size of facets at which the surface has to come out right, where there is one: a part of the distance over which the
  /// gradient turns round, and of known gaps and radii. Nothing where the surface has creases.
  std::optional<double> safe_size;
  /// Points of this domain are the shift and so many times the point that the generator had.
  double scale = 1;
};

/// Negative inside.
using Function = std::function<double(Point3)>;

/// A level set of a sum of 2 to 12 Gaussians of different widths.
Input gaussians(std::uint64_t seed);
/// The same with the threshold such that the domain reaches its bounds.
Input cut_gaussians(std::uint64_t seed);
/// Unions, intersections and differences of spheres, tori and boxes, with creases where they meet.
Input solids(std::uint64_t seed);
/// Two or three overlapping functions, each vector of signs a region.
Input materials(std::uint64_t seed);
/// A random smooth field in an image with different spacings, turned or not.
Input grey_image(std::uint64_t seed);
/// Boxes of labels, some of one voxel; read as they are or smoothed.
Input labels(std::uint64_t seed);
/// A gyroid in a box.
Input gyroid(std::uint64_t seed);
/// Spheres in spheres.
Input nested_spheres(std::uint64_t seed);
/// Two or more spheres that touch, nearly touch or overlap a little.
Input touching_spheres(std::uint64_t seed);
/// A shell with a thickness of 1/100 to 1/10 of its radius.
Input thin_shell(std::uint64_t seed);
/// 30 to 100 small spheres apart from each other.
Input many_spheres(std::uint64_t seed);
/// A sphere or a torus whose function is not a number in some ball or half-space.
Input not_a_number(std::uint64_t seed);
/// Tori with one to five holes, linked or apart.
Input tori(std::uint64_t seed);

/// The generators by turns, each time with another seed; two thirds of the results are scaled by 1e-6 to 1e6, and some of these moved up
/// to a million times their size away.
Input generate(std::uint64_t seed);
/// A domain made by hand, as much larger as `scale` says.
Input implicit(std::string name, const Function& f, const BoundingBox3& bounds, double scale = 1);
/// How many generators there are.
std::size_t generator_count();

}  // namespace delref::property_smooth
