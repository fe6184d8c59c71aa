// SPDX-License-Identifier: MIT
// Facets near a point, nearest boxes first.
#pragma once

#include "cast/nearness.h"
#include "geometry/rounding.h"
#include "index/box_f.h"
#include "solid/face_shape.h"

namespace firma {

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

/// A visitor of facets within `found.reach` of a point, which `Found` may bring nearer:
///   bool takes(point, polygon, closest) const
///   bool keep(block, slot, polygon, closest)    true ends the traversal
template <class Found>
struct NearFacets {
    const Vec3& point;
    std::uint32_t mask;
    Found& found;

    /// Distances to faces are rounded, so boxes a little farther are looked into as well.
    bool within(double distance) const {
        return distance <= found.reach + rounding(64) * (max_abs(point) + 4 * kWorldRim);
    }
    bool enter(const BoxF& box, double& nearest) const {
        nearest = distance_to(box, point);
        return within(nearest);
    }
    bool still(double nearest) const { return within(nearest); }
    bool facets(const IndexedFacets& facets, std::uint32_t first, std::uint32_t count) const {
        const Block& block = as_block(facets);
        for (std::uint32_t slot = first; slot < first + count; ++slot) {
            if (!(block.faces[slot].mask & mask)) continue;
            const FaceShape shape(block, block.faces[slot]);
            if (!shape.polygon.has_area()) continue;
            const Closest closest = closest_to(point - shape.polygon.corners[0], shape.polygon);
            if (found.takes(point, shape.polygon, closest) && found.keep(block, slot, shape.polygon, closest))
                return true;
        }
        return false;
    }
};

/// Whether a point lies on a facet, exactly.
bool on_some_facet(const Node& root, const Vec3& point);

/// Whether some facet lies within reach of a point, but for rounding.
/// @param root  null for no faces
bool any_facet_near(const Node* root, const Vec3& point, double reach);

}  // namespace firma
