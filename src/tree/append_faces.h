// SPDX-License-Identifier: MIT
// Faces out of blocks, back into a plain set.
#pragma once

#include "base/fetch_ahead.h"
#include "tree/block.h"
#include "tree/face_set.h"

namespace firma {

/// Empties a set, keeping its memory.
inline void clear(FaceSet& set) {
    set.faces.clear();
    set.vertices.clear();
    set.corners.clear();
    set.owners.clear();
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
    entry.owner = block.owner_of(record);
    return entry;
}

/// Puts the faces of a leaf block that `stays(slot)` at the end of a set. The block keeps their owners alive.
template <class Stays>
void append_faces(const Block& leaf, FaceSet& set, const Stays& stays) {
    for (const Ref<const FaceOwner>& owner : leaf.owners) fetch_ahead(owner.get());  // a new block will count as user
    const auto base = std::uint32_t(set.vertices.size());
    set.vertices.insert(set.vertices.end(), leaf.vertices.begin(), leaf.vertices.end());
    for (std::uint32_t slot = 0; slot < leaf.faces.size(); ++slot) {
        if (!stays(slot)) continue;
        FaceSet::Entry entry = entry_of(leaf, leaf.faces[slot]);
        entry.first_corner = std::uint32_t(set.corners.size());
        for (const std::uint16_t vertex : leaf.corners_of(leaf.faces[slot])) set.corners.push_back(base + vertex);
        set.faces.push_back(entry);
    }
}

/// Likewise all faces of a tree.
inline void append_all_faces(const Block& root, FaceSet& set) {
    if (!root.holds_blocks()) return append_faces(root, set, [](std::uint32_t) { return true; });
    for (const Ref<const Block>& child : root.children) append_all_faces(*child, set);
}

}  // namespace firma
