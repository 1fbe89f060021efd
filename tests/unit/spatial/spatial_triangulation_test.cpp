// SPDX-License-Identifier: GPL-3.0-or-later
//
// The triangulation of space under insertion by conflict zones, and the triangulations of facets that are kept beside it.
#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

#include <delref/domain/build_polyhedral_domain.hpp>
#include <delref/domain/check_plc.hpp>
#include <delref/levels/facet_complex.hpp>
#include <delref/triangulation/delaunay_3.hpp>

#include "../../property/generators.hpp"  // for its random numbers alone
#include "../domain_3/complexes.hpp"

using namespace delref;
using Catch::Approx;

namespace {

using Tr = Delaunay3<>;
using Kind = Location<Tr>::Kind;
using Complex = FacetComplex<Tr>;

/// The corners of a cube, from which on points are inserted by their zones.
void start(Tr& tr) {
  for (int i = 0; i < 8; ++i) {
    const auto v = tr.cgal().insert(Tr::Cgal::Point(i & 1, i / 2 & 1, i / 4));
    v->index = static_cast<std::uint32_t>(i);
  }
  tr.number_from(8);
}
Tr::Vertex insert(Tr& tr, Point3 p) {
  Tr::Zone zone;
  REQUIRE(tr.conflict_zone(p, tr.infinite_cell(), zone).kind == Kind::zone);
  return tr.insert(p, zone);
}

/// A complex with its vertices in a triangulation and its facets beside it.
struct Scene {
  explicit Scene(Plc plc)
      : domain(check_plc(std::move(plc))), vertices(insert_input_points(tr, domain, Control{})), facets(tr, domain, vertices) {}

  Tr tr;
  PolyhedralDomain domain;
  std::vector<Tr::Vertex> vertices;
  Complex facets;

  double area(Complex::Id id) const {
    const auto& frame = domain.facets[facets[id].facet].frame;
    const auto& c = facets[id].corners;
    const Point2 a = frame.project(tr.point(c[0]));
    return 0.5 * cross(frame.project(tr.point(c[1])) - a, frame.project(tr.point(c[2])) - a);
  }
  std::vector<double> areas() const {
    std::vector<double> sums(domain.facets.size());
    facets.for_each([&](Complex::Id id) { sums[facets[id].facet] += area(id); });
    return sums;
  }
  /// Counterclockwise, found by its corners, and each neighbour has the same edge the other way round.
  void check() const {
    facets.for_each([&](Complex::Id id) {
      const auto& s = facets[id];
      CHECK(area(id) > 0);
      CHECK(facets.find(tr, s.corners[2], s.corners[0], s.corners[1]) == id);
      for (int i = 0; i < 3; ++i) {
        const Complex::Id n = s.neighbours[static_cast<std::size_t>(i)];
        if (n == Complex::none) continue;
        CHECK(facets[n].facet == s.facet);
        const auto back = std::ranges::find(facets[n].neighbours, id);
        REQUIRE(back != facets[n].neighbours.end());
        const auto [a, b] = facets.ends({id, i});
        const auto [c, d] = facets.ends({n, static_cast<int>(back - facets[n].neighbours.begin())});
        CHECK((a == d && b == c));
      }
    });
  }
  std::size_t count() const {
    std::size_t n = 0;
    facets.for_each([&](Complex::Id) { ++n; });
    return n;
  }
  /// Whether no point of the facet is inside the circle of one of its subfacets, but for edges on segments.
  bool is_delaunay() const {
    bool result = true;
    facets.for_each([&](Complex::Id id) {
      for (const Complex::Id n : facets[id].neighbours) {
        if (n == Complex::none) continue;
        for (const Tr::Vertex v : facets[n].corners)
          if (std::ranges::find(facets[id].corners, v) == facets[id].corners.end() && facets.in_circumcircle(tr, id, tr.point(v)))
            result = false;
      }
    });
    return result;
  }
  /// A new vertex in space, on no facet yet.
  Tr::Vertex vertex(Point3 p) { return insert(tr, p); }
};
constexpr auto nothing = [](Complex::Id) {};

/// A square of side 1 in the plane z = 0 over a tetrahedron's apex, which makes it a solid.
Plc pyramid() {
  Plc plc;
  plc.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.4, 0.6, 1}};
  plc.facets = {complexes::facet({{0, 1, 2, 3}}, 1), complexes::facet({{0, 1, 4}}), complexes::facet({{1, 2, 4}}),
                complexes::facet({{2, 3, 4}}), complexes::facet({{3, 0, 4}})};
  return plc;
}

}  // namespace

