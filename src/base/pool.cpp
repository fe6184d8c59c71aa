// SPDX-License-Identifier: MIT
// A shelf for each size: pieces given back in a list, and the rest of the newest slab.
#include "base/pool.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <new>

#include "base/fetch_ahead.h"
#include "base/lock.h"
#include "firma/memory.h"

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace firma {
namespace {

constexpr std::size_t kSmallest = 16;            // and the step of sizes up to 256
constexpr std::size_t kSizes = 8 + 7 * 8;        // eight up to 128, then eight in each doubling up to kLargestPooled
constexpr std::size_t kFirstSlab = 4096;         // small programs stay small
constexpr std::size_t kLargestSlab = 256 << 10;  // each slab is twice the one before, up to this

constexpr std::size_t kAlignment = alignof(std::max_align_t);
constexpr std::size_t kLine = 64;         // of a cache
constexpr std::size_t kSmall = 256;       // several of which fit what is left of any slab
constexpr std::size_t kAhead = 64 << 10;  // of a slab that the system is asked for at once

struct Size {
    std::size_t index, bytes;
};

/// @param bytes  1 .. kLargestPooled
Size size_for(std::size_t bytes) {
    if (bytes <= 128) {
        const std::size_t index = (bytes - 1) / kSmallest;
        return {index, (index + 1) * kSmallest};
    }
    const auto width = std::size_t(std::bit_width(bytes - 1));  // 2^(width - 1) < bytes <= 2^width
    const std::size_t below = std::size_t(1) << (width - 1), step_bits = width - 4;
    const std::size_t eighth = (bytes - 1 - below) >> step_bits;
    return {8 + (width - 8) * 8 + eighth, below + ((eighth + 1) << step_bits)};
}

/// Where memory comes from: settled by whoever takes the first of it.
class Source {
public:
    bool set(const MemorySource& source) {
        if (!source.take || !source.give_back) return false;
        const std::lock_guard<Lock> guard(lock_);
        if (settled_.load(std::memory_order_relaxed)) return false;
        source_ = source;
        return true;
    }

    void* take(std::size_t bytes) {
        settle();
        if (!source_.take) return ::operator new(bytes);
        void* memory = source_.take(bytes, kAlignment, source_.user);
        if (!memory) pool_exhausted();
        return memory;
    }

    /// Whether operator new serves.
    bool is_general() {
        settle();
        return !source_.take;
    }

    void give_back(void* memory, std::size_t bytes) {
        if (!source_.take) return ::operator delete(memory);
        if (memory) source_.give_back(memory, bytes, kAlignment, source_.user);
    }

private:
    /// From here on `source_` does not change, and may be read without the lock.
    void settle() {
        if (settled_.load(std::memory_order_acquire)) return;
        const std::lock_guard<Lock> guard(lock_);
        settled_.store(true, std::memory_order_release);
    }

    Lock lock_;
    std::atomic<bool> settled_ = false;
    MemorySource source_;
};

/// Never destroyed: a World may outlive everything static.
Source& general() {
    static auto& source = *new Source;
    return source;
}

#if defined(__linux__)
/// Regions of one large page each, in which slabs lie side by side.
class LargePages {
public:
    static constexpr std::size_t kPage = 2 << 20;
    std::atomic<int> wanted = 0;

    /// @param bytes  a part of a page
    /// @return null: to be had elsewhere
    void* take(std::size_t bytes) {
        const std::lock_guard<Lock> guard(lock_);
        if (left_ < bytes) {
            void* const region = ::operator new(kPage, std::align_val_t(kPage), std::nothrow);
            if (!region) return nullptr;
            madvise(region, kPage, MADV_HUGEPAGE);  // where that is refused, the pages are small
            fresh_ = static_cast<std::byte*>(region);
            left_ = kPage;
        }
        void* const slab = fresh_;
        fresh_ += bytes;
        left_ -= bytes;
        return slab;
    }

private:
    Lock lock_;
    std::byte* fresh_ = nullptr;
    std::size_t left_ = 0;
};

/// Never destroyed, as above.
LargePages& large_pages() {
    static auto& pages = *new LargePages;
    return pages;
}
#endif

/// Asks the system for the pages of fresh memory, many at once: that takes less than a fault for each as it is first
/// touched (docs/performance.md). Where it is not to be had, they come one by one.
void bring_in(std::byte* from, std::byte* to) {
#if defined(__linux__) && defined(MADV_POPULATE_WRITE)
    constexpr std::uintptr_t kPage = 4096;
    const std::uintptr_t first = reinterpret_cast<std::uintptr_t>(from) & ~(kPage - 1);
    const std::uintptr_t last = (reinterpret_cast<std::uintptr_t>(to) + kPage - 1) & ~(kPage - 1);
    if (general().is_general()) madvise(reinterpret_cast<void*>(first), last - first, MADV_POPULATE_WRITE);
#else
    static_cast<void>(from), static_cast<void>(to);
#endif
}

void* take_slab(std::size_t bytes) {
#if defined(__linux__)
    static_assert(LargePages::kPage % kLargestSlab == 0);
    if (bytes == kLargestSlab && large_pages().wanted.load(std::memory_order_relaxed) > 0 && general().is_general())
        if (void* const slab = large_pages().take(bytes)) return slab;
#endif
    return general().take(bytes);
}

class Shelf {
public:
    void* take(std::size_t bytes) {
        const std::lock_guard<ShortLock> guard(lock_);
        if (given_back_) {
            Piece* piece = given_back_;
            given_back_ = piece->next;
            fetch_ahead(given_back_);  // the next one taken, wherever it lies
            return piece;
        }
        if (left_ < bytes) open_slab(bytes);
        std::byte* const piece = fresh_;
        fresh_ += bytes;
        left_ -= bytes;
        if (fresh_ > brought_in_) bring_in_more();
        return piece;
    }

    void give_back(void* memory) {
        const std::lock_guard<ShortLock> guard(lock_);
        given_back_ = new (memory) Piece{given_back_};
    }

private:
    struct Piece {
        Piece* next;
    };

    void open_slab(std::size_t bytes) {
        const std::size_t size = std::min(std::max(next_slab_ * 2, 4 * bytes), kLargestSlab);
        fresh_ = static_cast<std::byte*>(take_slab(size));
        left_ = next_slab_ = size;
        brought_in_ = size < kLargestSlab ? fresh_ + size : fresh_;  // smaller ones come as they are touched
        // Pieces that fill lines of a cache then share none, unless a slab would hold one large piece less.
        if (bytes % kLine != 0) return;
        const std::size_t aside = (kLine - reinterpret_cast<std::uintptr_t>(fresh_) % kLine) % kLine;
        if (bytes > kSmall && left_ % bytes < aside) return;
        fresh_ += aside;
        left_ -= aside;
    }

    void bring_in_more() {
        std::byte* const to = std::min(fresh_ + left_, fresh_ + kAhead);
        bring_in(brought_in_, to);
        brought_in_ = to;
    }

    alignas(kLine) ShortLock lock_;  // shelves do not share a cache line
    Piece* given_back_ = nullptr;
    std::byte* fresh_ = nullptr;
    std::size_t left_ = 0;
    std::byte* brought_in_ = nullptr;  ///< so far the slab's pages have been asked for
    std::size_t next_slab_ = kFirstSlab / 2;
};

/// Never destroyed, as above.
Shelf& shelf(std::size_t index) {
    static auto& shelves = *new std::array<Shelf, kSizes>;
    return shelves[index];
}

bool is_pooled(std::size_t bytes) {
    return kPoolKeepsSlabs && bytes <= kLargestPooled && bytes > 0;
}

}  // namespace

#if defined(__linux__)
PoolInLargePages::PoolInLargePages() {
    large_pages().wanted.fetch_add(1, std::memory_order_relaxed);
}
PoolInLargePages::~PoolInLargePages() {
    large_pages().wanted.fetch_sub(1, std::memory_order_relaxed);
}
#else
PoolInLargePages::PoolInLargePages() = default;
PoolInLargePages::~PoolInLargePages() = default;
#endif

void* pool_take(std::size_t bytes) {
    if (!is_pooled(bytes)) return general().take(bytes);
    const Size size = size_for(bytes);
    return shelf(size.index).take(size.bytes);
}

void pool_give_back(void* memory, std::size_t bytes) noexcept {
    if (!is_pooled(bytes)) return general().give_back(memory, bytes);
    if (memory) shelf(size_for(bytes).index).give_back(memory);
}

std::size_t pool_size(std::size_t bytes) {
    return is_pooled(bytes) ? size_for(bytes).bytes : bytes;
}

void pool_exhausted() {
#if defined(__cpp_exceptions)
    throw std::bad_alloc();
#else
    std::abort();
#endif
}

bool set_memory_source(const MemorySource& source) {
    return general().set(source);
}

}  // namespace firma
