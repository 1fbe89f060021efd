// SPDX-License-Identifier: GPL-3.0-or-later
//
// The surfaces that benchmarks/smooth/ measures on, as functions that are negative inside, with their gradients: mathematics that
// every mesher and the measuring program are given alike. After them, what the command lines of the drivers have in common.
#pragma once

#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>

namespace benchmark {

struct Vector {
  double x = 0, y = 0, z = 0;
};

/// The unit sphere.
struct Sphere {
  static constexpr double half_width = 1.25;   ///< of an upright cube about the origin that holds the surface
  static constexpr Vector inside{0.01, 0, 0};  ///< a point with a negative value
  static double value(Vector p) { return p.x * p.x + p.y * p.y + p.z * p.z - 1; }
  static Vector gradient(Vector p) { return {2 * p.x, 2 * p.y, 2 * p.z}; }
};

/// The torus of radii 1 and 0.4.
struct Torus {
  static constexpr double half_width = 1.75;
  static constexpr Vector inside{1, 0, 0};
  static double value(Vector p) {
    const double s = shifted_square(p);
    return s * s - 4 * (p.x * p.x + p.y * p.y);
  }
  static Vector gradient(Vector p) {
    const double s = shifted_square(p);
    return {4 * p.x * (s - 2), 4 * p.y * (s - 2), 4 * p.z * s};
  }

 private:
  static double shifted_square(Vector p) { return p.x * p.x + p.y * p.y + p.z * p.z + (1 - 0.4 * 0.4); }
};

/// The tangle cube, of genus 5.
struct Tangle {
  static constexpr double half_width = 3;
  static constexpr Vector inside{1.5, 1.5, 1.5};
  static double value(Vector p) { return well(p.x) + well(p.y) + well(p.z) + 11.8; }
  static Vector gradient(Vector p) { return {slope(p.x), slope(p.y), slope(p.z)}; }

 private:
  static double well(double t) { return t * t * (t * t - 5); }
  static double slope(double t) { return t * (4 * t * t - 10); }
};

/// Calls `visit` with the surface of a name; false when none has it.
template <class Visit>
bool visit_surface(std::string_view name, Visit&& visit) {
  if (name == "sphere") return visit(Sphere{}), true;
  if (name == "torus") return visit(Torus{}), true;
  if (name == "tangle") return visit(Tangle{}), true;
  return false;
}

/// What the first word of a command line names when it is no surface: a grey image and the value of a level set of it.
struct LevelSet {
  std::string image;
  float value = 0;
};

/// Takes "IMAGE:VALUE" apart. The level set bounds what is above the value.
inline LevelSet level_set(std::string_view text) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string_view::npos)
    throw std::invalid_argument("sphere, torus, tangle or IMAGE:VALUE expected: " + std::string(text));
  return {std::string(text.substr(0, colon)), std::strtof(std::string(text.substr(colon + 1)).c_str(), nullptr)};
}

/// The command line of every driver: DOMAIN FACET_ANGLE FACET_SIZE FACET_DISTANCE RADIUS_EDGE CELL_SIZE OUT.
/// 0 is no bound; without the two bounds on tetrahedra the surface alone is meshed.
struct CommandLine {
  std::string_view domain;
  double facet_angle, facet_size, facet_distance, radius_edge, cell_size;
  std::string_view out;  ///< a .mesh file, or "-" for none

  explicit CommandLine(char** a)
      : domain(a[1]),
        facet_angle(std::atof(a[2])),
        facet_size(std::atof(a[3])),
        facet_distance(std::atof(a[4])),
        radius_edge(std::atof(a[5])),
        cell_size(std::atof(a[6])),
        out(a[7]) {}

  bool surface_only() const { return radius_edge == 0 && cell_size == 0; }
};

}  // namespace benchmark
