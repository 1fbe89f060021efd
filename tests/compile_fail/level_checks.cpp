// expect: a mesher level needs: check_refinement_point(tr, proposal) that gives a delref::Verdict
// SPDX-License-Identifier: MIT
#include <delref/core/level_concepts.hpp>

#include "archetypes.hpp"
using namespace archetypes;

static_assert(delref::explain_level<HalvesWithout<LevelPart::check_refinement_point>, Line>());
