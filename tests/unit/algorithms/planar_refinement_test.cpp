// SPDX-License-Identifier: GPL-3.0-or-later
//
// Refinement in the hands of its caller: step by step, stopped and gone on with, and with vertices and segments added later.
#include <algorithm>
#include <cmath>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include "../../property/promises.hpp"
#include "../domain/graphs.hpp"

using namespace delref;
using namespace graphs;
using Catch::Matchers::ContainsSubstring;
using property::broken_promises;

namespace {

PlanarOptions fine() {
  PlanarOptions options;
  options.max_area = 0.005;
  return options;
}
Control most_vertices(std::size_t count) {
  Budget budget;
  budget.max_vertices = count;
  return Control(budget);
}
bool same(const PlanarMesh& a, const PlanarMesh& b) {
  return a.points == b.points && a.triangles == b.triangles && a.carriers == b.carriers && a.edges == b.edges;
}
/// A vertex of the mesh that is on a segment, or inside.
Point2 steiner_vertex(const PlanarMesh& mesh, std::uint8_t dimension, std::uint32_t segment = Carrier::none) {
  const auto found = std::ranges::find(mesh.carriers, Carrier{dimension, segment});
  REQUIRE(found != mesh.carriers.end());
  return mesh.points[static_cast<std::size_t>(found - mesh.carriers.begin())];
}
std::size_t count(const PlanarMesh& mesh, Carrier carrier) { return static_cast<std::size_t>(std::ranges::count(mesh.carriers, carrier)); }
bool has(const PlanarMesh& mesh, Point2 p) { return std::ranges::find(mesh.points, p) != mesh.points.end(); }

}  // namespace

TEST_CASE("Step by step gives the mesh of one run") {
  PlanarRefinement stepped(square(), fine()), run(square(), fine());
  run.refine();
  CHECK(!stepped.done());
  CHECK(stepped.outcome().stopped == Stop::token);
  std::size_t inserted = 0;
  for (Step s; (s = stepped.step()) != Step::done;) inserted += s == Step::inserted;
  CHECK(stepped.done());
  CHECK(stepped.outcome().complete());
  CHECK(same(stepped.mesh(), run.mesh()));
  CHECK(stepped.outcome().levels[0].inserted + stepped.outcome().levels[1].inserted == inserted);
  CHECK(same(mesh_planar(square(), fine()).mesh, run.mesh()));
}

TEST_CASE("The mesh may be looked at between any two steps, and is valid") {
  PlanarRefinement refinement(square(), fine());
  CHECK(refinement.mesh().triangles.size() == 2);
  for (int k = 0; k < 20; ++k) {
    refinement.step();
    CHECK(broken_promises(refinement, fine()) == "");
  }
}

TEST_CASE("Stopped and gone on with gives the mesh of one run") {
  PlanarRefinement stopped(square(), fine()), run(square(), fine());
  run.refine();
  for (std::size_t most = 20; !stopped.refine(most_vertices(most)).complete(); most += 20) CHECK(stopped.outcome().stopped == Stop::vertices);
  CHECK(same(stopped.mesh(), run.mesh()));
}

TEST_CASE("A moved refinement goes on where it was") {
  PlanarRefinement first(square(), fine()), run(square(), fine());
  first.refine(most_vertices(30));
  PlanarRefinement second = std::move(first);
  second.refine();
  run.refine();
  CHECK(same(second.mesh(), run.mesh()));
}

TEST_CASE("Added vertices are input vertices of the next mesh, in the order of what was given") {
  PlanarRefinement refinement(square(), fine());
  refinement.refine();
  const Point2 free = steiner_vertex(refinement.mesh(), 2), on_segment = steiner_vertex(refinement.mesh(), 1, 2);
  Pslg extra = graph({{0.3, 0.4}, free, on_segment, {0.37, 0}, {1, 1}}, {});
  extra.point_markers = {11, 12, 13, 14, 0};
  refinement.add(extra);
  CHECK(!refinement.done());
  CHECK(refinement.refine().complete());
  CHECK(broken_promises(refinement, fine()) == "");
  const PlanarMesh mesh = refinement.mesh();
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(mesh.points[4 + i] == extra.points[i]);
    CHECK(mesh.carriers[4 + i] == Carrier{0, static_cast<std::uint32_t>(4 + i)});
    CHECK(mesh.point_markers[4 + i] == extra.point_markers[i]);
    CHECK(mesh.provenance[4 + i] == input_level);
  }
  CHECK(count(mesh, {0, 8}) == 0);  // given again: it is vertex 2
}

