// SPDX-License-Identifier: MIT
// The nodes of a glTF file's scene, each with what it has from its parents.
#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include "firma/result.h"
#include "gltf/gltf_file.h"
#include "gltf/placement.h"

namespace firma::gltf {

inline constexpr std::uint32_t kNoNode = ~0u;

struct SceneNode {
    std::uint32_t index = 0;
    Placement placement;  ///< to the level's metres
    bool portal = false;
    std::uint32_t mask = ~0u;
    std::uint32_t part = kNoNode;   ///< the node itself, or the nearest above, that is a part; kNoNode: of the level
    std::uint32_t named = kNoNode;  ///< the node itself, or the nearest above that has a name; kNoNode: none has
};

/// Of the default scene, else the first, else all nodes; a parent before its children, in the file's order.
/// @param parts  names of nodes that are parts, besides those whose extras say so
/// @param notes  as meaning_of()'s
/// @return kMalformed for a scene or node that is not there, a node reached twice (as in a loop), a transform that is
///         not affine
Result<std::vector<SceneNode>> scene_nodes(const GltfFile& file, const Placement& root,
                                           const std::vector<std::string>& parts, std::set<std::string>& notes);

}  // namespace firma::gltf
