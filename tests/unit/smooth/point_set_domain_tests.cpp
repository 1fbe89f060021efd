// SPDX-License-Identifier: GPL-3.0-or-later
#include <delref/algorithms/smooth.hpp>
#include <delref/domain/point_set_domain.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <limits>
#include <map>
#include <numbers>
#include <random>
#include <set>
#include <span>
#include <sstream>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

using namespace delref;
using Catch::Matchers::ContainsSubstring;

namespace {

static_assert(FindsComponents<PointSetDomain>);

/// Points on known surfaces, the same ones in every run on every machine. Spread evenly at random.
class Scanner {
 public:
  PointSet set;

  void sphere(Point3 centre, double radius, std::size_t count, double noise = 0) {
    for (std::size_t i = 0; i != count; ++i) {
      const double z = 2 * next() - 1, a = turn() * next(), r = std::sqrt(1 - z * z);
      const Vector3 n{r * std::cos(a), r * std::sin(a), z};
      add(centre + (radius + noise * (2 * next() - 1)) * n, n);
    }
  }
  void torus(double large, double small, std::size_t count) {
    while (set.points.size() != count) {
      const double a = turn() * next(), b = turn() * next();
      if (next() * (large + small) > large + small * std::cos(b)) continue;
      const Vector3 n{std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b)};
      add({large * std::cos(a) + small * n.x, large * std::sin(a) + small * n.y, small * n.z}, n);
    }
  }
  /// An even spiral from pole to pole, all points on the sphere but for rounding.
  void spiral(double radius, std::size_t count) {
    for (std::size_t i = 0; i != count; ++i) {
      const double z = 1 - static_cast<double>(2 * i + 1) / static_cast<double>(count), r = std::sqrt(1 - z * z), a = 2.4 * static_cast<double>(i);
      const Vector3 n{r * std::cos(a), r * std::sin(a), z};
      add(Point3{} + radius * n, n);
    }
  }
  PointSet without_normals() const { return {set.points, {}}; }

 private:
  static double turn() { return 2 * std::numbers::pi; }
  double next() { return static_cast<double>(random_()) / 4294967296.0; }
  void add(Point3 p, Vector3 n) {
    set.points.push_back(p);
    set.normals.push_back(n);
  }
  std::mt19937 random_{1};
};

PointSet scanned_sphere(std::size_t count, double noise = 0) {
  Scanner scanner;
  scanner.sphere({}, 1, count, noise);
  return scanner.set;
}

/// The characteristic V - E + F of the triangles of a mesh, and whether each edge belongs to two of them that run along it in
/// different directions.
struct Shape {
  bool is_closed = true;
  int characteristic = 0;
};
Shape shape_of(const TetrahedralMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> directed;
  std::set<std::uint32_t> vertices;
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i != 3; ++i) {
      vertices.insert(t[i]);
      ++directed[{t[i], t[(i + 1) % 3]}];
    }
  Shape shape;
  for (const auto& [edge, count] : directed) shape.is_closed &= count == 1 && directed.contains({edge.second, edge.first});
  shape.characteristic = static_cast<int>(vertices.size()) - static_cast<int>(directed.size() / 2) + static_cast<int>(mesh.triangles.size());
  return shape;
}

struct Meshed {
  Shape shape;
  std::size_t components = 0, vertices = 0;
  double distance = 0;  // the greatest of a vertex from the true surface
  bool is_complete = false;
};
template <class Distance>
Meshed meshed(const PointSetDomain& domain, Distance distance) {
  SmoothOptions options;
  options.surface_only = true;
  options.facet_size = domain.default_facet_size();
  options.facet_distance = domain.default_facet_distance();
  const SmoothResult result = mesh_smooth_domain(domain, options);
  Meshed out{shape_of(result.mesh), result.components.found, result.mesh.points.size(), 0, result.outcome.complete() && result.outcome.unmet.empty()};
  for (const Point3 p : result.mesh.points) out.distance = std::max(out.distance, std::abs(distance(p)));
  return out;
}

