// expect: a mesher level needs: a type Element, empty() const that gives bool, next_element() that gives an Element, and pop_next_element(tr)
// times: 4
// SPDX-License-Identifier: MIT
#include <delref/core/level_concepts.hpp>

#include "archetypes.hpp"
using namespace archetypes;

static_assert(delref::explain_level<HalvesWithout<LevelPart::element_type>, Line>());
static_assert(delref::explain_level<HalvesWithout<LevelPart::empty>, Line>());
static_assert(delref::explain_level<HalvesWithout<LevelPart::next_element>, Line>());
static_assert(delref::explain_level<HalvesWithout<LevelPart::pop_next_element>, Line>());
