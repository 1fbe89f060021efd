// SPDX-License-Identifier: GPL-3.0-or-later
//
// What holds of every mesh of a smooth domain, tried on generated ones: it is closed, a manifold, within its bounds, or the outcome says
// where not; the verification, which shares nothing with the mesher, finds every promise kept; the topology is what a count without
// a mesher finds; the same domain gives the same bytes; and the domain is not asked more often than has to be.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

#include <delref/domain/grey_level_image.hpp>
#include <delref/domain/invalid_input.hpp>
#include <delref/domain/labelled_image.hpp>
#include <delref/domain/multi_material_domain.hpp>

#include "generators.hpp"
#include "meshing.hpp"
#include "topology.hpp"

using namespace delref;
using namespace delref::property_smooth;
using Catch::Approx;

namespace {

constexpr std::size_t most_vertices = 8000;

/// How many seeds each property is tried on: the environment variable DELREF_SEEDS, or `usual`.
std::uint64_t seed_count(std::uint64_t usual) {
  const char* given = std::getenv("DELREF_SEEDS");
  return given ? std::strtoull(given, nullptr, 10) : usual;
}

/// Every domain gets other bounds when its turn comes again, and every second time its surface alone is meshed.
SmoothOptions options_for(const Input& input, std::uint64_t seed) {
  const std::uint64_t turn = seed / generator_count();
  SmoothOptions options;
  options.surface_only = turn % 2 == 1;
  options.facet_size = std::clamp(input.safe_size.value_or(input.extent / 18), input.extent / 35, input.extent / 14);
  switch (turn % 5) {
    case 1: options.facet_distance = input.extent / 300; break;
    case 2: options.cell_size = input.extent / 15; break;
    case 3:
      options.facet_size_field = [centre = midpoint(input.domain.bounds().low, input.domain.bounds().high), size = options.facet_size](Point3 p) {
        return 0.7 * size + 0.3 * std::sqrt(squared_distance(centre, p));
      };
      break;
    case 4:
      options.radius_edge = 1.5;
      options.cell_size_field = [size = options.facet_size, low = input.domain.bounds().low](Point3 p) { return size + 0.2 * std::abs(p.x - low.x); };
      break;
    default: break;
  }
  return options;
}

double ball(Point3 p) { return std::sqrt(squared_distance(p, Point3{})) - 1; }
constexpr BoundingBox3 box{{-1.3, -1.3, -1.3}, {1.3, 1.3, 1.3}};

SmoothOptions surface_of_size(double size) {
  SmoothOptions options;
  options.facet_size = size;
  options.surface_only = true;
  return options;
}

}  // namespace

TEST_CASE("A mesh of a generated smooth domain is what was promised") {
  std::size_t stopped = 0;
  const std::uint64_t count = seed_count(10 * generator_count());
  for (std::uint64_t seed = 0; seed < count; ++seed) {
    const Input input = generate(seed);
    CAPTURE(input.name, seed);
    const Meshed result = meshed(input.domain, options_for(input, seed), most_vertices);
    stopped += result.outcome.stopped.has_value();
    CAPTURE(result.unmet());
    CHECK(defects(result) == "");
    CHECK(broken_promises(input.domain, result) == "");
    if (!result.outcome.stopped) CHECK(result.missed_components == 0);
    if (input.safe_size && result.options.facet_size <= *input.safe_size) {
      CHECK(result.unmet() == "");
      CHECK(result.loose_vertices == 0);
    }
  }
  CHECK(stopped <= 1 + count / 10);
}