double unit_sphere(Point3 p) { return std::sqrt(squared_distance(p, {})) - 1; }

std::string refusal(const PointSet& set, const PointSetOptions& options = {}) {
  try {
    const PointSetDomain domain(set, options);
    return "";
  } catch (const InvalidInput& error) {
    return error.what();
  }
}
std::string notes_of(const PointSetDomain& domain) {
  std::string all;
  for (const std::string& note : domain.notes()) all += note + "\n";
  return all;
}
std::vector<int> labels_of(const PointSetDomain& domain, std::span<const Point3> points) {
  std::vector<int> labels(points.size());
  domain.label(points, labels);
  return labels;
}
std::vector<Point3> cloud(const BoundingBox3& box, std::size_t count) {
  std::mt19937 random(2);
  const auto between = [&](double low, double high) { return low + (high - low) * (static_cast<double>(random()) / 4294967296.0); };
  std::vector<Point3> points(count);
  for (Point3& p : points) p = {between(box.low.x, box.high.x), between(box.low.y, box.high.y), between(box.low.z, box.high.z)};
  return points;
}

}  // namespace

TEST_CASE("points on a sphere are meshed as a sphere, with normals and without", "[point_set]") {
  Scanner scanner;
  scanner.sphere({}, 1, 2000);
  for (const PointSet& set : {scanner.set, scanner.without_normals()}) {
    const PointSetDomain domain(set);
    const Meshed mesh = meshed(domain, unit_sphere);
    CHECK(mesh.is_complete);
    CHECK(mesh.shape.is_closed);
    CHECK(mesh.shape.characteristic == 2);
    CHECK(mesh.components == 1);
    CHECK(mesh.vertices > 100);
    CHECK(mesh.distance < 0.7 * domain.average_spacing());
  }
}

TEST_CASE("points on a torus are meshed as a torus", "[point_set]") {
  Scanner scanner;
  scanner.torus(1, 0.4, 3000);
  for (const PointSet& set : {scanner.set, scanner.without_normals()}) {
    const PointSetDomain domain(set);
    const Meshed mesh = meshed(domain, [](Point3 p) { return std::hypot(std::hypot(p.x, p.y) - 1, p.z) - 0.4; });
    CHECK(mesh.shape.is_closed);
    CHECK(mesh.shape.characteristic == 0);
    CHECK(mesh.components == 1);
    CHECK(mesh.distance < 0.7 * domain.average_spacing());
  }
}

TEST_CASE("points in an even spiral exactly on a sphere are meshed as one sphere", "[point_set]") {
  for (const std::size_t count : {std::size_t{100}, std::size_t{400}, std::size_t{1000}}) {
    Scanner scanner;
    scanner.spiral(1.37, count);
    PointSet inwards = scanner.set;
    for (Vector3& n : inwards.normals) n = -1.0 * n;
    for (const PointSet& set : {scanner.set, scanner.without_normals(), inwards}) {
      const PointSetDomain domain(set);
      CHECK(domain.notes().size() == (set.normals.empty() ? 1 : 0));
      CHECK(domain.components(Control{}).components.size() == 1);
      const Meshed mesh = meshed(domain, [](Point3 p) { return std::sqrt(squared_distance(p, {})) - 1.37; });
      CHECK(mesh.is_complete);
      CHECK(mesh.shape.is_closed);
      CHECK(mesh.shape.characteristic == 2);
      CHECK(mesh.components == 1);
      CHECK(mesh.distance < 0.7 * domain.average_spacing());
    }
  }
}

