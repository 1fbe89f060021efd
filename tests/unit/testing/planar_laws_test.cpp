// SPDX-License-Identifier: GPL-3.0-or-later
//
// The levels of planar meshing keep the laws: with circles and with lenses, at small input angles, with slits and protected boundaries.
#include <catch2/catch_test_macros.hpp>

#include <cstdint>
#include <limits>
#include <tuple>
#include <utility>

#include <delref/algorithms/planar_levels.hpp>
#include <delref/criteria/triangle_criteria.hpp>
#include <delref/domain/build_planar_domain.hpp>
#include <delref/domain/pslg_check.hpp>
#include <delref/testing/laws.hpp>
#include <delref/triangulation/constrained_delaunay_2.hpp>

#include "../../property/generators.hpp"

namespace {

using namespace delref;
using Tr = ConstrainedDelaunay2<>;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// A needle-sharp notch, a slit that hangs in the inside, an isolated vertex, two vertices close to a segment.
Pslg awkward() {
  Pslg pslg;
  pslg.points = {{0, 0}, {10, 0}, {10, 6}, {5, 5.9}, {9.9, 5.5}, {0, 6}, {2, 2}, {4, 3}, {7, 0.05}, {7.2, 0.08}};
  pslg.segments = {{{0, 1}}, {{1, 2}}, {{2, 3}}, {{3, 5}}, {{5, 0}}, {{6, 7}}, {{3, 4}}};
  return pslg;
}

template <class Encroachment, class Points>
void check(const Pslg& pslg, double degrees, double max_area, Encroachment encroachment, Points points, EdgesOptions options = {}) {
  const AngleBound bound = AngleBound::degrees(degrees);
  const CheckedPslg checked = check_pslg(pslg, {}, Control{});
  const auto broken = testing::check_laws([&](auto run) {
    Tr tr;
    PlanarDomainBuilder builder(tr, checked, Control{});
    const PlanarDomain domain = std::move(builder).domain();
    run(tr, planar_levels<Tr>(domain, TriangleCriteria(MinimumAngle{bound}, MaximumArea{max_area}), encroachment, points, options));
  });
  for (const std::string& sentence : broken) UNSCOPED_INFO(sentence);
  CHECK(broken.empty());
}

TEST_CASE("the planar levels keep the laws with circles and circumcentres") {
  check(awkward(), 20.7, 0.3, DiametralCircle{}, Circumcentre{});
}

TEST_CASE("the planar levels keep the laws with lenses and off-centres") {
  const AngleBound bound = AngleBound::degrees(28);
  check(awkward(), 28, 0.3, DiametralLens{bound}, OffCentre(bound));
}

TEST_CASE("the planar levels keep the laws where segments are protected and short edges are left alone") {
  check(awkward(), 25, 0.5, DiametralCircle{}, Circumcentre{}, {.smallest_edge = 0.2, .protect_boundary = true});
}

TEST_CASE("the planar levels keep the laws on generated graphs") {
  const AngleBound bound = AngleBound::degrees(26);
  for (std::uint64_t seed = 0; seed < 14; ++seed) {
    const property::NamedPslg generated = property::generate(seed);
    INFO(generated.name);
    check(generated.pslg, 20.7, infinity, DiametralCircle{}, Circumcentre{});
    check(generated.pslg, 26, infinity, DiametralLens{bound}, OffCentre(bound));
  }
}

}  // namespace