TEST_CASE("Insertion at random keeps the triangulation Delaunay") {
  Tr tr;
  start(tr);
  property::Random random(1);
  for (int k = 0; k < 300; ++k) insert(tr, {random.uniform(), random.uniform(), random.uniform()});
  CHECK(tr.number_of_vertices() == 308);
  CHECK(tr.cgal().is_valid());
}

TEST_CASE("Insertion on a lattice, where all is cospherical, keeps the triangulation Delaunay and without flat cells") {
  Tr tr;
  start(tr);
  property::Random random(2);
  std::vector<Point3> lattice;
  for (int i = 0; i < 125; ++i) lattice.push_back({0.25 * (i % 5), 0.25 * (i / 5 % 5), 0.25 * (i / 25)});
  for (std::size_t i = lattice.size(); i > 1; --i) std::swap(lattice[i - 1], lattice[random.next() % i]);
  Tr::Zone zone;
  for (const Point3 p : lattice)
    if (tr.conflict_zone(p, tr.infinite_cell(), zone).kind == Kind::zone) tr.insert(p, zone);
  CHECK(tr.number_of_vertices() == 125);
  CHECK(tr.cgal().is_valid());
  for (const Tr::Cell c : tr.finite_cells()) {
    const auto v = tr.vertices(c);
    const Vector3 a = tr.point(v[1]) - tr.point(v[0]), b = tr.point(v[2]) - tr.point(v[0]), d = tr.point(v[3]) - tr.point(v[0]);
    CHECK(dot(a, cross(b, d)) > 0);
  }
}

TEST_CASE("A point on a vertex has no zone, wherever the search starts") {
  Tr tr;
  start(tr);
  insert(tr, {0.5, 0.5, 0.5});
  Tr::Zone zone;
  for (const Tr::Vertex v : tr.finite_vertices())
    for (const Tr::Cell c : tr.all_cells()) {
      CHECK(tr.conflict_zone(tr.point(v), c, zone).kind == Kind::on_vertex);
      CHECK(zone.dying_cells().empty());
    }
  CHECK(tr.cgal().is_valid());
}

TEST_CASE("A point outside the hull has a zone and is inserted") {
  Tr tr;
  start(tr);
  property::Random random(3);
  for (int k = 0; k < 60; ++k) insert(tr, {random.uniform(-3, 4), random.uniform(-3, 4), random.uniform(-3, 4)});
  insert(tr, {0.5, 0.5, 100});
  insert(tr, {0.5, 0.5, 101});
  CHECK(tr.number_of_vertices() == 70);
  CHECK(tr.cgal().is_valid());
}

TEST_CASE("Points of hull facets and edges keep the triangulation Delaunay") {
  Tr tr;
  start(tr);
  for (const Point3 p : {Point3{0.5, 0.5, 0}, {0.5, 0, 0}, {1, 1, 0.3}, {1, 0.2, 0.3}, {0.5, 0.5, 1}, {0.25, 0.5, 1}}) insert(tr, p);
  CHECK(tr.number_of_vertices() == 14);
  CHECK(tr.cgal().is_valid());
}

