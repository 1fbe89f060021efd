// expect: a mesher level needs: check_refinement_point(tr, proposal) that gives a delref::Verdict
// SPDX-License-Identifier: MIT
#include <delref/core/mesher.hpp>

#include "archetypes.hpp"
using namespace archetypes;

void refine(Line& line) { delref::Mesher(line, Halves(0.5), HalvesWithout<LevelPart::check_refinement_point>(0.25)); }
