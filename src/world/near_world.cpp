// SPDX-License-Identifier: MIT
// Questions without motion: what a ball overlaps, and what lies nearest to a point.
#include <cmath>

#include "base/sort.h"
#include "cast/nearness.h"
#include "firma/world.h"
#include "geometry/rounding.h"
#include "index/traverse.h"
#include "solid/near_facets.h"
#include "world/block_faces.h"
#include "world/world_data.h"

namespace firma {
namespace {

NearFace near_face(const Block& block, std::uint32_t slot, const PolygonShape& polygon, const Closest& closest) {
    NearFace near;
    const FaceRecord& face = block.faces[slot];
    near.point = polygon.corners[0] + closest.offset;
    near.distance = closest.distance;
    near.feature = closest.feature;
    near.feature_index = closest.index;
    near.face = face.id;
    near.ref = ref_to(block, slot);
    near.source = face.source;
    near.source_edit = face.edit;
    near.material = face.material;
    return near;
}

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
void look_at_portal(std::uint32_t index, const Portal& portal, const Vec3& point, Found& found) {
    std::optional<NearFace> nearest;
    for (const PortalPolygon& polygon : portal.polygons()) {
        const Closest closest = closest_to(point - polygon.shape.corners[0], polygon.shape);
        if (!found.takes(point, polygon.shape, closest)) continue;
        if (nearest && closest.distance >= nearest->distance) continue;
        nearest = near_portal(index, portal, polygon.shape, closest);
    }
    if (nearest) found.keep(*nearest);
}

template <class Found>
void look_near(const World& world, const Vec3& point, std::uint32_t mask, RoomId room, Found& found) {
    const WorldData& data = world.data();
    const Cells& cells = data.cells;
    NearFacets<Found> visitor{point, mask, found};
    const auto look_at = [&](std::uint32_t number, const Portal& portal) {
        if (cells.is_closed(number) && (portal.mask & mask)) look_at_portal(number, portal, point, found);
    };
    if (room != kAnyRoom) {
        const std::uint32_t here = cells.current_room(room.value);
        if (const Node* tree = data.faces_of(here).tree.get()) traverse(*tree, visitor);
        if (cells.any_closed())
            for (const std::uint32_t portal : cells.portals_of(here)) look_at(portal, cells.portal(portal));
        return;
    }
    for (const Node* index : indices_of(data))
        if (index) traverse(*index, visitor);
    if (!cells.any_closed()) return;
    cells.for_each_portal_where(
        [&](const GridBox& box) {
            const Box metres{to_metres(box.low), to_metres(box.high)};
            return visitor.within(distance_to(metres, point));
        },
        look_at);
}

struct Collect {
    double reach;
    std::vector<NearFace>& all;
    bool takes(const Vec3& point, const PolygonShape& polygon, const Closest& closest) const {
        return ball_meets(point, reach, polygon, closest);
    }
    void keep(const NearFace& near) { all.push_back(near); }
    bool keep(const Block& block, std::uint32_t slot, const PolygonShape& polygon, const Closest& closest) {
        keep(near_face(block, slot, polygon, closest));
        return false;
    }
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
    bool keep(const Block& block, std::uint32_t slot, const PolygonShape& polygon, const Closest& closest) {
        keep(near_face(block, slot, polygon, closest));
        return false;
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
    look_near(world, sphere.centre, mask, room, collect);
    sort_range(found, comes_before);
    return found.empty() ? Status::kMiss : Status::kTouching;
}

std::optional<NearFace> closest(const World& world, const Vec3& point, double reach, std::uint32_t mask, RoomId room) {
    if (!is_there(world, room) || !usable(point) || std::isnan(reach)) return {};
    KeepNearest nearest{reach, {}};
    look_near(world, point, mask, room, nearest);
    return nearest.best;
}

}  // namespace firma
