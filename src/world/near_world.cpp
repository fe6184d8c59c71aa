// SPDX-License-Identifier: MIT
// Questions without motion: what a ball, a capsule or a hull overlaps, and what lies nearest to a point.
#include <cmath>

#include "base/sort.h"
#include "cast/capsule_start.h"
#include "cast/make_hull_hit.h"
#include "cast/nearness.h"
#include "firma/queries.h"
#include "geometry/exact_predicates.h"
#include "geometry/rounding.h"
#include "index/traverse.h"
#include "solid/near_facets.h"
#include "world/block_faces.h"
#include "world/world_data.h"

namespace firma {
namespace {

void put_closest(const PolygonShape& polygon, const Closest& closest, NearFace& near) {
    near.status = Status::kHit;
    near.point = polygon.corners[0] + closest.offset;
    near.distance = closest.distance;
    near.feature = closest.feature;
    near.feature_index = closest.index;
}

NearFace near_face(const Block& block, std::uint32_t slot, const PolygonShape& polygon, const Closest& closest) {
    NearFace near;
    put_closest(polygon, closest, near);
    near.face = ref_to(block, slot);
    near.material = block.faces[slot].material;
    return near;
}

NearFace near_portal(std::uint32_t index, const Portal& portal, const PolygonShape& polygon, const Closest& closest) {
    NearFace near;
    put_closest(polygon, closest, near);
    near.portal = {index};
    near.material = portal.material;
    return near;
}

/// A portal counts once, by its nearest polygon.
/// @return whether that ends it
template <class Found>
bool look_at_portal(std::uint32_t index, const Portal& portal, const Vec3& point, Found& found) {
    const PolygonShape* nearest = nullptr;
    Closest best;
    for (const PortalPolygon& polygon : portal.polygons()) {
        const Closest closest = closest_to(point - polygon.shape.corners[0], polygon.shape);
        if (!found.takes(point, polygon.shape, closest)) continue;
        if (nearest && closest.distance >= best.distance) continue;
        nearest = &polygon.shape;
        best = closest;
    }
    return nearest && found.keep(near_portal(index, portal, *nearest, best), true, *nearest, best);
}

/// Goes on to the next part only while nothing has ended it.
template <class Found>
void look_near(const World& world, const Vec3& point, const NearOptions& options, Found& found) {
    const WorldData& data = world.data();
    const Cells& cells = data.cells;
    NearFacets<Found> visitor{point, options.mask, found};
    const auto look_at = [&](std::uint32_t number, const Portal& portal) {
        if (!found.ended && cells.is_closed(number) && (portal.mask & options.mask))
            look_at_portal(number, portal, point, found);
    };
    if (options.room != kAnyRoom) {
        const std::uint32_t here = cells.current_room(options.room.value);
        if (const Node* tree = data.faces_of(here).tree.get()) traverse(*tree, visitor);
        if (cells.any_closed())
            for (const PortalId portal : cells.portals_of(here)) look_at(portal.value, cells.portal(portal.value));
        return;
    }
    for (const Node* index : indices_of(data))
        if (index && !found.ended) traverse(*index, visitor);
    if (!cells.any_closed()) return;
    cells.for_each_portal_where(
        [&](const GridBox& box) {
            const Box metres{to_metres(box.low), to_metres(box.high)};
            return visitor.within(distance_to(metres, point));
        },
        look_at);
}

/// How to leave a polygon that a ball overlaps.
void put_way_out(const Vec3& centre, double radius, bool two_sided, const PolygonShape& polygon, const Closest& closest,
                 Overlap& overlap) {
    const Vec3 normal = polygon.unit_normal();
    const int side = exact_plane_side(centre, polygon);
    if (side < 0 && !two_sided) {
        overlap.direction = normal;
        overlap.depth = radius - dot(closest.away, normal);
    } else if (closest.distance > 0) {
        overlap.direction = closest.away * (1 / closest.distance);
        overlap.depth = radius - closest.distance;
    } else {
        overlap.direction = normal;
        overlap.depth = radius;
    }
    if (!(overlap.depth > 0)) overlap.depth = 0;
}

struct VisitOverlaps {
    const Vec3& centre;
    double reach;
    OverlapVisitor visit;
    bool any = false;
    bool ended = false;