TEST_CASE("a surface that misses points is told, and one that misses most is refused", "[point_set]") {
  Scanner scanner;
  scanner.sphere({}, 1, 1000);
  scanner.sphere({3, 0, 0}, 1, 250);
  for (std::size_t i = 1000; i != 1250; ++i) scanner.set.normals[i] = -1.0 * scanner.set.normals[i];
  CHECK_THAT(notes_of(PointSetDomain(scanner.set)), ContainsSubstring("of 1250 points") && ContainsSubstring("give more points"));

  PointSet random{cloud({{0, 0, 0}, {1, 1, 1}}, 1000), {}};
  for (const Point3 p : cloud({{-1, -1, -1}, {1, 1, 1}}, 1000)) random.normals.push_back(p - Point3{});
  std::ranges::reverse(random.normals);
  CHECK_THAT(refusal(random), ContainsSubstring("misses") && ContainsSubstring("of 1000 points"));
}

TEST_CASE("points on two spheres give two components, exactly", "[point_set]") {
  Scanner scanner;
  scanner.sphere({}, 1, 1500);
  scanner.sphere({3, 0, 0.2}, 1, 1500);
  for (const PointSet& set : {scanner.set, scanner.without_normals()}) {
    const PointSetDomain domain(set);
    const SurfaceComponents found = domain.components(Control{});
    CHECK(found.is_exact);
    REQUIRE(found.components.size() == 2);
    for (const auto& seeds : found.components) CHECK(seeds.size() > 10);
    const Meshed mesh = meshed(domain, [](Point3 p) { return std::min(unit_sphere(p), std::sqrt(squared_distance(p, {3, 0, 0.2})) - 1); });
    CHECK(mesh.shape.is_closed);
    CHECK(mesh.shape.characteristic == 4);
    CHECK(mesh.distance < 0.7 * domain.average_spacing());
  }
  CHECK_THAT(notes_of(PointSetDomain(scanner.without_normals())), ContainsSubstring("fall into 2 groups"));
}

TEST_CASE("a shell with normals has two surfaces and is hollow", "[point_set]") {
  Scanner scanner;
  scanner.sphere({}, 1, 2000);
  scanner.sphere({}, 0.5, 800);
  for (std::size_t i = 2000; i != 2800; ++i) scanner.set.normals[i] = -1.0 * scanner.set.normals[i];
  const PointSetDomain domain(scanner.set);
  CHECK(domain.components(Control{}).components.size() == 2);
  CHECK(labels_of(domain, std::vector<Point3>{{0, 0, 0}, {0.75, 0, 0}, {0, 0, -0.75}}) == std::vector{outside, 0, 0});
}

TEST_CASE("a noisy sphere stays one, with normals, without and smoothed", "[point_set]") {
  const PointSet noisy = scanned_sphere(2500, 0.03);
  for (const PointSet& set : {noisy, PointSet{noisy.points, {}}})
    for (const std::size_t passes : {std::size_t{0}, std::size_t{2}}) {
      const PointSetDomain domain(set, {.smoothing_passes = passes});
      const Meshed mesh = meshed(domain, unit_sphere);
      CHECK(mesh.shape.is_closed);
      CHECK(mesh.shape.characteristic == 2);
      CHECK(mesh.distance < 0.06);
    }
}

TEST_CASE("which way all normals point does not matter, nor do their lengths", "[point_set]") {
  PointSet inwards = scanned_sphere(600);
  for (std::size_t i = 0; i != inwards.normals.size(); ++i) inwards.normals[i] = -(1.0 + static_cast<double>(i % 7)) * inwards.normals[i];
  const PointSetDomain domain(inwards);
  CHECK(labels_of(domain, std::vector<Point3>{{0, 0, 0}, {1.04, 0, 0}, {9, 9, 9}}) == std::vector{0, outside, outside});
}

