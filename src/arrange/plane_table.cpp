// SPDX-License-Identifier: MIT
// All planes of what is arranged, each once.
#include "arrange/plane_table.h"

namespace firma {
namespace {

std::uint64_t hash_of(const Plane& plane) {
    std::uint64_t hash = table_seed();
    for (const std::int64_t n : plane.normal) hash = mix_bits(hash ^ std::uint64_t(n));
    hash = mix_bits(hash ^ std::uint64_t(plane.offset()));
    return mix_bits(hash ^ std::uint64_t(plane.offset() >> 64));
}

/// Of a plane and the same from behind, the one that is numbered first.
bool looks_forward(const Plane& plane) {
    for (const std::int64_t n : plane.normal)
        if (n != 0) return n > 0;
    return true;
}

}  // namespace

PlaneId PlaneTable::add(const Plane& plane) {
    const bool behind = !looks_forward(plane);
    const Plane forward = behind ? flipped(plane) : plane;
    for (std::uint64_t key = hash_of(forward);; key = next_key(key)) {
        std::uint32_t& known = of_hash_.at(key);
        if (known == FlatMap::kNone) {
            known = std::uint32_t(planes_.size());
            planes_.push_back(Ref<const SolidPlane>(new SolidPlane(forward)));
            planes_.push_back(Ref<const SolidPlane>(new SolidPlane(flipped(forward))));
            return known + behind;
        }
        if (planes_[known]->plane == forward) return known + behind;
    }
}

}  // namespace firma
