// SPDX-License-Identifier: MIT
// A mutex, where there are threads; nothing where a platform has none.
#pragma once

#if !defined(__wasm__) || defined(_REENTRANT)
#include <mutex>
#endif

namespace firma {

#if !defined(__wasm__) || defined(_REENTRANT)
using Lock = std::mutex;
using LockGuard = std::lock_guard<std::mutex>;
#else
struct Lock {};
class LockGuard {
public:
    explicit LockGuard(Lock&) {}
};
#endif

}  // namespace firma
