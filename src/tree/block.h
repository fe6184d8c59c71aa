// SPDX-License-Identifier: MIT
// Blocks: the immutable pieces that a room's bin tree is stored in, up to 64 items each, so that an edit can replace
// one.
//
// A block holds a small binary tree of bins over its items. Items are faces, or further blocks: blocks nest, and the
// bins of all of them together are the article's one tree.
#pragma once

#include <cstdint>
#include <span>

#include "base/fetch_ahead.h"
#include "base/pool.h"
#include "base/ref.h"
#include "firma/grid.h"
#include "firma/hit.h"
#include "geometry/grid_box.h"

namespace firma {

class Hasher;

inline constexpr std::uint32_t kBlockItems = 64;

/// A closed box, rounded outward, in metres.
struct BoxF {
    float low[3];
    float high[3];
};

/// A node of the bin tree. In an inner bin the left child follows at once and `first` is the right one; a leaf bin
/// holds items first .. first + count.
struct Bin {
    BoxF box;
    std::uint32_t first = 0;
    std::uint32_t count = 0;  ///< 0 in an inner bin

    bool is_leaf() const { return count != 0; }
};

/// What a facet was cut from: the exact face above it. Solids derive theirs from it; this is what trees and casts need.
/// Blocks keep alive the owners of their facets.
class FaceOwner : public RefCounted, public Pooled {
public:
    virtual ~FaceOwner() = default;
    /// Everything that makes it what it is, for hash_world().
    virtual void add_to(Hasher& hasher) const = 0;
    /// Memory it holds, itself included.
    virtual std::size_t bytes() const = 0;

    Vec3 normal;  ///< unit, of the exact plane, as the facets are wound
    GridBox box;
    std::uint32_t facets = 1;  ///< how many it has, in all blocks
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

class Block : public RefCounted, public Pooled {
public:
    /// What it shares with others lies scattered, and each counts one user less.
    ~Block() {
        for (const Ref<const Block>& child : children) fetch_ahead(child.get());
        for (const Ref<const FaceOwner>& owner : owners) fetch_ahead(owner.get());
    }

    // First, beside the count of users: of most blocks an edit reads no more.
    std::uint32_t faces_below = 0;  ///< faces here, or in all blocks below
    std::uint16_t depth = 0;        ///< bins above the deepest leaf bin, from bins[0] on down through children

    PoolVector<Bin> bins;  ///< bins[0] is the root; never empty

    /// Items that are blocks; then there are no faces here.
    PoolVector<Ref<const Block>> children;

    /// Items that are faces.
    PoolVector<FaceRecord> faces;
    PoolVector<GridPoint> vertices;             ///< each once
    PoolVector<std::uint16_t> corner_vertices;  ///< of all faces in a row
    PoolVector<Ref<const FaceOwner>> owners;    ///< each once

    bool holds_blocks() const { return !children.empty(); }

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
    /// Null for a face that is its own.
    const FaceOwner* owner_of(const FaceRecord& face) const {
        return face.owner == kNoOwner ? nullptr : owners[face.owner].get();
    }
};

}  // namespace firma
