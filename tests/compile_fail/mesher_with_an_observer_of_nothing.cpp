// expect: an observer needs at least one of: on_scanned(tr), on_proposed(tr, proposal), on_rejected(tr, proposal, level), on_rejected_forever(tr, proposal, reason), on_before_insertion(tr, proposal), on_after_insertion(tr, vertex, proposal)
// SPDX-License-Identifier: MIT
#include <delref/core/mesher.hpp>

#include "archetypes.hpp"
using namespace archetypes;

void refine(Line& line) {
  Watches<Event::none> blind;
  delref::Mesher(line, Halves(0.5)).step(blind);
}
