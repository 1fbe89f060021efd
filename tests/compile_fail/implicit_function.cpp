// expect: An implicit function must be callable while it is const, with a delref::Point3, and give a number: give it the member `double operator()(delref::Point3) const`, or use a lambda that is not mutable. It may have the member `void operator()(std::span<const delref::Point3>, std::span<double>) const` for many points besides, or instead.
// times: 3
// SPDX-License-Identifier: GPL-3.0-or-later
#include <delref/domain/implicit_function.hpp>

#include "archetype_oracles.hpp"
using namespace archetypes;

static_assert(delref::explain_implicit_function<ZeroWithout<FunctionPart::call>>());
static_assert(delref::explain_implicit_function<ZeroWithout<FunctionPart::constant_call>>());
static_assert(delref::explain_implicit_function<ZeroWithout<FunctionPart::number>>());
