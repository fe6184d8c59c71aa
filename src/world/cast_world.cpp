// SPDX-License-Identifier: MIT
// Casts through a world: the walk through each room's tree, and the first, any or all of the touches found.
#include <algorithm>

#include "cast/cast_sphere_polygon.h"
#include "cast/make_hit.h"
#include "firma/world.h"
#include "geometry/rounding.h"
#include "tree/sweep_box.h"
#include "tree/visit.h"
#include "world/block_faces.h"
#include "world/find_neighbour.h"
#include "world/world_data.h"

namespace firma {
namespace {

/// A touch and whose it is.
struct FaceContact {
    Contact contact;
    const Block* block = nullptr;
    std::uint32_t slot = 0;
    std::uint32_t room = 0;

    const FaceRecord& face() const { return block->faces[slot]; }
};

struct BoxOfFace {
    double low[3], high[3];
};

BoxOfFace box_of(const Block& block, const FaceRecord& face) {
    const auto corners = block.corners_of(face);
    GridPoint low = block.vertices[corners[0]], high = low;
    for (const std::uint16_t corner : corners.subspan(1)) {
        const GridPoint& p = block.vertices[corner];
        for (int axis = 0; axis < 3; ++axis) {
            if (p[axis] < low[axis]) low[axis] = p[axis];
            if (p[axis] > high[axis]) high[axis] = p[axis];
        }
    }
    const Vec3 a = to_metres(low), b = to_metres(high);
    return {{a.x, a.y, a.z}, {b.x, b.y, b.z}};
}

/// Walks one room's tree. `Found` is told of every touch up to `latest` and returns true to end the walk; it may bring
/// `latest` forward.
template <class Found>
class SweepVisitor {
public:
    SweepVisitor(const Sweep& sweep, const CastOptions& options, std::uint32_t room, Found& found)
        : sweep_(sweep), boxes_(sweep), options_(options), room_(room), found_(found) {}

    bool enter(const Bin& bin, double& nearest) {
        ++counts.bins;
        return boxes_.enters(bin.box, found_.latest, nearest);
    }
    bool still(double nearest) const { return nearest <= found_.latest; }

    bool faces(const Block& block, std::uint32_t first, std::uint32_t count) {
        for (std::uint32_t slot = first; slot < first + count; ++slot) {
            const FaceRecord& face = block.faces[slot];
            if (!(face.mask & options_.mask)) continue;
            ++counts.boxes;
            double nearest;
            if (!boxes_.enters(box_of(block, face), found_.latest, nearest)) continue;
            ++counts.faces;
            const FaceShape shape(block, face);
            const Sides sides = face.two_sided ? Sides::kBoth : options_.sides;
            const Contact contact = cast_sweep_polygon(sweep_, shape.polygon, sides, found_.latest, &counts);
            if (contact.touched() && found_({contact, &block, slot, room_})) return true;
        }
        return false;
    }

    CastCounts counts;

private:
    const Sweep& sweep_;
    const SweepBox boxes_;
    const CastOptions& options_;
    const std::uint32_t room_;
    Found& found_;
};

template <class Found>
void sweep_rooms(const World& world, const Sweep& sweep, const CastOptions& options, Found& found) {
    const WorldData& data = world.data();
    for (std::uint32_t room = 0; room < data.rooms.size(); ++room) {
        const Room& it = *data.rooms[room];
        if (!it.tree) continue;
        SweepVisitor<Found> visitor(sweep, options, room, found);
        visit(*it.tree, visitor);
        if (options.counts) {
            options.counts->bins += visitor.counts.bins;
            options.counts->boxes += visitor.counts.boxes;
            options.counts->faces += visitor.counts.faces;
            options.counts->precise += visitor.counts.precise;
        }
    }
}

/// Keeps the earliest touch; of several at one time the lowest id.
struct KeepFirst {
    double latest;
    FaceContact best;

    bool operator()(const FaceContact& other) {
        const bool sooner = !best.contact.touched() || other.contact.t < best.contact.t ||
                            (other.contact.t == best.contact.t && other.face().id < best.face().id);
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

    bool operator()(const FaceContact& contact) {
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

    bool operator()(const FaceContact& contact);
};

Hit dress(const World& world, const Sweep& sweep, const CastOptions& options, const FaceContact& found) {
    const FaceRecord& face = found.face();
    const FaceShape shape(*found.block, face);
    Hit hit;
    static_cast<PolygonHit&>(hit) = make_hit(sweep, shape.polygon, found.contact);
    hit.safe_fraction = safe_fraction(sweep, hit, options.skin >= 0 ? options.skin : world.tolerance().skin);
    hit.face = face.id;
    if (hit.feature == Feature::kEdge)
        hit.other_face = find_neighbour(*world.data().rooms[found.room]->tree, *found.block, face, hit.feature_index);
    hit.ref = {found.block, found.slot};
    if (const FaceOwner* owner = found.block->owner_of(face)) hit.face_normal = owner->normal;
    hit.source = face.source;
    hit.source_edit = face.edit;
    hit.material = face.material;
    hit.room = {found.room};
    hit.version = world.version();
    return hit;
}

bool CollectAll::operator()(const FaceContact& contact) {
    hits.push_back(dress(world, sweep, options, contact));
    return false;
}

/// A sweep, or why there is none: kHit when it is ready to go.
Status prepare(const Sphere& sphere, const Vec3& path, const CastOptions& options, Sweep& sweep) {
    if (!(options.skin <= kLargestNumber)) return Status::kInvalid;  // also not a number
    return make_sweep(sphere, path, sweep);
}

}  // namespace

Hit cast(const World& world, const Sphere& sphere, const Vec3& path, const CastOptions& options) {
    Sweep sweep;
    Hit none;
    none.version = world.version();
    none.status = prepare(sphere, path, options, sweep);
    if (none.status != Status::kHit) return none;
    KeepFirst first{sweep.end, {}};
    sweep_rooms(world, sweep, options, first);
    none.status = Status::kMiss;
    return first.best.contact.touched() ? dress(world, sweep, options, first.best) : none;
}

Status cast_any(const World& world, const Sphere& sphere, const Vec3& path, const CastOptions& options) {
    Sweep sweep;
    const Status ready = prepare(sphere, path, options, sweep);
    if (ready != Status::kHit) return ready;
    StopAtAny any{sweep.end};
    sweep_rooms(world, sweep, options, any);
    return any.status;
}

Status cast_all(const World& world, const Sphere& sphere, const Vec3& path, std::vector<Hit>& hits,
                const CastOptions& options) {
    hits.clear();
    Sweep sweep;
    const Status ready = prepare(sphere, path, options, sweep);
    if (ready != Status::kHit) return ready;
    CollectAll all{sweep.end, hits, world, sweep, options};
    sweep_rooms(world, sweep, options, all);
    std::sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) {
        return a.fraction != b.fraction ? a.fraction < b.fraction : a.face < b.face;
    });
    return hits.empty() ? Status::kMiss : hits[0].status;
}

}  // namespace firma
