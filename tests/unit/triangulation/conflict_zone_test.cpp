// SPDX-License-Identifier: GPL-3.0-or-later
//
// Conflict zones of the constrained Delaunay triangulation: where the search for a point ends, what dies, and what the new faces
// take over from the old ones.
#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include <catch2/catch_test_macros.hpp>

#include <delref/domain/build_planar_domain.hpp>
#include <delref/domain/pslg_check.hpp>
#include <delref/triangulation/constrained_delaunay_2.hpp>

#include "../domain/graphs.hpp"

using namespace delref;

namespace {

using Tr = ConstrainedDelaunay2<>;
using Kind = Location<Tr>::Kind;

/// Triangulates a graph; the domain's regions are numbered from 1 in the order of their seeds.
PlanarDomain build(Tr& tr, Pslg pslg) {
  const Control control;
  const CheckedPslg checked = check_pslg(std::move(pslg), {}, control);
  return PlanarDomainBuilder<Tr>(tr, checked, control).domain();
}
/// A square in two halves, of which the left is region 1 and the right 2; segment 4 is between them.
Pslg halves() {
  Pslg p = graphs::graph({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}}, {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {1, 4}, {4, 5}, {5, 0}});
  p.regions = {{{0.5, 0.5}, 10, 0}, {{1.5, 0.5}, 20, 0}};
  return p;
}
Tr::Face face_at(const Tr& tr, Point2 p) { return {tr.cgal().locate({p.x, p.y})}; }
Tr::Edge subsegment_of(const Tr& tr, std::size_t segment) {
  for (const auto e : tr.subsegments())
    if (tr.segment(e) == segment) return e;
  FAIL("no such subsegment");
  return {};
}
/// Inserts a free vertex.
Tr::Vertex insert(Tr& tr, Point2 p) {
  Tr::Zone zone;
  REQUIRE(tr.conflict_zone(p, face_at(tr, p), zone).kind == Kind::zone);
  const Tr::Vertex v = tr.insert(p, zone);
  tr.set_origin(v, {2, Carrier::none}, 1);
  return v;
}
std::size_t count_subsegments(const Tr& tr, std::size_t segment) {
  return static_cast<std::size_t>(std::ranges::count_if(tr.subsegments(), [&](auto e) { return tr.segment(e) == segment; }));
}

}  // namespace

TEST_CASE("The zone of a point is what its circumcircles hold, with a boundary of two edges more than faces") {
  Tr tr;
  build(tr, graphs::square());
  const Point2 p{0.5, 0.25};
  const Tr::Face f = face_at(tr, p);
  Tr::Zone zone;
  REQUIRE(tr.conflict_zone(p, f, zone).kind == Kind::zone);
  CHECK(tr.dies(f, zone));
  CHECK(zone.dying_faces().size() == 2);
  CHECK(zone.boundary_edges().size() == 4);
  CHECK(zone.dying_subsegments().empty());
  CHECK(zone.vanishing().empty());
  for (const Tr::Edge e : zone.boundary_edges()) {
    CHECK(!tr.dies(tr.face(e), zone));
    CHECK(tr.is_constrained(e));
  }
  const std::size_t before = tr.number_of_vertices();
  const Tr::Vertex v = tr.insert(p, zone);
  CHECK_FALSE(v == Tr::Vertex{});
  CHECK(tr.point(v) == p);
  CHECK(tr.number_of_vertices() == before + 1);
  CHECK(zone.new_faces().size() == 4);
  for (const Tr::Face n : zone.new_faces()) CHECK(tr.in_domain(n));
  CHECK(tr.cgal().is_valid());
}

TEST_CASE("A zone that is not used leaves the triangulation as it was") {
  Tr tr;
  build(tr, graphs::square());
  Tr::Zone zone;
  const Point2 p{0.5, 0.25}, q{0.5, 0.75};
  REQUIRE(tr.conflict_zone(p, face_at(tr, p), zone).kind == Kind::zone);
  REQUIRE(tr.conflict_zone(q, face_at(tr, q), zone).kind == Kind::zone);
  CHECK(zone.dying_faces().size() == 2);
  CHECK_FALSE(tr.insert(q, zone) == Tr::Vertex{});
  for (const Tr::Face f : tr.finite_faces()) CHECK(!tr.dies(f, zone));
  CHECK(tr.cgal().is_valid());
}

