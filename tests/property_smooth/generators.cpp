// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <utility>

#include <delref/core/point.hpp>
#include <delref/domain/bounding_box_3.hpp>
#include <delref/domain/grey_level_image.hpp>
#include <delref/domain/image.hpp>
#include <delref/domain/implicit_domain.hpp>
#include <delref/domain/labelled_image.hpp>
#include <delref/domain/multi_material_domain.hpp>

#include "../property/generators.hpp"  // for its random numbers alone

namespace delref::property_smooth {
namespace {

using property::Random;

double log_uniform(Random& random, double from, double to) { return std::exp(random.uniform(std::log(from), std::log(to))); }
Point3 point_in(Random& random, double half) { return {random.uniform(-half, half), random.uniform(-half, half), random.uniform(-half, half)}; }
BoundingBox3 cube(double half) { return {{-half, -half, -half}, {half, half, half}}; }

Vector3 unit(Vector3 v) { return (1 / std::sqrt(squared_length(v))) * v; }
Vector3 direction(Random& random) {
  while (true) {
    const Vector3 d{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    if (const double l = squared_length(d); l > 0.01 && l < 1) return unit(d);
  }
}
std::array<Vector3, 3> frame(Random& random) {
  const Vector3 u = direction(random);
  Vector3 w = cross(u, direction(random));
  while (squared_length(w) < 0.01) w = cross(u, direction(random));
  w = unit(w);
  return {u, cross(w, u), w};
}

/// Where a function made around the origin comes to lie.
struct Place {
  double scale = 1;
  Vector3 shift{};

  Function operator()(Function f) const {
    if (scale == 1 && shift == Vector3{}) return f;
    return [f = std::move(f), *this](Point3 p) { return f(Point3{} + (1 / scale) * (p - (Point3{} + shift))); };
  }
  BoundingBox3 operator()(BoundingBox3 b) const {
    return {Point3{} + shift + scale * (b.low - Point3{}), Point3{} + shift + scale * (b.high - Point3{})};
  }
};
Place place_for(std::uint64_t seed, std::string& name) {
  Random random(seed + 1'000'000);
  Place place;
  if (random.chance(1.0 / 3)) return place;
  place.scale = std::pow(10, random.integer(-6, 6));
  const double away = random.chance(0.3) ? place.scale * std::pow(10, random.integer(1, 6)) : 0;
  place.shift = {away, -away, 0.5 * away};
  name += " scaled by " + std::to_string(place.scale);
  if (away > 0) name += " moved by " + std::to_string(away);
  return place;
}

// -- functions that are negative inside
Function sphere(Point3 centre, double radius) {
  return [=](Point3 p) { return std::sqrt(squared_distance(p, centre)) - radius; };
}
Function torus(Point3 centre, const std::array<Vector3, 3>& axes, double large, double small) {
  return [=](Point3 p) {
    const Vector3 v = p - centre;
    return std::hypot(std::hypot(dot(v, axes[0]), dot(v, axes[1])) - large, dot(v, axes[2])) - small;
  };
}
Function box(Point3 centre, const std::array<Vector3, 3>& axes, Vector3 half) {
  return [=](Point3 p) {
    const Vector3 v = p - centre;
    return std::max({std::abs(dot(v, axes[0])) - half.x, std::abs(dot(v, axes[1])) - half.y, std::abs(dot(v, axes[2])) - half.z});
  };
}
Function united(std::vector<Function> parts) {
  return [parts = std::move(parts)](Point3 p) {
    double least = std::numeric_limits<double>::infinity();
    for (const Function& f : parts) least = std::min(least, f(p));
    return least;
  };
}

struct Gaussian {
  Point3 centre;
  double weight, inverse_square;
  double operator()(Point3 p) const { return weight * std::exp(-inverse_square * squared_distance(p, centre)); }
};
std::vector<Gaussian> gaussian_sum(Random& random, double half) {
  std::vector<Gaussian> sum;
  const int n = random.integer(2, 12);
  for (int i = 0; i < n; ++i) {
    const double width = random.uniform(0.3, 0.9);
    sum.push_back({point_in(random, half), random.uniform(0.6, 1.4) * (random.chance(0.15) ? -1 : 1), 1 / (width * width)});
  }
  return sum;
}
double value(const std::vector<Gaussian>& sum, Point3 p) {
  double total = 0;
  for (const Gaussian& g : sum) total += g(p);
  return total;
}

/// The least distance over which the gradient could turn round on the surface: its length over the norm of the second derivatives. A lower
/// bound of about the local feature size where functions are smooth.
double turning_distance(const Function& f, const BoundingBox3& b) {
  constexpr int n = 28;
  const double step = b.extent() / n, h = 1e-4 * b.extent();
  const auto gradient = [&](Point3 p) {
    return (0.5 / h) * Vector3{f(p + Vector3{h, 0, 0}) - f(p + Vector3{-h, 0, 0}), f(p + Vector3{0, h, 0}) - f(p + Vector3{0, -h, 0}),
                               f(p + Vector3{0, 0, h}) - f(p + Vector3{0, 0, -h})};
  };
  double least = b.extent();
  const auto look_at = [&](Point3 in, Point3 out) {
    if ((f(in) < 0) == (f(out) < 0)) return;
    if (f(in) >= 0) std::swap(in, out);
    for (int k = 0; k < 16; ++k) (f(midpoint(in, out)) < 0 ? in : out) = midpoint(in, out);
    double second = 0;
    for (const Vector3 d : {Vector3{h, 0, 0}, Vector3{0, h, 0}, Vector3{0, 0, h}})
      second += squared_length((0.5 / h) * (gradient(in + d) - gradient(in + -1.0 * d)));
    least = std::min(least, std::sqrt(squared_length(gradient(in)) / second));
  };
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const Point3 p = b.low + step * Vector3{i + 0.5, j + 0.5, k + 0.5};
        for (const Vector3 d : {Vector3{step, 0, 0}, Vector3{0, step, 0}, Vector3{0, 0, step}}) look_at(p, p + d);
      }
  return least;
}

Input placed(std::string name, const Place& place, const Function& f, const BoundingBox3& box_of_f, std::optional<double> safe_size) {
  const BoundingBox3 bounds = place(box_of_f);
  if (safe_size) *safe_size *= place.scale;
  const auto count = std::make_shared<std::size_t>(0);
  const Function counted = [f = place(f), count](Point3 p) { return ++*count, f(p); };
  Input input{std::move(name), Domain(ImplicitDomain(counted, bounds)), bounds.extent(), safe_size, place.scale};
  input.domain.counts_evaluations(count);
  return input;
}

Input implicit(std::string name, std::uint64_t seed, const Function& f, const BoundingBox3& box_of_f, std::optional<double> safe_size) {
  name += " " + std::to_string(seed);
  const Place place = place_for(seed, name);
  return placed(std::move(name), place, f, box_of_f, safe_size);
}

std::string numbered(const char* name, std::uint64_t seed) { return std::string(name) + " " + std::to_string(seed); }

/// The threshold that a part of the samples in a box is above.
double level_for(const Function& f, const BoundingBox3& b, double part) {
  std::vector<double> values;
  constexpr int n = 20;
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) values.push_back(f(b.low + (b.extent() / (n - 1)) * Vector3{double(i), double(j), double(k)}));
  std::ranges::sort(values);
  return values[static_cast<std::size_t>((1 - part) * static_cast<double>(values.size() - 1))];
}

/// Of a turning distance, of a gap between surfaces, and of the radius of a round part.
constexpr double turning_part = 0.8, gap_part = 0.8, round_part = 0.5;

}  // namespace

