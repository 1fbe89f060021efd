// expect: a mesher needs between 1 and 254 levels
// SPDX-License-Identifier: MIT
#include <delref/core/mesher.hpp>

#include "archetypes.hpp"
using namespace archetypes;

using Nothing = delref::Mesher<Line>;
auto size = sizeof(Nothing);
