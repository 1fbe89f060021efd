// SPDX-License-Identifier: MIT
//
// First in, first out: every element waits its turn. Does not look at priorities.
#pragma once

#include <delref/core/queue/list_queue.hpp>

namespace delref {

/// A first in, first out refinement queue.
template <class T>
using FifoQueue = ListQueue<T, ListOrder::first_in_first_out>;

}  // namespace delref
