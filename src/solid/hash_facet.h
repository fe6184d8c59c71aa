// SPDX-License-Identifier: MIT
// The hash of a face: every number that makes it what it is. Hashes of worlds are sums of them.
#pragma once

#include "base/hasher.h"
#include "solid/block.h"
#include "solid/face_set.h"

namespace firma {

/// @param face  a FaceRecord, or an entry of a FaceSet
/// @param corner(k)  its corners in order
template <class AnyFace, class Corner>
std::uint64_t hash_facet(const AnyFace& face, const FaceOwner* owner, const Corner& corner) {
    Hasher hasher;
    hasher.add(face.id.value, face.source);
    hasher.add(face.edit, face.material);
    const std::uint32_t flags = std::uint32_t(face.two_sided) | std::uint32_t(face.solid) << 1;
    hasher.add(face.mask, std::uint32_t(face.corner_count) << 8 | flags);
    hasher.add(owner ? owner->hash : std::uint64_t(0));
    for (std::uint32_t k = 0; k < face.corner_count; ++k) {
        const GridPoint& p = corner(k);
        hasher.add(p.x, p.y);
        hasher.add(std::uint32_t(p.z));
    }
    return hasher.value();
}

inline std::uint64_t hash_facet(const Block& block, const FaceRecord& face) {
    return hash_facet(face, block.owner_of(face), [&](std::uint32_t k) { return block.corner(face, k); });
}
inline std::uint64_t hash_facet(const FaceSet& set, const FaceSet::Entry& face) {
    return hash_facet(face, face.owner, [&](std::uint32_t k) { return set.corner(face, k); });
}

}  // namespace firma
