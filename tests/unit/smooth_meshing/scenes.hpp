// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the tests of smooth meshing mesh: plain oracles, and triangulations to start from.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <delref/core/point.hpp>
#include <delref/domain/bounding_box_3.hpp>
#include <delref/domain/oracle.hpp>

namespace delref {

/// The region of each point by a function; crossings by bisection. It throws when it is asked about what is out of bounds.
struct Regions3 {
  std::function<int(Point3)> region;
  BoundingBox3 box{{-2, -2, -2}, {2, 2, 2}};
  std::vector<int> names{};

  struct AskedOutOfBounds {
    Point3 where;
  };

  BoundingBox3 bounds() const { return box; }
  void label(std::span<const Point3> points, std::span<int> labels) const {
    for (std::size_t i = 0; i < points.size(); ++i) labels[i] = at(points[i]);
  }
  Point3 crossing(Point3 a, Point3 b, int label_a, double tolerance) const {
    double from = 0, to = 1;
    const double length = std::sqrt(squared_distance(a, b));
    while ((to - from) * length > tolerance && to - from > 1e-15) {
      const double middle = 0.5 * (from + to);
      (at(a + middle * (b - a)) == label_a ? from : to) = middle;
    }
    return a + 0.5 * (from + to) * (b - a);
  }
  std::vector<int> region_labels() const { return names; }

 private:
  int at(Point3 p) const {
    const auto& [low, high] = box;
    if (p.x < low.x || p.x > high.x || p.y < low.y || p.y > high.y || p.z < low.z || p.z > high.z) throw AskedOutOfBounds{p};
    return region(p);
  }
};
static_assert(Oracle<Regions3>);

inline double radius(Point3 p) { return std::sqrt(squared_distance(p, Point3{})); }

/// Eight vertices far around the bounds, as the mesher has them.
template <class Tr>
void start(Tr& tr, const BoundingBox3& b) {
  const Vector3 side = b.high - b.low;
  const Point3 low = b.low + -1.0 * side, high = b.high + side;
  for (std::uint32_t i = 0; i < 8; ++i) {
    const auto v = tr.cgal().insert(typename Tr::Cgal::Point((i & 1) ? high.x : low.x, (i & 2) ? high.y : low.y, (i & 4) ? high.z : low.z));
    v->index = i;
  }
  tr.number_from(8);
}
/// A vertex on the surface.
template <class Tr>
typename Tr::Vertex insert_seed(Tr& tr, Point3 p) {
  typename Tr::Zone zone;
  if (tr.conflict_zone(p, typename Tr::Hint(tr.infinite_cell()), zone).kind != Location<Tr>::Kind::zone) return {};
  const auto v = tr.insert(p, zone);
  tr.set_origin(v, {2, 0}, input_level);
  return v;
}

}  // namespace delref