TEST_CASE("A surface with facets that are small against its features has the topology that is counted without a mesher") {
  std::size_t sure = 0;
  const std::array makers{gaussians, nested_spheres, tori, many_spheres};
  const std::uint64_t count = seed_count(24);
  for (std::uint64_t seed = 0; seed < count; ++seed) {
    const Input input = makers[seed % makers.size()](seed);
    if (*input.safe_size < input.extent / 80) continue;
    CAPTURE(input.name, seed, *input.safe_size / input.extent);
    const std::optional<Topology> counted = sure_topology(input.domain, 0, 88);
    if (!counted) continue;
    ++sure;
    const Meshed result = meshed(input.domain, surface_of_size(std::min(*input.safe_size, input.extent / 14)), 40'000);
    REQUIRE(result.outcome.complete());
    const Topology found = topology_of(result.mesh);
    CHECK(found.components == counted->components);
    CHECK(found.euler_characteristic == counted->euler_characteristic);
    CHECK(result.unmet() == "");
    CHECK(defects(result) == "");
  }
  CHECK(sure >= count / 4);
}

TEST_CASE("The same domain gives the same mesh twice") {
  for (std::uint64_t seed = 0; seed < seed_count(8 * generator_count()) / 4; ++seed) {
    const Input input = generate(seed);
    CAPTURE(input.name, seed);
    const SmoothOptions options = options_for(input, seed);
    CHECK(same_bytes(meshed(input.domain, options, most_vertices).mesh, meshed(input.domain, options, most_vertices).mesh));
  }
}

TEST_CASE("A domain that is larger by a power of two has the same mesh, larger by that power") {
  const Function torus = [](Point3 p) { return std::hypot(std::hypot(p.x, p.y) - 0.8, p.z) - 0.35; };
  for (const bool surface_only : {true, false}) {
    SmoothOptions options = surface_of_size(0.1);
    options.surface_only = surface_only;
    options.facet_distance = 0.02;
    options.cell_size = 0.15;
    const Meshed usual = meshed(implicit("torus", torus, box).domain, options, most_vertices);
    for (const double scale : {0x1p-60, 0x1p-20, 0x1p10, 0x1p70}) {
      CAPTURE(scale, surface_only);
      SmoothOptions scaled = options;
      scaled.facet_size *= scale, scaled.facet_distance *= scale, scaled.cell_size *= scale;
      const Meshed result = meshed(implicit("torus", torus, box, scale).domain, scaled, most_vertices);
      CHECK(result.mesh.triangles == usual.mesh.triangles);
      CHECK(result.mesh.tetrahedra == usual.mesh.tetrahedra);
      REQUIRE(result.mesh.points.size() == usual.mesh.points.size());
      for (std::size_t v = 0; v < usual.mesh.points.size(); ++v) REQUIRE(result.mesh.points[v] == Point3{} + scale * (usual.mesh.points[v] - Point3{}));
    }
  }
}

TEST_CASE("A run that its budget stops gives a closed mesh and says so") {
  for (std::uint64_t seed = 0; seed < seed_count(2 * generator_count()); ++seed) {
    const Input input = generate(seed);
    CAPTURE(input.name, seed);
    const SmoothOptions options = options_for(input, seed);
    const Meshed whole = meshed(input.domain, options, most_vertices);
    for (const double part : {0.3, 0.8}) {
      const auto most = static_cast<std::size_t>(part * static_cast<double>(whole.vertices));
      const Meshed result = meshed(input.domain, options, most);
      CAPTURE(part, most, result.vertices);
      CHECK(result.outcome.stopped == Stop::vertices);
      CHECK_FALSE(result.outcome.complete());
      CHECK(result.outcome.unmet_count(Reason::budget) > 0);
      if (result.mesh.triangles.empty()) continue;  // the seeds alone
      CHECK(defects(result) == "");
      CHECK(broken_promises(input.domain, result) == "");
    }
  }
}

TEST_CASE("A smooth function is asked for some hundred values a vertex") {
  for (const auto make : {gaussians, tori, nested_spheres})
    for (std::uint64_t seed = 0; seed < 3; ++seed)
      for (const bool surface_only : {true, false}) {
        const Input input = make(seed);
        SmoothOptions options = surface_of_size(input.extent / 60);
        options.surface_only = surface_only;
        const Meshed result = meshed(input.domain, options, 20'000);
        const auto vertices = static_cast<double>(result.vertices);
        CAPTURE(input.name, surface_only, result.vertices);
        CHECK(static_cast<double>(result.asked.labels) / vertices < 40);
        CHECK(static_cast<double>(result.asked.crossings) / vertices < 10);
        CHECK(static_cast<double>(result.asked.evaluations) / vertices < 120);
      }
}

TEST_CASE("Each of 300 small spheres is meshed") {
  const Function spheres = [](Point3 p) {
    double least = 10;
    for (int i = 0; i < 300; ++i) {
      const Point3 centre{0.8 * (i % 7) - 2.4, 0.8 * (i / 7 % 7) - 2.4, 0.8 * (i / 49) - 2.4};
      least = std::min(least, std::sqrt(squared_distance(p, centre)) - 0.1 - 0.1 / 3 * (i % 4));
    }
    return least;
  };
  for (const bool surface_only : {true, false}) {
    SmoothOptions options = surface_of_size(0.3);
    options.surface_only = surface_only;
    const Meshed result = meshed(implicit("spheres", spheres, {{-3, -3, -3}, {3, 3, 3}}).domain, options, 100'000);
    CHECK(result.outcome.complete());
    CHECK(result.unmet() == "");
    CHECK(result.components == 300);
    CHECK(topology_of(result.mesh) == Topology{300, 600});
    CHECK(defects(result) == "");
  }
}

TEST_CASE("A thin shell has both of its sides") {
  for (const double thickness : {0.2, 0.05}) {
    const Function shell = [thickness](Point3 p) { return std::abs(ball(p) + 0.5 * thickness) - 0.5 * thickness; };
    const Meshed result = meshed(implicit("shell", shell, box).domain, surface_of_size(0.8 * thickness), 40'000);
    CAPTURE(thickness, result.unmet());
    CHECK(result.outcome.complete());
    CHECK(topology_of(result.mesh) == Topology{2, 4});
  }
}

TEST_CASE("No region is lost between two others, though it is thin against the facets") {
  const auto ball_at = [](double x) -> Function { return [x](Point3 p) { return std::sqrt(squared_distance(p, {x, 0, 0})) - 0.8; }; };
  for (const double distance : {1.2, 1.4, 1.5}) {
    const Domain domain(MultiMaterialDomain<Function>({ball_at(-0.5 * distance), ball_at(0.5 * distance)}, {{-1.8, -1, -1}, {1.8, 1, 1}}));
    for (const bool surface_only : {true, false}) {
      SmoothOptions options = surface_of_size(0.4);
      options.surface_only = surface_only;
      const Meshed result = meshed(domain, options, most_vertices);
      CAPTURE(distance, surface_only, result.unmet());
      CHECK(result.patches >= 4);
      CHECK(broken_promises(domain, result) == "");
      if (!surface_only) CHECK(std::ranges::count(result.mesh.regions, 3) > 0);
    }
  }
}

TEST_CASE("A label of one voxel has a surface of its own, and the volume of a voxel") {
  Image<std::int32_t> image;
  image.grid.size = {7, 6, 5};
  image.grid.spacing = {1, 1.5, 0.8};
  image.values.assign(image.grid.voxels(), 0);
  image.at(3, 2, 2) = 9;
  const Domain domain{LabelledImage(image)};
  SmoothOptions options = surface_of_size(0.15);
  options.surface_only = false;
  options.smallest_facet = 0.02;
  const Meshed result = meshed(domain, options, 40'000);
  CHECK(result.outcome.complete());
  CHECK(topology_of(result.mesh) == Topology{1, 2});
  CHECK(std::ranges::all_of(result.mesh.regions, [](int label) { return label == 9; }));
  double volume = 0;
  for (const auto& t : result.mesh.tetrahedra) {
    const auto at = [&](std::size_t i) { return result.mesh.points[t[i]] - result.mesh.points[t[0]]; };
    volume += dot(at(1), cross(at(2), at(3))) / 6;
  }
  CHECK(volume == Approx(1.2).epsilon(0.05));
  CHECK(defects(result) == "");
}

TEST_CASE("A constant function and an iso value that no voxel reaches are refused in words") {
  for (const double value : {-1.0, 0.0, 1.0}) {
    const Input input = implicit("constant", [value](Point3) { return value; }, box);
    CHECK_THROWS_AS(meshed(input.domain, surface_of_size(0.1), most_vertices), InvalidInput);
  }
  Image<float> image;
  image.grid.size = {4, 4, 4};
  image.values.assign(64, 1.0F);
  image.values[21] = 2.0F;
  CHECK_THROWS_AS(GreyLevelImage(image, 3.0), InvalidInput);
  CHECK_THROWS_AS(GreyLevelImage(image, 0.5), InvalidInput);
}
