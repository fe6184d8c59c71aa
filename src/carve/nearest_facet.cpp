// SPDX-License-Identifier: MIT
// The facet of a solid that is nearest to a point.
#include "carve/nearest_facet.h"

#include "index/traverse.h"
#include "solid/near_facets.h"

namespace firma {
namespace {

struct KeepNearestFacet {
    double reach;
    std::optional<NearestFacet> best;

    bool takes(const Vec3&, const PolygonShape&, const Closest& closest) const { return closest.distance <= reach; }
    bool keep(const Block& block, std::uint32_t slot, const PolygonShape& polygon, const Closest& closest) {
        if (best && closest.distance == reach && best->place.record().id < block.faces[slot].id) return false;
        best = {{&block, slot}, polygon.corners[0] + closest.offset, polygon.unit_normal()};
        reach = closest.distance;
        return false;
    }
};

}  // namespace

std::optional<NearestFacet> nearest_facet(const Node* root, const Vec3& point, double reach) {
    KeepNearestFacet found{reach, std::nullopt};
    NearFacets<KeepNearestFacet> near{point, ~0u, found};
    if (root) traverse(*root, near);
    return found.best;
}

}  // namespace firma
