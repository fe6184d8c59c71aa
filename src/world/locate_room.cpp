// SPDX-License-Identifier: MIT
// Which room a point lies in.
#include "world/first_seen.h"

namespace firma {
namespace {

/// What lies beyond all faces, where no rock does.
Location outside(const WorldData& data) {
    if (data.room_records)
        for (std::uint32_t room = 0; room < data.room_records->size(); ++room)
            if ((*data.room_records)[room].exterior) return {Location::Kind::kRoom, {current_room(data, room)}};
    if (data.rooms.size() == 1) return {Location::Kind::kRoom, {0}};
    return {};
}

}  // namespace

Location locate(const World& world, const Vec3& point) {
    if (!world.data().knows_walls) return {};
    const Location seen = see_where(world, point, SeePortals::kYes);
    return seen.kind == Location::Kind::kRoom && seen.room == kAnyRoom ? outside(world.data()) : seen;
}

}  // namespace firma
