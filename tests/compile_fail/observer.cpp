// expect: an observer needs at least one of: on_scanned(tr), on_proposed(tr, proposal), on_rejected(tr, proposal, level), on_rejected_forever(tr, proposal, reason), on_before_insertion(tr, proposal), on_after_insertion(tr, vertex, proposal)
// SPDX-License-Identifier: MIT
#include <delref/core/observer.hpp>

#include "archetypes.hpp"
using namespace archetypes;

static_assert(delref::explain_observer<Watches<Event::none>, Line>());
