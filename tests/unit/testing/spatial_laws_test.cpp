// SPDX-License-Identifier: GPL-3.0-or-later
//
// The levels of polyhedral meshing keep the laws: while they make a triangulation conform, with empty balls asked for and without,
// and with tetrahedra behind them, at walls, small input angles and facets that hang in the inside.
#include <catch2/catch_test_macros.hpp>

#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <delref/algorithms/polyhedral_levels.hpp>
#include <delref/core/mesher.hpp>
#include <delref/criteria/tetrahedron_criteria.hpp>
#include <delref/domain/build_polyhedral_domain.hpp>
#include <delref/domain/check_plc.hpp>
#include <delref/domain/label_polyhedral_domain.hpp>
#include <delref/testing/laws.hpp>
#include <delref/triangulation/delaunay_3.hpp>

#include "../../property_3/generators.hpp"

namespace {

using namespace delref;
using property_3::add_box;
using property_3::add_facet;
using Tr = Delaunay3<>;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Two boxes that share a wall; a square hangs in one, a segment and a vertex are loose in the other.
Plc two_rooms() {
  Plc plc;
  add_box(plc, {0, 0, 0}, {1, 1, 1});
  add_box(plc, {1, 0, 0}, {2, 1, 1});
  for (Plc::Facet& f : plc.facets) f.marker = 0;  // the wall is given twice
  add_facet(plc, {{0.2, 0.3, 0.5}, {0.6, 0.3, 0.5}, {0.6, 0.7, 0.55}, {0.2, 0.7, 0.55}});
  plc.points.insert(plc.points.end(), {{1.2, 0.5, 0.3}, {1.8, 0.4, 0.7}, {1.5, 0.8, 0.2}});
  const auto n = static_cast<Plc::Index>(plc.points.size());
  plc.segments.push_back({n - 3, n - 2});
  return plc;
}
/// A prism over a triangle with an angle of 15 degrees.
Plc wedge() {
  Plc plc;
  const Point3 a{0, 0, 0}, b{1, 0, 0}, c{0.9659, 0.2588, 0};
  const Vector3 up{0, 0, 1};
  add_facet(plc, {a, b, c});
  add_facet(plc, {a + up, b + up, c + up});
  add_facet(plc, {a, b, b + up, a + up});
  add_facet(plc, {b, c, c + up, b + up});
  add_facet(plc, {c, a, a + up, c + up});
  return plc;
}

void expect_none(const std::vector<std::string>& broken) {
  for (const std::string& sentence : broken) UNSCOPED_INFO(sentence);
  CHECK(broken.empty());
}

void check_conforming(const Plc& plc, ConformingOptions options) {
  const PolyhedralDomain domain = check_plc(plc);
  expect_none(testing::check_laws([&](auto run) {
    Tr tr;
    RegionRepair<Tr> repair;
    const auto vertices = insert_input_points(tr, domain, Control{});
    run(tr, conforming_levels<Tr>(tr, domain, vertices, repair, options));
  }));
}

void check_all(const Plc& plc, double radius_edge, double max_volume, ConformingOptions options = {}) {
  const PolyhedralDomain domain = check_plc(plc);
  const SmallAngleGuard guard(domain);
  expect_none(testing::check_laws([&](auto run) {
    Tr tr;
    RegionRepair<Tr> repair;
    const auto vertices = insert_input_points(tr, domain, Control{});
    Mesher<Tr, EdgesLevel3<Tr>, FacetsLevel3<Tr>> conforming(tr, conforming_levels<Tr>(tr, domain, vertices, repair, options));
    REQUIRE_FALSE(conforming.refine().stopped);
    PolyhedralDomainLabeller<Tr>(tr, domain, Control{}).take();
    TetrahedraLevel3<Tr, TetrahedronCriteria<RadiusEdge, MaximumVolume>> tetrahedra(
        TetrahedronCriteria(RadiusEdge{radius_edge}, MaximumVolume{max_volume}), repair, guard, options.smallest_edge);
    run(tr, polyhedral_levels(tr, conforming.release<0>(), conforming.release<1>(), std::move(tetrahedra)));
  }));
}

TEST_CASE("the conforming levels keep the laws where elements need only be present") {
  check_conforming(two_rooms(), {});
  check_conforming(wedge(), {});
}

TEST_CASE("the conforming levels keep the laws where diametral balls are to be empty") {
  check_conforming(two_rooms(), {.gabriel = true});
  check_conforming(wedge(), {.gabriel = true});
}

TEST_CASE("the polyhedral levels keep the laws") {
  check_all(two_rooms(), 2, 0.01);
  check_all(two_rooms(), 1.4, 0.05, {.gabriel = true});
}

TEST_CASE("the polyhedral levels keep the laws at a small angle") {
  check_all(wedge(), 2, 0.005);
}

TEST_CASE("the polyhedral levels keep the laws where short edges are left alone") {
  check_all(wedge(), 1.6, 0.002, {.smallest_edge = 0.15});
}

TEST_CASE("the polyhedral levels keep the laws on generated complexes") {
  for (std::uint64_t seed = 0; seed < 4 * property_3::generator_count(); ++seed) {
    const property_3::NamedComplex generated = property_3::generate(seed);
    INFO(generated.name);
    check_conforming(generated.complex.plc, {.gabriel = true});
    check_all(generated.complex.plc, 2, infinity);
  }
}

}  // namespace
