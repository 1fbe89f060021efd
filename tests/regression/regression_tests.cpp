// SPDX-License-Identifier: GPL-3.0-or-later
//
// One case for every bug that was found.
#include <algorithm>
#include <cstddef>

#include <catch2/catch_test_macros.hpp>

#include <delref/algorithms/planar.hpp>
#include <delref/domain/build_planar_domain.hpp>
#include <delref/levels/split_point.hpp>

#include "../property/generators.hpp"
#include "../property/promises.hpp"
#include "../unit/domain/graphs.hpp"

using namespace delref;

TEST_CASE("A zone that split a subsegment names no edge of the next free vertex") {
  using Tr = ConstrainedDelaunay2<>;
  Tr tr;
  const Control control;
  const CheckedPslg checked = check_pslg(graphs::square(), {}, control);
  const PlanarDomain domain = PlanarDomainBuilder<Tr>(tr, checked, control).domain();
  Tr::Zone zone;  // one for both, as in a mesher
  const auto e = tr.subsegments().front();
  const Point2 m = midpoint(tr.point(tr.source(e)), tr.point(tr.target(e)));
  tr.conflict_zone(m, e, zone);
  CHECK_FALSE(tr.insert(m, zone) == Tr::Vertex{});
  const Point2 p{0.4, 0.6};
  tr.conflict_zone(p, Tr::Face{tr.cgal().locate({p.x, p.y})}, zone);
  const auto v = tr.insert(p, zone);
  CHECK_FALSE(v == Tr::Vertex{});
  CHECK(tr.subsegments().size() == 5);
  for (const auto s : tr.subsegments()) CHECK((!(tr.source(s) == v) && !(tr.target(s) == v)));
}

TEST_CASE("A needle whose corner has ends that do not line up is meshed to the end") {
  // Two segments of nearly one direction and different lengths: their split points have to be on common shells.
  const Pslg needle = graphs::graph({{0, 0}, {0.7251154744912752, -0.581624184976141}, {0.5818402121133647, -0.4667007404345388}},
                                    {{0, 1}, {1, 2}, {2, 0}});
  for (const property::Mode& mode : property::modes) {
    CAPTURE(mode.name);
    const PlanarOptions options = mode.options(needle);
    Budget budget;
    budget.max_vertices = 200'000;
    const PlanarResult result = mesh_planar(needle, options, Control(budget));
    CHECK(result.outcome.complete());
    CHECK(property::broken_promises(needle, result.mesh, property::promises(options, result.outcome)) == "");
  }
}

TEST_CASE("A split point is never out of order on its segment, however short the subsegment") {
  property::Random random(7);
  for (int k = 0; k < 20'000; ++k) {
    const Point2 p{random.uniform(-1, 1), random.uniform(-1, 1)}, q{random.uniform(-1, 1), random.uniform(-1, 1)};
    const double t = random.uniform(), width = std::pow(10, random.uniform(-16, -12));
    const Point2 a = onto_line(p + t * (q - p), p, q), b = onto_line(p + (t + width) * (q - p), p, q);
    if (a == b) continue;
    for (const Point2 m : {split_point(a, b, p, q), split_point_near_corner(a, b, p, q)}) CHECK((m == a || is_between(m, a, b, q - p)));
  }
}

TEST_CASE("A seed on a vertex that no segment uses is inside its region") {
  Pslg pslg = graphs::with_points(graphs::square(), {{0.5, 0.5}});
  pslg.regions = {{{0.5, 0.5}, 4, 0}};
  const PlanarResult result = mesh_planar(pslg, {});
  CHECK(std::ranges::all_of(result.mesh.regions, [](int label) { return label == 4; }));
}

TEST_CASE("A vertex added on the boundary of a mesh without Steiner vertices is next to the box around it") {
  // The box's vertices have the highest numbers then; a table by vertex number was too short for them.
  PlanarRefinement refinement(graphs::square());
  Pslg extra;
  extra.points = {{0.5, 0}};
  refinement.add(extra);
  CHECK(refinement.refine().complete());
  CHECK(refinement.mesh().points.size() >= 5);
}
