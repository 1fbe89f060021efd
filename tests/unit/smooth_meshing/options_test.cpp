// SPDX-License-Identifier: GPL-3.0-or-later
//
// What cannot be met is refused in words that say what to give; what was left open is chosen and told; and a run says what it did.
#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <limits>
#include <map>
#include <stop_token>
#include <string>

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <delref/algorithms/smooth.hpp>

#include "scenes.hpp"

using namespace delref;
using Catch::Approx;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

Regions3 ball() {
  return {[](Point3 p) { return radius(p) < 1 ? 0 : outside; }};
}
void expect_refused(const SmoothOptions& options, const std::string& words) {
  CHECK_THROWS_MATCHES(mesh_smooth_domain(ball(), options), InvalidInput, MessageMatches(ContainsSubstring(words)));
}
SmoothOptions sized(double facet_size) {
  SmoothOptions options;
  options.facet_size = facet_size;
  return options;
}
std::size_t open_edges(const TetrahedralMesh& mesh) {
  std::map<std::array<TetrahedralMesh::Index, 2>, int> edges;
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) ++edges[{std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])}];
  return static_cast<std::size_t>(std::ranges::count_if(edges, [](const auto& e) { return e.second % 2 != 0; }));
}

}  // namespace

TEST_CASE("sizes that are not positive are refused, each by its name") {
  for (const double bad : {0.0, -1.0, not_a_number, -std::numeric_limits<double>::infinity()}) {
    SmoothOptions options;
    options.facet_size = bad;
    expect_refused(options, "the size of facets");
    options = {};
    options.facet_distance = bad;
    expect_refused(options, "the distance of facets");
    options = {};
    options.cell_size = bad;
    expect_refused(options, "the circumradius of tetrahedra");
    if (bad == 0) continue;  // no bound for this region
    options = {};
    options.region_cell_sizes = {0, bad};
    expect_refused(options, "region 1");
  }
}

TEST_CASE("a radius-edge bound under 1, a tolerance out of range and a negative floor are refused") {
  for (const double bad : {0.99, 0.0, -2.0, not_a_number}) {
    SmoothOptions options;
    options.radius_edge = bad;
    expect_refused(options, "radius-edge");
  }
  for (const double bad : {0.0, -1.0, 0.1, 1.0, not_a_number}) {
    SmoothOptions options;
    options.surface_tolerance = bad;
    expect_refused(options, "tolerance");
  }
  for (const double bad : {-1.0, not_a_number, std::numeric_limits<double>::infinity()}) {
    SmoothOptions options;
    options.smallest_facet = bad;
    expect_refused(options, "left as they are");
  }
}

TEST_CASE("a field that is not positive is refused where it is asked") {
  for (const double bad : {0.0, -1.0, not_a_number}) {
    const auto field = [bad](Point3 p) { return p.x > 0 ? bad : 0.5; };
    SmoothOptions options = sized(0.5);
    options.facet_size_field = field;
    CHECK_THROWS_AS(mesh_smooth_domain(ball(), options), InvalidInput);
    options = sized(0.5);
    options.facet_distance_field = field;
    CHECK_THROWS_AS(mesh_smooth_domain(ball(), options), InvalidInput);
    options = sized(0.5);
    options.cell_size_field = field;
    CHECK_THROWS_AS(mesh_smooth_domain(ball(), options), InvalidInput);
  }
}

TEST_CASE("bounds that are no box are refused") {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const BoundingBox3& bad : {BoundingBox3{}, BoundingBox3{{0, 0, 0}, {0, 1, 1}}, BoundingBox3{{1, 0, 0}, {0, 1, 1}}, BoundingBox3{{0, 0, 0}, {infinity, 1, 1}},
                                  BoundingBox3{{0, 0, not_a_number}, {1, 1, 1}}, BoundingBox3{{0, 0, 0}, {1e61, 1, 1}}, BoundingBox3{{0, 0, 0}, {1e-61, 1e-61, 1e-61}}}) {
    Regions3 domain = ball();
    domain.box = bad;
    CHECK_THROWS_MATCHES(mesh_smooth_domain(domain), InvalidInput, MessageMatches(ContainsSubstring("bounds")));
  }
}

TEST_CASE("a domain without a surface is refused") {
  const Regions3 nothing{[](Point3) { return outside; }};
  CHECK_THROWS_MATCHES(mesh_smooth_domain(nothing), InvalidInput, MessageMatches(ContainsSubstring("no surface")));
}

TEST_CASE("without any size the facets get one, and the notes say so") {
  const SmoothResult result = mesh_smooth_domain(ball());
  REQUIRE(result.notes.size() == 1);
  CHECK_THAT(result.notes[0], ContainsSubstring("no size of facets was asked for"));
  const Regions3 domain = ball();
  SmoothRefinement refinement(domain);
  CHECK(refinement.options().facet_size == Approx(0.1).epsilon(0.1));
  CHECK(refinement.options().smallest_facet == Approx(1e-3 * refinement.options().facet_size));
  SmoothOptions near;
  near.facet_distance = 0.01;
  CHECK(mesh_smooth_domain(ball(), near).notes.empty());
}