    bool takes(const Vec3& point, const PolygonShape& polygon, const Closest& closest) const {
        return ball_meets(point, reach, polygon, closest);
    }
    bool keep(const NearFace& near, bool two_sided, const PolygonShape& polygon, const Closest& closest) {
        Overlap overlap;
        static_cast<NearFace&>(overlap) = near;
        put_way_out(centre, reach, two_sided, polygon, closest, overlap);
        any = true;
        return ended = !visit(overlap);
    }
    bool keep(const Block& block, std::uint32_t slot, const PolygonShape& polygon, const Closest& closest) {
        return keep(near_face(block, slot, polygon, closest), block.faces[slot].two_sided, polygon, closest);
    }
};

/// What is there and no sphere. One traversal serves all of them.
class OtherThere {
public:
    virtual bool meets(const PolygonShape& polygon) const = 0;
    virtual WayOut way_out(const PolygonShape& polygon, bool along_normal) const = 0;

protected:
    ~OtherThere() = default;
};

/// A capsule that is no sphere.
struct CapsuleThere final : OtherThere {
    CapsuleSweep capsule;

    CapsuleThere(const Sweep& sweep, const CapsuleShape& shape) : capsule(sweep, shape) {}
    bool meets(const PolygonShape& polygon) const override { return capsule_meets(capsule, polygon); }
    WayOut way_out(const PolygonShape& polygon, bool along_normal) const override {
        return way_out_of_capsule(capsule, polygon, along_normal);
    }
};

struct HullThere final : OtherThere {
    const Sweep& sweep;
    const HullShape& hull;

    HullThere(const Sweep& s, const HullShape& h) : sweep(s), hull(h) {}
    bool meets(const PolygonShape& polygon) const override {
        return hull_meets(HullAgainstPolygon(sweep, hull, polygon));
    }
    WayOut way_out(const PolygonShape& polygon, bool along_normal) const override {
        return way_out_of_hull(sweep, hull, polygon, along_normal);
    }
};

struct VisitShapeOverlaps {
    const Sweep& around;  ///< its sphere holds the shape
    const OtherThere& shape;
    OverlapVisitor visit;
    double reach = around.radius;
    bool any = false;
    bool ended = false;

    bool takes(const Vec3& point, const PolygonShape& polygon, const Closest& closest) const {
        const double noise = rounding(64) * (max_abs(point) + 4 * kWorldRim + reach);
        return closest.distance <= reach + noise && shape.meets(polygon);
    }
    bool keep(const NearFace& near, bool two_sided, const PolygonShape& polygon, const Closest&) {
        const WayOut out = shape.way_out(polygon, !two_sided && exact_plane_side(around.start, polygon) < 0);
        Overlap overlap;
        static_cast<NearFace&>(overlap) = near;
        put_closest(polygon, out.closest, overlap);
        overlap.direction = out.direction;
        overlap.depth = out.depth;
        any = true;
        return ended = !visit(overlap);
    }
    bool keep(const Block& block, std::uint32_t slot, const PolygonShape& polygon, const Closest& closest) {
        return keep(near_face(block, slot, polygon, closest), block.faces[slot].two_sided, polygon, closest);
    }
};

Status shape_overlaps(const World& world, const Sweep& around, const OtherThere& shape, OverlapVisitor visit,
                      const NearOptions& options) {
    VisitShapeOverlaps overlaps{around, shape, visit};
    look_near(world, around.start, options, overlaps);
    return overlaps.any ? Status::kInitialOverlap : Status::kMiss;
}

bool comes_before(const NearFace& a, const NearFace& b) {
    return a.face.id != b.face.id ? a.face.id < b.face.id : a.portal < b.portal;
}

/// All that `each` hands on, in order.
template <class Each>
Status gathered(std::vector<Overlap>& found, const Each& each) {
    found.clear();
    const auto add = [&](const Overlap& one) {
        found.push_back(one);
        return true;
    };
    const Status status = each(add);
    sort_range(found, comes_before);
    return status;
}

struct KeepNearest {
    double reach;
    NearFace best;
    static constexpr bool ended = false;

