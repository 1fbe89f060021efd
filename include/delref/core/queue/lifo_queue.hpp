// SPDX-License-Identifier: MIT
//
// Last in, first out: works where it worked last, so that memory is warm. Does not look at priorities.
#pragma once

#include <delref/core/queue/list_queue.hpp>

namespace delref {

/// A last in, first out refinement queue.
template <class T>
using LifoQueue = ListQueue<T, ListOrder::last_in_first_out>;

}  // namespace delref
