// expect: a mesher level needs: to be movable, since a mesher owns its levels by value
// SPDX-License-Identifier: MIT
#include <delref/core/level_concepts.hpp>

#include "archetypes.hpp"
using namespace archetypes;

static_assert(delref::explain_level<HalvesWithout<LevelPart::move>, Line>());
