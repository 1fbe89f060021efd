// SPDX-License-Identifier: GPL-3.0-or-later
//
// Each archetype of a planar policy models its concept, and no longer does when it loses any one member. The triangulation is known
// by name only: these concepts ask nothing of it.
#include <catch2/catch_test_macros.hpp>

#include <delref/criteria/sizing_field.hpp>
#include <delref/criteria/triangle_criteria.hpp>
#include <delref/levels/encroachment.hpp>
#include <delref/levels/point_choice.hpp>

#include "archetype_criteria.hpp"

namespace {

using namespace archetypes;
using namespace delref;

// -- criterion
static_assert(explain_triangle_criterion<AnythingWithout<CriterionPart::none>>());

template <CriterionPart part>
constexpr bool no_criterion = !TriangleCriterion<AnythingWithout<part>>;
static_assert(no_criterion<CriterionPart::copy> && no_criterion<CriterionPart::is_met> && no_criterion<CriterionPart::name> &&
              no_criterion<CriterionPart::bounds_size>);

// -- encroachment
struct SomeTriangulation {
  struct Edge {};
};
template <EncroachmentPart part>
constexpr bool encroaches = Encroachment2<NeverWithout<SomeTriangulation, part>, SomeTriangulation>;
static_assert(encroaches<EncroachmentPart::none>);
static_assert(explain_encroachment<NeverWithout<SomeTriangulation, EncroachmentPart::none>, SomeTriangulation>());
static_assert(!encroaches<EncroachmentPart::copy> && !encroaches<EncroachmentPart::encroaches> &&
              !encroaches<EncroachmentPart::deletes_free_vertices>);

// -- point
template <PointPart part>
constexpr bool chooses = PointChoice2<CentroidWithout<part>>;
static_assert(chooses<PointPart::none>);
static_assert(explain_point_choice<CentroidWithout<PointPart::none>>());
static_assert(!chooses<PointPart::copy> && !chooses<PointPart::point>);
static_assert(PointChoice2<Circumcentre> && PointChoice2<OffCentre>);

// -- sizing field
template <FieldPart part>
constexpr bool sizes = SizingField2<UnboundedWithout<part>>;
static_assert(sizes<FieldPart::none>);
static_assert(!sizes<FieldPart::call> && !sizes<FieldPart::constant_call> && !sizes<FieldPart::number>);

TEST_CASE("the archetypes of planar policies model their concepts, and without any one member they do not") {
  SUCCEED("checked by the compiler");
}

}  // namespace
