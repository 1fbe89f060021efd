// expect: A sizing field must return the size as a number: what yours returns for a delref::Point2 does not convert to double.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <delref/criteria/sizing_field.hpp>

#include "archetype_criteria.hpp"
using namespace archetypes;

template void delref::explain_sizing_field<UnboundedWithout<FieldPart::number>>();
