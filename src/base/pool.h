// SPDX-License-Identifier: MIT
// Where blocks, rooms and what faces were cut from live: one pool of memory for the whole process, in pieces of set
// sizes.
//
// Both taking and giving back are a few instructions under a lock of their size's own, however much is held; memory is
// got from the general allocator, or from the program's own source (set_memory_source), in slabs of at most 256 KiB and
// kept, so that neither growth nor the end of a version ever stalls. (With std::pmr::synchronized_pool_resource of
// GNU's library the time that a piece takes grows with how many are held: see docs/architecture.md.)
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace firma {

// The address sanitizer sees a use after the end only when memory really ends: then each piece is taken by itself.
#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool kPoolKeepsSlabs = false;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
inline constexpr bool kPoolKeepsSlabs = false;
#else
inline constexpr bool kPoolKeepsSlabs = true;
#endif
#else
inline constexpr bool kPoolKeepsSlabs = true;
#endif

/// Anything larger is no piece of a slab, but taken by itself.
inline constexpr std::size_t kLargestPooled = 16384;

/// Aligned as for any fundamental type. Throws std::bad_alloc when there is no more, as operator new does; compiled
/// without exceptions it ends the program. Any thread may give back what another took.
void* pool_take(std::size_t bytes);
void pool_give_back(void* memory, std::size_t bytes) noexcept;
/// What taking so many bytes really takes: up to an eighth more.
std::size_t pool_size(std::size_t bytes);
/// What pool_take() ends in when there is no more.
[[noreturn]] void pool_exhausted();

/// While one of these lives, in any thread, large slabs lie side by side in regions that the system is asked to hold in
/// pages of 2 MiB (Linux; where the pool has a source of its own, nothing is asked). For levels that are only cast
/// against, as they are made: casts through a hundred megabytes then wait for fewer addresses. Edits are slower in such
/// pages where the system maps memory in software (docs/performance.md), and the first touch of one clears all of it.
class PoolInLargePages {
public:
    PoolInLargePages();
    ~PoolInLargePages();
    PoolInLargePages(const PoolInLargePages&) = delete;
    PoolInLargePages& operator=(const PoolInLargePages&) = delete;
};

/// Base of classes whose objects live in the pool.
struct Pooled {
    static void* operator new(std::size_t bytes) { return pool_take(bytes); }
    static void operator delete(void* memory, std::size_t bytes) noexcept { pool_give_back(memory, bytes); }
};

/// For containers inside such objects.
template <class T>
struct PoolAllocator {
    using value_type = T;
    static_assert(alignof(T) <= alignof(std::max_align_t));

    PoolAllocator() = default;
    template <class U>
    PoolAllocator(const PoolAllocator<U>&) {}

    T* allocate(std::size_t count) {
        if (count > std::numeric_limits<std::size_t>::max() / sizeof(T)) pool_exhausted();
        return static_cast<T*>(pool_take(count * sizeof(T)));
    }
    void deallocate(T* memory, std::size_t count) noexcept { pool_give_back(memory, count * sizeof(T)); }

    friend bool operator==(const PoolAllocator&, const PoolAllocator&) { return true; }
};

template <class T>
using PoolVector = std::vector<T, PoolAllocator<T>>;

/// What such a container takes from the pool.
template <class T>
std::size_t pool_size_of(const PoolVector<T>& vector) {
    return vector.capacity() ? pool_size(vector.capacity() * sizeof(T)) : 0;
}

}  // namespace firma
