// expect: an oracle needs: label(std::span<const delref::Point3>, std::span<int>) const that writes a region number, or delref::outside, for each point
// times: 2
// SPDX-License-Identifier: GPL-3.0-or-later
#include <delref/domain/oracle.hpp>

#include "archetype_oracles.hpp"
using namespace archetypes;

static_assert(delref::explain_oracle<NothingWithout<OraclePart::label>>());
static_assert(delref::explain_oracle<NothingWithout<OraclePart::constant_label>>());
