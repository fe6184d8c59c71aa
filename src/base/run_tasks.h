// SPDX-License-Identifier: MIT
// Spreads pieces of work over the threads that a caller has.
#pragma once

#include "firma/tasks.h"

namespace firma {

/// Calls work(context, k) for each k below count, once, and returns when all are done. `work` must not throw.
/// @param tasks  `run` null: in the calling thread
/// @return false when `run` returned before it had done all of it: some may be done, none is under way
[[nodiscard]] bool run_tasks(const Tasks& tasks, std::size_t count, void (*work)(void* context, std::size_t k),
                             void* context);

}  // namespace firma