Input gaussians(std::uint64_t seed) {
  Random random(seed);
  auto sum = gaussian_sum(random, 1.2);
  const double iso = log_uniform(random, 0.15, 0.5);
  if (std::ranges::none_of(sum, [&](const Gaussian& g) { return value(sum, g.centre) > 1.05 * iso; })) sum.push_back({{0, 0, 0}, 3, 2});
  const Function f = [sum, iso](Point3 p) { return iso - value(sum, p); };
  return implicit("gaussians", seed, f, cube(3.5), turning_part * turning_distance(f, cube(3.5)));
}

Input cut_gaussians(std::uint64_t seed) {
  Random random(seed);
  const auto sum = gaussian_sum(random, 1.6);
  const Function g = [sum](Point3 p) { return value(sum, p); };
  const double iso = level_for(g, cube(1.3), random.uniform(0.2, 0.7));
  return implicit("cut_gaussians", seed, [g, iso](Point3 p) { return iso - g(p); }, {{-1.3, -1.2, -1}, {1.3, 1.1, 1.2}}, std::nullopt);
}

Input solids(std::uint64_t seed) {
  Random random(seed);
  const auto solid = [&]() -> Function {
    const Point3 centre = point_in(random, 0.6);
    switch (random.integer(0, 2)) {
      case 0: return sphere(centre, random.uniform(0.4, 0.9));
      case 1: return torus(centre, frame(random), random.uniform(0.5, 0.8), random.uniform(0.15, 0.3));
      default: return box(centre, frame(random), {random.uniform(0.3, 0.8), random.uniform(0.3, 0.8), random.uniform(0.3, 0.8)});
    }
  };
  Function f = solid();
  const int n = random.integer(1, 4);
  for (int i = 1; i < n; ++i) {
    const Function g = solid(), before = f;
    switch (random.integer(0, 2)) {
      case 0: f = [before, g](Point3 p) { return std::min(before(p), g(p)); }; break;
      case 1: f = [before, g](Point3 p) { return std::max(before(p), -g(p)); }; break;
      default: f = [before, g](Point3 p) { return std::max(before(p), g(p)); };
    }
  }
  double least = 1;
  for (int i = 0; i < 4000; ++i) least = std::min(least, f(point_in(random, 1.2)));
  if (least > -0.08) f = united({f, sphere({0, 0, 0}, 0.5)});  // otherwise next to nothing is left
  return implicit("solids", seed, f, cube(2.5), std::nullopt);
}

