// SPDX-License-Identifier: MIT
// A lock for a few instructions or for a writer's turn: std::mutex, or nothing where the standard library knows no
// threads (wasm).
#pragma once

#include <mutex>

namespace firma {

#if defined(_LIBCPP_HAS_NO_THREADS)
struct Lock {  // nobody to wait for
    void lock() {}
    void unlock() {}
};
#else
using Lock = std::mutex;
#endif

}  // namespace firma
