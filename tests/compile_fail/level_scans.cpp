// expect: a mesher level needs: scan_triangulation(tr) that fills its set from the whole triangulation
// SPDX-License-Identifier: MIT
#include <delref/core/level_concepts.hpp>

#include "archetypes.hpp"
using namespace archetypes;

static_assert(delref::explain_level<HalvesWithout<LevelPart::scan_triangulation>, Line>());
