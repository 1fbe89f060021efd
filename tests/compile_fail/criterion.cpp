// expect: a criterion needs: is_met(shape) const that gives bool for the shape of what it judges, such as delref::TriangleShape or delref::TetrahedronShape; a static constexpr name, and a static constexpr bool bounds_size; and to be copy constructible
// times: 4
// SPDX-License-Identifier: GPL-3.0-or-later
#include <delref/criteria/triangle_criteria.hpp>

#include "archetype_criteria.hpp"
using namespace archetypes;

static_assert(delref::explain_triangle_criterion<AnythingWithout<CriterionPart::copy>>());
static_assert(delref::explain_triangle_criterion<AnythingWithout<CriterionPart::is_met>>());
static_assert(delref::explain_triangle_criterion<AnythingWithout<CriterionPart::name>>());
static_assert(delref::explain_triangle_criterion<AnythingWithout<CriterionPart::bounds_size>>());
