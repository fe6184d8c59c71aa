// SPDX-License-Identifier: MIT
// Questions without motion: what a ball overlaps, and what lies nearest to a point.
#include <cmath>

#include "base/sort.h"
#include "cast/nearness.h"
#include "firma/world.h"
#include "geometry/rounding.h"
#include "tree/visit.h"
#include "world/block_faces.h"
#include "world/each_room.h"
#include "world/world_data.h"

namespace firma {
namespace {

/// How near a box is at least.
template <class AnyBox>
double distance_to(const AnyBox& box, const Vec3& point) {
    Vec3 away;
    for (int axis = 0; axis < 3; ++axis) {
        const double below = double(box.low[axis]) - point[axis], above = point[axis] - double(box.high[axis]);
        const double out = below > above ? below : above;
        away[axis] = out > 0 ? out : 0;
    }
    return length(away) * (1 - rounding(16));
}

NearFace near_face(const Block& block, std::uint32_t slot, const PolygonShape& polygon, const Closest& closest) {
    NearFace near;
    const FaceRecord& face = block.faces[slot];
    near.point = polygon.corners[0] + closest.offset;
    near.distance = closest.distance;
    near.feature = closest.feature;
    near.feature_index = closest.index;
    near.face = face.id;
    near.ref = {&block, slot};
    near.source = face.source;
    near.source_edit = face.edit;
    near.material = face.material;
    return near;
}

/// Faces within `reach` of a point; `Found` may bring it nearer.
template <class Found>
struct NearVisitor {
    const Vec3& point;
    std::uint32_t mask;
    Found& found;

    /// Distances to faces are rounded, so boxes a little farther are looked into as well.
    bool within(double distance) const {
        return distance <= found.reach + rounding(64) * (largest(point) + 4 * kWorldRim);
    }
    bool enter(const Bin& bin, double& nearest) const {
        nearest = distance_to(bin.box, point);
        return within(nearest);
    }
    bool still(double nearest) const { return within(nearest); }
    bool faces(const Block& block, std::uint32_t first, std::uint32_t count) const {
        for (std::uint32_t slot = first; slot < first + count; ++slot) {
            if (!(block.faces[slot].mask & mask)) continue;
            const FaceShape shape(block, block.faces[slot]);
            const Closest closest = closest_to(point - shape.polygon.corners[0], shape.polygon);
            if (found.takes(point, shape.polygon, closest)) found.keep(near_face(block, slot, shape.polygon, closest));
        }
        return false;
    }
};

NearFace near_portal(std::uint32_t index, const Portal& portal, const PolygonShape& polygon, const Closest& closest) {
    NearFace near;
    near.point = polygon.corners[0] + closest.offset;
    near.distance = closest.distance;
    near.feature = closest.feature;
    near.feature_index = closest.index;
    near.portal = {index};
    near.material = portal.material;
    return near;
}

/// A portal counts once, by its nearest polygon.
template <class Found>
void look_at_portal(const PortalSet& portals, std::uint32_t index, const Vec3& point, Found& found) {
    const Portal& portal = portals.portals()[index];
    std::optional<NearFace> nearest;
    for (const PortalPolygon& polygon : portals.polygons_of(portal)) {
        const Closest closest = closest_to(point - polygon.shape.corners[0], polygon.shape);
        if (!found.takes(point, polygon.shape, closest)) continue;
        if (nearest && closest.distance >= nearest->distance) continue;
        nearest = near_portal(index, portal, polygon.shape, closest);
    }
    if (nearest) found.keep(*nearest);
}

template <class Found>
void visit_near(const World& world, const Vec3& point, std::uint32_t mask, RoomId room, Found& found) {
    const WorldData& data = world.data();
    NearVisitor<Found> visitor{point, mask, found};
    const auto stops = [&](std::uint32_t portal) {
        return data.closed->is_closed[portal] && (data.portals->portals()[portal].mask & mask);
    };
    if (room != kAnyRoom) {
        const std::uint32_t here = current_room(data, room.value);
        if (data.rooms[here]->tree) visit(*data.rooms[here]->tree, visitor);
        if (!data.closed) return;
        for (const std::uint32_t portal : data.portals->portals_of(here))
            if (stops(portal)) look_at_portal(*data.portals, portal, point, found);
        return;
    }
    const auto near = [&](const BoxD& box) { return visitor.within(distance_to(box, point)); };
    for_each_room_where(data, near, [&](std::uint32_t, const Block& tree) { visit(tree, visitor); });
    if (!data.closed) return;
    for (const std::uint32_t portal : data.closed->all)
        if (stops(portal)) look_at_portal(*data.portals, portal, point, found);
}

struct Collect {
    double reach;
    std::vector<NearFace>& all;
    bool takes(const Vec3& point, const PolygonShape& polygon, const Closest& closest) const {
        return ball_meets(point, reach, polygon, closest);
    }
    void keep(const NearFace& near) { all.push_back(near); }
};

bool comes_before(const NearFace& a, const NearFace& b) {
    return a.face != b.face ? a.face < b.face : a.portal < b.portal;
}

struct KeepNearest {
    double reach;
    std::optional<NearFace> best;
    bool takes(const Vec3&, const PolygonShape&, const Closest& closest) const { return closest.distance <= reach; }
    void keep(const NearFace& near) {
        if (best && !(near.distance < best->distance || (near.distance == best->distance && comes_before(near, *best))))
            return;
        best = near;
        reach = near.distance;
    }
};

bool usable(const Vec3& point) {
    return is_finite(point) && largest(point) <= kLargestNumber;
}

bool is_there(const World& world, RoomId room) {
    return room == kAnyRoom || room.value < world.room_count();
}

}  // namespace

Status overlap(const World& world, const Sphere& sphere, std::vector<NearFace>& found, std::uint32_t mask,
               RoomId room) {
    found.clear();
    if (!is_there(world, room)) return Status::kInvalid;
    if (!usable(sphere.centre) || !(sphere.radius >= 0 && sphere.radius <= kLargestNumber)) return Status::kInvalid;
    Collect collect{sphere.radius, found};
    visit_near(world, sphere.centre, mask, room, collect);
    sort_range(found, comes_before);
    return found.empty() ? Status::kMiss : Status::kTouching;
}

std::optional<NearFace> closest(const World& world, const Vec3& point, double reach, std::uint32_t mask, RoomId room) {
    if (!is_there(world, room) || !usable(point) || std::isnan(reach)) return {};
    KeepNearest nearest{reach, {}};
    visit_near(world, point, mask, room, nearest);
    return nearest.best;
}

}  // namespace firma
