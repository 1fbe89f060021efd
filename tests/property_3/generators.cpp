// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <utility>

#include <delref/core/point.hpp>
#include <delref/domain/facet_frame.hpp>

#include "../property/generators.hpp"  // for its random numbers alone

namespace delref::property_3 {
namespace {

using property::Random;
using Index = Plc::Index;
constexpr double pi = std::numbers::pi;

Index vertex(Plc& p, Point3 at) {
  const auto found = std::ranges::find(p.points, at);
  if (found != p.points.end()) return static_cast<Index>(found - p.points.begin());
  p.points.push_back(at);
  return static_cast<Index>(p.points.size() - 1);
}

double log_uniform(Random& random, double from, double to) { return std::exp(random.uniform(std::log(from), std::log(to))); }

/// Corners in the order of their angle around the origin, counterclockwise; every one is seen from there.
std::vector<Point2> star_corners(Random& random, int n, double inner) {
  std::vector<Point2> corners;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * pi * (i + random.uniform(-0.35, 0.35)) / n, radius = random.uniform(inner, 1);
    corners.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return corners;
}
double area(const std::vector<Point2>& corners) {
  double sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) sum += 0.5 * cross(corners[i] - Point2{}, corners[(i + 1) % corners.size()] - Point2{});
  return sum;
}
std::vector<Point3> at_height(const std::vector<Point2>& corners, double z) {
  std::vector<Point3> result;
  for (const Point2 c : corners) result.push_back({c.x, c.y, z});
  return result;
}
Plc extruded(const std::vector<Point2>& corners, double height) {
  Plc p;
  add_facet(p, at_height(corners, 0), 1);
  add_facet(p, at_height(corners, height), 2);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point2 a = corners[i], b = corners[(i + 1) % corners.size()];
    add_facet(p, {{a.x, a.y, 0}, {b.x, b.y, 0}, {b.x, b.y, height}, {a.x, a.y, height}}, 3 + static_cast<int>(i));
  }
  return p;
}
std::array<Vector3, 3> rotation(std::uint64_t seed) {
  Random random(seed);
  const auto direction = [&] {
    while (true) {
      const Vector3 d{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
      if (const double l = squared_length(d); l > 0.01 && l < 1) return unit(d);
    }
  };
  const Vector3 u = direction();
  Vector3 w = cross(u, direction());
  while (squared_length(w) < 0.01) w = cross(u, direction());
  w = unit(w);
  return {u, cross(w, u), w};
}

}  // namespace

void add_facet(Plc& plc, const std::vector<Point3>& polygon, int marker) {
  Plc::Facet facet;
  facet.polygons.emplace_back();
  for (const Point3 q : polygon) facet.polygons.back().push_back(vertex(plc, q));
  facet.marker = marker;
  plc.facets.push_back(std::move(facet));
}

void add_box(Plc& plc, Point3 a, Point3 b, int marker) {
  add_facet(plc, {{a.x, a.y, a.z}, {a.x, b.y, a.z}, {b.x, b.y, a.z}, {b.x, a.y, a.z}}, marker + 1);
  add_facet(plc, {{a.x, a.y, b.z}, {b.x, a.y, b.z}, {b.x, b.y, b.z}, {a.x, b.y, b.z}}, marker + 2);
  add_facet(plc, {{a.x, a.y, a.z}, {b.x, a.y, a.z}, {b.x, a.y, b.z}, {a.x, a.y, b.z}}, marker + 3);
  add_facet(plc, {{b.x, a.y, a.z}, {b.x, b.y, a.z}, {b.x, b.y, b.z}, {b.x, a.y, b.z}}, marker + 4);
  add_facet(plc, {{b.x, b.y, a.z}, {a.x, b.y, a.z}, {a.x, b.y, b.z}, {b.x, b.y, b.z}}, marker + 5);
  add_facet(plc, {{a.x, b.y, a.z}, {a.x, a.y, a.z}, {a.x, a.y, b.z}, {a.x, b.y, b.z}}, marker + 6);
}

Plc in_triangles(const Plc& plc) {
  Plc result = plc;
  result.facets.clear();
  for (const Plc::Facet& f : plc.facets)
    for (const auto& polygon : f.polygons)
      for (std::size_t k = 2; k < polygon.size(); ++k) {
        Plc::Facet triangle;
        triangle.polygons = {{polygon[0], polygon[k - 1], polygon[k]}};
        triangle.marker = f.marker;
        result.facets.push_back(std::move(triangle));
      }
  return result;
}

