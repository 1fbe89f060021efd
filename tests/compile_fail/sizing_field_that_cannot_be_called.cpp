// expect: A sizing field must be callable with a delref::Point2 while it is const: give it the member `double operator()(delref::Point2) const`, or use a lambda that is not mutable.
// times: 2
// SPDX-License-Identifier: GPL-3.0-or-later
#include <delref/criteria/sizing_field.hpp>

#include "archetype_criteria.hpp"
using namespace archetypes;

template void delref::explain_sizing_field<UnboundedWithout<FieldPart::call>>();
template void delref::explain_sizing_field<UnboundedWithout<FieldPart::constant_call>>();
