// SPDX-License-Identifier: GPL-3.0-or-later
//
// How the graphs are kept free of crossings is said at each generator.
#include "generators.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <delref/core/point.hpp>

namespace delref::property {
namespace {

constexpr double pi = std::numbers::pi;
using Index = Pslg::Index;

Point2 polar(double radius, double angle) { return {radius * std::cos(angle), radius * std::sin(angle)}; }

Index add_point(Pslg& p, Point2 at) {
  p.points.push_back(at);
  return static_cast<Index>(p.points.size() - 1);
}

void add_segment(Pslg& p, Index a, Index b, int marker = 1) {
  p.segments.push_back({a, b});
  p.segment_markers.push_back(marker);
}

/// The closed polygon, with markers first_marker, first_marker + 1, first_marker + 2, and again.
void add_loop(Pslg& p, const std::vector<Point2>& corners, int first_marker = 1) {
  const auto first = static_cast<Index>(p.points.size());
  for (const Point2 c : corners) add_point(p, c);
  const auto n = static_cast<Index>(corners.size());
  for (Index i = 0; i < n; ++i) add_segment(p, first + i, first + (i + 1) % n, first_marker + static_cast<int>(i % 3));
}

void add_polyline(Pslg& p, const std::vector<Point2>& points, int marker) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Index v = add_point(p, points[i]);
    if (i != 0) add_segment(p, v - 1, v, marker);
  }
}

/// A square from (-half, -half) to (half, half).
void add_square(Pslg& p, double half) { add_loop(p, {{-half, -half}, {half, -half}, {half, half}, {-half, half}}); }

/// Rotates, scales by 1e-3 to 1e3 and shifts by up to ten diameters; for graphs whose parts are apart by far more than rounding.
Pslg moved(Pslg p, Random& random) {
  const double angle = random.uniform(0, 2 * pi), scale = std::pow(10, random.uniform(-3, 3));
  const double c = scale * std::cos(angle), s = scale * std::sin(angle);
  const Vector2 shift{scale * random.uniform(-10, 10), scale * random.uniform(-10, 10)};
  const auto move = [&](Point2& q) { q = Point2{c * q.x - s * q.y, s * q.x + c * q.y} + shift; };
  for (Point2& q : p.points) move(q);
  for (Point2& q : p.holes) move(q);
  for (Pslg::Region& r : p.regions) {
    move(r.seed);
    r.max_area *= scale * scale;
  }
  return p;
}

double distance_to_segment(Point2 p, Point2 a, Point2 b) {
  const Vector2 along = b - a;
  const double t = std::clamp(dot(p - a, along) / squared_length(along), 0.0, 1.0);
  return std::sqrt(squared_distance(p, a + t * along));
}

/// 0 when the segments cross.
double distance_of_segments(Point2 a, Point2 b, Point2 c, Point2 d) {
  const auto side = [](Point2 p, Point2 q, Point2 r) { return cross(q - p, r - p) > 0; };
  if (side(a, b, c) != side(a, b, d) && side(c, d, a) != side(c, d, b)) return 0;
  return std::min({distance_to_segment(a, c, d), distance_to_segment(b, c, d), distance_to_segment(c, a, b), distance_to_segment(d, a, b)});
}

/// Breaks one edge of a polygon by a displaced midpoint, unless one of the halves would come too near to another edge.
void break_edge(std::vector<Point2>& loop, std::size_t i, Random& random) {
  const std::size_t n = loop.size();
  const Point2 a = loop[i], b = loop[(i + 1) % n];
  const Vector2 along = b - a;
  const double height = random.uniform(-0.45, 0.45);
  const Point2 m = midpoint(a, b) + height * Vector2{-along.y, along.x};
  const double apart = 0.02 * std::sqrt(squared_length(along));
  for (std::size_t j = 0; j < n; ++j) {
    if (j == i) continue;
    const Point2 c = loop[j], d = loop[(j + 1) % n];
    // a neighbour edge shares an end with one half: there the other half and the new vertex must be apart from it
    if ((c != b && distance_of_segments(m, b, c, d) < apart) || (d != a && distance_of_segments(a, m, c, d) < apart)) return;
    if (distance_to_segment(m, c, d) < apart) return;
    if (c == b && distance_to_segment(d, m, b) < apart) return;
    if (d == a && distance_to_segment(c, a, m) < apart) return;
  }
  loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(i + 1), m);
}

