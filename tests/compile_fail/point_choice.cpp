// expect: a point policy needs: point(shape) const that gives a delref::Point2 for a delref::TriangleShape; and to be copy constructible
// times: 2
// SPDX-License-Identifier: GPL-3.0-or-later
#include <delref/levels/point_choice.hpp>

#include "archetype_criteria.hpp"
using namespace archetypes;

static_assert(delref::explain_point_choice<CentroidWithout<PointPart::copy>>());
static_assert(delref::explain_point_choice<CentroidWithout<PointPart::point>>());
