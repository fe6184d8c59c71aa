// SPDX-License-Identifier: MIT
// All that a hit says, to be compared to the bit.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "firma/queries.h"

namespace firma {

inline void add_bits(std::vector<std::uint64_t>& bits, const Hit& hit) {
    bits.push_back(std::uint64_t(hit.status) | std::uint64_t(hit.feature) << 8 |
                   std::uint64_t(hit.feature_index) << 16);
    bits.push_back(hit.face.id.value | std::uint64_t(hit.material) << 32);
    bits.push_back(hit.portal.value);
    for (const double number : {hit.fraction, hit.safe_fraction}) bits.push_back(std::bit_cast<std::uint64_t>(number));
    for (const Vec3& v : {hit.centre, hit.point, hit.normal, hit.face_normal})
        for (int axis = 0; axis < 3; ++axis) bits.push_back(std::bit_cast<std::uint64_t>(v[axis]));
}

}  // namespace firma
