// SPDX-License-Identifier: MIT
// Is a point in the solid: the first face that a ray from it meets says so.
#include "world/first_seen.h"

namespace firma {

std::optional<bool> in_solid(const World& world, const Vec3& point) {
    switch (see_where(world, point, SeePortals::kNo).kind) {
        case Location::Kind::kRoom:
            return false;
        case Location::Kind::kSolid:
            return true;
        case Location::Kind::kUnsure:
            break;
    }
    return {};
}

}  // namespace firma
