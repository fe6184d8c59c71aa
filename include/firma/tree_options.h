// SPDX-License-Identifier: MIT
// How the tree over a room's faces is built, and what it came to.
#pragma once

#include <cstddef>
#include <cstdint>

#include "firma/vec.h"

namespace firma {

enum class Split : std::uint8_t {
    kLongestAxis,  ///< the node's box in half across its longest axis, faces by their centre
    kSurfaceArea,  ///< where the expected cost, by surface area, is least
};

/// Three stop rules, all at once; a node that meets any of them is not divided further.
struct TreeOptions {
    /// Of several rooms, and by edits, nodes of more than 64 faces are split by surface area anyway; what edits divide
    /// anew of up to 64 in half.
    Split split = Split::kSurfaceArea;
    int max_depth = 48;          ///< nodes above a node, 0..64; out of range counts as the nearest end
    int faces_per_leaf = 4;      ///< a node of at most this many is a leaf, >= 1; of more than one only where
                                 ///< they are no more than eight triangles
    double min_node_volume = 0;  ///< cubic metres; a node whose box holds less is a leaf
};

/// What a tree came to.
struct TreeStatistics {
    std::size_t faces = 0;
    std::size_t blocks = 0;  ///< immutable pieces of up to 64 items
    std::size_t nodes = 0;   ///< inner ones and leaves
    std::size_t leaves = 0;
    int depth = 0;                   ///< nodes above the deepest leaf
    std::size_t max_leaf_faces = 0;  ///< faces in the fullest leaf
    double overlap = 0;              ///< mean over inner nodes: area shared by both children / area of the node, 0..1
    std::size_t bytes = 0;           ///< tree and faces, resident
    /// 0 without faces.
    FIRMA_INLINE double bytes_per_face() const { return faces ? double(bytes) / double(faces) : 0; }
};

}  // namespace firma
