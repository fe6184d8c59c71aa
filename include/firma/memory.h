// SPDX-License-Identifier: MIT
// How much memory worlds hold, and where it comes from.
#pragma once

#include <cstddef>
#include <span>

#include "firma/export.h"
#include "firma/world.h"

namespace firma {

/// Bytes that some versions of a world, or several worlds, hold together: what they share counts once, so one more
/// version costs what it does not share. Edges, vertices and planes that exact faces share are counted by an estimate
/// for each face. Goes through every block, room and portal of all worlds, each shared one once, with a table of those
/// seen: grows with all faces; for budgets and diagnosis, not for each frame.
FIRMA_EXPORT std::size_t memory_used(std::span<const World> worlds);
/// Of one world.
inline std::size_t memory_used(const World& world) {
    return memory_used({&world, 1});
}

/// Where the pool that blocks, rooms and exact faces live in gets its memory from, in place of operator new.
///
/// The pool asks for slabs of 4 to 256 KiB and cuts them into pieces; slabs are kept until the program ends, for the
/// pieces given back to be used again, so give_back() is never called for one. A piece of more than 16 KiB is asked for
/// by itself and given back when it ends. Both functions may be called from several threads at once, and must not call
/// Firma. Handles (World), rules, names and the scratch memory of edits are not of the pool: operator new serves them.
/// Under the address sanitizer there are no slabs: every piece is asked for and given back by itself.
struct MemorySource {
    /// @param alignment  a power of two, that of std::max_align_t
    /// @return null when there is no more: as out of memory anywhere, std::bad_alloc, or the end of a program compiled
    ///         without exceptions
    void* (*take)(std::size_t bytes, std::size_t alignment, void* user) = nullptr;
    /// Gets what take() was asked for and returned.
    void (*give_back)(void* memory, std::size_t bytes, std::size_t alignment, void* user) = nullptr;
    void* user = nullptr;  ///< handed to both; must last as long as the program
};

/// For the whole process, and only before the pool took anything: call it first thing in main().
/// @return false once it is too late, or when a function is missing; then nothing changes
/// Costs nothing by itself; what the source costs, every slab costs.
[[nodiscard]] FIRMA_EXPORT bool set_memory_source(const MemorySource& source);

}  // namespace firma
