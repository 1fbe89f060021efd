// expect: a queue policy needs: push(value, priority), front(), at(position), erase(position), empty(), size(), clear(), for_each(f)
// times: 10
// SPDX-License-Identifier: MIT
#include <delref/core/queue/element_set.hpp>

#include "archetype_policies.hpp"
using namespace archetypes;

static_assert(delref::explain_queue<StackWithout<QueuePart::make>, Interval>());
static_assert(delref::explain_queue<StackWithout<QueuePart::move>, Interval>());
static_assert(delref::explain_queue<StackWithout<QueuePart::push>, Interval>());
static_assert(delref::explain_queue<StackWithout<QueuePart::front>, Interval>());
static_assert(delref::explain_queue<StackWithout<QueuePart::at>, Interval>());
static_assert(delref::explain_queue<StackWithout<QueuePart::erase>, Interval>());
static_assert(delref::explain_queue<StackWithout<QueuePart::empty>, Interval>());
static_assert(delref::explain_queue<StackWithout<QueuePart::size>, Interval>());
static_assert(delref::explain_queue<StackWithout<QueuePart::clear>, Interval>());
static_assert(delref::explain_queue<StackWithout<QueuePart::for_each>, Interval>());