Plc icosphere(int cuts) {
  const double g = std::numbers::phi;
  std::vector<Vector3> corners;
  for (const double a : {-1.0, 1.0})
    for (const double b : {-g, g}) {
      corners.push_back(unit({0, a, b}));
      corners.push_back(unit({a, b, 0}));
      corners.push_back(unit({b, 0, a}));
    }
  std::vector<std::array<Vector3, 3>> triangles;
  for (std::size_t i = 0; i < 12; ++i)
    for (std::size_t j = i + 1; j < 12; ++j)
      for (std::size_t k = j + 1; k < 12; ++k) {
        const Vector3 a = corners[i], b = corners[j], c = corners[k];
        if (std::min({dot(a, b), dot(b, c), dot(c, a)}) < 0.4) continue;  // neighbours have 0.447
        if (dot(a, cross(b, c)) > 0) triangles.push_back({a, b, c});
        else triangles.push_back({a, c, b});
      }
  for (int cut = 0; cut < cuts; ++cut) {
    std::vector<std::array<Vector3, 3>> finer;
    for (const auto& [a, b, c] : triangles) {
      const Vector3 ab = unit(a + b), bc = unit(b + c), ca = unit(c + a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    triangles = std::move(finer);
  }
  Plc p;
  for (const auto& [a, b, c] : triangles) add_facet(p, {Point3{} + a, Point3{} + b, Point3{} + c}, 1);
  return p;
}

double enclosed_volume(const Plc& plc) {
  double sum = 0;
  const Point3 o = plc.points.front();
  for (const Plc::Facet& f : plc.facets) {
    const auto& q = f.polygons.front();
    sum += dot(plc.points[q[0]] - o, cross(plc.points[q[1]] - o, plc.points[q[2]] - o)) / 6;
  }
  return sum;
}

Plc moved(Plc plc, std::uint64_t seed, double scale, Vector3 shift) {
  const auto [u, v, w] = rotation(seed);
  const auto move = [&](Point3& p) { p = Point3{} + shift + scale * (p.x * u + p.y * v + p.z * w); };
  for (Point3& p : plc.points) move(p);
  for (Point3& p : plc.holes) move(p);
  for (Plc::Facet& f : plc.facets)
    for (Point3& p : f.holes) move(p);
  for (Plc::Region& r : plc.regions) {
    move(r.seed);
    r.max_volume *= scale * scale * scale;
  }
  return plc;
}

// A triangle is on the hull when all other points are on one side of it. In general position but for a chance that does not happen.
Complex hull(std::uint64_t seed) {
  Random random(seed);
  const int n = random.integer(4, 24);
  std::vector<Point3> points;
  for (int i = 0; i < n; ++i) {
    const auto u = rotation(random.next())[0];
    points.push_back(Point3{} + random.uniform(0.7, 1) * u);
  }
  Complex c;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j)
      for (std::size_t k = j + 1; k < points.size(); ++k) {
        const Vector3 normal = cross(points[j] - points[i], points[k] - points[i]);
        int above = 0, below = 0;
        for (std::size_t l = 0; l < points.size(); ++l)
          if (l != i && l != j && l != k) ++(dot(normal, points[l] - points[i]) > 0 ? above : below);
        if (above == 0) add_facet(c.plc, {points[i], points[j], points[k]}, 1);
        if (below == 0) add_facet(c.plc, {points[i], points[k], points[j]}, 2);
      }
  c.volume = enclosed_volume(c.plc);
  return c;
}

Complex prism(std::uint64_t seed) {
  Random random(seed);
  const auto corners = star_corners(random, random.integer(5, 14), random.uniform(0.3, 0.9));
  const double height = log_uniform(random, 0.2, 3);
  return {extruded(corners, height), area(corners) * height};
}

Complex divided_prism(std::uint64_t seed) {
  Random random(seed);
  const int n = random.integer(5, 10);
  const auto corners = star_corners(random, n, random.uniform(0.5, 0.9));
  const double height = log_uniform(random, 0.3, 2);
  Complex c{extruded(corners, height), area(corners) * height};
  const Point3 low{0, 0, 0}, high{0, 0, height};
  const Index bottom = vertex(c.plc, low), top = vertex(c.plc, high);
  for (int i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (i > 1 && random.chance(0.4)) continue;
    const Point3 a{corners[k].x, corners[k].y, 0}, b{a.x, a.y, height};
    add_facet(c.plc, {low, a, b, high}, 100 + i);
    c.plc.facets[0].polygons.push_back({bottom, vertex(c.plc, a)});
    c.plc.facets[1].polygons.push_back({top, vertex(c.plc, b)});
    if (i == 0) {
      const Point2 next = corners[1];
      c.plc.regions.push_back({{(a.x + next.x) / 4, (a.y + next.y) / 4, height / 2}, 7, 0.05 * *c.volume});
    }
  }
  return c;
}

Complex pyramid(std::uint64_t seed) {
  Random random(seed);
  const auto corners = star_corners(random, random.integer(4, 9), random.uniform(0.5, 0.9));
  const double height = log_uniform(random, 0.3, 8);
  Complex c;
  add_facet(c.plc, at_height(corners, 0), 1);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point2 a = corners[i], b = corners[(i + 1) % corners.size()];
    add_facet(c.plc, {{a.x, a.y, 0}, {b.x, b.y, 0}, {0, 0, height}}, 2);
  }
  c.volume = area(corners) * height / 3;
  return c;
}

