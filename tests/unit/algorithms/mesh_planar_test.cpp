// SPDX-License-Identifier: GPL-3.0-or-later
//
// What `mesh_planar` does with each of its options, and what it says when it cannot do it.
#include <algorithm>
#include <cmath>
#include <limits>
#include <stop_token>

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include "../../property/promises.hpp"
#include "../domain/graphs.hpp"

using namespace delref;
using namespace graphs;
using Catch::Matchers::ContainsSubstring;
using property::broken_promises;
using property::promises;

namespace {

/// A unit square with a spike and a notch, so that every criterion has work.
Pslg house() {
  return graph({{0, 0}, {1, 0}, {1, 1}, {0.55, 0.9}, {0.5, 1.4}, {0.45, 0.9}, {0, 1}}, {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 6}, {6, 0}});
}
std::size_t triangles(const Pslg& pslg, const PlanarOptions& options) { return mesh_planar(pslg, options).mesh.triangles.size(); }
Control with_budget(auto&& change) {
  Budget budget;
  change(budget);
  return Control(budget);
}
Pslg moved(Pslg pslg, double scale, Vector2 by = {}) {
  for (Point2& p : pslg.points) p = Point2{scale * p.x, scale * p.y} + by;
  return pslg;
}

}  // namespace

TEST_CASE("Every choice of options gives a mesh that keeps its promises") {
  for (const Encroachment encroachment : {Encroachment::circle, Encroachment::lens})
    for (const PointChoice points : {PointChoice::circumcentre, PointChoice::off_centre})
      for (const double area : {0.001, std::numeric_limits<double>::infinity()})
        for (const double edge : {0.07, std::numeric_limits<double>::infinity()}) {
          PlanarOptions options;
          options.encroachment = encroachment, options.points = points, options.max_area = area, options.max_edge = edge;
          const PlanarResult result = mesh_planar(house(), options);
          CHECK(result.outcome.complete());
          CHECK(broken_promises(house(), result.mesh, promises(options, result.outcome)) == "");
        }
}

TEST_CASE("A greater angle bound, a smaller area, a shorter edge and a smaller size make more triangles") {
  const PlanarOptions plain;
  PlanarOptions angle = plain, area = plain, edge = plain, size = plain;
  angle.min_angle = AngleBound::degrees(32);
  area.max_area = 0.001;
  edge.max_edge = 0.05;
  size.size = [](Point2 p) { return 0.02 + 0.2 * p.x; };
  const std::size_t few = triangles(house(), plain);
  for (const PlanarOptions& more : {angle, area, edge, size}) CHECK(triangles(house(), more) > few);
  PlanarOptions none = plain;
  none.min_angle = AngleBound::degrees(0), none.encroachment = Encroachment::lens;
  CHECK(triangles(house(), none) < few);
}

TEST_CASE("A region's own area bound holds in it alone, and its label is on its triangles") {
  Pslg p = graph({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}}, {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {1, 4}, {4, 5}, {5, 0}});
  p.regions = {{{0.5, 0.5}, 10, 0.001}, {{1.5, 0.5}, 20, 0}};
  const PlanarResult result = mesh_planar(p, {});
  CHECK(broken_promises(p, result.mesh, promises({}, result.outcome)) == "");
  CHECK(std::ranges::count(result.mesh.regions, 10) > 1000);
  CHECK(std::ranges::count(result.mesh.regions, 20) < 800);
}

TEST_CASE("A small input angle is the reason of what is unmet near it") {
  const Pslg needle = graph({{0, 0}, {1, 0}, {1, 0.1}}, {{0, 1}, {1, 2}, {2, 0}});
  const PlanarResult result = mesh_planar(needle, {});
  CHECK(result.outcome.complete());
  REQUIRE(!result.outcome.unmet.empty());
  CHECK(result.outcome.unmet_count(Reason::small_input_angle) == result.outcome.unmet.size());
  CHECK(result.outcome.unmet.front().criterion == "minimum angle");
}

