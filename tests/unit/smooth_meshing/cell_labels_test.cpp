// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cells have the label of their circumcentre, and none beyond the bounds; centres of surface balls are on dual edges, in bounds, and
// where the label changes.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

#include <catch2/catch_test_macros.hpp>

#include <delref/criteria/tetrahedron_shape.hpp>
#include <delref/levels/cell_labels.hpp>
#include <delref/triangulation/delaunay_3.hpp>

#include "../../property/generators.hpp"  // for its random numbers alone
#include "scenes.hpp"

using namespace delref;

namespace {

using Tr = Delaunay3<1, 1>;

/// Points at random, none far around them: duals are far out, and cells on the hull are infinite.
void fill(Tr& tr, std::uint64_t seed, int count) {
  property::Random random(seed);
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(count); ++i) {
    const auto v = tr.cgal().insert(Tr::Cgal::Point(random.uniform(-1.8, 1.8), random.uniform(-1.8, 1.8), random.uniform(-1.8, 1.8)));
    v->index = i;
  }
  tr.number_from(static_cast<std::size_t>(count));
}
bool is_in(const BoundingBox3& b, Point3 p, double margin = 0) {
  return p.x >= b.low.x - margin && p.x <= b.high.x + margin && p.y >= b.low.y - margin && p.y <= b.high.y + margin &&
         p.z >= b.low.z - margin && p.z <= b.high.z + margin;
}
double distance_to_border(const BoundingBox3& b, Point3 p) {
  return std::min({p.x - b.low.x, b.high.x - p.x, p.y - b.low.y, b.high.y - p.y, p.z - b.low.z, b.high.z - p.z});
}
TetrahedronShape shape(const Tr& tr, Tr::Cell c) {
  const auto v = tr.vertices(c);
  return TetrahedronShape({tr.point(v[0]), tr.point(v[1]), tr.point(v[2]), tr.point(v[3])});
}

const std::vector<std::function<int(Point3)>> domains{
    [](Point3) { return 0; },                                                     // all that is in bounds
    [](Point3 p) { return p.x < 0.2 ? 0 : outside; },                             // reaches five sides of them
    [](Point3 p) { return radius(p) < 1.2 ? 0 : outside; },                       // none
    [](Point3 p) { return p.x < -0.3 ? 2 : p.y < 0.4 ? 0 : p.z < 0 ? 1 : outside; }  // several regions and the outside reach them
};

}  // namespace

TEST_CASE("cells have the region of their circumcentre, and those beyond the bounds and infinite ones are outside") {
  for (std::size_t k = 0; k < domains.size(); ++k) {
    const Regions3 domain{domains[k]};
    Tr tr;
    fill(tr, k, 200);
    CellLabels<Tr, Regions3> labels(domain);
    labels.label_all(tr);
    std::size_t beyond = 0, in_bounds = 0;
    for (const auto c : tr.all_cells()) {
      if (tr.is_infinite(c)) {
        REQUIRE(tr.region(c) == outside);
        continue;
      }
      const TetrahedronShape t = shape(tr, c);
      if (t.is_flat()) continue;
      const bool is_in_bounds = is_in(domain.box, t.circumcentre);
      ++(is_in_bounds ? in_bounds : beyond);
      REQUIRE(tr.region(c) == (is_in_bounds ? domain.region(t.circumcentre) : outside));
    }
    CHECK(beyond > 20);
    CHECK(in_bounds > 100);
  }
}

TEST_CASE("only the cells that are given are labelled") {
  const Regions3 domain{domains[0]};
  Tr tr;
  fill(tr, 9, 50);
  CellLabels<Tr, Regions3> labels(domain);
  std::vector<Tr::Cell> all;
  for (const auto c : tr.all_cells()) tr.set_region(c, 77), all.push_back(c);
  labels.label(tr, std::span(all).first(40));
  for (std::size_t i = 0; i < all.size(); ++i) CHECK((tr.region(all[i]) == 77) == (i >= 40));
  labels.label(tr, {});
}

TEST_CASE("the centre of a surface ball is on the dual edge, in bounds, where the label changes or the bounds end") {
  constexpr double tolerance = 1e-9;
  for (std::size_t k = 0; k < domains.size(); ++k) {
    const Regions3 domain{domains[k]};
    Tr tr;
    fill(tr, 10 + k, 150);
    CellLabels<Tr, Regions3> labels(domain);
    labels.label_all(tr);
    std::size_t facets = 0, on_border = 0, of_infinite = 0;
    for (const auto c : tr.finite_cells())
      for (int i = 0; i < 4; ++i) {
        const Tr::Facet f = tr.facet(c, i);
        const auto n = tr.cell(tr.mirror(f));
        if (tr.region(c) <= tr.region(n) || shape(tr, c).is_flat() || (!tr.is_infinite(n) && shape(tr, n).is_flat())) continue;
        CAPTURE(k, facets);
        ++facets;
        of_infinite += tr.is_infinite(n);
        const Point3 centre = labels.surface_centre(tr, f, tolerance);
        REQUIRE(is_in(domain.box, centre, 1e-12));
        const auto v = tr.vertices(f);
        const double r = std::sqrt(squared_distance(centre, tr.point(v[0])));
        for (const auto w : v) REQUIRE(std::abs(std::sqrt(squared_distance(centre, tr.point(w))) - r) < 1e-7 * (1 + r));
        // Along the edge from the circumcentre the label is that of the cell before, and another one behind.
        const Point3 from = shape(tr, c).circumcentre;
        const double length = std::sqrt(squared_distance(from, centre));
        if (distance_to_border(domain.box, centre) < 1e-9) {
          ++on_border;
        } else if (length > 1e-4) {
          const Vector3 step = (1e-6 / length) * (centre - from);
          REQUIRE(domain.region(centre + -1.0 * step) == tr.region(c));
          REQUIRE(domain.region(centre + step) != tr.region(c));
        }
      }
    CHECK(facets > 50);
    if (k != 2) CHECK(on_border > 20);
    if (k == 2) CHECK(on_border == 0);
    if (k != 2) CHECK(of_infinite > 0);
  }
}

TEST_CASE("a region that fills its bounds has all its centres on their border") {
  const Regions3 domain{domains[0], {{-1, -1.5, -1}, {1.2, 1, 1.7}}};
  Tr tr;
  fill(tr, 21, 150);
  CellLabels<Tr, Regions3> labels(domain);
  labels.label_all(tr);
  std::size_t facets = 0;
  for (const auto c : tr.finite_cells())
    for (int i = 0; i < 4; ++i) {
      const Tr::Facet f = tr.facet(c, i);
      if (tr.region(c) <= tr.region(tr.cell(tr.mirror(f)))) continue;
      ++facets;
      CHECK(std::abs(distance_to_border(domain.box, labels.surface_centre(tr, f, 1e-6))) < 1e-12);
    }
  CHECK(facets > 50);
}
