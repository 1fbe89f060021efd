// SPDX-License-Identifier: GPL-3.0-or-later
//
// Each archetype of what smooth domains ask of their users models its concept, and no longer does when it loses any one member. No
// triangulation is needed for that.
#include <catch2/catch_test_macros.hpp>

#include <functional>

#include <delref/criteria/surface_facet_criteria.hpp>
#include <delref/criteria/tetrahedron_criteria.hpp>
#include <delref/criteria/triangle_criteria.hpp>
#include <delref/domain/grey_level_image.hpp>
#include <delref/domain/implicit_domain.hpp>
#include <delref/domain/labelled_image.hpp>
#include <delref/domain/multi_material_domain.hpp>
#include <delref/domain/oracle.hpp>

#include "archetype_oracles.hpp"

namespace {

using namespace archetypes;
using namespace delref;

// -- oracle
static_assert(Oracle<NothingWithout<OraclePart::none>> && explain_oracle<NothingWithout<OraclePart::none>>());

template <OraclePart part>
constexpr bool no_oracle = !Oracle<NothingWithout<part>>;
static_assert(no_oracle<OraclePart::bounds> && no_oracle<OraclePart::label> && no_oracle<OraclePart::constant_label> &&
              no_oracle<OraclePart::crossing> && no_oracle<OraclePart::point>);

// -- oracle that finds components
template <ComponentsPart part>
constexpr bool finds = FindsComponents<NoneFoundWithout<part>>;
static_assert(finds<ComponentsPart::none>);
static_assert(!finds<ComponentsPart::components> && !finds<ComponentsPart::constant_components> && !finds<ComponentsPart::result>);
static_assert(Oracle<NoneFoundWithout<ComponentsPart::components>>, "an oracle need not find the components of its surfaces");

// -- criterion of facets
static_assert(explain_surface_facet_criterion<AnyFacetWithout<CriterionPart::none>>());

template <CriterionPart part>
constexpr bool no_facet_criterion = !SurfaceFacetCriterion<AnyFacetWithout<part>>;
static_assert(no_facet_criterion<CriterionPart::copy> && no_facet_criterion<CriterionPart::is_met> &&
              no_facet_criterion<CriterionPart::name> && no_facet_criterion<CriterionPart::bounds_size>);
static_assert(!SurfaceFacetCriterion<RadiusEdge> && !TetrahedronCriterion<MinimumFacetAngle> && !TriangleCriterion<MinimumFacetAngle>,
              "a criterion of one kind of simplex is none of another");

// -- function of a point
template <FunctionPart part>
constexpr bool is_function = PointFunction<ZeroWithout<part>>;
static_assert(is_function<FunctionPart::none> && explain_implicit_function<ZeroWithout<FunctionPart::none>>());
static_assert(!is_function<FunctionPart::call> && !is_function<FunctionPart::constant_call> && !is_function<FunctionPart::number>);
static_assert(BatchFunction<ZerosInBatches> && !PointFunction<ZerosInBatches> && explain_implicit_function<ZerosInBatches>());
static_assert(!RangedFunction<ZerosInBatches>);

// -- the oracles that come with delref
static_assert(FindsComponents<ImplicitDomain<std::function<double(Point3)>>> && FindsComponents<ImplicitDomain<ZerosInBatches>> &&
              FindsComponents<MultiMaterialDomain<std::function<double(Point3)>>> && FindsComponents<GreyLevelImage> &&
              FindsComponents<LabelledImage>);

TEST_CASE("the archetypes of smooth domains model their concepts, and without any one member they do not") {
  SUCCEED("checked by the compiler");
}

}  // namespace
