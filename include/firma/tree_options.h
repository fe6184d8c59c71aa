// SPDX-License-Identifier: MIT
// How the tree over a room's faces is built, and what it came to.
#pragma once

#include <cstddef>
#include <cstdint>

#include "firma/vec.h"

namespace firma {

enum class Split : std::uint8_t {
    kLongestAxis,  ///< the faces' box in half across its longest axis, faces by their centre
    kSurfaceArea,  ///< where the expected cost, by surface area, is least
};

/// Faces are divided in two, and again; what meets any of three stop rules is not divided further: a leaf. Up to eight
/// boxes of several divisions make a node.
struct TreeOptions {
    /// Of several rooms, and by edits, more than 64 faces are split by surface area anyway; what edits divide anew of
    /// up to 64 in half.
    Split split = Split::kSurfaceArea;
    int max_depth = 48;  ///< divisions above a leaf, 0..64; out of range counts as the nearest end
    /// At most this many triangles are a leaf, >= 1, rounded up to a multiple of eight: casts test eight at a time. By
    /// surface area eight and fewer are divided where they lie apart.
    int faces_per_leaf = 4;
    double min_node_volume = 0;  ///< cubic metres; faces whose box holds less are a leaf
};

/// What a tree came to.
struct TreeStatistics {
    std::size_t faces = 0;
    std::size_t blocks = 0;  ///< immutable pieces of up to 64 items
    std::size_t nodes = 0;   ///< inner ones, of up to eight boxes each, and leaves
    std::size_t leaves = 0;
    int depth = 0;                   ///< nodes above the deepest leaf
    std::size_t max_leaf_faces = 0;  ///< faces in the fullest leaf
    double overlap = 0;              ///< mean over inner nodes: area that its boxes share by twos / its area
    std::size_t bytes = 0;           ///< tree and faces, resident
    /// 0 without faces.
    FIRMA_INLINE double bytes_per_face() const { return faces ? double(bytes) / double(faces) : 0; }
};

}  // namespace firma
