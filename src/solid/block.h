// SPDX-License-Identifier: MIT
// Blocks: the immutable pieces that faces are kept in, up to 64 that lie near each other, so that an edit can replace
// one.
//
// Which faces share a block is like the pages of a file: nothing that a user can ask depends on it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "base/fetch_ahead.h"
#include "base/pool.h"
#include "base/ref.h"
#include "firma/grid.h"
#include "firma/hit.h"
#include "geometry/grid_box.h"
#include "index/node.h"
#include "solid/face_lanes.h"

namespace firma {

/// What a facet was cut from: the exact face above it. Solids derive theirs from it; this is what casts need. Blocks
/// keep alive the owners of their facets.
class FaceOwner : public RefCounted, public Pooled {
public:
    virtual ~FaceOwner() = default;
    /// Memory it holds, itself included.
    virtual std::size_t bytes() const = 0;

    Vec3 normal;  ///< unit, of the exact plane, as the facets are wound
    GridBox box;
    std::uint32_t facets = 1;  ///< how many it has, in all blocks
    std::uint64_t hash = 0;    ///< of everything that makes it what it is
};

/// Bits of the small numbers in a FaceRecord, and their largest values.
inline constexpr int kFirstLaneBits = 14, kCornerCountBits = 7, kOwnerBits = 7;
inline constexpr std::uint32_t kLastFirstLane = (1u << kFirstLaneBits) - 1,
                               kLastCornerCount = (1u << kCornerCountBits) - 1, kLastOwner = (1u << kOwnerBits) - 1;

inline constexpr std::uint32_t kNoOwner = kLastOwner;

/// What a face is besides its corners. Small, as there is one for each face; one type throughout, as compilers for
/// Windows begin a new number at each other one.
struct FaceRecord {
    FaceId id;
    std::uint32_t source = 0;
    std::uint32_t material = 0;
    std::uint32_t mask = ~0u;
    std::uint32_t edit = 0;  ///< 0: `source` is a face of the level's file; else of the cutter of that edit
    std::uint32_t first_lane : kFirstLaneBits = 0;  ///< where the first triangle of its fan is: Block::fan_of()
    std::uint32_t corner_count : kCornerCountBits = 0;
    /// Index into Block::owners; kNoOwner: the face is its own exact face.
    std::uint32_t owner : kOwnerBits = kNoOwner;
    std::uint32_t two_sided : 1 = 0;
    std::uint32_t solid : 1 = 0;  ///< bounds a closed solid that can be carved
};
static_assert(sizeof(FaceRecord) == 24);

class Block final : public IndexedFacets {
public:
    /// What it shares with others lies scattered, and each counts one user less.
    ~Block() override {
        for (const Ref<const FaceOwner>& owner : owners) fetch_ahead(owner.get());
    }
    std::size_t bytes() const override {
        return pool_size(sizeof(Block)) + pool_size_of(faces) + pool_size_of(owners) + pool_size_of(lanes);
    }

    /// Faces of different parts never share a block. What a part is, says whoever holds the faces: to a world, a room.
    std::uint32_t part = 0;
    std::uint32_t mask_of_all = ~0u;  ///< bits that the masks of all faces have
    PoolVector<FaceRecord> faces;
    PoolVector<FaceLanes> lanes;              ///< the corners of all faces, as casts read them
    PoolVector<Ref<const FaceOwner>> owners;  ///< each once

    /// The triangles of a face's fan: of the first corner, the k-th after it and the next.
    FaceFan fan_of(const FaceRecord& face) const { return FaceFan(lanes.data(), face.first_lane); }
    FIRMA_SELDOM GridPoint corner(const FaceRecord& face, std::size_t k) const {
        FaceFan fan = fan_of(face);
        if (k <= 2) return fan.corner(std::uint32_t(k));
        fan.advance(std::uint32_t(k) - 2);
        return fan.corner(2);
    }
    /// Calls `function(corner)` for each, in order.
    template <class Function>
    void for_each_corner(const FaceRecord& face, const Function& function) const {
        FaceFan fan = fan_of(face);
        GridPoint first[3];
        fan.read_corners(first);
        for (const GridPoint& corner : first) function(corner);
        for (std::uint32_t k = 3; k < face.corner_count; ++k) {
            fan.advance(1);
            function(fan.corner(2));
        }
    }
    /// Around its corners.
    FIRMA_SELDOM GridBox box_of(const FaceRecord& face) const {
        GridBox box;
        for_each_corner(face, [&](const GridPoint& corner) { box.add(corner); });
        return box;
    }
    /// Around all.
    FIRMA_SELDOM GridBox box() const {
        GridBox all;
        for (const FaceRecord& face : faces) all.add(box_of(face));
        return all;
    }
    /// Null for a face that is its own.
    const FaceOwner* owner_of(const FaceRecord& face) const {
        return face.owner == kNoOwner ? nullptr : owners[face.owner].get();
    }
};

/// The first corner in order of coordinates: it says which region a face belongs to.
FIRMA_SELDOM inline GridPoint lowest_corner(const Block& block, const FaceRecord& face) {
    GridPoint lowest = block.corner(face, 0);
    for (std::uint32_t k = 1; k < face.corner_count; ++k) lowest = std::min(lowest, block.corner(face, k));
    return lowest;
}

/// The facets of an index over faces are blocks.
inline const Block& as_block(const IndexedFacets& facets) {
    return static_cast<const Block&>(facets);
}
inline const Block& block_of(const Node& leaf) {
    return as_block(*leaf.facets);
}

/// Every block below, in the index's order.
template <class Function>
void for_each_block(const Node& root, const Function& function) {
    if (root.is_leaf()) return function(block_of(root));
    for (const Ref<const Node>& child : root.children) for_each_block(*child, function);
}

/// Where a facet lies.
struct FacetPlace {
    const Block* block = nullptr;
    std::uint32_t slot = 0;

    const FaceRecord& record() const { return block->faces[slot]; }
    friend bool operator==(const FacetPlace&, const FacetPlace&) = default;
};

}  // namespace firma
