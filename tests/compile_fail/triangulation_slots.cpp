// expect: a triangulation needs: clear_slots() that forgets every level's mark on every element
// SPDX-License-Identifier: MIT
#include <delref/core/triangulation_concept.hpp>

#include "archetype_triangulation.hpp"
using namespace archetypes;

static_assert(delref::explain_triangulation<LineWithout<LinePart::clear_slots>>());
