// expect: an oracle needs: crossing(a, b, label_a, tolerance) const that gives a delref::Point3 of the segment where the label changes
// times: 2
// SPDX-License-Identifier: GPL-3.0-or-later
#include <delref/domain/oracle.hpp>

#include "archetype_oracles.hpp"
using namespace archetypes;

static_assert(delref::explain_oracle<NothingWithout<OraclePart::crossing>>());
static_assert(delref::explain_oracle<NothingWithout<OraclePart::point>>());