TEST_CASE("A constraint between the hint and the point blocks it") {
  Tr tr;
  build(tr, halves());
  Tr::Zone zone;
  const auto where = tr.conflict_zone({1.9, 0.5}, face_at(tr, {0.1, 0.5}), zone);
  REQUIRE(where.kind == Kind::blocked);
  CHECK(tr.segment(where.blocker) == 4);
  SECTION("and so does one that the point lies on") {
    const auto on = tr.conflict_zone({1, 0.5}, face_at(tr, {0.1, 0.5}), zone);
    REQUIRE(on.kind == Kind::blocked);
    CHECK(tr.segment(on.blocker) == 4);
  }
}

TEST_CASE("A point outside the triangulated box is outside") {
  Tr tr;
  build(tr, graphs::square());
  Tr::Zone zone;
  CHECK(tr.conflict_zone({50, 60}, face_at(tr, {2.5, 2.5}), zone).kind == Kind::outside);
}

TEST_CASE("A point with the coordinates of a vertex is on that vertex, whatever the hint") {
  Tr tr;
  build(tr, graphs::square());
  const Tr::Vertex v = insert(tr, {0.5, 0.25});
  Tr::Zone zone;
  CHECK(tr.conflict_zone({0.5, 0.25}, face_at(tr, {0.1, 0.6}), zone).kind == Kind::on_vertex);
  CHECK(tr.conflict_zone({0.5, 0.25}, v, zone).kind == Kind::on_vertex);
  const Tr::Edge e = subsegment_of(tr, 0);
  CHECK(tr.conflict_zone(tr.point(tr.source(e)), e, zone).kind == Kind::on_vertex);
}

TEST_CASE("A hint that is a vertex starts the search at it") {
  Tr tr;
  build(tr, graphs::square());
  const Tr::Vertex v = insert(tr, {0.5, 0.25});
  Tr::Zone zone;
  REQUIRE(tr.conflict_zone({0.45, 0.6}, v, zone).kind == Kind::zone);
  CHECK_FALSE(tr.insert({0.45, 0.6}, zone) == Tr::Vertex{});
  CHECK(tr.cgal().is_valid());
}

TEST_CASE("A point that splits a subsegment spans both its sides, which keep their regions, and its halves keep its name") {
  Tr tr;
  build(tr, halves());
  const Tr::Edge e = subsegment_of(tr, 4);
  Tr::Zone zone;
  REQUIRE(tr.conflict_zone({1, 0.5}, e, zone).kind == Kind::zone);
  REQUIRE(zone.dying_subsegments().size() == 1);
  CHECK(tr.segment(zone.dying_subsegments()[0]) == 4);
  CHECK(tr.dies(e, zone));
  const Tr::Vertex v = tr.insert({1, 0.5}, zone);
  for (const Tr::Face f : zone.new_faces()) CHECK(tr.region(f) == (tr.barycentre(tr.vertices(f)).x < 1 ? 1 : 2));
  CHECK(count_subsegments(tr, 4) == 2);
  for (const Tr::Edge s : tr.subsegments())
    if (tr.segment(s) == 4) CHECK((tr.source(s) == v || tr.target(s) == v));
  CHECK(tr.subsegments().size() == 8);
  CHECK(tr.cgal().is_valid());
}