Input materials(std::uint64_t seed) {
  Random random(seed);
  std::string name = numbered("materials", seed);
  const Place place = place_for(seed, name);
  std::vector<Function> functions;
  const int n = random.integer(2, 3);
  for (int i = 0; i < n; ++i) {
    const Point3 centre = point_in(random, 0.5);
    if (random.chance(0.6)) functions.push_back(place(sphere(centre, random.uniform(0.5, 0.9))));
    else functions.push_back(place(torus(centre, frame(random), 0.7, 0.3)));
  }
  const BoundingBox3 bounds = place(cube(2));
  return {name, Domain(MultiMaterialDomain<Function>(functions, bounds)), bounds.extent(), std::nullopt, place.scale};
}

Input grey_image(std::uint64_t seed) {
  Random random(seed);
  std::string name = numbered("grey_image", seed);
  const Place place = place_for(seed, name);
  const int n = random.integer(14, 26);
  Image<float> image;
  image.grid.size = {n, random.integer(14, 26), random.integer(10, 20)};
  const double step = place.scale * 3 / n;
  image.grid.spacing = {step, step * random.uniform(0.6, 1.6), step * random.uniform(0.8, 2.5)};
  if (random.chance(0.5)) image.grid.axes = frame(random);
  image.grid.origin = Point3{} + place.shift;
  const auto sum = gaussian_sum(random, 1.2);
  for (int z = 0; z < image.grid.size[2]; ++z)
    for (int y = 0; y < image.grid.size[1]; ++y)
      for (int x = 0; x < n; ++x) {
        const auto along = [&](int i, std::size_t axis) { return 4.0 * i / (image.grid.size[axis] - 1) - 2; };
        image.values.push_back(static_cast<float>(value(sum, {along(x, 0), along(y, 1), along(z, 2)})));
      }
  std::vector<float> sorted = image.values;
  std::ranges::sort(sorted);
  const double iso = sorted[static_cast<std::size_t>(random.uniform(0.7, 0.97) * static_cast<double>(sorted.size()))] * 1.0000001;
  Domain domain(GreyLevelImage(std::move(image), iso, {.close_at_border = true}));
  const double extent = domain.bounds().extent();
  return {std::move(name), std::move(domain), extent, std::nullopt, place.scale};
}