std::vector<Point2> coast_loop(Point2 centre, double radius, int steps, Random& random) {
  std::vector<Point2> loop;
  const int corners = random.integer(3, 8);
  for (int i = 0; i < corners; ++i) loop.push_back(centre + (polar(radius, 2 * pi * i / corners) - Point2{}));
  for (int step = 0; step < steps; ++step) {
    std::size_t edge = 0;  // the longest of three
    double longest = 0;
    for (int k = 0; k < 3; ++k) {
      const auto i = static_cast<std::size_t>(random.next() % loop.size());
      const double length = squared_distance(loop[i], loop[(i + 1) % loop.size()]);
      if (length > longest) longest = length, edge = i;
    }
    break_edge(loop, edge, random);
  }
  return loop;
}

/// Points in a square, apart from each other and from its sides.
std::vector<Point2> scattered(int count, double half, double apart, Random& random) {
  std::vector<Point2> points;
  for (int i = 0; i < 20 * count && static_cast<int>(points.size()) < count; ++i) {
    const Point2 p{random.uniform(-half, half), random.uniform(-half, half)};
    if (std::ranges::all_of(points, [&](Point2 q) { return squared_distance(p, q) > apart * apart; })) points.push_back(p);
  }
  return points;
}

double tiny_angle(Random& random) { return std::pow(10, random.uniform(-9, 1)) * pi / 180; }

}  // namespace

// Corners in the order of their angle around the centre: the polygon is star-shaped, so it is simple.
Pslg star(std::uint64_t seed) {
  Random random(seed);
  std::vector<Point2> corners;
  const int n = random.integer(5, 60);
  const double inner = random.uniform(0.05, 0.9);
  for (int i = 0; i < n; ++i) corners.push_back(polar(random.uniform(inner, 1), 2 * pi * (i + random.uniform(-0.4, 0.4)) / n));
  Pslg p;
  add_loop(p, corners);
  return moved(std::move(p), random);
}

// The upper side goes from left to right; the lower is a straight line below it.
Pslg comb(std::uint64_t seed) {
  Random random(seed);
  std::vector<Point2> upper;
  const int teeth = random.integer(2, 25);
  double x = 0;
  for (int i = 0; i < teeth; ++i) {
    const double height = random.uniform(0.2, 1);
    for (const double y : {0.1, height, height, 0.1}) {
      upper.push_back({x, y});
      x += std::pow(10, random.uniform(-3, 0)) / teeth;
    }
  }
  std::vector<Point2> corners{{x, 0}, {x, 0.1}};
  corners.insert(corners.end(), upper.rbegin(), upper.rend());
  corners.push_back({0, 0});
  Pslg p;
  add_loop(p, corners);
  return moved(std::move(p), random);
}

// The band is at most 0.6 of the pitch wide, and its two sides have their corners on the same rays.
Pslg spiral(std::uint64_t seed) {
  Random random(seed);
  const double turns = random.uniform(1, 5), step = 0.15, pitch = 1 / (turns + 1), width = pitch * random.uniform(0.02, 0.6);
  std::vector<Point2> outer, inner;
  for (double angle = 0; angle < 2 * pi * turns; angle += step) {
    const double middle = pitch * (1 + angle / (2 * pi));
    outer.push_back(polar(middle + width / 2, angle));
    inner.push_back(polar(middle - width / 2, angle));
  }
  outer.insert(outer.end(), inner.rbegin(), inner.rend());
  Pslg p;
  add_loop(p, outer);
  return moved(std::move(p), random);
}

// Rays from one point in different directions meet nowhere else. The apex is the origin: turned, but not shifted.
Pslg fan(std::uint64_t seed) {
  Random random(seed);
  Pslg p;
  add_square(p, 2);
  const Index apex = add_point(p, {0, 0});
  const int rays = random.integer(2, 24);
  double angle = random.uniform(0, 2 * pi);
  const double last = angle + 2 * pi - 0.1;
  for (int i = 0; i < rays && angle < last; ++i) {
    const Index tip = add_point(p, polar(random.uniform(0.5, 1.5), angle));
    add_segment(p, apex, tip, 2 + i % 5);
    angle += random.chance(0.5) ? tiny_angle(random) : random.uniform(0.1, 1);
  }
  return p;
}

Pslg needle(std::uint64_t seed) {
  Random random(seed);
  const double angle = std::pow(10, random.uniform(-9, 1.5)) * pi / 180, turn = random.uniform(0, 2 * pi);
  Pslg p;
  add_loop(p, {{0, 0}, polar(random.uniform(0.5, 1), turn), polar(random.uniform(0.5, 1), turn + angle)});
  return p;
}

