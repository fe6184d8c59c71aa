// SPDX-License-Identifier: MIT
// The threads that oneTBB has, for work that the library divides.
#pragma once

#include <oneapi/tbb/parallel_for.h>

#include <cstddef>

namespace firma::cli {

/// Tasks::run.
inline void run_by_tbb(std::size_t count, void (*work)(void* context, std::size_t k), void* context, void*) {
    tbb::parallel_for(std::size_t(0), count, [=](std::size_t k) { work(context, k); });
}

}  // namespace firma::cli
