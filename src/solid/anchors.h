// SPDX-License-Identifier: MIT
// What holds pieces of a solid, so that they are not loose: faces by what they were cut from.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solid/block.h"

namespace firma {

/// All ascending. A piece with one such face stays where it is.
struct Anchors {
    std::vector<std::uint32_t> materials;
    std::vector<std::uint32_t> sources;  ///< of the level's file
    std::vector<std::uint32_t> edits;    ///< whose cutters' faces hold: fills that stand free
    std::vector<std::uint64_t> hanging;  ///< key_of() of what bounded a body that hung free
    std::vector<GridBox> volumes;        ///< that hold what reaches into them, by their corners

    static std::uint64_t key_of(const FaceRecord& face) { return std::uint64_t(face.edit) << 32 | face.source; }

    bool holds(const FaceRecord& face) const {
        const auto has = [](const auto& list, auto value) {
            return std::binary_search(list.begin(), list.end(), value);
        };
        return has(materials, face.material) || (face.edit == 0 && has(sources, face.source)) ||
               (face.edit != 0 && has(edits, face.edit)) || has(hanging, key_of(face));
    }
    /// Memory beside the object itself.
    std::size_t bytes() const {
        return sizeof(std::uint32_t) * (materials.capacity() + sources.capacity() + edits.capacity()) +
               sizeof(std::uint64_t) * hanging.capacity() + sizeof(GridBox) * volumes.capacity();
    }
    friend bool operator==(const Anchors&, const Anchors&) = default;
};

/// The keys of all faces that bound bodies which nothing else of the solid holds: shells that look outward. Not of one
/// that bounds something else as well: a side of a brush that reaches from a hall through its wall.
/// @param root  of all faces, or of some: then shells that these do not close hang from others
/// @param edit  only shells all of whose faces it made; 0: all
/// Costs all faces.
std::vector<std::uint64_t> find_hanging(const Node* root, std::uint32_t edit = 0);

}  // namespace firma
