// SPDX-License-Identifier: GPL-3.0-or-later
//
// What levels are handed (vertices, faces, edges, points, ranges, zones) can be compared, subtracted and iterated after an import
// alone. With CGAL's own types it could not: their operators are free functions, which an importer does not see.
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cstddef>
#include <ranges>
#include <tuple>
#include <vector>

import delref;

#include "scenes.hpp"

namespace {

using Tr = delref::ConstrainedDelaunay2<>;
static_assert(delref::PlanarTriangulation<Tr> && delref::Triangulation<Tr>);

/// The domain in a triangulation, and nothing refined yet.
struct Scene {
  delref::Control control;
  delref::CheckedPslg checked = delref::check_pslg(square_with_hole(), {}, control);
  Tr tr;
  delref::PlanarDomain domain = delref::PlanarDomainBuilder(tr, checked, control).domain();
};

double area(const Tr& tr, Tr::Face f) {
  const auto [a, b, c] = tr.vertices(f);
  return 0.5 * cross(tr.point(b) - tr.point(a), tr.point(c) - tr.point(a));
}

}  // namespace

TEST_CASE("the faces of the domain are iterated after import") {
  const Scene scene;
  const Tr& tr = scene.tr;
  double total = 0;
  std::size_t count = 0;
  for (const Tr::Face f : tr.domain_faces()) total += area(tr, f), ++count;
  CHECK(total == Catch::Approx(3));
  CHECK(count == 8);
  CHECK(static_cast<std::size_t>(std::ranges::distance(tr.finite_faces())) > count);
  CHECK(std::ranges::distance(tr.finite_vertices()) == 12);  // and the four of the box around the domain
}

TEST_CASE("ranges of the triangulation go through standard views after import") {
  static_assert(std::ranges::forward_range<decltype(std::declval<const Tr&>().domain_faces())>);
  static_assert(std::ranges::view<decltype(std::declval<const Tr&>().domain_faces())>);
  const Scene scene;
  const Tr& tr = scene.tr;
  const auto touches_corner = [&](Tr::Face f) {
    return std::ranges::any_of(tr.vertices(f), [&](Tr::Vertex v) { return tr.point(v) == delref::Point2{0, 0}; });
  };
  double at_corner = 0, all = 0;
  for (const double a : tr.domain_faces() | std::views::filter(touches_corner) |
                            std::views::transform([&](Tr::Face f) { return area(tr, f); }))
    at_corner += a;
  for (const double a : tr.domain_faces() | std::views::transform([&](Tr::Face f) { return area(tr, f); })) all += a;
  CHECK(at_corner > 0);
  CHECK(at_corner < all);
  CHECK(std::ranges::distance(tr.domain_faces() | std::views::take(3)) == 3);
  CHECK(std::ranges::count_if(tr.finite_vertices(), [&](Tr::Vertex v) { return tr.carrier(v).dimension == 0; }) == 8);
}

TEST_CASE("handles are compared after import") {
  const Scene scene;
  const Tr& tr = scene.tr;
  const Tr::Face f = *tr.domain_faces().begin();
  const Tr::Face again = tr.face(tr.edge(f, 0));
  CHECK(f == again);
  CHECK(tr.vertex(f, 0) != tr.vertex(f, 1));
  CHECK(tr.edge(f, 0) == tr.mirror(tr.mirror(tr.edge(f, 0))));
  CHECK(tr.edge(f, 0) != tr.edge(f, 1));
  CHECK(tr.source(tr.edge(f, 0)) == tr.vertex(f, 1));
  CHECK(tr.apex(tr.edge(f, 2)) == tr.vertex(f, 2));
  CHECK(Tr::Vertex{} == Tr::Vertex{});
}

TEST_CASE("subsegments know their input segment and their length after import") {
  const Scene scene;
  const Tr& tr = scene.tr;
  const auto subsegments = tr.subsegments();
  CHECK(subsegments.size() == 8);
  double length = 0;
  for (const Tr::Edge e : subsegments) {
    CHECK(tr.is_constrained(e));
    CHECK(scene.domain.segments[tr.segment(e)].bounds_domain);
    const delref::Vector2 along = tr.point(tr.target(e)) - tr.point(tr.source(e));
    length += std::max(std::abs(along.x), std::abs(along.y));
    CHECK_FALSE(tr.in_diametral_circle(e, tr.point(tr.source(e))));
  }
  CHECK(length == 12);
}

TEST_CASE("a conflict zone is searched, read and filled by hand after import") {
  Scene scene;
  Tr& tr = scene.tr;
  const Tr::Face f = *tr.domain_faces().begin();
  const auto corners = tr.vertices(f);
  Tr::Zone zone;
  const delref::Location<Tr> location = tr.conflict_zone(tr.barycentre(corners), Tr::Hint(f), zone);
  REQUIRE(location.kind == delref::Location<Tr>::Kind::zone);
  CHECK(std::ranges::find(zone.dying_faces(), f) != zone.dying_faces().end());
  CHECK(std::ranges::all_of(zone.dying_faces(), [&](Tr::Face dying) { return tr.dies(dying, zone); }));
  CHECK(zone.boundary_edges().size() == zone.dying_faces().size() + 2);
  CHECK(zone.vanishing().empty());
  const Tr::Vertex v = tr.insert(tr.barycentre(corners), zone);
  tr.set_origin(v, {2, delref::Carrier::none}, 0);
  CHECK(zone.new_faces().size() == zone.boundary_edges().size());
  CHECK(tr.number_of_vertices() == 13);
}

TEST_CASE("the levels are put together by hand after import, with every policy") {
  Scene scene;
  const auto bound = delref::AngleBound::degrees(25);
  const delref::DiametralLens lens{bound};
  static_assert(delref::Encroachment2<delref::DiametralLens, Tr> && delref::Encroachment2<delref::DiametralCircle, Tr>);
  static_assert(delref::PointChoice2<delref::OffCentre> && delref::PointChoice2<delref::Circumcentre>);
  using Criteria = delref::TriangleCriteria<delref::MinimumAngle>;
  using Edges = delref::EdgesLevel2<Tr, delref::DiametralLens, delref::LifoQueue<Tr::Edge>>;
  using Faces = delref::FacesLevel2<Tr, Criteria, delref::OffCentre, delref::FifoQueue<Tr::Face>>;
  static_assert(delref::explain_level<Edges, Tr>() && delref::explain_level<Faces, Tr>());
  delref::Mesher mesher(scene.tr, std::tuple(Edges(scene.domain, lens, delref::EdgesOptions{}),
                                             Faces(scene.domain, Criteria(delref::MinimumAngle{bound}), delref::OffCentre(bound))));
  auto outcome = mesher.refine();
  CHECK(outcome.complete());
  delref::SmallAngleExcuses(scene.tr, scene.domain).apply(outcome, delref::MinimumAngle::name);
  CHECK(outcome.unmet.empty());
  const delref::PlanarMesh mesh = delref::extract_planar_mesh(scene.tr, scene.domain, {"edges", "faces"});
  CHECK(delref::planar_quality(mesh).smallest_angle >= 25);
}
