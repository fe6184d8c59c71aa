// SPDX-License-Identifier: MIT
// A shelf for each size: pieces given back in a list, and the rest of the newest slab.
#include "base/pool.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <mutex>

namespace firma {
namespace {

constexpr std::size_t kSmallest = 16;            // and the step of sizes up to 256
constexpr std::size_t kLargest = 16384;          // anything larger goes to the general allocator
constexpr std::size_t kSizes = 8 + 7 * 8;        // eight up to 128, then eight in each doubling
constexpr std::size_t kFirstSlab = 4096;         // small programs stay small
constexpr std::size_t kLargestSlab = 256 << 10;  // each slab is twice the one before, up to this

// The address sanitizer sees a use after the end only when memory really ends.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool kUsesPool = false;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
constexpr bool kUsesPool = false;
#else
constexpr bool kUsesPool = true;
#endif
#else
constexpr bool kUsesPool = true;
#endif

struct Size {
    std::size_t index, bytes;
};

/// @param bytes  1 .. kLargest
Size size_for(std::size_t bytes) {
    if (bytes <= 128) {
        const std::size_t index = (bytes - 1) / kSmallest;
        return {index, (index + 1) * kSmallest};
    }
    const auto width = std::size_t(std::bit_width(bytes - 1));  // 2^(width - 1) < bytes <= 2^width
    const std::size_t below = std::size_t(1) << (width - 1), step = below / 8;
    const std::size_t eighth = (bytes - 1 - below) / step;
    return {8 + (width - 8) * 8 + eighth, below + (eighth + 1) * step};
}

class Shelf {
public:
    void* take(std::size_t bytes) {
        const std::lock_guard<std::mutex> guard(lock_);
        if (given_back_) {
            Piece* piece = given_back_;
            given_back_ = piece->next;
            return piece;
        }
        if (left_ < bytes) open_slab(bytes);
        void* piece = fresh_;
        fresh_ += bytes;
        left_ -= bytes;
        return piece;
    }

    void give_back(void* memory) {
        const std::lock_guard<std::mutex> guard(lock_);
        given_back_ = new (memory) Piece{given_back_};
    }

private:
    struct Piece {
        Piece* next;
    };

    void open_slab(std::size_t bytes) {
        next_slab_ = std::min(std::max(next_slab_ * 2, 4 * bytes), kLargestSlab);
        fresh_ = static_cast<std::byte*>(::operator new(next_slab_));
        left_ = next_slab_;
    }

    alignas(64) std::mutex lock_;  // shelves do not share a cache line
    Piece* given_back_ = nullptr;
    std::byte* fresh_ = nullptr;
    std::size_t left_ = 0;
    std::size_t next_slab_ = kFirstSlab / 2;
};

/// Never destroyed: a World may outlive everything static.
Shelf& shelf(std::size_t index) {
    static auto& shelves = *new std::array<Shelf, kSizes>;
    return shelves[index];
}

bool is_pooled(std::size_t bytes) {
    return kUsesPool && bytes <= kLargest && bytes > 0;
}

}  // namespace

void* pool_take(std::size_t bytes) {
    if (!is_pooled(bytes)) return ::operator new(bytes);
    const Size size = size_for(bytes);
    return shelf(size.index).take(size.bytes);
}

void pool_give_back(void* memory, std::size_t bytes) noexcept {
    if (!is_pooled(bytes)) return ::operator delete(memory);
    if (memory) shelf(size_for(bytes).index).give_back(memory);
}

std::size_t pool_size(std::size_t bytes) {
    return is_pooled(bytes) ? size_for(bytes).bytes : bytes;
}

}  // namespace firma
