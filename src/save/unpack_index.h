// SPDX-License-Identifier: MIT
// How a saved world's faces were kept and found: blocks, and indices over them.
#pragma once

#include <optional>
#include <vector>

#include "save/entries.h"
#include "save/unpack_data.h"
#include "solid/face_set.h"

namespace firma {

struct UnpackedIndex {
    Ref<const Node> solid, castable;     ///< null: no faces
    std::vector<Ref<const Node>> rooms;  ///< of each
};

/// Nothing where the file has no index, or where damage was reported.
/// @return indices of which each is a tree, no deeper than traversals can go; whether they hold what they should is for
///         check_world() to find out
std::optional<UnpackedIndex> unpack_index(Sections& sections, const UnpackedData& data, const FaceSet& faces,
                                          Damage& damage);

}  // namespace firma
