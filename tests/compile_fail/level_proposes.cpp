// expect: a mesher level needs: refinement_point(tr, element) that gives the point whose insertion kills the element
// SPDX-License-Identifier: MIT
#include <delref/core/level_concepts.hpp>

#include "archetypes.hpp"
using namespace archetypes;

static_assert(delref::explain_level<HalvesWithout<LevelPart::refinement_point>, Line>());
