// expect: a level whose elements the triangulation does not store needs: element_vertices(tr, element)
// SPDX-License-Identifier: MIT
#include <delref/core/mesher.hpp>

#include "archetypes.hpp"
using namespace archetypes;

using Unstored = LineWithout<LinePart::vertices>;
void refine(Unstored& line) { delref::Mesher(line, HalvesWithout<LevelPart::none, Unstored>(0.5)).step(); }
