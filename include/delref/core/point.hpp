// SPDX-License-Identifier: MIT
//
// Points and vectors of the plane and of space, as every level, criterion and file format of delref sees them. Bare coordinates: what a
// point lies on and who made it are kept by the triangulation, per vertex. The operators are hidden friends, so that they are
// found through a module import too.
#pragma once

#include <cmath>

namespace delref {

/// A difference of two points of the plane.
struct Vector2 {
  double x = 0, y = 0;

  friend constexpr bool operator==(const Vector2&, const Vector2&) = default;
  friend constexpr Vector2 operator+(Vector2 a, Vector2 b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Vector2 operator-(Vector2 a, Vector2 b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr Vector2 operator*(double s, Vector2 a) { return {s * a.x, s * a.y}; }
  /// The scalar product.
  friend constexpr double dot(Vector2 a, Vector2 b) { return a.x * b.x + a.y * b.y; }
  /// Twice the signed area of the triangle that the two vectors span; positive when `b` is to the left of `a`. Inexact.
  friend constexpr double cross(Vector2 a, Vector2 b) { return a.x * b.y - a.y * b.x; }
  friend constexpr double squared_length(Vector2 a) { return dot(a, a); }
};

/// A point of the plane, in the unit of the input.
struct Point2 {
  double x = 0, y = 0;

  friend constexpr bool operator==(const Point2&, const Point2&) = default;
  friend constexpr Vector2 operator-(Point2 a, Point2 b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr Point2 operator+(Point2 a, Vector2 v) { return {a.x + v.x, a.y + v.y}; }
  friend constexpr double squared_distance(Point2 a, Point2 b) { return squared_length(a - b); }
  friend constexpr Point2 midpoint(Point2 a, Point2 b) { return {0.5 * a.x + 0.5 * b.x, 0.5 * a.y + 0.5 * b.y}; }
  /// False when a coordinate is infinite or not a number.
  friend bool is_finite(Point2 a) { return std::isfinite(a.x) && std::isfinite(a.y); }
};

/// A difference of two points of space.
struct Vector3 {
  double x = 0, y = 0, z = 0;

  friend constexpr bool operator==(const Vector3&, const Vector3&) = default;
  friend constexpr Vector3 operator+(Vector3 a, Vector3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend constexpr Vector3 operator-(Vector3 a, Vector3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend constexpr Vector3 operator*(double s, Vector3 a) { return {s * a.x, s * a.y, s * a.z}; }
  /// The scalar product.
  friend constexpr double dot(Vector3 a, Vector3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
  /// Orthogonal to both; its length is twice the area of the triangle that they span. Inexact.
  friend constexpr Vector3 cross(Vector3 a, Vector3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
  friend constexpr double squared_length(Vector3 a) { return dot(a, a); }
};

/// A point of space, in the unit of the input.
struct Point3 {
  double x = 0, y = 0, z = 0;

  friend constexpr bool operator==(const Point3&, const Point3&) = default;
  friend constexpr Vector3 operator-(Point3 a, Point3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend constexpr Point3 operator+(Point3 a, Vector3 v) { return {a.x + v.x, a.y + v.y, a.z + v.z}; }
  friend constexpr double squared_distance(Point3 a, Point3 b) { return squared_length(a - b); }
  friend constexpr Point3 midpoint(Point3 a, Point3 b) {
    return {0.5 * a.x + 0.5 * b.x, 0.5 * a.y + 0.5 * b.y, 0.5 * a.z + 0.5 * b.z};
  }
  /// False when a coordinate is infinite or not a number.
  friend bool is_finite(Point3 a) { return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z); }
};

/// A bound on how far rounding may put a computed point from where it should be.
inline double rounding_near(Point2 p) { return 4e-16 * (std::abs(p.x) + std::abs(p.y)); }
inline double rounding_near(Point3 p) { return 4e-16 * (std::abs(p.x) + std::abs(p.y) + std::abs(p.z)); }

}  // namespace delref