TEST_CASE("The zone is what the circumspheres hold, and its boundary is named from outside") {
  Tr tr;
  start(tr);
  property::Random random(4);
  for (int k = 0; k < 100; ++k) insert(tr, {random.uniform(), random.uniform(), random.uniform()});
  Tr::Zone zone;
  for (int k = 0; k < 50; ++k) {
    const Point3 p{random.uniform(), random.uniform(), random.uniform()};
    REQUIRE(tr.conflict_zone(p, tr.infinite_cell(), zone).kind == Kind::zone);
    std::size_t holding = 0;
    for (const Tr::Cell c : tr.all_cells()) {
      const bool holds = tr.cgal().side_of_sphere(c.handle, Tr::Cgal::Point(p.x, p.y, p.z), true) == CGAL::ON_BOUNDED_SIDE;
      holding += holds;
      CHECK(tr.dies(c, zone) == holds);
    }
    CHECK(zone.dying_cells().size() == holding);
    for (const Tr::Facet f : zone.boundary_facets()) {
      CHECK_FALSE(tr.dies(tr.cell(f), zone));
      CHECK(tr.dies(tr.cell(tr.mirror(f)), zone));
    }
  }
}

TEST_CASE("Marks around the zone and regions go over to the new cells") {
  Tr tr;
  start(tr);
  for (const Tr::Cell c : tr.finite_cells()) tr.set_region(c, 3);
  std::size_t marked = 0;
  for (const Tr::Cell c : tr.finite_cells())
    for (int i = 0; i < 4; ++i)
      if (tr.is_infinite(tr.cell(tr.mirror(tr.facet(c, i))))) tr.mark(tr.facet(c, i), true), ++marked;
  CHECK(marked == 12);
  insert(tr, {0.4, 0.5, 0.6});
  insert(tr, {0.7, 0.3, 0.2});
  std::size_t still_marked = 0;
  for (const Tr::Cell c : tr.finite_cells()) {
    CHECK(tr.region(c) == 3);
    for (int i = 0; i < 4; ++i) {
      const bool on_hull = tr.is_infinite(tr.cell(tr.mirror(tr.facet(c, i))));
      CHECK(tr.is_marked(tr.facet(c, i)) == on_hull);
      still_marked += on_hull;
    }
  }
  CHECK(still_marked == 12);
}

TEST_CASE("The triangulations of the facets of a box fit together and cover them") {
  const Scene scene(complexes::box({0, 0, 0}, {2, 1, 1}));
  CHECK(scene.count() == 12);
  scene.check();
  for (const double area : scene.areas()) CHECK((area == Approx(1) || area == Approx(2)));
}

TEST_CASE("A subsegment that is split is split in every facet that has it") {
  Scene scene(complexes::box());
  const Tr::Vertex a = scene.vertices[0], b = scene.vertices[1];
  const Tr::Vertex m = scene.vertex(midpoint(scene.tr.point(a), scene.tr.point(b)));
  std::vector<Complex::Id> created;
  std::size_t removed = 0;
  scene.facets.split_subsegment(scene.tr, a, b, m, [&](Complex::Id) { ++removed; }, created);
  CHECK(removed >= 2);
  std::set<std::uint32_t> facets;
  for (const Complex::Id id : created) {
    CHECK(std::ranges::find(scene.facets[id].corners, m) != scene.facets[id].corners.end());
    facets.insert(scene.facets[id].facet);
  }
  CHECK(facets.size() == 2);
  CHECK(scene.count() == 14);
  scene.check();
  for (const double area : scene.areas()) CHECK(area == Approx(1));
}

