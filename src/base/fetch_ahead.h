// SPDX-License-Identifier: MIT
// Asking for memory before it is needed.
#pragma once

#include <cstddef>

namespace firma {

/// Lets the processor fetch the line of memory that an address lies in, so that waits for several overlap. Changes
/// nothing; any address may be given.
inline void fetch_ahead(const void* memory) {
    __builtin_prefetch(memory);
}
/// All lines of so many bytes.
inline void fetch_ahead(const void* memory, std::size_t bytes) {
    constexpr std::size_t kLine = 64;
    if (bytes == 0) return;
    const auto* from = static_cast<const char*>(memory);
    for (std::size_t at = 0; at < bytes; at += kLine) fetch_ahead(from + at);
    fetch_ahead(from + bytes - 1);
}

}  // namespace firma
