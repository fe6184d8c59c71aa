// SPDX-License-Identifier: MIT
// A node of the binary trees that an index is made of: the article's bins.
#pragma once

#include <cstdint>

namespace firma {

/// A closed box, rounded outward, in metres.
struct BoxF {
    float low[3];
    float high[3];
};

/// In an inner bin the left child follows at once and `first` is the right one; a leaf bin holds items first .. first +
/// count.
struct Bin {
    BoxF box;
    std::uint32_t first = 0;
    std::uint32_t count = 0;  ///< 0 in an inner bin

    bool is_leaf() const { return count != 0; }
};

}  // namespace firma