// Each displacement is checked against all edges; the islands are far from each other.
Pslg coast(std::uint64_t seed) {
  Random random(seed);
  Pslg p;
  const int steps = random.integer(20, 300);
  if (random.chance(0.5)) {  // land
    add_loop(p, coast_loop({0, 0}, 1, steps, random));
  } else {  // a sea with islands
    add_square(p, 4);
    for (const Point2 centre : {Point2{-2, -2}, Point2{2, -2}, Point2{2, 2}, Point2{-2, 2}}) {
      if (random.chance(0.3)) continue;
      add_loop(p, coast_loop(centre, 0.6, steps / 4, random), 10);
    }
  }
  return moved(std::move(p), random);
}

// The next ring is inside the inscribed circle of the one before: cos(pi / 8) > 0.92, and the ratio is at most 0.8.
Pslg nested_holes(std::uint64_t seed) {
  Random random(seed);
  Pslg p;
  const int rings = random.integer(2, 7);
  double radius = 1;
  for (int i = 0; i < rings; ++i) {
    const int corners = random.integer(8, 30);
    const double turn = random.uniform(0, 2 * pi), next = radius * random.uniform(0.4, 0.8);
    std::vector<Point2> loop;
    for (int k = 0; k < corners; ++k) loop.push_back(polar(radius, turn + 2 * pi * k / corners));
    add_loop(p, loop, 1 + 10 * i);
    if (i % 2 == 1) p.holes.push_back(polar((0.92 * radius + next) / 2, random.uniform(0, 2 * pi)));
    else if (random.chance(0.5)) p.regions.push_back({polar((0.92 * radius + next) / 2, random.uniform(0, 2 * pi)), i + 1, 0.01});
    radius = next;
  }
  return moved(std::move(p), random);
}

Pslg disjoint_segments(std::uint64_t seed) {
  Random random(seed);
  Pslg p;
  add_square(p, 1);
  std::vector<std::array<Point2, 2>> kept;
  const int tries = random.integer(5, 300);
  const double longest = random.uniform(0.05, 1);
  for (int i = 0; i < tries; ++i) {
    const Point2 a{random.uniform(-0.99, 0.99), random.uniform(-0.99, 0.99)};
    const Point2 b = a + (polar(longest * random.uniform(0.01, 1), random.uniform(0, 2 * pi)) - Point2{});
    if (std::max(std::abs(b.x), std::abs(b.y)) > 0.99) continue;
    const auto apart = [&](const auto& s) { return distance_of_segments(a, b, s[0], s[1]) > 0.002; };
    if (!std::ranges::all_of(kept, apart)) continue;
    kept.push_back({a, b});
    add_polyline(p, {a, b}, 5 + i % 7);
  }
  return moved(std::move(p), random);
}

// The unit square as vertices from 0 on; that of column i in the middle of its lower side is 2 + i.
void add_square_of_columns(Pslg& p, int columns) {
  std::vector<Point2> boundary{{0, 1}, {0, 0}};
  for (int i = 0; i < columns; ++i) boundary.push_back({(i + 0.5) / columns, 0});
  boundary.push_back({1, 0});
  boundary.push_back({1, 1});
  add_loop(p, boundary);
}

// Each polyline is in a column of its own and goes upwards; those that hang share a vertex with the lower side.
Pslg slits(std::uint64_t seed) {
  Random random(seed);
  Pslg p;
  const int columns = random.integer(1, 12);
  add_square_of_columns(p, columns);
  for (int i = 0; i < columns; ++i) {
    const bool hangs = random.chance(0.6);
    const int pieces = random.integer(1, 5);
    std::vector<Point2> line;
    for (int k = 0; k <= pieces; ++k)
      line.push_back({(i + random.uniform(0.1, 0.9)) / columns, (k + random.uniform(0.2, 0.8)) / (pieces + 1)});
    add_polyline(p, line, 4 + i);
    if (hangs) add_segment(p, static_cast<Index>(2 + i), static_cast<Index>(p.points.size() - line.size()), 3);
  }
  return moved(std::move(p), random);
}

// Each hole is a triangle in a column of its own, with one corner on the lower side.
Pslg touching_holes(std::uint64_t seed) {
  Random random(seed);
  Pslg p;
  const int columns = random.integer(1, 6);
  add_square_of_columns(p, columns);
  for (int i = 0; i < columns; ++i) {
    const Point2 left{(i + random.uniform(0.05, 0.45)) / columns, random.uniform(0.01, 0.9)};
    const Point2 right{(i + random.uniform(0.55, 0.95)) / columns, random.uniform(0.01, 0.9)};
    const auto corner = static_cast<Index>(2 + i);
    const Index l = add_point(p, left), r = add_point(p, right);
    add_segment(p, corner, r, 4), add_segment(p, r, l, 5), add_segment(p, l, corner, 6);
    const Point2 c = p.points[corner];
    p.holes.push_back(c + (1.0 / 3) * ((left - c) + (right - c)));
  }
  return moved(std::move(p), random);
}

