// SPDX-License-Identifier: MIT
// Faces out of blocks, back into a plain set.
#pragma once

#include <span>

#include "base/fetch_ahead.h"
#include "solid/block.h"
#include "solid/face_set.h"

namespace firma {

/// Empties a set, keeping its memory.
inline void clear(FaceSet& set) {
    set.faces.clear();
    set.vertices.clear();
    set.corners.clear();
    set.owners.clear();
}

/// Puts a face of one set at the end of another, with corners of its own. Owners stay where they are kept.
inline void append_face(const FaceSet& from, const FaceSet::Entry& face, FaceSet& to) {
    FaceSet::Entry entry = face;
    entry.first_corner = std::uint32_t(to.corners.size());
    for (std::uint32_t c = 0; c < face.corner_count; ++c) {
        to.corners.push_back(std::uint32_t(to.vertices.size()));
        to.vertices.push_back(from.corner(face, c));
    }
    to.faces.push_back(entry);
}

/// Puts a face like `face` at the end of a set, with corners of its own.
inline void add_facet(FaceSet& set, std::span<const GridPoint> corners, FaceSet::Entry face) {
    face.first_corner = std::uint32_t(set.corners.size());
    face.corner_count = std::uint32_t(corners.size());
    for (const GridPoint& corner : corners) {
        set.corners.push_back(std::uint32_t(set.vertices.size()));
        set.vertices.push_back(corner);
    }
    set.faces.push_back(face);
}

/// What a face of a block is, on its way into another one; its corners still to be set.
inline FaceSet::Entry entry_of(const Block& block, const FaceRecord& record) {
    FaceSet::Entry entry;
    entry.id = record.id;
    entry.source = record.source;
    entry.material = record.material;
    entry.mask = record.mask;
    entry.corner_count = record.corner_count;
    entry.two_sided = record.two_sided;
    entry.solid = record.solid;
    entry.edit = record.edit;
    entry.part = block.part;
    entry.owner = block.owner_of(record);
    return entry;
}

/// The corners of a face of a block, each as a vertex of its own.
FIRMA_SELDOM inline void append_corners(const Block& block, const FaceRecord& face, FaceSet& set) {
    block.for_each_corner(face, [&](const GridPoint& corner) {
        set.corners.push_back(std::uint32_t(set.vertices.size()));
        set.vertices.push_back(corner);
    });
}

/// Puts the faces of a block that `stays(slot)` at the end of a set. The block keeps their owners alive.
template <class Stays>
void append_faces(const Block& block, FaceSet& set, const Stays& stays) {
    for (const Ref<const FaceOwner>& owner : block.owners) fetch_ahead(owner.get());  // a new block will count as user
    for (std::uint32_t slot = 0; slot < block.faces.size(); ++slot) {
        if (!stays(slot)) continue;
        FaceSet::Entry entry = entry_of(block, block.faces[slot]);
        entry.first_corner = std::uint32_t(set.corners.size());
        append_corners(block, block.faces[slot], set);
        set.faces.push_back(entry);
    }
}

/// Likewise all faces below a node.
inline void append_all_faces(const Node& root, FaceSet& set) {
    for_each_block(root, [&](const Block& block) { append_faces(block, set, [](std::uint32_t) { return true; }); });
}

}  // namespace firma