    bool takes(const Vec3&, const PolygonShape&, const Closest& closest) const { return closest.distance <= reach; }
    bool keep(const NearFace& near, bool, const PolygonShape&, const Closest&) {
        if (best.found() &&
            !(near.distance < best.distance || (near.distance == best.distance && comes_before(near, best))))
            return false;
        best = near;
        reach = near.distance;
        return false;
    }
    bool keep(const Block& block, std::uint32_t slot, const PolygonShape& polygon, const Closest& closest) {
        return keep(near_face(block, slot, polygon, closest), false, polygon, closest);
    }
};

bool usable(const Vec3& point) {
    return is_finite(point) && max_abs(point) <= kLargestNumber;
}

bool is_there(const World& world, RoomId room) {
    return room == kAnyRoom || room.value < world.room_count();
}

}  // namespace

Status overlap_each(const World& world, const Sphere& sphere, OverlapVisitor visit, const NearOptions& options) {
    if (!is_there(world, options.room)) return Status::kInvalid;
    if (!usable(sphere.centre) || !(sphere.radius >= 0 && sphere.radius <= kLargestNumber)) return Status::kInvalid;
    VisitOverlaps overlaps{sphere.centre, sphere.radius, visit};
    look_near(world, sphere.centre, options, overlaps);
    return overlaps.any ? Status::kInitialOverlap : Status::kMiss;
}

Status overlap_each(const World& world, const Capsule& capsule, OverlapVisitor visit, const NearOptions& options) {
    const Sphere around = ball_around(capsule);
    if (capsule.from == capsule.to) return overlap_each(world, around, visit, options);
    Sweep sweep;
    if (!is_there(world, options.room) || make_sweep(around, {1, 0, 0}, sweep) != Status::kHit) return Status::kInvalid;
    return shape_overlaps(world, sweep, CapsuleThere(sweep, shape_of_capsule(capsule)), visit, options);
}

Status overlap_each(const World& world, const Hull& hull, const Vec3& at, OverlapVisitor visit,
                    const NearOptions& options) {
    Sweep sweep;
    if (!hull.valid() || !is_there(world, options.room)) return Status::kInvalid;
    if (make_sweep({at, hull.shape()->reach}, {1, 0, 0}, sweep) != Status::kHit) return Status::kInvalid;
    return shape_overlaps(world, sweep, HullThere(sweep, *hull.shape()), visit, options);
}

Status overlap(const World& world, const Sphere& sphere, std::vector<Overlap>& found, const NearOptions& options) {
    return gathered(found, [&](OverlapVisitor add) { return overlap_each(world, sphere, add, options); });
}

Status overlap(const World& world, const Capsule& capsule, std::vector<Overlap>& found, const NearOptions& options) {
    return gathered(found, [&](OverlapVisitor add) { return overlap_each(world, capsule, add, options); });
}

Status overlap(const World& world, const Hull& hull, const Vec3& at, std::vector<Overlap>& found,
               const NearOptions& options) {
    return gathered(found, [&](OverlapVisitor add) { return overlap_each(world, hull, at, add, options); });
}

NearFace closest(const World& world, const Vec3& point, double reach, const NearOptions& options) {
    NearFace none;
    none.status = Status::kInvalid;
    if (!is_there(world, options.room) || !usable(point) || std::isnan(reach)) return none;
    KeepNearest nearest{reach, {}};
    look_near(world, point, options, nearest);
    return nearest.best;
}

}  // namespace firma