Pslg isolated_vertices(std::uint64_t seed) {
  Random random(seed);
  Pslg p;
  add_square(p, 1);
  for (const Point2 q : scattered(random.integer(1, 200), 0.99, std::pow(10, random.uniform(-4, -2)), random)) add_point(p, q);
  p.point_markers.resize(p.points.size());
  for (std::size_t i = 0; i < p.points.size(); ++i) p.point_markers[i] = static_cast<int>(i);
  return moved(std::move(p), random);
}

// Corners in the order of their angle around the origin, as in `star`. The steps are at least some 30 times the rounding of the
// coordinates, and nothing is moved.
Pslg dirty_coast(std::uint64_t seed) {
  Random random(seed);
  const int n = random.integer(6, 40);
  std::vector<Point2> corners;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * pi * (i + random.uniform(0, 0.5)) / n, radius = random.uniform(0.7, 1);
    const double step = random.uniform(1e-14, 1e-13);
    corners.push_back(polar(radius, angle));
    const double kind = random.uniform();
    if (kind < 0.3) {  // short segments
      for (int k = 1; k <= 3; ++k) corners.push_back(polar(radius, angle + k * step));
    } else if (kind < 0.5) {  // a spike
      corners.push_back(polar(radius + random.uniform(0.1, 0.5), angle + step));
      corners.push_back(polar(radius, angle + 2 * step));
    } else if (kind < 0.7) {  // a crack
      corners.push_back(polar(radius * random.uniform(0.3, 0.9), angle + step));
      corners.push_back(polar(radius, angle + 2 * step));
    }
  }
  Pslg p;
  add_loop(p, corners);
  return p;
}

// The vertices move by less than a fifth of a cell.
Pslg region_grid(std::uint64_t seed) {
  Random random(seed);
  Pslg p;
  const int nx = random.integer(1, 6), ny = random.integer(1, 6);
  const auto at = [&](int i, int j) { return static_cast<Index>(j * (nx + 1) + i); };
  for (int j = 0; j <= ny; ++j)
    for (int i = 0; i <= nx; ++i) add_point(p, {i + random.uniform(-0.2, 0.2), j + random.uniform(-0.2, 0.2)});
  for (int j = 0; j <= ny; ++j)
    for (int i = 0; i <= nx; ++i) {
      if (i < nx) add_segment(p, at(i, j), at(i + 1, j), 1 + j);
      if (j < ny) add_segment(p, at(i, j), at(i, j + 1), 100 + i);
    }
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      const Point2 centre{i + 0.5, j + 0.5};
      const double kind = random.uniform();
      const bool first = i == 0 && j == 0;  // stays, so that something is left
      if (kind < 0.2 && !first) p.holes.push_back(centre);
      else if (kind < 0.9) p.regions.push_back({centre, 1 + j * nx + i, random.chance(0.5) ? random.uniform(0.005, 0.2) : 0});
    }
  return moved(std::move(p), random);
}

// Coordinates are multiples of 1/64, so that "inside a segment" is exact; the segments stand on the axis-parallel side.
Pslg tees(std::uint64_t seed) {
  Random random(seed);
  Pslg p;
  add_loop(p, {{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  for (int i = 2; i < 62; i += random.integer(2, 16)) {
    const double x = i / 64.0, height = random.integer(1, 30) / 64.0;
    add_polyline(p, {{x, 0}, {x + random.integer(0, 1) / 64.0, height}}, 7);
    if (random.chance(0.3)) add_point(p, {x, 1});
  }
  return p;
}

std::span<const Generator> generators() {
  static constexpr std::array all{Generator{"star", star},
                                  Generator{"comb", comb},
                                  Generator{"spiral", spiral},
                                  Generator{"fan", fan},
                                  Generator{"needle", needle},
                                  Generator{"coast", coast},
                                  Generator{"nested_holes", nested_holes},
                                  Generator{"disjoint_segments", disjoint_segments},
                                  Generator{"slits", slits},
                                  Generator{"touching_holes", touching_holes},
                                  Generator{"isolated_vertices", isolated_vertices},
                                  Generator{"dirty_coast", dirty_coast},
                                  Generator{"region_grid", region_grid},
                                  Generator{"tees", tees, true}};
  return all;
}

NamedPslg generate(std::uint64_t seed) {
  const Generator& g = generators()[seed % generators().size()];
  return {std::string(g.name) + " " + std::to_string(seed), g.make(seed)};
}

}  // namespace delref::property
