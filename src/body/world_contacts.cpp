// SPDX-License-Identifier: MIT
// Spheres of a body near faces of the world.
#include "body/world_contacts.h"

#include <algorithm>
#include <cmath>

#include "base/sort.h"
#include "body/body_tolerance.h"
#include "geometry/closest_point.h"
#include "index/traverse.h"
#include "solid/face_shape.h"
#include "solid/near_facets.h"
#include "world/block_faces.h"
#include "world/world_data.h"

namespace firma {
namespace {

/// The facets near a ball, each shown once.
template <class Show>
struct FacetsNear {
    const Vec3& centre;
    const double reach;
    const std::uint32_t mask;
    const Show& show;

    bool within(double distance) const { return distance <= reach; }
    bool enter(const BoxF& box, double& nearest) const {
        nearest = distance_to(box, centre);
        return within(nearest);
    }
    bool still(double nearest) const { return within(nearest); }
    bool facets(const IndexedFacets& facets, std::uint32_t first, std::uint32_t count) const {
        const Block& block = as_block(facets);
        for (std::uint32_t slot = first; slot < first + count; ++slot) {
            const FaceRecord& face = block.faces[slot];
            if (!(face.mask & mask)) continue;
            const FaceShape shape(block, face);
            if (shape.polygon.has_area()) show(block, slot, shape.polygon);
        }
        return false;
    }
};

}  // namespace

void WorldContacts::find(Mover& mover, std::uint32_t index, const Body& body, double margin,
                         std::vector<NearContact>& found) {
    touches_.clear();
    mover.clear = margin + skin_;
    const double reach = mover.shape->reach + margin;
    const auto show = [&](const Block& block, std::uint32_t slot, const PolygonShape& polygon) {
        look_at(mover, margin, polygon, block.faces[slot].two_sided, ref_to(block, slot), {});
    };
    const FacetsNear<decltype(show)> near{mover.position, reach, body.mask, show};
    for (const Node* root : indices_of(world_.data()))
        if (root) traverse(*root, near);
    const Cells& cells = world_.data().cells;
    if (cells.any_closed())
        cells.for_each_portal_where(
            [&](const GridBox& box) {
                return distance_to(Box{to_metres(box.low), to_metres(box.high)}, mover.position) <= reach;
            },
            [&](std::uint32_t number, const Portal& portal) {
                if (!cells.is_closed(number) || !(portal.mask & body.mask)) return;
                for (const PortalPolygon& polygon : portal.polygons())
                    look_at(mover, margin, polygon.shape, true, {}, {number});
            });
    keep_apart(found, mover, index);
}

void WorldContacts::look_at(const Mover& mover, double margin, const PolygonShape& polygon, bool two_sided,
                            FaceRef face, PortalId portal) {
    const SphereSet& spheres = mover.shape->spheres;
    const Vec3 normal = polygon.unit_normal();
    const double height = dot(mover.position - polygon.corners[0], normal);
    if (std::fabs(height) > mover.shape->reach + margin) return;
    for (std::uint32_t k = 0; k < spheres.size(); ++k) {
        const Vec3 w = mover.centre_of(k) - polygon.corners[0];
        const double side = dot(w, normal), reach = spheres[k].radius + margin;
        if (side > reach || side < (two_sided ? -reach : 0)) continue;
        const Closest closest = closest_to(w, polygon);
        if (closest.distance > reach) continue;
        const double gap = closest.distance - spheres[k].radius;
        const Vec3 away = closest.distance > 0 ? closest.away * (1 / closest.distance) : normal * (side < 0 ? -1 : 1);
        touches_.push_back({k, gap, polygon.corners[0] + closest.offset, away, face, portal});
    }
}

void WorldContacts::keep_apart(std::vector<NearContact>& found, Mover& mover, std::uint32_t index) {
    sort_range(touches_, [](const Touch& a, const Touch& b) {
        if (a.sphere != b.sphere) return a.sphere < b.sphere;
        if (a.gap != b.gap) return a.gap < b.gap;
        return a.face.id != b.face.id ? a.face.id < b.face.id : a.portal < b.portal;
    });
    const std::size_t first = found.size();
    for (const Touch& touch : touches_) {
        // Behind the plane of a nearer contact of the sphere there is nothing that it could touch.
        const auto hides = [&](const NearContact& other) {
            return other.at.sphere == touch.sphere && dot(touch.point - other.at.point, other.at.normal) < kInPlaneSlop;
        };
        if (std::any_of(found.begin() + std::ptrdiff_t(first), found.end(), hides)) continue;
        NearContact contact;
        contact.at.body = mover.slot;
        contact.at.sphere = touch.sphere;
        contact.at.face = touch.face;
        contact.at.portal = touch.portal;
        contact.at.point = touch.point;
        contact.at.normal = touch.normal;
        contact.a = index;
        contact.centre_a = mover.centre_of(touch.sphere);
        contact.radius_a = mover.shape->spheres[touch.sphere].radius;
        contact.gap = touch.gap;
        found.push_back(contact);
    }
    // Of spheres thinner than two skins half the radius may sink in, as when they are swept.
    for (const Touch& touch : touches_) {
        const double sinks = std::min(skin_, 0.5 * mover.shape->spheres[touch.sphere].radius);
        mover.clear = std::min(mover.clear, touch.gap + sinks);
    }
}

}  // namespace firma