Input labels(std::uint64_t seed) {
  Random random(seed);
  std::string name = numbered("labels", seed);
  Place place = place_for(seed, name);
  // Centres of surface balls are on the faces of voxels: very far away rounding decides on which side, and for the surface alone the
  // verification cannot tell the regions of the smallest patches any more.
  place.shift = 1e-3 * place.shift;
  Image<std::int32_t> image;
  image.grid.size = {random.integer(6, 14), random.integer(6, 14), random.integer(6, 14)};
  image.grid.spacing = {0.2 * place.scale, 0.2 * place.scale * random.uniform(0.7, 1.5), 0.2 * place.scale * random.uniform(0.7, 2)};
  if (random.chance(0.5)) image.grid.axes = frame(random);
  image.grid.origin = Point3{} + place.shift;
  image.values.assign(image.grid.voxels(), 0);
  const int parts = random.integer(1, 5);
  for (int part = 0; part < parts; ++part) {
    std::array<int, 3> low{}, high{};
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = random.integer(0, image.grid.size[a] - 2);
      high[a] = part == 0 || random.chance(0.7) ? random.integer(low[a] + 1, image.grid.size[a] - 1) : low[a];
    }
    for (int z = low[2]; z <= high[2]; ++z)
      for (int y = low[1]; y <= high[1]; ++y)
        for (int x = low[0]; x <= high[0]; ++x) image.at(x, y, z) = 10 * (1 + part % 3);
  }
  if (random.chance(0.5)) image.at(random.integer(0, 5), random.integer(0, 5), random.integer(0, 5)) = 50;
  LabelOptions options;
  if (random.chance(0.5)) options.smoothing = random.uniform(0.4, 0.6), name += " smoothed";
  Domain domain(LabelledImage(image, options));
  const double extent = domain.bounds().extent();
  return {std::move(name), std::move(domain), extent, std::nullopt, place.scale};
}

Input gyroid(std::uint64_t seed) {
  Random random(seed);
  const double k = random.uniform(1.5, 3), level = random.uniform(-0.6, 0.6);
  const Function f = [=](Point3 p) {
    return std::sin(k * p.x) * std::cos(k * p.y) + std::sin(k * p.y) * std::cos(k * p.z) + std::sin(k * p.z) * std::cos(k * p.x) - level;
  };
  return implicit("gyroid", seed, f, {{-1.3, -1.2, -1}, {1.3, 1.1, 1.2}}, std::nullopt);
}

Input nested_spheres(std::uint64_t seed) {
  Random random(seed);
  const int n = random.integer(2, 5);
  std::vector<Function> spheres;
  double radius = 1, gap = 1, smallest = 1;
  Point3 centre{};
  for (int i = 0; i < n; ++i) {
    spheres.push_back(sphere(centre, radius));
    const double next = radius * random.uniform(0.6, 0.8), room = (radius - next) * random.uniform(0, 0.4);
    centre = centre + room * direction(random);
    if (i + 1 < n) gap = std::min(gap, radius - next - room);
    smallest = radius;
    radius = next;
  }
  const Function f = [spheres](Point3 p) {
    double v = spheres[0](p);
    for (std::size_t i = 1; i < spheres.size(); ++i) v = i % 2 == 1 ? std::max(v, -spheres[i](p)) : std::min(v, spheres[i](p));
    return v;
  };
  return implicit("nested_spheres", seed, f, cube(1.4), std::min(gap_part * gap, round_part * smallest));
}

Input touching_spheres(std::uint64_t seed) {
  Random random(seed);
  const int n = random.integer(2, 4);
  const double between = std::array{0.0, 1e-3, -1e-3, 0.02, -0.02}[static_cast<std::size_t>(random.integer(0, 4))];
  std::vector<Function> spheres;
  double x = -0.75 * (n - 1);
  for (int i = 0; i < n; ++i) {
    spheres.push_back(sphere({x, 0, 0}, 0.75));
    x += 1.5 + between;
  }
  return implicit("touching_spheres", seed, united(spheres), {{-3.4, -1.1, -1}, {3.4, 1, 1.2}}, std::nullopt);
}

Input thin_shell(std::uint64_t seed) {
  Random random(seed);
  const double thickness = log_uniform(random, 0.01, 0.1);
  const Point3 centre = point_in(random, 0.1);
  const Function f = [=](Point3 p) {
    const double r = std::sqrt(squared_distance(p, centre));
    return std::max(1 - thickness - r, r - 1);
  };
  return implicit("thin_shell", seed, f, cube(1.4), gap_part * thickness);
}