TEST_CASE("A split point beside its subsegment by rounding splits it all the same") {
  Tr tr;
  build(tr, graphs::graph({{0, 0}, {1, 0.3}, {0.2, 1}}, {{0, 1}, {1, 2}, {2, 0}}));
  for (const double y : {0.15 - 1e-17, 0.15, 0.15 + 3e-17}) {
    Tr::Zone zone;
    REQUIRE(tr.conflict_zone({0.5, y}, subsegment_of(tr, 0), zone).kind == Kind::zone);
  }
  Tr::Zone zone;
  tr.conflict_zone({0.5, std::nextafter(0.15, 1)}, subsegment_of(tr, 0), zone);
  CHECK_FALSE(tr.insert({0.5, std::nextafter(0.15, 1)}, zone) == Tr::Vertex{});
  CHECK(count_subsegments(tr, 0) == 2);
  CHECK(tr.subsegments().size() == 4);
}

TEST_CASE("The free vertices that vanish are gone when their subsegment is split") {
  Tr tr;
  build(tr, halves());
  const Tr::Vertex left = insert(tr, {0.9, 0.5}), right = insert(tr, {1.1, 0.45});
  const std::size_t before = tr.number_of_vertices();
  const std::array vanishing{left, right};
  Tr::Zone zone;
  REQUIRE(tr.conflict_zone({1, 0.5}, subsegment_of(tr, 4), vanishing, zone).kind == Kind::zone);
  REQUIRE(zone.vanishing().size() == 2);
  CHECK_FALSE(tr.insert({1, 0.5}, zone) == Tr::Vertex{});
  CHECK(tr.number_of_vertices() == before - 1);
  CHECK(count_subsegments(tr, 4) == 2);
  CHECK(tr.subsegments().size() == 8);
  for (const Tr::Vertex v : tr.finite_vertices()) {
    CHECK(tr.point(v) != Point2{0.9, 0.5});
    CHECK(tr.point(v) != Point2{1.1, 0.45});
  }
  for (const Tr::Face f : tr.domain_faces()) CHECK(tr.region(f) == (tr.barycentre(tr.vertices(f)).x < 1 ? 1 : 2));
  CHECK(tr.cgal().is_valid());
}

TEST_CASE("Edges around a zone keep their slots, names and numbers; new faces have none") {
  Tr tr;
  build(tr, halves());
  insert(tr, {0.5, 0.5});
  QueuePosition next = 100;
  for (const Tr::Edge e : tr.subsegments()) tr.set_slot(e, 0, next++);
  for (const Tr::Face f : tr.domain_faces()) tr.set_slot(f, 0, 7);
  std::set<QueuePosition> expected;
  for (const Tr::Edge e : tr.subsegments())
    if (tr.segment(e) != 4) expected.insert(tr.slot(e, 0));
  Tr::Zone zone;
  REQUIRE(tr.conflict_zone({1, 0.5}, subsegment_of(tr, 4), zone).kind == Kind::zone);
  CHECK_FALSE(tr.insert({1, 0.5}, zone) == Tr::Vertex{});
  std::set<QueuePosition> found;
  for (const Tr::Edge e : tr.subsegments()) {
    CHECK(tr.slot(e, 0) == tr.slot(tr.mirror(e), 0));
    CHECK(tr.segment(e) == tr.segment(tr.mirror(e)));
    if (tr.segment(e) == 4) CHECK(tr.slot(e, 0) == -1);
    else found.insert(tr.slot(e, 0));
  }
  CHECK(found == expected);
  for (const Tr::Face f : zone.new_faces()) CHECK(tr.slot(f, 0) == -1);
}

TEST_CASE("Vertices have numbers that are never used again, input first") {
  Tr tr;
  build(tr, graphs::square());
  const Tr::Vertex v = insert(tr, {0.25, 0.5});
  const std::size_t number = tr.index(v);
  const std::array vanishing{v};
  Tr::Zone zone;
  REQUIRE(tr.conflict_zone({0, 0.5}, subsegment_of(tr, 3), vanishing, zone).kind == Kind::zone);
  const Tr::Vertex w = tr.insert({0, 0.5}, zone);
  tr.set_origin(w, {1, 3}, 0);
  CHECK(tr.index(w) > number);
  for (const Tr::Vertex u : tr.finite_vertices())
    if (tr.carrier(u).dimension == 0) CHECK(tr.index(u) == tr.carrier(u).index);
}
