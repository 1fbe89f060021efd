// SPDX-License-Identifier: MIT
//
// Points and vectors of the plane, as every level, criterion and file format of delref sees them. Bare coordinates: what a
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

}  // namespace delref
