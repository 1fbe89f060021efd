// expect: a triangulation needs: conflict_zone(point, hint, zone) that gives a delref::Location of it
// SPDX-License-Identifier: MIT
#include <delref/core/triangulation_concept.hpp>

#include "archetype_triangulation.hpp"
using namespace archetypes;

static_assert(delref::explain_triangulation<LineWithout<LinePart::conflict_zone>>());
