// expect: an element of a level has at most 4 vertices, and element_vertices(tr, element) gives more
// times: 1
// SPDX-License-Identifier: MIT
#include <array>

#include <delref/core/mesher.hpp>

#include "archetypes.hpp"
using namespace archetypes;

struct Pentagons : Halves {
  using Halves::Halves;
  std::array<Knot, 5> element_vertices(const Line&, const Interval& e) const { return {e.left, e.right, e.left, e.right, e.left}; }
};
void refine(Line& line) { delref::Mesher(line, Pentagons(0.5)).step(); }
