// SPDX-License-Identifier: MIT
// The faces that only one of two worlds has.
#pragma once

#include <vector>

#include "firma/hit.h"
#include "solid/block.h"
#include "world/world_data.h"

namespace firma {

struct ChangedFace {
    FacetPlace place;  ///< good as long as its world is
    RoomId room;       ///< that it looks into, in its world

    const FaceRecord& record() const { return place.record(); }
};

struct ChangedFaces {
    std::vector<ChangedFace> removed, added;  ///< of `before` only, of `after` only; in order of id
};

/// A face is the same when it has the same id and is alike in everything but its room. Opens only the nodes that one of
/// the worlds does not share: for versions a few edits apart the cost follows the edits.
ChangedFaces changed_faces(const WorldData& before, const WorldData& after);

}  // namespace firma