TEST_CASE("the unit of the points is of no importance, and what is far from the origin neither", "[point_set]") {
  const PointSet set = scanned_sphere(600);
  const PointSetDomain domain(set);
  for (const double unit : {0x1p-60, 0x1p60}) {
    PointSet other = set;
    for (Point3& p : other.points) p = Point3{} + unit * (p - Point3{});
    const PointSetDomain scaled(other);
    CHECK(scaled.average_spacing() == unit * domain.average_spacing());
    CHECK(scaled.bounds().high.x == unit * domain.bounds().high.x);
  }
  PointSet far = set;
  for (Point3& p : far.points) p = p + Vector3{5e6, -3e6, 1e6};
  CHECK(PointSetDomain(far).components(Control{}).components.size() == 1);
}

TEST_CASE("crossings are on the surface and the same question has the same answer, from every thread", "[point_set]") {
  const PointSetDomain domain(scanned_sphere(600));
  const std::vector<Point3> points = cloud(domain.bounds(), 20000);
  const std::vector<int> labels = labels_of(domain, points);
  CHECK(std::ranges::count(labels, 0) > 5000);
  std::array<std::vector<int>, 3> answers;
  {
    std::vector<std::jthread> threads;
    for (auto& answer : answers) threads.emplace_back([&] { answer = labels_of(domain, points); });
  }
  for (const auto& answer : answers) CHECK(answer == labels);
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < points.size(); i += 37) wrong += labels_of(domain, std::span(points).subspan(i, 1))[0] != labels[i];
  CHECK(wrong == 0);
  double worst = 0;
  for (std::size_t i = 0; i + 1 < 2000; ++i) {
    if (labels[i] == labels[i + 1]) continue;
    const Point3 p = domain.crossing(points[i], points[i + 1], labels[i], 1e-9);
    CHECK(p == domain.crossing(points[i], points[i + 1], labels[i], 1e-9));
    worst = std::max(worst, std::abs(unit_sphere(p)));
  }
  CHECK(worst < 0.1);
  for (const auto& component : domain.components(Control{}).components)
    for (const Point3 seed : component) CHECK(std::abs(domain.value(seed)) < 1e-9);
}

TEST_CASE("the same points give the same mesh twice", "[point_set]") {
  Scanner scanner;
  scanner.sphere({}, 1, 500);
  const auto mesh = [&] {
    SmoothOptions options;
    options.surface_only = true;
    return mesh_smooth_domain(PointSetDomain(scanner.without_normals()), options).mesh;
  };
  const TetrahedralMesh first = mesh(), second = mesh();
  CHECK(first.points == second.points);
  CHECK(first.triangles == second.triangles);
}

TEST_CASE("points where others are, outliers and normals of no length are told", "[point_set]") {
  PointSet set = scanned_sphere(800);
  const PointSetDomain clean(set);
  CHECK(clean.notes().empty());
  for (std::size_t i = 0; i != 100; ++i) {
    set.points.push_back(set.points[i]);
    set.normals.push_back(set.normals[i]);
  }
  const PointSetDomain repeated(set);
  CHECK_THAT(notes_of(repeated), ContainsSubstring("100 points are where others are"));
  CHECK(repeated.average_spacing() == clean.average_spacing());

  PointSet zero = scanned_sphere(800);
  zero.normals[5] = {};
  CHECK_THAT(notes_of(PointSetDomain(zero)), ContainsSubstring("1 point has a normal of no length"));

  PointSet stray = scanned_sphere(800);
  stray.points.push_back({0, 0, 9});
  stray.normals.push_back({0, 0, 1});
  CHECK_THAT(notes_of(PointSetDomain(stray)), ContainsSubstring("point 800 at (0, 0, 9)") && ContainsSubstring("outlier distance"));
  const PointSetDomain kept(stray, {.outlier_distance = 8});
  CHECK_THAT(notes_of(kept), ContainsSubstring("left out"));
  CHECK(kept.bounds().high.z < 1.2);
}

