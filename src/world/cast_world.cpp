// SPDX-License-Identifier: MIT
// Casts through a world: the first, any or all of the touches on the way.
#include <algorithm>

#include "cast/make_hit.h"
#include "firma/rooms.h"
#include "geometry/rounding.h"
#include "solid/find_neighbour.h"
#include "world/sweep_world.h"

namespace firma {
namespace {

/// Goes as the options say.
/// @return the rooms looked into; none when all of several were
template <class Found>
RoomsPassed sweep_rooms(const World& world, const Sphere& sphere, const Sweep& sweep, const CastOptions& options,
                        Found& found) {
    const WorldData& data = world.data();
    RoomsPassed passed;
    passed.all = options.passed;
    WorldSweep<Found> on_its_way(data, sweep, options, found);
    if (data.cells.room_count() == 1) {
        passed.add(0);
        on_its_way.ask_all();
        return passed;
    }
    RoomId start = options.room;
    if (start == kLocateRoom) {
        const Location location = locate(world, sphere.centre);
        start = location.kind == Location::Kind::kRoom ? location.room : kAnyRoom;
    }
    if (start != kAnyRoom) {
        on_its_way.ask_from(data.cells.current_room(start.value), passed);
        return passed;
    }
    on_its_way.ask_all();
    return passed;
}

/// Keeps the earliest touch; of several at one time the lowest id.
struct KeepFirst {
    double latest;
    SweepContact best;

    bool operator()(const SweepContact& other) {
        const bool sooner = !best.contact.touched() || other.contact.t < best.contact.t ||
                            (other.contact.t == best.contact.t && other.comes_before(best));
        if (sooner) {
            best = other;
            latest = other.contact.t;
        }
        return false;
    }
};

struct StopAtAny {
    double latest;
    Status status = Status::kMiss;

    bool operator()(const SweepContact& contact) {
        status = contact.contact.status;
        return true;
    }
};

struct CollectAll {
    double latest;
    std::vector<Hit>& hits;
    const World& world;
    const Sweep& sweep;
    const CastOptions& options;

    bool operator()(const SweepContact& contact);
};

void dress_face(const World& world, const SweepContact& found, Hit& hit) {
    const FaceRecord& face = found.face();
    hit.face = face.id;
    const WorldData& data = world.data();
    const std::uint32_t room = data.cells.current_room(found.block->part);
    if (hit.feature == Feature::kEdge)
        hit.other_face = find_neighbour(*data.faces_of(room).tree, *found.block, face, hit.feature_index);
    hit.ref = ref_to(*found.block, found.slot);
    if (const FaceOwner* owner = found.block->owner_of(face)) hit.face_normal = owner->normal;
    hit.source = face.source;
    hit.source_edit = face.edit;
    hit.material = face.material;
    hit.room = {room};
}

/// As of the room on the side that it was met from.
void dress_portal(const Cells& cells, const Portal& portal, const SweepContact& found, Hit& hit) {
    hit.portal = {found.portal};
    hit.material = portal.material;
    hit.room = cells.rooms_of(portal)[dot(hit.normal, hit.face_normal) >= 0 ? 0 : 1];
}

Hit dress(const World& world, const Sweep& sweep, const CastOptions& options, const SweepContact& found) {
    Hit hit;
    const auto make = [&](const PolygonShape& polygon) {
        static_cast<PolygonHit&>(hit) = make_hit(sweep, polygon, found.contact);
        hit.safe_fraction = safe_fraction(sweep, hit, options.skin >= 0 ? options.skin : world.tolerance().skin);
    };
    if (found.block) {
        make(FaceShape(*found.block, found.face()).polygon);
        dress_face(world, found, hit);
    } else {
        const Portal& portal = world.data().cells.portal(found.portal);
        make(portal.polygons()[found.slot].shape);
        dress_portal(world.data().cells, portal, found, hit);
    }
    hit.version = world.version();
    return hit;
}

bool CollectAll::operator()(const SweepContact& contact) {
    hits.push_back(dress(world, sweep, options, contact));
    return false;
}

/// A sweep, or why there is none: kHit when it is ready to go.
Status prepare(const World& world, const Sphere& sphere, const Vec3& path, const CastOptions& options, Sweep& sweep) {
    if (!(options.skin <= kLargestNumber)) return Status::kInvalid;  // also not a number
    const bool is_room = options.room.value < world.room_count();
    if (!is_room && options.room != kAnyRoom && options.room != kLocateRoom) return Status::kInvalid;
    return make_sweep(sphere, path, sweep);
}

}  // namespace

Hit cast(const World& world, const Sphere& sphere, const Vec3& path, const CastOptions& options) {
    Sweep sweep;
    Hit none;
    none.version = world.version();
    none.status = prepare(world, sphere, path, options, sweep);
    if (none.status != Status::kHit) return none;
    KeepFirst first{sweep.end, {}};
    const RoomsPassed passed = sweep_rooms(world, sphere, sweep, options, first);
    none.status = Status::kMiss;
    Hit hit = first.best.contact.touched() ? dress(world, sweep, options, first.best) : none;
    hit.rooms_passed = passed.count;
    hit.passed = passed.first;
    return hit;
}

Status cast_any(const World& world, const Sphere& sphere, const Vec3& path, const CastOptions& options) {
    Sweep sweep;
    const Status ready = prepare(world, sphere, path, options, sweep);
    if (ready != Status::kHit) return ready;
    StopAtAny any{sweep.end};
    sweep_rooms(world, sphere, sweep, options, any);
    return any.status;
}

Status cast_all(const World& world, const Sphere& sphere, const Vec3& path, std::vector<Hit>& hits,
                const CastOptions& options) {
    hits.clear();
    Sweep sweep;
    const Status ready = prepare(world, sphere, path, options, sweep);
    if (ready != Status::kHit) return ready;
    CollectAll all{sweep.end, hits, world, sweep, options};
    const RoomsPassed passed = sweep_rooms(world, sphere, sweep, options, all);
    for (Hit& hit : hits) {
        hit.rooms_passed = passed.count;
        hit.passed = passed.first;
    }
    std::sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) {
        return a.fraction != b.fraction ? a.fraction < b.fraction
               : a.face != b.face       ? a.face < b.face
                                        : a.portal < b.portal;
    });
    return hits.empty() ? Status::kMiss : hits[0].status;
}

}  // namespace firma