Input many_spheres(std::uint64_t seed) {
  Random random(seed);
  const int n = random.integer(30, 100);
  std::vector<std::pair<Point3, double>> spheres;
  for (int tries = 0; static_cast<int>(spheres.size()) < n && tries < 20'000; ++tries) {
    const Point3 c = point_in(random, 1.7);
    const double r = random.uniform(0.12, 0.25);
    if (std::ranges::all_of(spheres, [&](const auto& s) { return std::sqrt(squared_distance(s.first, c)) > s.second + r + 0.1; }))
      spheres.emplace_back(c, r);
  }
  const Function f = [spheres](Point3 p) {
    double least = 10;
    for (const auto& [c, r] : spheres) least = std::min(least, std::sqrt(squared_distance(p, c)) - r);
    return least;
  };
  return implicit("many_spheres", seed, f, cube(2.1), round_part * 0.12);
}

Input not_a_number(std::uint64_t seed) {
  Random random(seed);
  const Function whole = random.chance(0.5) ? sphere({0, 0, 0}, 1) : torus({0, 0, 0}, frame(random), 0.8, 0.35);
  const Vector3 n = direction(random);
  const double reach = random.uniform(0, 0.6);
  const bool flat = random.chance(0.5);
  const Function f = [=](Point3 p) {
    const bool bad = flat ? dot(n, p - Point3{}) > reach : squared_distance(p, Point3{} + 0.8 * n) < 0.3 * (reach + 0.2);
    return bad ? std::numeric_limits<double>::quiet_NaN() : whole(p);
  };
  return implicit("not_a_number", seed, f, cube(1.4), std::nullopt);
}

Input tori(std::uint64_t seed) {
  Random random(seed);
  if (random.chance(0.4)) {  // linked
    const double small = random.uniform(0.1, 0.25);
    const auto a = torus({-0.5, 0, 0}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, 1, small);
    const auto b = torus({0.5, 0, 0}, {{{1, 0, 0}, {0, 0, 1}, {0, 1, 0}}}, 1, small);
    return implicit("tori", seed, united({a, b}), cube(2), round_part * small);
  }
  // A chain of rings that melt into one another: as many holes.
  const int holes = random.integer(1, 5);
  std::vector<Gaussian> sum;
  for (int i = 0; i < holes; ++i)
    for (int k = 0; k < 16; ++k) {
      const double angle = 2 * std::numbers::pi * k / 16;
      sum.push_back({{1.7 * (i - 0.5 * (holes - 1)) + std::cos(angle), std::sin(angle), 0.2 * std::sin(1.0 * i)}, 1, 1 / (0.3 * 0.3)});
    }
  const Function f = [sum](Point3 p) { return 0.7 - value(sum, p); };
  const double x = 1.9 + 0.85 * (holes - 1);
  const BoundingBox3 b{{-x, -1.9, -1}, {x, 1.9, 1.2}};
  return implicit("tori", seed, f, b, turning_part * turning_distance(f, b));
}

namespace {

struct Generator {
  const char* name;
  Input (*make)(std::uint64_t seed);
};
constexpr std::array all_generators{Generator{"gaussians", gaussians},
                                    Generator{"cut_gaussians", cut_gaussians},
                                    Generator{"solids", solids},
                                    Generator{"materials", materials},
                                    Generator{"grey_image", grey_image},
                                    Generator{"labels", labels},
                                    Generator{"gyroid", gyroid},
                                    Generator{"nested_spheres", nested_spheres},
                                    Generator{"touching_spheres", touching_spheres},
                                    Generator{"thin_shell", thin_shell},
                                    Generator{"many_spheres", many_spheres},
                                    Generator{"not_a_number", not_a_number},
                                    Generator{"tori", tori}};

}  // namespace

Input implicit(std::string name, const Function& f, const BoundingBox3& bounds, double scale) {
  return placed(std::move(name), {scale, {}}, f, bounds, std::nullopt);
}

std::size_t generator_count() { return all_generators.size(); }
Input generate(std::uint64_t seed) { return all_generators[seed % all_generators.size()].make(seed); }

}  // namespace delref::property_smooth
