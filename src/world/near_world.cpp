// SPDX-License-Identifier: MIT
// Questions without motion: what a ball overlaps, and what lies nearest to a point.
#include <cmath>

#include "base/sort.h"
#include "cast/nearness.h"
#include "firma/world.h"
#include "geometry/rounding.h"
#include "tree/visit.h"
#include "world/block_faces.h"
#include "world/world_data.h"

namespace firma {
namespace {

/// How near a box is at least.
double distance_to(const BoxF& box, const Vec3& point) {
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

template <class Found>
void visit_near(const World& world, const Vec3& point, std::uint32_t mask, Found& found) {
    NearVisitor<Found> visitor{point, mask, found};
    for (const Ref<const Room>& room : world.data().rooms)
        if (room->tree) visit(*room->tree, visitor);
}

struct Collect {
    double reach;
    std::vector<NearFace>& all;
    bool takes(const Vec3& point, const PolygonShape& polygon, const Closest& closest) const {
        return ball_meets(point, reach, polygon, closest);
    }
    void keep(const NearFace& near) { all.push_back(near); }
};

struct KeepNearest {
    double reach;
    std::optional<NearFace> best;
    bool takes(const Vec3&, const PolygonShape&, const Closest& closest) const { return closest.distance <= reach; }
    void keep(const NearFace& near) {
        if (best && (near.distance > best->distance || (near.distance == best->distance && near.face > best->face)))
            return;
        best = near;
        reach = near.distance;
    }
};

bool usable(const Vec3& point) {
    return is_finite(point) && largest(point) <= kLargestNumber;
}

}  // namespace

Status overlap(const World& world, const Sphere& sphere, std::vector<NearFace>& found, std::uint32_t mask) {
    found.clear();
    if (!usable(sphere.centre) || !(sphere.radius >= 0 && sphere.radius <= kLargestNumber)) return Status::kInvalid;
    Collect collect{sphere.radius, found};
    visit_near(world, sphere.centre, mask, collect);
    sort_range(found, [](const NearFace& a, const NearFace& b) { return a.face < b.face; });
    return found.empty() ? Status::kMiss : Status::kTouching;
}

std::optional<NearFace> closest(const World& world, const Vec3& point, double reach, std::uint32_t mask) {
    if (!usable(point) || std::isnan(reach)) return {};
    KeepNearest nearest{reach, {}};
    visit_near(world, point, mask, nearest);
    return nearest.best;
}

}  // namespace firma
