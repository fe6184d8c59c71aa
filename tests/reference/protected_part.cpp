// SPDX-License-Identifier: MIT
// What of a world may not be carved.
#include "tests/reference/protected_part.h"

#include "firma/grid.h"
#include "solid/matter_pieces.h"
#include "world/world_data.h"

namespace firma::reference {

bool ProtectedPart::holds(const Vec3& p) const {
    const WorldData& world = world_.data();
    if (world.rules)
        for (const CarveZone& zone : world.rules->zones) {
            bool inside = zone.hardness >= 1;
            for (int axis = 0; axis < 3; ++axis)
                inside = inside && p[axis] >= zone.box.low[axis] && p[axis] <= zone.box.high[axis];
            if (inside) return true;
        }
    const std::optional<GridPoint> at = snap(p);
    if (fills_ || !world.matters || !at) return false;
    for (const MatterPiece& piece : world.matters->pieces)
        if (hardness_of(*world.matters, piece, world.rules.get()) >= 1 && firma::holds(*world.matters, piece, *at))
            return true;
    return false;
}

bool ProtectedPart::is_by_pieces() const {
    const WorldData& world = world_.data();
    return !fills_ && world.matters && !world.matters->pieces.empty() &&
           hardness_of_rest(*world.matters, world.rules.get()) < 1;
}

}  // namespace firma::reference