TEST_CASE("Splits and insertions at random keep facets covered and Delaunay") {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    Scene scene(complexes::moved(complexes::box({0, 0, 0}, {2, 1, 1}), static_cast<unsigned>(seed), 1, 0));
    const std::vector<double> before = scene.areas();
    property::Random random(seed);
    std::vector<Complex::Id> created;
    for (int k = 0; k < 60; ++k) {
      // Somewhere in a subfacet, or the middle of one of its sides if that is on a subsegment.
      std::vector<Complex::Id> all;
      scene.facets.for_each([&](Complex::Id id) { all.push_back(id); });
      const Complex::Id id = all[random.next() % all.size()];
      const auto s = scene.facets[id];
      const auto corner = [&](std::size_t i) { return scene.tr.point(s.corners[i]); };
      const int side = random.integer(0, 2);
      if (s.neighbours[static_cast<std::size_t>(side)] == Complex::none) {
        const auto [a, b] = scene.facets.ends({id, side});
        if (squared_distance(scene.tr.point(a), scene.tr.point(b)) < 1e-3) continue;
        const Tr::Vertex m = scene.vertex(midpoint(scene.tr.point(a), scene.tr.point(b)));
        scene.facets.split_subsegment(scene.tr, a, b, m, nothing, created);
      } else {
        const double u = random.uniform(0.2, 0.5), v = random.uniform(0.2, 0.4);
        const Tr::Vertex m = scene.vertex(corner(0) + u * (corner(1) - corner(0)) + v * (corner(2) - corner(0)));
        scene.facets.insert(scene.tr, id, m, nothing, created);
      }
    }
    scene.check();
    CHECK(scene.is_delaunay());
    const std::vector<double> after = scene.areas();
    for (std::size_t f = 0; f < before.size(); ++f) CHECK(after[f] == Approx(before[f]).epsilon(1e-12));
  }
}

TEST_CASE("A walk in a facet ends where the point is, or at the subsegment that blocks it") {
  Scene scene(pyramid());
  std::vector<Complex::Id> created;
  Complex::Id first = Complex::none;
  scene.facets.for_each([&](Complex::Id id) {
    if (scene.facets[id].facet == 0 && first == Complex::none) first = id;
  });
  property::Random random(5);
  for (int k = 0; k < 40; ++k) {
    const Point3 p{random.uniform(0.01, 0.99), random.uniform(0.01, 0.99), 0};
    const Complex::Place place = scene.facets.locate(scene.tr, first, p);
    REQUIRE(place.subfacet != Complex::none);
    CHECK_FALSE(place.blocker);
    const auto& c = scene.facets[place.subfacet].corners;
    for (std::size_t i = 0; i < 3; ++i) {  // seen counterclockwise from the facet's own side
      const auto& frame = scene.domain.facets[0].frame;
      const Point2 a = frame.project(scene.tr.point(c[i])), b = frame.project(scene.tr.point(c[(i + 1) % 3]));
      CHECK(cross(b - a, frame.project(p) - a) >= -1e-15);
    }
    scene.facets.insert(scene.tr, place.subfacet, scene.vertex(p), nothing, created);
    first = created.front();
  }
  const Complex::Place outside = scene.facets.locate(scene.tr, first, {0.5, 3, 0});
  REQUIRE(outside.blocker);
  CHECK(scene.facets[outside.blocker->subfacet].neighbours[static_cast<std::size_t>(outside.blocker->side)] == Complex::none);
  for (const Tr::Vertex v : scene.facets.ends(*outside.blocker)) CHECK(scene.tr.point(v).y == 1);
}

TEST_CASE("The diagonals of a square are as good as each other, and the other one can be taken") {
  Scene scene(pyramid());
  std::vector<Complex::Id> square;
  scene.facets.for_each([&](Complex::Id id) {
    if (scene.facets[id].facet == 0) square.push_back(id);
  });
  REQUIRE(square.size() == 2);
  const auto side = scene.facets.side_between(square[0], square[1]);
  REQUIRE(side);
  CHECK(scene.facets.tie(scene.tr, *side));
  CHECK(scene.facets.is_convex(scene.tr, *side));
  const auto before = scene.facets.ends(*side);
  scene.facets.flip(scene.tr, *side, nothing);
  const auto after = scene.facets.side_between(square[0], square[1]);
  REQUIRE(after);
  for (const Tr::Vertex v : scene.facets.ends(*after)) CHECK(std::ranges::find(before, v) == before.end());
  scene.check();
  CHECK(scene.areas()[0] == Approx(1));
}
