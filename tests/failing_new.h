// SPDX-License-Identifier: MIT
// An operator new that fails on demand. For one source of a program of its own, as it is for the whole process.
#pragma once

#include <cstdlib>
#include <new>

namespace firma::tests {

inline long allocations_left = -1;  ///< calls of operator new until all fail; negative: none fails
inline bool ran_out = false;

inline void* take(std::size_t bytes) {
    if (allocations_left == 0) {
        ran_out = true;
        return nullptr;
    }
    if (allocations_left > 0) --allocations_left;
    return std::malloc(bytes ? bytes : 1);
}

/// Calls with memory for so many allocations; whether that was too few. The call must not throw.
template <class Call>
bool runs_out(long allocations, const Call& call) {
    ran_out = false;
    allocations_left = allocations;
    call();
    allocations_left = -1;
    return ran_out;
}

}  // namespace firma::tests

// None inlined, or g++ takes free() for a mistake where it sees `new`.
[[gnu::noinline]] void* operator new(std::size_t bytes) {
    void* memory = firma::tests::take(bytes);
    if (!memory) throw std::bad_alloc();
    return memory;
}
[[gnu::noinline]] void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
    return firma::tests::take(bytes);
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
    std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