TEST_CASE("a ball comes out as one, with its surface alone and with its volume") {
  for (const bool surface_only : {true, false}) {
    SmoothOptions options = sized(0.25);
    options.surface_only = surface_only;
    const SmoothResult result = mesh_smooth_domain(ball(), options);
    CHECK(result.outcome.complete());
    CHECK(result.outcome.unmet.empty());
    CHECK(result.mesh.tetrahedra.empty() == surface_only);
    CHECK(open_edges(result.mesh) == 0);
    CHECK(result.components.found == 1);
    CHECK(result.components.missed == 0);
    CHECK(result.components.loose_vertices == 0);
    CHECK_FALSE(result.components.is_exact);
    REQUIRE(result.patches.size() == 1);
    CHECK(result.patches[0].regions == std::array{0, outside});
    double enclosed = 0;
    for (const auto& t : result.mesh.triangles) {
      const auto at = [&](std::size_t i) { return result.mesh.points[t[i]] - Point3{}; };
      enclosed += dot(at(0), cross(at(1), at(2))) / 6;
    }
    CHECK(enclosed == Approx(4.18879).epsilon(0.05));
    for (std::size_t v = 0; v < result.mesh.points.size(); ++v)
      if (result.mesh.carriers[v].dimension == 2) CHECK(radius(result.mesh.points[v]) == Approx(1).epsilon(1e-5));
  }
}

TEST_CASE("regions keep the names that the oracle has for them, and else are numbered from 1") {
  Regions3 halves{[](Point3 p) { return radius(p) > 1 ? outside : p.z > 0.1 ? 1 : 0; }};
  SmoothOptions options = sized(0.4);
  options.smallest_facet = 0.02;
  const auto labels = [](const SmoothResult& r) {
    std::map<int, int> found;
    for (const int l : r.mesh.regions) found[l] = 1;
    return found;
  };
  CHECK(labels(mesh_smooth_domain(halves, options)) == std::map<int, int>{{1, 1}, {2, 1}});
  halves.names = {30, 7};
  const SmoothResult named = mesh_smooth_domain(halves, options);
  CHECK(labels(named) == std::map<int, int>{{7, 1}, {30, 1}});
  REQUIRE(named.patches.size() == 3);
  CHECK(named.patches[0].regions == std::array{0, outside});
  CHECK(named.patches[1].regions == std::array{1, outside});
  CHECK(named.patches[2].regions == std::array{1, 0});
}

TEST_CASE("the bound of a region holds in that region alone") {
  const Regions3 halves{[](Point3 p) { return radius(p) > 1 ? outside : p.z > 0 ? 1 : 0; }};
  SmoothOptions options = sized(0.4);
  options.smallest_facet = 0.02;
  options.region_cell_sizes = {0.12};
  const SmoothResult result = mesh_smooth_domain(halves, options);
  const auto small = std::ranges::count(result.mesh.regions, 1), large = std::ranges::count(result.mesh.regions, 2);
  CHECK(large > 0);
  CHECK(small > 3 * large);
}

TEST_CASE("a budget of vertices ends a run with a closed mesh that is said to be unfinished, and it can go on") {
  SmoothOptions options = sized(0.08);
  options.surface_only = true;
  const Regions3 domain = ball();
  SmoothRefinement refinement(domain, options);
  Budget budget;
  budget.max_vertices = 300;
  const auto outcome = refinement.refine(Control(budget));
  REQUIRE(outcome.stopped.has_value());
  CHECK(*outcome.stopped == Stop::vertices);
  CHECK_FALSE(outcome.complete());
  CHECK_FALSE(refinement.done());
  CHECK(outcome.unmet_count(Reason::budget) > 0);
  CHECK(open_edges(refinement.mesh()) == 0);
  CHECK(refinement.refine().complete());
  CHECK(refinement.done());
  CHECK(open_edges(refinement.mesh()) == 0);
  CHECK(refinement.mesh().points.size() > 1000);
}

TEST_CASE("a stop token and a time limit end a run") {
  std::stop_source source;
  source.request_stop();
  CHECK_THROWS_AS(mesh_smooth_domain(ball(), sized(0.1), Control({}, source.get_token())), Interrupted);
  const Regions3 domain = ball();
  SmoothRefinement refinement(domain, sized(0.01));
  Budget budget;
  budget.time_limit = std::chrono::duration<double>(0.2);
  const auto outcome = refinement.refine(Control(budget));
  REQUIRE(outcome.stopped.has_value());
  CHECK(*outcome.stopped == Stop::time);
  CHECK(open_edges(refinement.mesh()) == 0);
}
