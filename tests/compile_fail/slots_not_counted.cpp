// expect: a triangulation whose elements keep the place of a level needs: a constant slot_count<Element>, slot(element, k) and set_slot(element, k, position)
// SPDX-License-Identifier: MIT
#include <delref/core/mesher.hpp>

#include "archetypes.hpp"
using namespace archetypes;

struct Placed : Halves {
  void assign_slot(std::size_t) {}
};
void refine(Line& line) { delref::Mesher(line, Placed{Halves(0.5)}); }
