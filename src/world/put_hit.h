// SPDX-License-Identifier: MIT
// A cast's beginning, and what it says at its end.
#pragma once

#include "cast/make_hit.h"
#include "firma/queries.h"
#include "firma/rooms.h"
#include "geometry/rounding.h"
#include "world/invalid_hit.h"
#include "world/sweep_world.h"

namespace firma {

/// A sweep, or why there is none: kHit when it is ready to go.
inline Status prepare(const World& world, const Sphere& sphere, const Vec3& path, const CastOptions& options,
                      Sweep& sweep) {
    if (options.trail) options.trail->count = 0;
    if (!(options.contact_offset <= kLargestNumber)) return Status::kInvalid;  // also not a number
    if (options.room != kAnyRoom && options.room != kLocateRoom && options.room.value >= world.room_count())
        return Status::kInvalid;
    return make_sweep(sphere, path, sweep);
}

/// The room that a cast goes on from; kAnyRoom: it goes through all at once.
inline RoomId first_room(const World& world, const Vec3& centre, const CastOptions& options) {
    const WorldData& data = world.data();
    if (data.cells.room_count() == 1) {
        if (options.trail) add_room(*options.trail, 0);
        return kAnyRoom;
    }
    const RoomId start = options.room == kLocateRoom ? locate(world, centre).room : options.room;
    return start == kAnyRoom ? kAnyRoom : RoomId{data.cells.current_room(start.value)};
}

/// A lane that has the facet whole tells its corner, too: that is one place in memory less to wait for.
inline FaceRef name_of(const SweepContact& found) {
    if (!found.whole) return ref_to(*found.block, found.slot);
    return {found.face().id, found.whole->grid_corner(found.lane, 0)};
}

inline void put_face(const SweepContact& found, Hit& hit) {
    const FaceRecord& face = found.face();
    hit.face = name_of(found);
    if (const FaceOwner* owner = found.block->owner_of(face)) hit.face_normal = owner->normal;
    hit.material = face.material;
}

/// @param hit  one that says nothing yet
template <class Mover>
void put_hit(const World& world, const Sweep& sweep, const Mover& mover, const CastOptions& options,
             const SweepContact& found, Hit& hit) {
    const auto make = [&](const PolygonShape& polygon) {
        static_cast<PolygonHit&>(hit) = mover.hit(sweep, polygon, found.contact);
    };
    if (found.block) {
#if !defined(__wasm__)  // which has to be small
        if (found.through_plane) {
            const Vec3 corner = to_metres(found.whole->grid_corner(found.lane, 0));
            make_particle_hit(sweep, corner, found.normal, found.away, found.contact, hit);
        } else
#endif
            if (found.whole) {
            make(LaneShape(*found.whole, found.lane).polygon);
        } else {
            make(FaceShape(*found.block, found.face()).polygon);
        }
        put_face(found, hit);
    } else {
        const Portal& portal = world.data().cells.portal(found.portal);
        make(portal.polygons()[found.slot].shape);
        hit.portal = {found.portal};
        hit.material = portal.material;
    }
    hit.safe_fraction = safe_fraction(
        sweep, hit, options.contact_offset >= 0 ? options.contact_offset : world.tolerance().contact_offset);
}

/// What a cast for the first touch says at its end.
/// @param ready  as of prepare()
/// @param first  what was met first; not looked at where there was nothing to look for
/// @param hit    one that says nothing yet
template <class Mover>
void put_first(const World& world, Status ready, const Vec3& centre, const Vec3& path, const Sweep& sweep,
               const Mover& mover, const CastOptions& options, const SweepContact& first, Hit& hit) {
    if (ready == Status::kInvalid)
        hit = invalid_hit(centre);
    else if (ready == Status::kHit && first.contact.touched())
        put_hit(world, sweep, mover, options, first, hit);
    else
        hit.centre = centre + path;
}

}  // namespace firma
