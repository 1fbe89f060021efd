// expect: the member `give_up` of a level is passed over: it must be callable as give_up(tr, element)
// SPDX-License-Identifier: MIT
#include <optional>

#include <delref/core/mesher.hpp>

#include "archetypes.hpp"
using namespace archetypes;

struct ForgotTheTriangulation : Halves {
  std::optional<delref::Reason> give_up(const Interval&) { return {}; }
};
static_assert(delref::explain_level<ForgotTheTriangulation, Line>());
