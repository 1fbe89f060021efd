// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which point kills a triangle: the policies of the planar faces level.
#pragma once

#include <cmath>
#include <concepts>

#include <delref/criteria/angle_bound.hpp>
#include <delref/criteria/circumcentre.hpp>
#include <delref/criteria/triangle_shape.hpp>

namespace delref {

/// A point policy: `point(shape)` gives a point strictly inside the triangle's circumcircle.
template <class P>
concept PointChoice2 = std::copy_constructible<P> && requires(const P& policy, const TriangleShape& shape) {
  { policy.point(shape) } -> std::same_as<Point2>;
};

/// Fails to compile with a sentence when `P` is no point policy.
template <class P>
consteval bool explain_point_choice() {
  static_assert(PointChoice2<P>,
                "a point policy needs: point(shape) const that gives a delref::Point2 for a delref::TriangleShape; and to be copy "
                "constructible");
  return PointChoice2<P>;
}

/// The centre of the circumcircle. Not finite when the triangle is flat.
struct Circumcentre {
  Point2 point(const TriangleShape& t) const { return t.corners[0] + offset(t, 0); }

  /// The circumcentre less corner `i`.
  static Vector2 offset(const TriangleShape& t, std::size_t i) {
    const Vector2 u = t.corners[(i + 1) % 3] - t.corners[i], v = t.corners[(i + 2) % 3] - t.corners[i];
    return to_circumcentre(u, v, t.doubled_area);
  }
};

/// The off-centre of Ungor (2004): on the bisector of the shortest edge, no farther from it than where a new vertex makes a triangle
/// that just meets the angle bound with that edge. Fewer vertices than the circumcentre.
class OffCentre {
 public:
  /// `reach` < 1 puts the point a little nearer than the bound asks, so that the new triangle meets it in spite of rounding.
  explicit OffCentre(AngleBound bound, double reach = 0.95) {
    const double cosine = std::sqrt(1 - bound.squared_sine());
    height_ = 0.5 * reach * std::sqrt((1 + cosine) / (1 - cosine));
  }

  Point2 point(const TriangleShape& t) const {
    // From the middle of the shortest edge towards the circumcentre, in units of that edge.
    const Point2 p = t.corners[(t.shortest + 1) % 3], q = t.corners[(t.shortest + 2) % 3];
    const Vector2 centre = Circumcentre::offset(t, (t.shortest + 1) % 3);
    const Vector2 edge = q - p;
    const Vector2 off = 0.5 * edge + height_ * Vector2{-edge.y, edge.x};
    return p + (squared_length(off) < squared_length(centre) && dot(Vector2{-edge.y, edge.x}, centre) > 0 ? off : centre);
  }

 private:
  double height_;  // infinite for a bound of 0: the circumcentre is then taken
};

}  // namespace delref
