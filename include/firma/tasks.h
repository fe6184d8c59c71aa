// SPDX-License-Identifier: MIT
// How a caller lends its threads to long work, and hears how far that is.
#pragma once

#include <cstddef>

namespace firma {

/// Who runs pieces of work. `run` calls work(context, k) once for each k below count, in any order and on any threads,
/// and returns when all have returned.
struct Tasks {
    void (*run)(std::size_t count, void (*work)(void* context, std::size_t k), void* context, void* user) = nullptr;
    void* user = nullptr;  ///< handed to run
};

/// Who does a long piece of work, and who is told of it. What is made does not depend on either, and does not keep
/// them.
struct WorkOptions {
    const Tasks* tasks = nullptr;  ///< null: this thread does it all
    /// Told now and then, by whichever thread is at it, one at a time, how much of `count` is done; it returns whether
    /// to go on. Null: nobody is told. Must not throw.
    bool (*progress)(std::size_t done, std::size_t count, void* user) = nullptr;
    void* user = nullptr;  ///< handed to progress
};

}  // namespace firma
