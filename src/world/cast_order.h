// SPDX-License-Identifier: MIT
// An order of casts in which neighbours come together, so that what one has brought into the caches serves the next.
//
// By where they start, in a box around all, and then by where they end: the bits of these coordinates in turn in one
// number, the highest first (a Morton code), sorted by radix. Sources: G. M. Morton, 1966; H. H. Seward, 1954.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "firma/function_ref.h"
#include "firma/vec.h"

namespace firma {

/// No more are put in order at once.
inline constexpr std::size_t kMostInOrder = std::size_t(1) << 20;

/// The entry of a cast in an order: its number in the low bits.
inline std::size_t cast_of(std::uint64_t entry) {
    return std::size_t(entry & (kMostInOrder - 1));
}

/// Where a cast starts, and its path.
struct CastWay {
    Vec3 start, path;
};

/// @param world  where there is anything; ways are looked at as far as they are near it
/// @param way    of cast k, k below the size of `order`; may be not finite
/// @param order  filled with entries of all k; at most kMostInOrder
/// @param spare  as many, to work in
/// @return false, and nothing of use in `order`, where they come together as they are
bool order_casts(const Box& world, FunctionRef<CastWay(std::size_t k)> way, std::span<std::uint64_t> order,
                 std::span<std::uint64_t> spare);

}  // namespace firma
