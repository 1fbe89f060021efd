// SPDX-License-Identifier: GPL-3.0-or-later
//
// How the zero set of a trilinear function runs through one cube of an image: which of the cube's edges that it crosses are joined by
// it, on the faces and inside. On a face the curves are hyperbolas, and the sign at their saddle decides which crossings are joined
// (Nielson and Hamann, "The asymptotic decider", 1991). Inside, two closed curves of the faces may bound a tunnel (Chernyaev,
// "Marching cubes 33", 1995; Nielson, "On marching cubes", 2003). No table of cases is used here: the cube is cut into slices, whose
// curves are hyperbolas too, and the slices' crossings belong to curves of the side faces. Curves change partners only where a corner
// of the slice or its saddle changes sign, so one slice between every two such heights shows all that is joined.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace delref::detail {

/// Corners are numbered by bits: 1 for x, 2 for y, 4 for z. Edges 0 to 3 run along x, 4 to 7 along y, 8 to 11 along z; within each
/// four by the bits of the two other coordinates, the lower one first.
struct TrilinearCube {
  static constexpr std::array<std::array<int, 2>, 12> edge_corners{
      {{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3}, {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};
  struct Face {
    std::array<int, 4> corners;  // around it
    std::array<int, 4> edges;    // the edge i joins the corners i and i + 1
  };
  /// The four sides, of which side i stands on the edge from bottom corner i to i + 1, then bottom and top.
  static constexpr std::array<Face, 6> faces{{{{0, 1, 5, 4}, {0, 9, 2, 8}},
                                              {{1, 3, 7, 5}, {5, 11, 7, 9}},
                                              {{3, 2, 6, 7}, {1, 10, 3, 11}},
                                              {{2, 0, 4, 6}, {4, 8, 6, 10}},
                                              {{0, 1, 3, 2}, {0, 5, 1, 4}},
                                              {{4, 5, 7, 6}, {2, 7, 3, 6}}}};

  static constexpr int none = -1;
  /// For each crossed edge the lowest crossed edge that the zero set joins it with inside the cube; `none` for edges that it does not cross.
  std::array<int, 12> piece{};
  /// For the lowest edge of each piece, the number of closed curves on the faces that bound it: 1 for a disk, 2 for a tube; 0 for other
  /// edges.
  std::array<int, 12> curves_of{};

  /// Requires numbers that are not NaN; zero counts as positive. Pairs that meet in a saddle of value zero count as joined through
  /// what is positive, on each of two cubes that share a face.
  explicit TrilinearCube(const std::array<double, 8>& value) : value_(value) {
    for (std::size_t e = 0; e != 12; ++e) piece[e] = crossed(static_cast<int>(e)) ? static_cast<int>(e) : none;
    for (const Face& face : faces) join_on(face);
    std::array<bool, 12> is_curve{};
    int curves = 0;
    for (std::size_t e = 0; e != 12; ++e) curves += is_curve[e] = piece[e] == static_cast<int>(e);
    if (curves > 1) join_inside();
    for (std::size_t e = 0; e != 12; ++e) {
      if (piece[e] < 0) continue;
      piece[e] = root(static_cast<int>(e));
      if (is_curve[e]) ++curves_of[static_cast<std::size_t>(piece[e])];
    }
  }

 private:
  bool positive(int corner) const { return value_[static_cast<std::size_t>(corner)] >= 0; }
  bool crossed(int edge) const {
    const auto [a, b] = edge_corners[static_cast<std::size_t>(edge)];
    return positive(a) != positive(b);
  }
  int root(int edge) const {
    while (piece[static_cast<std::size_t>(edge)] != edge) edge = piece[static_cast<std::size_t>(edge)];
    return edge;
  }
  void join(int a, int b) {
    a = root(a), b = root(b);
    piece[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
  }

  /// Joins the things on the four sides of a square that cross its zero curves. The corners are around it; side i is from i to i + 1.
  void join_across(const std::array<double, 4>& corner, const std::array<bool, 4>& plus, const std::array<int, 4>& side) {
    if (plus[0] == plus[2] && plus[1] == plus[3] && plus[0] != plus[1]) {
      const bool even_joined = plus[0] ? corner[0] * corner[2] >= corner[1] * corner[3] : corner[0] * corner[2] > corner[1] * corner[3];
      // A curve runs around each of the two corners that are not joined through the middle.
      join(side[even_joined ? 0 : 3], side[even_joined ? 1 : 0]);
      join(side[even_joined ? 2 : 1], side[even_joined ? 3 : 2]);
      return;
    }
    int first = -1;
    for (std::size_t i = 0; i != 4; ++i) {
      if (plus[i] == plus[(i + 1) % 4]) continue;
      if (first >= 0) join(first, side[i]);
      first = side[i];
    }
  }

  void join_on(const Face& face) {
    std::array<double, 4> corner{};
    std::array<bool, 4> plus{};
    for (std::size_t i = 0; i != 4; ++i) {
      corner[i] = value_[static_cast<std::size_t>(face.corners[i])];
      plus[i] = positive(face.corners[i]);
    }
    join_across(corner, plus, face.edges);
  }

  /// The heights between 0 and 1 at which a corner of the slice or its saddle changes sign, after 0 and before one or more 1, sorted.
  std::array<double, 8> heights() const {
    std::array<double, 8> height{0, 1, 1, 1, 1, 1, 1, 1};
    const auto add = [&](double z) {
      if (!(z > 0 && z < 1)) return;
      for (double& h : height) {
        if (z < h) std::swap(z, h);
      }
    };
    std::array<double, 4> b{}, d{};
    for (std::size_t i = 0; i != 4; ++i) {
      const double top = value_[static_cast<std::size_t>(bottom[i]) + 4];
      b[i] = value_[static_cast<std::size_t>(bottom[i])];
      d[i] = top - b[i];
      if ((b[i] >= 0) != (top >= 0)) add(b[i] / -d[i]);
    }
    // The product of one diagonal's corners less that of the other's: p z^2 + q z + r.
    const double p = d[0] * d[2] - d[1] * d[3], q = b[0] * d[2] + d[0] * b[2] - b[1] * d[3] - d[1] * b[3], r = b[0] * b[2] - b[1] * b[3];
    const double discriminant = q * q - 4 * p * r;
    if (discriminant >= 0) {
      const double w = -0.5 * (q + std::copysign(std::sqrt(discriminant), q));
      if (p != 0) add(w / p);
      if (w != 0) add(r / w);
    }
    return height;
  }

  void join_inside() {
    const std::array<double, 8> height = heights();
    for (std::size_t i = 1; i != height.size(); ++i) {
      if (height[i] > height[i - 1]) join_in_slice(0.5 * height[i - 1] + 0.5 * height[i]);
    }
  }

  void join_in_slice(double z) {
    std::array<double, 4> corner{};
    std::array<bool, 4> plus{}, low{}, high{};
    for (std::size_t i = 0; i != 4; ++i) {
      const double b = value_[static_cast<std::size_t>(bottom[i])], t = value_[static_cast<std::size_t>(bottom[i]) + 4];
      corner[i] = (1 - z) * b + z * t;
      low[i] = b >= 0, high[i] = t >= 0;
      plus[i] = low[i] == high[i] ? low[i] : corner[i] >= 0;
    }
    std::array<int, 4> side{-1, -1, -1, -1};
    for (std::size_t i = 0; i != 4; ++i) {
      const std::size_t j = (i + 1) % 4;
      if (plus[i] == plus[j]) continue;
      // A side face has one curve, which every crossed edge of it is on, or two, of which one goes through its bottom edge where the
      // signs are those of the bottom.
      const std::array<int, 4>& edges = faces[i].edges;
      if (low[i] != low[j] && high[i] != high[j] && low[i] != high[i])
        side[i] = plus[i] == low[i] ? edges[0] : edges[2];
      else
        side[i] = *std::ranges::find_if(edges, [&](int e) { return crossed(e); });
    }
    join_across(corner, plus, side);
  }

  /// The bottom's corners, around it.
  static constexpr std::array<int, 4> bottom{0, 1, 3, 2};
  std::array<double, 8> value_;
};

}  // namespace delref::detail