TEST_CASE("A vertex within rounding of a segment cuts it, and the parts keep its number and marker") {
  Pslg slanted = graph({{0.1, 0.2}, {1.3, 0.7}, {0.4, 1.9}}, {{0, 1}, {1, 2}, {2, 0}});
  slanted.segment_markers = {5, 6, 7};
  PlanarRefinement refinement(slanted, fine());
  refinement.refine();
  Pslg extra;
  for (const double t : {0.1, 0.37, 0.71}) extra.points.push_back(slanted.points[0] + t * (slanted.points[1] - slanted.points[0]));
  refinement.add(extra);
  refinement.refine();
  CHECK(broken_promises(refinement, fine()) == "");
  CHECK(refinement.domain().segments.size() == 6);
  const PlanarMesh mesh = refinement.mesh();
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) CHECK(mesh.edge_markers[e] == 5 + static_cast<int>(mesh.edge_segments[e]));
}

TEST_CASE("An added segment runs over the Steiner vertices on its way") {
  PlanarRefinement refinement(square(), fine());
  refinement.refine();
  const Point2 a = steiner_vertex(refinement.mesh(), 1, 0), c = steiner_vertex(refinement.mesh(), 1, 2);
  SECTION("from one Steiner vertex on the boundary to another") {
    refinement.add(graph({a, c}, {{0, 1}}));
    CHECK(refinement.refine().complete());
    CHECK(broken_promises(refinement, fine()) == "");
    CHECK(count(refinement.mesh(), {1, 4}) > 0);
    CHECK(refinement.united_input().pslg.segments.size() == 7);  // two of the four were cut
  }
  SECTION("over free ones that are within rounding of it") {
    const PlanarMesh before = refinement.mesh();
    const Point2 v = steiner_vertex(before, 2);
    const Vector2 half{0x1p-4, 0x1p-5};
    const Point2 p = v + Vector2{-half.x, -half.y}, q = v + half;
    refinement.add(graph({p, q}, {{0, 1}}));
    CHECK(has(refinement.mesh(), v));
    CHECK(count(refinement.mesh(), {1, 4}) >= 1);
    CHECK(refinement.refine().complete());
    CHECK(broken_promises(refinement, fine()) == "");
  }
  SECTION("along an edge of the mesh between free vertices") {
    const PlanarMesh before = refinement.mesh();
    const auto t = std::ranges::find_if(before.triangles, [&](const auto& v) {
      return std::ranges::all_of(v, [&](auto i) { return before.carriers[i].dimension == 2; });
    });
    REQUIRE(t != before.triangles.end());
    refinement.add(graph({before.points[(*t)[0]], before.points[(*t)[1]]}, {{0, 1}}));
    CHECK(refinement.refine().complete());
    CHECK(broken_promises(refinement, fine()) == "");
  }
}

TEST_CASE("An added segment that is there already changes nothing but the time") {
  PlanarRefinement refinement(square(), fine());
  refinement.refine();
  const std::size_t before = refinement.mesh().triangles.size();
  refinement.add(graph({{0, 0}, {1, 0}}, {{0, 1}}));
  CHECK(refinement.refine().complete());
  CHECK(refinement.mesh().triangles.size() == before);
  CHECK(refinement.united_input().pslg.segments.size() == 4);
}

TEST_CASE("A segment that crosses another is refused in words, and nothing has changed") {
  PlanarRefinement refinement(square(), fine());
  refinement.refine();
  refinement.add(graph({{0, 0}, {1, 1}}, {{0, 1}}));
  refinement.refine();
  const PlanarMesh before = refinement.mesh();
  CHECK_THAT(refusal([&] { refinement.add(graph({{0.9, 0.2}, {0.2, 0.9}}, {{0, 1}})); }),
             ContainsSubstring("segment 4") && ContainsSubstring("segment 5") && ContainsSubstring("cross at"));
  CHECK(refinement.done());
  CHECK(same(before, refinement.mesh()));
  CHECK_THAT(refusal([&] { refinement.add(graph({{0.9, 0.2}}, {{0, 1}})); }), ContainsSubstring("segment 0 refers to vertex 1"));
  Pslg hole;
  hole.holes = {{0.5, 0.3}, {0.3, 0.5}};
  CHECK_THAT(refusal([&] { refinement.add(hole); }), ContainsSubstring("swallow"));
  CHECK(same(before, refinement.mesh()));
}

TEST_CASE("Segments that are added across others are split at the crossings on request") {
  PlanarOptions options = fine();
  options.split_crossings = true;
  PlanarRefinement refinement(square(), options);
  refinement.refine();
  refinement.add(graph({{0.1, 0.13}, {0.9, 0.71}}, {{0, 1}}));
  refinement.refine();
  refinement.add(graph({{0.9, 0.2}, {0.2, 0.9}, {1.5, 0.5}}, {{0, 1}, {1, 2}}));
  CHECK(refinement.refine().complete());
  CHECK(broken_promises(refinement, options) == "");
}

