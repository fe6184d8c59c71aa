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
        all.push_back(wide.count);
        for (int axis = 0; axis < 3; ++axis)
            all.push_back(std::uint64_t(std::bit_cast<std::uint32_t>(wide.base[axis])) << 32 |
                          std::bit_cast<std::uint32_t>(wide.scale[axis]));
        for (std::uint32_t lane = 0; lane < wide.count; ++lane) {
            std::uint64_t sides = 0;
            for (int axis = 0; axis < 3; ++axis)
                sides = sides << 16 | std::uint32_t(wide.side[0][axis][lane]) << 8 | wide.side[1][axis][lane];
            all.push_back(sides);
            all.push_back(std::uint64_t(wide.facets[lane]) << 32 | std::uint32_t(wide.first[lane]) << 16 |
                          wide.first[lane + 1]);
        }
    }
}

}  // namespace firma::test