Complex wedge(std::uint64_t seed) {
  Random random(seed);
  const double angle = log_uniform(random, 5, 60) * pi / 180, length = random.uniform(0.7, 1), height = log_uniform(random, 0.2, 2);
  const std::vector<Point2> corners{{0, 0}, {1, 0}, {length * std::cos(angle), length * std::sin(angle)}};
  Complex c{extruded(corners, height), area(corners) * height};
  if (random.chance(0.5)) c.plc = in_triangles(c.plc);
  return c;
}

Complex nested_boxes(std::uint64_t seed) {
  Random random(seed);
  Complex c;
  const int boxes = random.integer(2, 4);
  Point3 low{0, 0, 0}, high{random.uniform(1, 3), random.uniform(1, 3), random.uniform(1, 3)};
  double sum = 0;
  for (int i = 0; i < boxes; ++i) {
    const Vector3 size = high - low;
    add_box(c.plc, low, high, 10 * i);
    const auto inside = [&](double from, double to, double length) { return random.uniform(from, to) * length; };
    const Point3 a = low + Vector3{inside(0.1, 0.3, size.x), inside(0.1, 0.3, size.y), inside(0.1, 0.3, size.z)};
    const Point3 b = high + Vector3{-inside(0.1, 0.3, size.x), -inside(0.1, 0.3, size.y), -inside(0.1, 0.3, size.z)};
    const Vector3 inner = b - a;
    const double its = size.x * size.y * size.z - (i + 1 < boxes ? inner.x * inner.y * inner.z : 0);
    const Point3 seed_of_it = low + 0.04 * size;
    if (i > 0 && random.chance(0.4)) {
      c.plc.holes.push_back(seed_of_it);
    } else {
      sum += its;
      if (random.chance(0.6)) c.plc.regions.push_back({seed_of_it, i + 1, random.chance(0.5) ? 0.02 * its : 0});
    }
    low = a, high = b;
  }
  c.volume = sum;
  return c;
}

Complex grid(std::uint64_t seed) {
  Random random(seed);
  std::array<std::vector<double>, 3> planes;
  for (auto& axis : planes) {
    axis = {0};
    for (int k = random.integer(1, 3); k > 0; --k) axis.push_back(axis.back() + random.uniform(0.5, 1.5));
  }
  const auto at = [&](const std::array<std::size_t, 3>& i) { return Point3{planes[0][i[0]], planes[1][i[1]], planes[2][i[2]]}; };
  Complex c;
  double sum = 0;
  int label = 0;
  for (std::size_t x = 0; x < planes[0].size(); ++x)
    for (std::size_t y = 0; y < planes[1].size(); ++y)
      for (std::size_t z = 0; z < planes[2].size(); ++z) {
        const std::array<std::size_t, 3> i{x, y, z};
        for (std::size_t d = 0; d < 3; ++d) {  // the rectangle at right angles to axis d
          const std::size_t e = (d + 1) % 3, f = (d + 2) % 3;
          if (i[e] + 1 == planes[e].size() || i[f] + 1 == planes[f].size()) continue;
          auto j = i, k = i, l = i;
          ++j[e], ++k[e], ++k[f], ++l[f];
          add_facet(c.plc, {at(i), at(j), at(k), at(l)}, static_cast<int>(d));
        }
        if (x + 1 == planes[0].size() || y + 1 == planes[1].size() || z + 1 == planes[2].size()) continue;
        const Point3 a = at(i);
        const Vector3 size = at({x + 1, y + 1, z + 1}) - a;
        const double its = size.x * size.y * size.z;
        ++label;
        if (label > 1 && random.chance(0.2)) {
          c.plc.holes.push_back(a + 0.5 * size);
          continue;
        }
        sum += its;
        if (random.chance(0.8)) c.plc.regions.push_back({a + 0.5 * size, label, random.chance(0.5) ? 0.1 * its : 0});
      }
  c.volume = sum;
  return c;
}

