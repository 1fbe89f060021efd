// expect: a mesher level needs: before_insertion(tr, proposal) that takes dying elements out of its set, and after_insertion(tr, vertex, proposal) that looks at the new ones
// times: 2
// SPDX-License-Identifier: MIT
#include <delref/core/level_concepts.hpp>

#include "archetypes.hpp"
using namespace archetypes;

static_assert(delref::explain_level<HalvesWithout<LevelPart::before_insertion>, Line>());
static_assert(delref::explain_level<HalvesWithout<LevelPart::after_insertion>, Line>());
