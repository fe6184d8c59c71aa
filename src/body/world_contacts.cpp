// SPDX-License-Identifier: MIT
// Spheres of a body near faces of the world.
#include "body/world_contacts.h"

#include <algorithm>
#include <cmath>
#include <tuple>

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

/// Of one sphere with the level, or with a part: of more the nearest. So what a large sphere costs on a detailed mesh
/// is no square of its faces.
constexpr std::size_t kMaxContacts = 256;

/// Facets of one face, and polygons of one portal, by where they are touched and how.
template <class Touch>
bool touch_comes_before(const Touch& a, const Touch& b) {
    const auto key = [](const Touch& of) {
        return std::tuple(of.face.corner, of.point.x, of.point.y, of.point.z, of.normal.x, of.normal.y, of.normal.z);
    };
    return key(a) < key(b);
}

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

void WorldContacts::find(Mover& mover, std::uint32_t index, const Body& body, double margin, double far,
                         std::vector<NearContact>& found) {
    look_around(world_, mover, body.mask, far);
    mover.known = std::min(far, behind_);
    keep_apart(found, mover, index, kNoPart, margin);
    mover.first_plane = std::uint32_t(planes_.size());
    mover.planes = std::uint32_t(touches_.size());
    for (const Touch& touch : touches_) planes_.push_back({touch.sphere, touch.side, touch.point, touch.plane});
    mover.clear = std::min(far + skin_, least_clear(mover));
}

void WorldContacts::find_on_parts(const StepParts& parts, Mover& mover, std::uint32_t index, const Body& body,
                                  double margin, double most, std::vector<NearContact>& found) {
    mover.part_clear = margin + skin_;
    for (std::uint32_t k = 0; k < parts.size(); ++k) {
        const StepPart& part = parts[k];
        const double reach = std::max(margin, std::min(margin + part.way, most));
        if (!(part.part.mask & body.mask) || !part.may_meet(mover.position, mover.shape->reach + reach)) continue;
        Mover seen = mover;
        seen.position = part.frame.in(mover.position);
        if (part.frame.turned)
            for (int row = 0; row < 3; ++row) {
                const Vec3 axis = part.frame.rotation.column(row);
                for (int column = 0; column < 3; ++column)
                    seen.matrix.rows[row][column] = dot(axis, mover.matrix.column(column));
            }
        look_around(part.part.world(), seen, body.mask, reach);
        for (Touch& touch : touches_) {
            touch.point = part.frame.out(touch.point);
            touch.normal = part.frame.direction_out(touch.normal);
        }
        keep_apart(found, mover, index, k, reach);
        mover.part_clear = std::min(mover.part_clear, least_clear(mover));
    }
}

/// Puts all touches into touches_.
void WorldContacts::look_around(const World& world, const Mover& mover, std::uint32_t mask, double margin) {
    touches_.clear();
    behind_ = INFINITY;
    const double reach = mover.shape->reach + margin;
    const auto show = [&](const Block& block, std::uint32_t slot, const PolygonShape& polygon) {
        look_at(mover, margin, polygon, block.faces[slot].two_sided, ref_to(block, slot), {});
    };
    const FacetsNear<decltype(show)> near{mover.position, reach, mask, show};
    for (const Node* root : indices_of(world.data()))
        if (root) traverse(*root, near);
    const Cells& cells = world.data().cells;
    if (cells.any_closed())
        cells.for_each_portal_where(
            [&](const GridBox& box) {
                return distance_to(Box{to_metres(box.low), to_metres(box.high)}, mover.position) <= reach;
            },
            [&](std::uint32_t number, const Portal& portal) {
                if (!cells.is_closed(number) || !(portal.mask & mask)) return;
                for (const PortalPolygon& polygon : portal.polygons())
                    look_at(mover, margin, polygon.shape, true, {}, {number});
            });
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
        const bool is_behind = side < 0 && !two_sided;
        if (side > reach || side < (is_behind ? -std::min(margin, behind_) : -reach)) continue;
        const Closest closest = closest_to(w, polygon);
        if (closest.distance > reach) continue;
        if (is_behind) {
            behind_ = -side;
            continue;
        }
        const double gap = closest.distance - spheres[k].radius;
        const Vec3 away = closest.distance > 0 ? closest.away * (1 / closest.distance) : normal * (side < 0 ? -1 : 1);
        touches_.push_back({k, gap, polygon.corners[0] + closest.offset, away, std::fabs(side),
                            side < 0 ? normal * -1.0 : normal, face, portal});
    }
}

/// The level's, or those of one part: what lies behind a part comes to light when that goes.
void WorldContacts::keep_apart(std::vector<NearContact>& found, const Mover& mover, std::uint32_t index,
                               std::uint32_t part, double margin) {
    sort_range(touches_, [](const Touch& a, const Touch& b) {
        if (a.sphere != b.sphere) return a.sphere < b.sphere;
        if (a.gap != b.gap) return a.gap < b.gap;
        if (a.face.id != b.face.id) return a.face.id < b.face.id;
        return a.portal != b.portal ? a.portal < b.portal : touch_comes_before(a, b);
    });
    std::size_t first = found.size();  // of the sphere's
    for (const Touch& touch : touches_) {
        if (first < found.size() && found[first].at.sphere != touch.sphere) first = found.size();
        if (touch.gap > margin || found.size() - first == kMaxContacts) continue;
        // Behind the plane of a nearer contact of the sphere there is nothing that it could touch.
        const auto hides = [&](const NearContact& other) {
            return dot(touch.point - other.at.point, other.at.normal) < kInPlaneSlop;
        };
        if (std::any_of(found.begin() + std::ptrdiff_t(first), found.end(), hides)) continue;
        NearContact contact;
        contact.at.body = mover.slot;
        contact.at.sphere = touch.sphere;
        contact.at.part = part;
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
}

double WorldContacts::least_clear(const Mover& mover) const {
    double clear = INFINITY;
    // Of spheres thinner than two skins half the radius may sink in, as when they are swept.
    for (const Touch& touch : touches_) {
        const double sinks = std::min(skin_, 0.5 * mover.shape->spheres[touch.sphere].radius);
        clear = std::min(clear, touch.gap + sinks);
    }
    return clear;
}

}  // namespace firma
