// expect: a triangulation needs: point(v), index(v), carrier(v), provenance(v), set_origin(v, carrier, level), number_of_vertices(), is_simplex(vertices), barycentre(vertices)
// times: 8
// SPDX-License-Identifier: MIT
#include <delref/core/triangulation_concept.hpp>

#include "archetype_triangulation.hpp"
using namespace archetypes;

static_assert(delref::explain_triangulation<LineWithout<LinePart::point>>());
static_assert(delref::explain_triangulation<LineWithout<LinePart::index>>());
static_assert(delref::explain_triangulation<LineWithout<LinePart::carrier>>());
static_assert(delref::explain_triangulation<LineWithout<LinePart::provenance>>());
static_assert(delref::explain_triangulation<LineWithout<LinePart::set_origin>>());
static_assert(delref::explain_triangulation<LineWithout<LinePart::number_of_vertices>>());
static_assert(delref::explain_triangulation<LineWithout<LinePart::is_simplex>>());
static_assert(delref::explain_triangulation<LineWithout<LinePart::barycentre>>());