TEST_CASE("Added seeds make holes and regions of what the segments enclose") {
  PlanarRefinement refinement(square(), fine());
  refinement.refine();
  Pslg extra = graph({{0.3, 0.3}, {0.7, 0.3}, {0.7, 0.7}, {0.3, 0.7}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
  extra.regions = {{{0.5, 0.5}, 9, 1e-4}};
  refinement.add(extra);
  refinement.refine();
  CHECK(broken_promises(refinement, fine()) == "");
  CHECK(std::ranges::count(refinement.mesh().regions, 9) > 1600);
  Pslg hole;
  hole.holes = {{0.1, 0.1}};
  refinement.add(hole);
  refinement.refine();
  CHECK(broken_promises(refinement, fine()) == "");
  CHECK(std::ranges::count(refinement.mesh().regions, 0) == 0);
}

TEST_CASE("What is added may lie outside what was there") {
  PlanarRefinement refinement(square(), fine());
  refinement.refine();
  refinement.add(graph({{0, 1}, {0, 40}, {40, 40}, {40, 0}, {1, 0}}, {{0, 1}, {1, 2}, {2, 3}, {3, 4}}));
  CHECK(refinement.refine(most_vertices(3000)).stopped == Stop::vertices);
  CHECK(broken_promises(refinement, fine()) == "");
}

TEST_CASE("A segment that is added outside the domain has no effect, and a note says so") {
  PlanarRefinement refinement(square());
  CHECK(refinement.notes().empty());
  Pslg extra;
  extra.points = {{5, 5}, {6, 5.5}};
  extra.segments = {{0, 1}};
  refinement.add(extra);
  REQUIRE(refinement.notes().size() == 1);
  CHECK_THAT(refinement.notes().front(), ContainsSubstring("1 segment has no effect, outside the domain or in a hole: segment 4 (vertices 4 and 5, (5, 5) to (6, 5.5))"));
  CHECK(refinement.refine().complete());
  CHECK(refinement.mesh().edges.size() >= 4);
}

TEST_CASE("Corners are found anew: a segment that is added at a small angle makes one") {
  PlanarRefinement refinement(square(), fine());
  refinement.refine();
  CHECK(std::ranges::none_of(refinement.domain().segments, [](const auto& s) { return s.sharp[0] || s.sharp[1]; }));
  refinement.add(graph({{0, 0}, {0.9, 0.05}}, {{0, 1}}));
  CHECK(std::ranges::count_if(refinement.domain().segments, [](const auto& s) { return s.sharp[0] || s.sharp[1]; }) == 2);
  const auto outcome = refinement.refine();
  CHECK(outcome.complete());
  CHECK(outcome.unmet_count(Reason::small_input_angle) == outcome.unmet.size());
  CHECK(broken_promises(refinement, fine()) == "");
  for (const double height : {1e-3, 1e-6}) {
    refinement.add(graph({{1, 1}, {0.2, 1 - height}}, {{0, 1}}));
    CHECK(refinement.refine().complete());
    CHECK(broken_promises(refinement, fine()) == "");
  }
}

TEST_CASE("What was given up is considered again after an addition, and with another size floor") {
  const Pslg needle = graph({{0, 0}, {1, 0}, {1, 0.1}}, {{0, 1}, {1, 2}, {2, 0}});
  PlanarRefinement refinement(needle);
  const std::size_t unmet = refinement.refine().unmet.size();
  REQUIRE(unmet > 0);
  refinement.add(graph({{0.5, 0.02}}, {}));
  CHECK(refinement.outcome().unmet.empty());
  CHECK(refinement.refine().unmet.size() > 0);

  Budget coarse;
  coarse.smallest_edge = 0.1;
  PlanarRefinement floored(square(), fine(), Control(coarse));
  CHECK(floored.refine(Control(coarse)).unmet_count(Reason::size_floor) > 0);
  CHECK(floored.refine().unmet.empty());
  CHECK(broken_promises(floored, fine()) == "");
}

TEST_CASE("Free vertices next to an added segment make no tiny triangles") {
  PlanarRefinement refinement(square(), fine());
  refinement.refine();
  const std::size_t before = refinement.mesh().triangles.size();
  const Point2 v = steiner_vertex(refinement.mesh(), 2);
  refinement.add(graph({{v.x - 0.1, v.y + 1e-9}, {v.x + 0.1, v.y + 1e-9}}, {{0, 1}}));
  CHECK(!has(refinement.mesh(), v));
  CHECK(refinement.refine().complete());
  CHECK(refinement.mesh().triangles.size() < 2 * before);
  CHECK(broken_promises(refinement, fine()) == "");
}

TEST_CASE("Counts go on over additions") {
  PlanarRefinement refinement(square(), fine());
  const std::size_t before = refinement.refine().levels[1].inserted;
  refinement.add(graph({{0.3, 0.3}, {0.31, 0.3}}, {}));
  CHECK(refinement.refine().levels[1].inserted > before);
}
