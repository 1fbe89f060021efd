// expect: a triangulation needs: insert(point, zone) that gives the new Vertex, and zone.vanishing() that lists the vertices this insertion removes
// SPDX-License-Identifier: MIT
#include <delref/core/mesher.hpp>

#include "archetypes.hpp"
using namespace archetypes;

using Unfinished = LineWithout<LinePart::insert>;
void refine(Unfinished& line) { delref::Mesher(line, HalvesWithout<LevelPart::none, Unfinished>(0.5)); }