TEST_CASE("A protected boundary is not split, and what that costs is told") {
  PlanarOptions options;
  options.keep_boundary = true, options.max_area = 0.01;
  const PlanarResult result = mesh_planar(house(), options);
  CHECK(result.mesh.edges.size() == house().segments.size());
  CHECK(result.outcome.complete());
  CHECK(result.outcome.unmet_count(Reason::protected_segment) > 0);
  CHECK(std::ranges::all_of(result.mesh.carriers, [](Carrier c) { return c.dimension != 1; }));
}

TEST_CASE("No edge that is refined is shorter than the size floor") {
  PlanarOptions options;
  options.max_area = 1e-5;
  const double floor = 0.05;
  const PlanarResult result = mesh_planar(square(), options, with_budget([&](Budget& b) { b.smallest_edge = floor; }));
  CHECK(result.outcome.complete());
  CHECK(result.outcome.unmet_count(Reason::size_floor) > 0);
  CHECK(result.mesh.triangles.size() < 10'000);
  CHECK(broken_promises(square(), result.mesh, promises(options, result.outcome)) == "");
}

TEST_CASE("A budget of vertices is kept to, and the mesh is valid then") {
  PlanarOptions options;
  options.max_area = 1e-6;
  const PlanarResult result = mesh_planar(square(), options, with_budget([](Budget& b) { b.max_vertices = 500; }));
  CHECK(result.outcome.stopped == Stop::vertices);
  CHECK(result.mesh.points.size() <= 500);
  CHECK(result.mesh.points.size() > 450);
  CHECK(result.outcome.unmet_count(Reason::budget) > 0);
  CHECK(broken_promises(square(), result.mesh, promises(options, result.outcome)) == "");
}

TEST_CASE("A stop request ends the refinement with the mesh so far") {
  struct StopAt {
    std::stop_source& source;
    std::size_t left = 1000;
    void on_after_insertion(const ConstrainedDelaunay2<>&, ConstrainedDelaunay2<>::Vertex, const Proposal<ConstrainedDelaunay2<>>&) {
      if (left-- == 0) source.request_stop();
    }
  };
  std::stop_source source;
  StopAt observer{source};
  PlanarOptions options;
  options.max_area = 1e-6;
  const PlanarResult result = mesh_planar(square(), options, Control({}, source.get_token()), observer);
  CHECK(result.outcome.stopped == Stop::token);
  CHECK(result.mesh.points.size() > 1000);
  CHECK(result.mesh.points.size() < 1300);
  CHECK(broken_promises(square(), result.mesh, promises(options, result.outcome)) == "");
}

TEST_CASE("A stop request before there is a mesh is Interrupted") {
  std::stop_source source;
  source.request_stop();
  CHECK_THROWS_AS(mesh_planar(square(), {}, Control({}, source.get_token())), Interrupted);
  CHECK_THROWS_AS(mesh_planar(square(), {}, with_budget([](Budget& b) { b.time_limit = std::chrono::seconds(0); })), Interrupted);
}

TEST_CASE("What was mended in the input is in the notes") {
  Pslg p = with_points(square(), {{1, 1}});
  p = with_segments(p, {{2, 4}, {0, 1}});
  p.holes = {{5, 5}};
  const std::string notes = joined(mesh_planar(p, {}).notes);
  CHECK_THAT(notes, ContainsSubstring("merged") && ContainsSubstring("no length") && ContainsSubstring("repeated") &&
                        ContainsSubstring("hole seed 0 at (5, 5) lies outside"));
}

TEST_CASE("Input that cannot be meshed is refused in words") {
  const auto refused = [](const Pslg& p) { return refusal([&] { mesh_planar(p, {}); }); };
  CHECK_THAT(refused(with_segments(square(), {{0, 2}, {1, 3}})), ContainsSubstring("cross at (0.5, 0.5)"));
  CHECK_THAT(refused(graph({{0, 0}, {1, 0}, {1, 1}}, {{0, 1}, {1, 2}})), ContainsSubstring("bound no region") && ContainsSubstring("vertex 0"));
  Pslg swallowed = square();
  swallowed.holes = {{0.5, 0.5}};
  CHECK_THAT(refused(swallowed), ContainsSubstring("swallow") && ContainsSubstring("(0.5, 0.5)"));
  Pslg on_segment = square();
  on_segment.regions = {{{0.5, 0}, 1, 0}};
  CHECK_THAT(refused(on_segment), ContainsSubstring("region seed 0 at (0.5, 0) lies on a segment"));
  Pslg twice = square();
  twice.regions = {{{0.5, 0.2}, 1, 0}, {{0.5, 0.7}, 2, 0}};
  CHECK_THAT(refused(twice), ContainsSubstring("region seed 1") && ContainsSubstring("region seed 0"));
}

TEST_CASE("Crossing segments are split on request, and pieces keep the number of their segment") {
  PlanarOptions options;
  options.split_crossings = true;
  const PlanarResult result = mesh_planar(with_segments(square(), {{0, 2}, {1, 3}}), options);
  CHECK(result.outcome.complete());
  CHECK(std::ranges::count(result.mesh.edge_segments, 4u) >= 2);
  CHECK(std::ranges::count(result.mesh.edge_segments, 5u) >= 2);
  CHECK(std::ranges::find(result.mesh.points, Point2{0.5, 0.5}) != result.mesh.points.end());
}

TEST_CASE("The mesh of a scaled graph is the scaled mesh, for the greatest and the smallest coordinates") {
  const PlanarMesh plain = mesh_planar(house(), {}).mesh;
  for (const int exponent : {500, -500, 100, -100, 7}) {
    const double scale = std::ldexp(1.0, exponent);
    PlanarMesh mesh = mesh_planar(moved(house(), scale), {}).mesh;
    CHECK(mesh.triangles == plain.triangles);
    for (Point2& p : mesh.points) p = {p.x / scale, p.y / scale};
    CHECK(mesh.points == plain.points);
  }
  for (const double scale : {1e150, 1e-150}) {
    const Pslg pslg = moved(house(), scale);
    PlanarOptions options;
    options.max_edge = 0.1 * scale;
    const PlanarResult result = mesh_planar(pslg, options);
    CHECK(result.outcome.complete());
    CHECK(broken_promises(pslg, result.mesh, promises(options, result.outcome)) == "");
  }
}

TEST_CASE("A graph far from the origin is meshed as near to it") {
  const Pslg pslg = moved(house(), 1, {1e9, -1e9});
  const PlanarResult result = mesh_planar(pslg, {});
  CHECK(result.outcome.complete());
  CHECK(broken_promises(pslg, result.mesh, promises({}, result.outcome)) == "");
  CHECK(result.mesh.triangles.size() < 2 * triangles(house(), {}));
}

TEST_CASE("A sizing field is asked in the coordinates of the input, and its errors name the point") {
  PlanarOptions options;
  for (const double bad : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    options.size = [bad](Point2 p) { return p.x > 0.5 ? bad : 1.0; };
    CHECK_THAT(refusal([&] { mesh_planar(square(), options); }), ContainsSubstring("(0."));
  }
  const double scale = 1e120;
  options.size = [&](Point2 p) { return p.x < 0.5 * scale ? 0.05 * scale : scale; };
  const PlanarResult result = mesh_planar(moved(square(), scale), options);
  CHECK(broken_promises(moved(square(), scale), result.mesh, promises(options, result.outcome)) == "");
  CHECK(result.mesh.triangles.size() > 400);
}

TEST_CASE("The vertices of the mesh are those of the input first, in their order") {
  const PlanarMesh mesh = mesh_planar(house(), {}).mesh;
  for (std::size_t i = 0; i < house().points.size(); ++i) {
    CHECK(mesh.points[i] == house().points[i]);
    CHECK(mesh.provenance[i] == input_level);
  }
  for (std::size_t i = house().points.size(); i < mesh.points.size(); ++i) CHECK(mesh.provenance[i] < mesh.level_names.size());
}
