// SPDX-License-Identifier: MIT
// Whether two faces hang together.
#pragma once

#include <cstdint>

#include "solid/block.h"

namespace firma {

/// Whether they have a corner in common.
inline bool share_a_corner(const FacetPlace& a, const FacetPlace& b) {
    for (std::uint32_t j = 0; j < a.record().corner_count; ++j)
        for (std::uint32_t k = 0; k < b.record().corner_count; ++k)
            if (a.block->corner(a.record(), j) == b.block->corner(b.record(), k)) return true;
    return false;
}

}  // namespace firma
