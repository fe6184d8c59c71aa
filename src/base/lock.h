// SPDX-License-Identifier: MIT
// A lock for a writer's turn and one for a few instructions; nothing where the standard library knows no threads
// (wasm).
#pragma once

#include <atomic>
#include <mutex>

namespace firma {

#if defined(_LIBCPP_HAS_NO_THREADS)
struct Lock {  // nobody to wait for
    void lock() {}
    void unlock() {}
};
using ShortLock = Lock;
#else
using Lock = std::mutex;

/// For a few instructions: inline, no call as a mutex has. Whoever finds it taken sleeps.
class ShortLock {
public:
    void lock() {
        while (taken_.test_and_set(std::memory_order_acquire)) taken_.wait(true, std::memory_order_relaxed);
    }
    void unlock() {
        taken_.clear(std::memory_order_release);
        taken_.notify_one();
    }

private:
    std::atomic_flag taken_ = ATOMIC_FLAG_INIT;
};
#endif

}  // namespace firma
