// SPDX-License-Identifier: MIT
// Blocks: the immutable pieces that a room's bin tree is stored in, up to 64 items each, so that an edit can replace
// one.
//
// A block holds a small binary tree of bins over its items. Items are faces, or further blocks: blocks nest, and the
// bins of all of them together are the article's one tree.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/ref.h"
#include "firma/grid.h"
#include "firma/hit.h"

namespace firma {

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

/// What a face is besides its corners.
struct FaceRecord {
    FaceId id;
    std::uint32_t source = 0;
    std::uint32_t material = 0;
    std::uint32_t mask = ~0u;
    std::uint16_t first_corner = 0;
    std::uint8_t corner_count = 0;
    bool two_sided = false;
};

class Block : public RefCounted {
public:
    std::vector<Bin> bins;  ///< bins[0] is the root; never empty

    /// Items that are blocks; then there are no faces here.
    std::vector<Ref<const Block>> children;

    /// Items that are faces.
    std::vector<FaceRecord> faces;
    std::vector<GridPoint> vertices;             ///< each once
    std::vector<std::uint16_t> corner_vertices;  ///< of all faces in a row

    bool holds_blocks() const { return !children.empty(); }

    std::span<const std::uint16_t> corners_of(const FaceRecord& face) const {
        return {corner_vertices.data() + face.first_corner, face.corner_count};
    }
};

}  // namespace firma