Complex slit(std::uint64_t seed) {
  Random random(seed);
  Complex c;
  add_box(c.plc, {-1, -1, 0}, {1, 1, 1});
  c.volume = 4;
  const double angle = random.uniform(0, pi), length = random.uniform(0.2, 0.9);
  const Vector3 along{length * std::cos(angle), length * std::sin(angle), 0};
  const int kind = random.integer(0, 2);
  if (kind == 2) {  // tilted, around the middle
    const auto axes = rotation(seed + 1);
    const Point3 o{0, 0, 0.5};
    const Vector3 u = random.uniform(0.1, 0.3) * axes[0], v = random.uniform(0.1, 0.3) * axes[1], corner = u + v, other = u + (-1) * v;
    add_facet(c.plc, {o + (-1) * corner, o + other, o + corner, o + (-1) * other}, 50);
    return c;
  }
  const double low = kind == 0 ? random.uniform(0.1, 0.4) : 0, high = random.uniform(0.5, 0.9);
  const Point3 o;
  const Vector3 up{0, 0, high}, from{0, 0, low}, back = (-1) * along;
  add_facet(c.plc, {o + back + from, o + along + from, o + along + up, o + back + up}, 50);
  if (kind == 1) c.plc.facets[0].polygons.push_back({vertex(c.plc, o + back), vertex(c.plc, o + along)});
  return c;
}

Complex fan(std::uint64_t seed) {
  Random random(seed);
  Complex c;
  add_box(c.plc, {-2, -2, -1}, {2, 2, 2});
  c.volume = 48;
  double angle = random.uniform(0, 2 * pi);
  const double last = angle + 2 * pi - 0.1;
  for (int k = random.integer(2, 8); k > 0 && angle < last; --k) {
    const double radius = random.uniform(0.5, 1.5);
    const Point3 tip{radius * std::cos(angle), radius * std::sin(angle), 0};
    add_facet(c.plc, {{0, 0, 0}, tip, tip + Vector3{0, 0, 1}, {0, 0, 1}}, 10 + k);
    angle += log_uniform(random, 5, 90) * pi / 180;
  }
  return c;
}

Complex plate(std::uint64_t seed) {
  Random random(seed);
  const double width = random.uniform(0.5, 1), height = log_uniform(random, 0.04, 0.3);
  Complex c;
  add_box(c.plc, {0, 0, 0}, {1, width, height});
  if (random.chance(0.5)) c.plc = in_triangles(c.plc);
  c.volume = width * height;
  return c;
}

Complex sphere(std::uint64_t seed) {
  Random random(seed);
  Complex c;
  c.plc = icosphere(random.integer(0, 2));
  c.volume = enclosed_volume(c.plc);
  return c;
}

Complex loose_parts(std::uint64_t seed) {
  Random random(seed);
  Complex c;
  add_box(c.plc, {0, 0, 0}, {1, 1, 1});
  c.volume = 1;
  for (int k = random.integer(0, 20); k > 0; --k)
    vertex(c.plc, {random.uniform(0.02, 0.98), random.uniform(0.02, 0.98), random.uniform(0.02, 0.48)});
  for (int k = random.integer(0, 5); k > 0; --k) {  // in planes of their own, so that none cross
    const double z = 0.5 + 0.08 * k;
    const Index a = vertex(c.plc, {random.uniform(0.1, 0.4), random.uniform(0.1, 0.9), z});
    const Index b = vertex(c.plc, {random.uniform(0.6, 0.9), random.uniform(0.1, 0.9), z});
    c.plc.segments.push_back({a, b});
    c.plc.segment_markers.push_back(k);
  }
  return c;
}

namespace {

struct Generator {
  const char* name;
  Complex (*make)(std::uint64_t seed);
};
constexpr std::array all_generators{Generator{"hull", hull},
                                    Generator{"prism", prism},
                                    Generator{"divided_prism", divided_prism},
                                    Generator{"pyramid", pyramid},
                                    Generator{"wedge", wedge},
                                    Generator{"nested_boxes", nested_boxes},
                                    Generator{"grid", grid},
                                    Generator{"slit", slit},
                                    Generator{"fan", fan},
                                    Generator{"plate", plate},
                                    Generator{"sphere", sphere},
                                    Generator{"loose_parts", loose_parts}};

}  // namespace

std::size_t generator_count() { return all_generators.size(); }

NamedComplex generate(std::uint64_t seed) {
  const Generator& g = all_generators[seed % all_generators.size()];
  NamedComplex result{std::string(g.name) + " " + std::to_string(seed), g.make(seed)};
  Random random(seed + 1'000'000);
  if (random.chance(0.3)) return result;
  const double scale = std::pow(10, random.integer(-6, 6));
  const double away = random.chance(0.2) ? 1e6 * scale : random.chance(0.5) ? scale : 0;
  result.name += " moved";
  result.complex.plc = moved(std::move(result.complex.plc), seed, scale, {away, -away, 0.5 * away});
  if (result.complex.volume) *result.complex.volume *= scale * scale * scale;
  return result;
}

}  // namespace delref::property_3
