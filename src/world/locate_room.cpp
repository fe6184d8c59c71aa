// SPDX-License-Identifier: MIT
// Which room a point lies in, or that it lies in the solid.
#include "firma/rooms.h"
#include "solid/first_seen.h"
#include "world/world_data.h"

namespace firma {
namespace {

class SeePortals final : public SeePolygons {
public:
    explicit SeePortals(const Cells& cells) : cells_(cells) {}
    void look(FirstSeen& ray) const override {
        cells_.for_each_portal_where([&](const GridBox& box) { return ray.enter(in_metres(box)); },
                                     [&](std::uint32_t number, const Portal& portal) {
                                         for (const PortalPolygon& polygon : portal.polygons())
                                             ray.look_at(polygon.shape, number);
                                     });
    }

private:
    struct BoxD {
        double low[3], high[3];
    };
    static BoxD in_metres(const GridBox& box) {
        const Vec3 low = to_metres(box.low), high = to_metres(box.high);
        return {{low.x, low.y, low.z}, {high.x, high.y, high.z}};
    }

    const Cells& cells_;
};

Location in_room(const WorldData& data, std::uint32_t room) {
    return {Where::kAir, {data.cells.current_room(room)}};
}

/// What lies beyond all faces, where no rock does.
Location outside(const WorldData& data) {
    if (data.rock_outside()) return {Where::kSolid, {}};
    if (data.cells.room_count() == 1) return in_room(data, 0);
    if (const std::optional<std::uint32_t> room = data.cells.exterior()) return {Where::kAir, {*room}};
    return {};
}

}  // namespace

Location locate(const World& world, const Vec3& point) {
    const WorldData& data = world.data();
    if (!data.knows_walls()) return {};
    const SeePortals portals(data.cells);
    const Seen seen = see_first(data.solid.data().faces.root.get(), point, &portals);
    switch (seen.kind) {
        case Seen::Kind::kAir:
            return in_room(data, seen.part);
        case Seen::Kind::kSolid:
            return {Where::kSolid, {}};
        case Seen::Kind::kPolygon:
            return {Where::kAir, data.cells.rooms_of(data.cells.portal(seen.number))[seen.front ? 0 : 1]};
        case Seen::Kind::kNothing:
            return outside(data);
        case Seen::Kind::kSurface:
            return {Where::kSurface, {}};
        case Seen::Kind::kUnsure:
            break;
    }
    return {};
}

}  // namespace firma
