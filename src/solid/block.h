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

inline constexpr std::uint16_t kNoOwner = 0xFFFF;

/// What a face is besides its corners.
struct FaceRecord {
    FaceId id;
    std::uint32_t source = 0;
    std::uint32_t material = 0;
    std::uint32_t mask = ~0u;
    std::uint16_t first_corner = 0;
    std::uint8_t corner_count = 0;
    bool two_sided = false;
    bool solid = false;              ///< bounds a closed solid that can be carved
    std::uint16_t owner = kNoOwner;  ///< index into Block::owners; kNoOwner: the face is its own exact face
    std::uint32_t edit = 0;          ///< 0: `source` is a face of the level's file; else of the cutter of that edit
};

class Block final : public IndexedFacets {
public:
    /// What it shares with others lies scattered, and each counts one user less.
    ~Block() override {
        for (const Ref<const FaceOwner>& owner : owners) fetch_ahead(owner.get());
    }
    std::size_t bytes() const override {
        return pool_size(sizeof(Block)) + pool_size_of(faces) + pool_size_of(vertices) + pool_size_of(corner_vertices) +
               pool_size_of(owners) + pool_size_of(lanes);
    }

    /// Faces of different parts never share a block. What a part is, says whoever holds the faces: to a world, a room.
    std::uint32_t part = 0;
    std::uint32_t mask_of_all = ~0u;  ///< bits that the masks of all faces have
    PoolVector<FaceRecord> faces;
    PoolVector<GridPoint> vertices;             ///< each once
    PoolVector<std::uint16_t> corner_vertices;  ///< of all faces in a row
    PoolVector<Ref<const FaceOwner>> owners;    ///< each once
    PoolVector<FaceLanes> lanes;                ///< the same facets, as casts read them

    std::span<const std::uint16_t> corners_of(const FaceRecord& face) const {
        return {corner_vertices.data() + face.first_corner, face.corner_count};
    }
    const GridPoint& corner(const FaceRecord& face, std::size_t k) const {
        return vertices[corner_vertices[face.first_corner + k]];
    }
    /// Around its corners.
    GridBox box_of(const FaceRecord& face) const {
        GridBox box;
        for (const std::uint16_t vertex : corners_of(face)) box.add(vertices[vertex]);
        return box;
    }
    /// Around all.
    GridBox box() const {
        GridBox all;
        for (const GridPoint& vertex : vertices) all.add(vertex);
        return all;
    }
    /// Null for a face that is its own.
    const FaceOwner* owner_of(const FaceRecord& face) const {
        return face.owner == kNoOwner ? nullptr : owners[face.owner].get();
    }
};

/// The first corner in order of coordinates: it says which region a face belongs to.
inline GridPoint lowest_corner(const Block& block, const FaceRecord& face) {
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
