// SPDX-License-Identifier: MIT
// All that the wide nodes of a node say, but where they lie: equal only for equal ones.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "index/node.h"

namespace firma::test {

inline void add_wide_contents(const Node& node, std::vector<std::uint64_t>& all) {
    for (const WideNode& wide : node.wide) {
        const LaneItems& items = node.items_of(wide);
        all.push_back(items.count);
        for (std::uint32_t lane = 0; lane < items.count; ++lane) {
            for (int axis = 0; axis < 3; ++axis)
                all.push_back(std::uint64_t(std::bit_cast<std::uint32_t>(wide.side[0][axis][lane])) << 32 |
                              std::bit_cast<std::uint32_t>(wide.side[1][axis][lane]));
            all.push_back(std::uint64_t(wide.leads_to_facets(lane)) << 32 | std::uint32_t(items.first[lane]) << 16 |
                          items.first[lane + 1]);
        }
    }
}

}  // namespace firma::test
