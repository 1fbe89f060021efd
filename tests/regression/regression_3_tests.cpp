// SPDX-License-Identifier: GPL-3.0-or-later
//
// One case for every bug that was found in meshing space.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

#include "../property_3/generators.hpp"
#include "../property_3/meshing.hpp"

using namespace delref;
using namespace delref::property_3;
using Catch::Approx;

namespace {

/// Meshes to the end, keeps every promise, and gives up nothing that no small angle forces.
Meshed good_mesh(const Plc& input, const PolyhedralOptions& options = {}, std::size_t most_vertices = 100'000) {
  Meshed result = meshed(input, options, most_vertices);
  CHECK(result.outcome.complete());
  CHECK(result.conforms);
  CHECK(broken_promises(input, options, result) == "");
  CHECK(result.not_excused() == "");
  return result;
}
Point3 polar(double radius, double degrees, double z) {
  const double a = degrees * std::numbers::pi / 180;
  return {radius * std::cos(a), radius * std::sin(a), z};
}
Plc box() {
  Plc plc;
  add_box(plc, {0, 0, 0}, {1, 1, 1});
  return plc;
}

}  // namespace

TEST_CASE("Points of hull facets that round to the outside of the hull are inserted") {
  Plc tetrahedron;
  const Point3 a{0, 0, 0}, b{1, 0, 0}, c{0.3, 0.9, 0}, d{0.4, 0.3, 0.8};
  for (const auto& triangle : {std::vector{a, c, b}, {a, b, d}, {b, c, d}, {c, a, d}}) add_facet(tetrahedron, triangle);
  PolyhedralOptions options;
  options.cell_size = 0.1;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    CAPTURE(seed);
    const Plc turned = moved(tetrahedron, seed, 1, {1, 2, 3});
    CHECK(volume(good_mesh(turned, options).mesh) == Approx(0.12).epsilon(1e-9));
  }
}

TEST_CASE("The cocircular points of a turned cube's facets leave no flat cells in the domain and none out of it") {
  PolyhedralOptions options;
  options.cell_size = 0.2;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    CAPTURE(seed);
    CHECK(volume(good_mesh(moved(box(), seed, 1, {})).mesh) == Approx(1).epsilon(1e-9));
    CHECK(volume(good_mesh(moved(box(), seed, 1, {}), options).mesh) == Approx(1).epsilon(1e-9));
  }
}

TEST_CASE("An icosahedron with cospherical corners is filled") {
  for (int cuts = 0; cuts < 3; ++cuts) {
    const Plc sphere = icosphere(cuts);
    CHECK(volume(good_mesh(sphere).mesh) == Approx(enclosed_volume(sphere)).epsilon(1e-9));
  }
}

TEST_CASE("Two boxes with a gap of a millionth between them stay apart") {
  Plc plc;
  add_box(plc, {0, 0, 0}, {1, 1, 1});
  add_box(plc, {1 + 1e-6, 0, 0}, {2, 1, 1}, 10);
  // The gap itself is as fine as it is narrow wherever the facets see each other, so the budget ends this.
  const Meshed result = meshed(plc, {}, 20'000);
  if (result.conforms) CHECK(broken_promises(plc, {}, result) == "");
  else CHECK(result.outcome.stopped);
  CHECK((result.outcome.stopped || result.not_excused() == ""));
}

TEST_CASE("A wedge of 5 degrees is meshed to the end") {
  Plc plc;
  const Point3 a{0, 0, 0}, b{1, 0, 0}, c = polar(1, 5, 0);
  const Vector3 up{0, 0, 1};
  add_facet(plc, {a, b, c}, 1);
  add_facet(plc, {a + up, b + up, c + up}, 2);
  add_facet(plc, {a, b, b + up, a + up}, 3);
  add_facet(plc, {b, c, c + up, b + up}, 4);
  add_facet(plc, {c, a, a + up, c + up}, 5);
  CHECK(volume(good_mesh(plc).mesh) == Approx(0.5 * std::sin(5 * std::numbers::pi / 180)).epsilon(1e-9));
  good_mesh(in_triangles(plc));
}

TEST_CASE("A fan of facets 5 degrees apart is meshed to the end") {
  Plc plc;
  add_box(plc, {-2, -2, -1}, {2, 2, 2});
  for (int k = 0; k < 5; ++k) add_facet(plc, {{0, 0, 0}, polar(1, 5.0 * k, 0), polar(1, 5.0 * k, 1), {0, 0, 1}}, 10 + k);
  CHECK(volume(good_mesh(plc).mesh) == Approx(48).epsilon(1e-9));
}

TEST_CASE("A thin plate in triangles is meshed to the end") {
  Plc plc;
  add_box(plc, {0, 0, 0}, {1, 1, 0.01});
  CHECK(volume(good_mesh(in_triangles(plc), {}, 400'000).mesh) == Approx(0.01).epsilon(1e-9));
}

TEST_CASE("A segment with a needle's corner at one end and a blunt one at the other is meshed to the end") {
  Plc plc;
  const Point3 tip{0, 0, 0}, a = polar(1, 0, 0), b = polar(1.1, 3, 0), c = polar(0.6, 60, 0);
  const Vector3 up{0, 0, 0.5};
  const std::vector<Point3> polygon{tip, a, b};
  add_facet(plc, polygon, 1);
  add_facet(plc, {tip + up, a + up, b + up}, 2);
  add_facet(plc, {tip, a, a + up, tip + up}, 3);
  add_facet(plc, {a, b, b + up, a + up}, 4);
  add_facet(plc, {b, tip, tip + up, b + up}, 5);
  add_facet(plc, {tip, b, c}, 6);
  add_facet(plc, {tip + up, b + up, c + up}, 7);
  add_facet(plc, {b, c, c + up, b + up}, 8);
  add_facet(plc, {c, tip, tip + up, c + up}, 9);
  good_mesh(plc);
}

TEST_CASE("No region is lost when all of its cells are new before a torn facet is whole, a million sizes from the origin") {
  const NamedComplex grid = generate(198);
  CHECK(volume(good_mesh(grid.complex.plc).mesh) == Approx(*grid.complex.volume).epsilon(1e-8));
}

TEST_CASE("A vertex at the origin of a large facet is not taken for the counterpart of itself") {
  Plc plc;
  for (int k = 0; k < 4; ++k) {
    const Point3 a = polar(3e5, 90.0 * k, 0), b = polar(2e5, 90.0 * k + 60, 0), o;
    const Vector3 up{0, 0, 4e5};
    const Point3 c = polar(3e5, 90.0 * ((k + 1) % 4), 0);
    add_facet(plc, {a, b, c, o}, 1);
    add_facet(plc, {a + up, b + up, c + up, o + up}, 2);
    add_facet(plc, {a, b, b + up, a + up}, 3);
    add_facet(plc, {b, c, c + up, b + up}, 4);
    add_facet(plc, {o, a, a + up, o + up}, 10 + k);
  }
  for (std::uint64_t seed = 0; seed < 10; ++seed) good_mesh(moved(plc, seed, 1, {}));
  good_mesh(generate(230).complex.plc);
  good_mesh(generate(1010).complex.plc);
}

TEST_CASE("Tetrahedra left for facets of a fan 5 degrees apart are excused by the vertices on both facets") {
  for (const std::uint64_t seed : {56u, 140u, 236u}) {
    CAPTURE(seed);
    good_mesh(generate(seed).complex.plc);
  }
}
