// SPDX-License-Identifier: MIT
// Many convex brushes become one closed solid.
#include "join/join_brushes.h"

#include "join/brush_join.h"

namespace firma {

Result<std::unique_ptr<JoinedLevel>> join_brushes(const BrushLevel& level) {
    if (!BrushJoin::fits(level))
        return Error{ErrorCode::kTooLarge, level.name, "a level has fewer than 2^20 brush sides"};
    BrushJoin join(level);
    join.update();
    return join.finish();
}

}  // namespace firma
