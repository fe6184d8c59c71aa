// SPDX-License-Identifier: MIT
// Spreads the work of a batch over the threads that the caller's hook has.
#pragma once

#include <cstddef>

#include "firma/firma_c.h"

namespace firma::c {

/// `run` null: in the calling thread.
void set_batch_tasks(const firma_tasks& tasks);

/// Calls work(context, k) for each k below count, once, and returns when all are done. `work` must not throw.
/// @return false when the caller's hook returned before it had done all of it: some may be done, none is under way
[[nodiscard]] bool run_batch(std::size_t count, void (*work)(void* context, std::size_t k), void* context);

}  // namespace firma::c