TEST_CASE("sets that bound nothing are refused in words", "[point_set]") {
  CHECK_THAT(refusal({}), ContainsSubstring("0 different points") && ContainsSubstring("the least that has an inside is 4"));
  CHECK_THAT(refusal({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0}}, {}}), ContainsSubstring("3 different points"));
  PointSet line, plane;
  for (int i = 0; i != 50; ++i) {
    line.points.push_back({0.1 * i, 0.2 * i, 0.3 * i});
    plane.points.push_back({0.1 * (i % 7), 0.3 * (i / 7), 0.1 * (i % 7) + 0.7 * (i / 7)});
  }
  CHECK_THAT(refusal(line), ContainsSubstring("on one line"));
  CHECK_THAT(refusal(plane), ContainsSubstring("in one plane"));
}

TEST_CASE("numbers that are none are refused with the points that have them", "[point_set]") {
  PointSet set = scanned_sphere(50);
  set.points[7].y = std::numeric_limits<double>::quiet_NaN();
  set.normals[9].x = std::numeric_limits<double>::infinity();
  CHECK_THAT(refusal(set), ContainsSubstring("point 7 at") && ContainsSubstring("of point 9 at"));
  set = scanned_sphere(50);
  set.normals.pop_back();
  CHECK_THAT(refusal(set), ContainsSubstring("50 points and 49 normals"));
  set = scanned_sphere(50);
  std::ranges::fill(set.normals, Vector3{});
  CHECK_THAT(refusal(set), ContainsSubstring("the normals of all points are zero"));
  CHECK_THAT(refusal({{{0, 0, 0}, {1e70, 0, 0}, {0, 1e70, 0}, {0, 0, 1e70}}, {}}), ContainsSubstring("between 1e-60 and 1e60"));
  CHECK_THAT(refusal(scanned_sphere(50), {.neighbours = 2}), ContainsSubstring("give 6 to 1000"));
  CHECK_THAT(refusal(scanned_sphere(50), {.outlier_distance = -1}), ContainsSubstring("the distance of outliers is -1"));
}

TEST_CASE("hostile sets are reconstructed or refused, and nothing is printed", "[point_set]") {
  std::ostringstream printed;
  std::streambuf* const before = std::cerr.rdbuf(printed.rdbuf());
  std::vector<PointSet> sets;
  sets.push_back({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {}});
  PointSet grid, two_far, random, needle;
  for (int i = 0; i != 343; ++i) grid.points.push_back({0.1 * (i % 7), 0.1 * (i / 7 % 7), 0.1 * (i / 49)});
  two_far = scanned_sphere(40);
  for (std::size_t i = 0; i != 40; ++i) {
    two_far.points.push_back(two_far.points[i] + Vector3{1e5, 0, 0});
    two_far.normals.push_back(two_far.normals[i]);
  }
  random.points = cloud({{0, 0, 0}, {1, 1, 1}}, 300);
  for (const Point3 p : cloud({{-1, -1, -1}, {1, 1, 1}}, 300)) random.normals.push_back(p - Point3{});
  needle = scanned_sphere(300);
  for (Point3& p : needle.points) p.x *= 1e4;
  for (const PointSet& set : {grid, two_far, random, needle}) {
    sets.push_back(set);
    sets.push_back({set.points, {}});
  }
  for (const PointSet& set : sets) try {
      const PointSetDomain domain(set);
      CHECK(!domain.components(Control{}).components.empty());
    } catch (const InvalidInput& error) {
      CHECK(std::string(error.what()).size() > 20);
    }
  std::cerr.rdbuf(before);
  CHECK(printed.str().empty());
}

TEST_CASE("a reconstruction that is told to stop stops", "[point_set]") {
  const PointSet set = scanned_sphere(300);
  std::stop_source source;
  source.request_stop();
  CHECK_THROWS_AS(PointSetDomain(set, {}, Control({}, source.get_token())), Interrupted);
  Budget none;
  none.time_limit = std::chrono::duration<double>(0);
  CHECK_THROWS_AS(PointSetDomain(set, {}, Control(none)), Interrupted);
}
