// expect: a triangulation needs: insert(point, zone) that gives the new Vertex, and zone.vanishing() that lists the vertices this insertion removes
// times: 2
// SPDX-License-Identifier: MIT
#include <delref/core/triangulation_concept.hpp>

#include "archetype_triangulation.hpp"
using namespace archetypes;

static_assert(delref::explain_triangulation<LineWithout<LinePart::insert>>());
static_assert(delref::explain_triangulation<LineWithout<LinePart::vanishing>>());
