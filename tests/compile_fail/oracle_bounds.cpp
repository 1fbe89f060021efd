// expect: an oracle needs: bounds() const that gives a delref::BoundingBox3
// SPDX-License-Identifier: GPL-3.0-or-later
#include <delref/domain/oracle.hpp>

#include "archetype_oracles.hpp"
using namespace archetypes;

static_assert(delref::explain_oracle<NothingWithout<OraclePart::bounds>>());
