// SPDX-License-Identifier: MIT
// Spreads the work of a batch over the threads that a caller has.
#pragma once

#include "firma/queries.h"

namespace firma {

/// Calls work(context, k) for each k below count, once, and returns when all are done. `work` must not throw.
/// @param tasks  `run` null: in the calling thread
/// @return false when `run` returned before it had done all of it: some may be done, none is under way
[[nodiscard]] bool run_tasks(const Tasks& tasks, std::size_t count, void (*work)(void* context, std::size_t k),
                             void* context);

/// What could not be asked.
inline Hit invalid_hit(const Vec3& centre) {
    Hit hit;
    hit.status = Status::kInvalid;
    hit.fraction = hit.safe_fraction = 0;
    hit.centre = centre;
    return hit;
}

}  // namespace firma
