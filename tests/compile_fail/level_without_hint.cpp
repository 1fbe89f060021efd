// expect: a level whose elements the triangulation does not store needs: hint(tr, element)
// SPDX-License-Identifier: MIT
#include <delref/core/mesher.hpp>

#include "archetypes.hpp"
using namespace archetypes;

using Unstored = LineWithout<LinePart::hint_from_element>;
struct NoHint : HalvesWithout<LevelPart::none, Unstored> {
  std::array<Knot, 2> element_vertices(const Unstored& tr, const Interval& e) const { return tr.vertices(e); }
};
void refine(Unstored& line) { delref::Mesher(line, NoHint{HalvesWithout<LevelPart::none, Unstored>(0.5)}).step(); }
