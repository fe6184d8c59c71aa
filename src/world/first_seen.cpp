// SPDX-License-Identifier: MIT
// What a ray from a point sees first, and so where the point is.
#include "world/first_seen.h"

#include <cmath>

#include "cast/cast_sphere_polygon.h"
#include "geometry/rounding.h"
#include "tree/sweep_box.h"
#include "tree/visit.h"
#include "world/block_faces.h"
#include "world/each_room.h"

namespace firma {
namespace {

constexpr double kRayLength = 4 * kWorldRim;  ///< from anywhere in the world to well outside

/// Bound on how far off the point is where such a ray is found to meet a face, metres. Height over the plane and
/// approach to it are off by rounding(16) of the sizes, and double is used down to an approach of an eighth: 128 of the
/// distance to a corner, and as much of the way there. Twice that covers the point's own sum.
constexpr double kMeetingError = rounding(512) * (kRayLength + 2 * kWorldRim);

/// Where two faces meet at an angle of 0.03 or more (radians), a ray that passes their edge at this distance meets them
/// farther apart than the error; nearer to the edge, or in a sharper corner, either may seem to be first.
constexpr double kRim = 1e-7;  // metres
static_assert(kRim * 0.03 > kMeetingError);

/// Whether a point of a polygon lies so near to its rim that rounding decides which of two neighbours is met first: of
/// a surface that a ray only grazes, either may be.
bool on_rim(const PolygonShape& polygon, const Vec3& point) {
    for (std::size_t k = 0; k < polygon.corners.size(); ++k) {
        const Vec3 edge = polygon.corners[polygon.next(k)] - polygon.corners[k];
        if (length(cross(edge, point - polygon.corners[k])) < kRim * length(edge)) return true;
    }
    return false;
}

/// The first face of the solid along a ray, or portal, either side.
struct FirstSeen {
    const Sweep& sweep;
    const SweepBox boxes;
    double latest;
    Contact best;
    const Block* block = nullptr;  ///< null: a portal, where anything was met
    std::uint32_t slot = 0;
    std::uint32_t room = 0, best_room = 0;
    std::uint32_t portal = 0;
    const PolygonShape* portal_shape = nullptr;

    bool enter(const Bin& bin, double& nearest) const { return boxes.enters(bin.box, latest, nearest); }
    bool enter(const BoxD& box) const {
        double nearest;
        return boxes.enters(box, latest, nearest);
    }
    bool still(double nearest) const { return nearest <= latest; }
    bool faces(const Block& in, std::uint32_t first, std::uint32_t count) {
        for (std::uint32_t k = first; k < first + count; ++k) {
            if (!in.faces[k].solid) continue;
            const FaceShape shape(in, in.faces[k]);
            const Contact contact = cast_sweep_polygon(sweep, shape.polygon, Sides::kBoth, latest, nullptr);
            if (!contact.touched() || (best.touched() && contact.t >= latest)) continue;
            best = contact;
            latest = contact.t;
            block = &in;
            slot = k;
            best_room = room;
        }
        return false;
    }

    /// At one time, faces count before portals, and of portals the lowest.
    void look_at(const PortalSet& portals, std::uint32_t index) {
        for (const PortalPolygon& polygon : portals.polygons_of(portals.portals()[index])) {
            const Contact contact = cast_sweep_polygon(sweep, polygon.shape, Sides::kBoth, latest, nullptr);
            if (!contact.touched()) continue;
            const bool tie = best.touched() && contact.t == latest;
            if (best.touched() && contact.t >= latest && !(tie && !block && index < portal)) continue;
            best = contact;
            latest = contact.t;
            block = nullptr;
            portal = index;
            portal_shape = &polygon.shape;
        }
    }
};

Location solid() {
    return {Location::Kind::kSolid, {}};
}
Location in_room(RoomId room) {
    return {Location::Kind::kRoom, room};
}

void look_along(const WorldData& data, SeePortals portals, FirstSeen& first) {
    const auto look = [&](std::uint32_t room, const Block& tree) {
        first.room = room;
        visit(tree, first);
        return false;
    };
    if (data.rooms.size() == 1) {
        if (data.rooms[0]->tree) look(0, *data.rooms[0]->tree);
    } else {
        for_each_room_nearest_first(
            data, [&](const auto& box, double& nearest) { return first.boxes.enters(box, first.latest, nearest); },
            [&](double nearest) { return nearest <= first.latest; }, look);
    }
    if (portals == SeePortals::kNo || !data.portals) return;
    data.portals->boxes().for_each_where([&](const GridBox& box) { return first.enter(in_metres(box)); },
                                         [&](std::uint32_t number) {
                                             first.look_at(*data.portals, data.portals->portal_of_box(number));
                                             return false;
                                         });
}

/// @return kUnsure where another ray should be asked
Location judge(const WorldData& data, const FirstSeen& first, const Vec3& path) {
    if (!first.best.touched()) return data.rock_outside ? solid() : in_room(kAnyRoom);
    if (first.best.feature != Feature::kFace && first.best.status == Status::kHit) return {};
    const auto facing_of = [&](const Vec3& normal) { return dot(path, normal) / length(path); };
    if (!first.block) {
        const std::array<RoomId, 2>& rooms = data.portals->portals()[first.portal].rooms;
        if (first.best.status == Status::kTouching) return in_room(rooms[0]);
        if (on_rim(*first.portal_shape, first.sweep.at(first.best.t))) return {};
        const double facing = facing_of(first.portal_shape->unit_normal());
        if (std::fabs(facing) < 0.01) return {};
        return in_room(rooms[facing < 0 ? 0 : 1]);
    }
    if (first.best.status != Status::kHit) return {};
    // A sliver's own plane may look anywhere: it must agree with the exact one.
    const FaceRecord& record = first.block->faces[first.slot];
    const FaceShape shape(*first.block, record);
    if (on_rim(shape.polygon, first.sweep.at(first.best.t))) return {};
    const Vec3 normal = shape.polygon.unit_normal();
    const FaceOwner* owner = first.block->owner_of(record);
    if (owner && dot(owner->normal, normal) < 0.9) return {};
    const double facing = facing_of(normal);
    if (std::fabs(facing) < 0.01) return {};
    return facing < 0 ? in_room({first.best_room}) : solid();
}

}  // namespace

Location see_where(const World& world, const Vec3& point, SeePortals portals) {
    constexpr Vec3 kWays[] = {{0.36, 0.48, 0.80},  {-0.48, 0.64, -0.60}, {0.60, -0.64, 0.48},  {-0.28, -0.96, 0.02},
                              {0.96, 0.03, -0.28}, {0.02, 0.28, 0.96},   {-0.8, -0.36, -0.48}, {0.64, 0.6, -0.48}};
    for (const Vec3& way : kWays) {
        const Vec3 path = way * kRayLength;
        Sweep sweep;
        if (make_sweep({point, 0}, path, sweep) != Status::kHit) return {};
        FirstSeen first{sweep, SweepBox(sweep), sweep.end, {}};
        look_along(world.data(), portals, first);
        const Location seen = judge(world.data(), first, path);
        if (seen.kind != Location::Kind::kUnsure) return seen;
    }
    return {};
}

}  // namespace firma
