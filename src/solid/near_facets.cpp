// SPDX-License-Identifier: MIT
// Facets near a point.
#include "solid/near_facets.h"

#include "index/traverse.h"

namespace firma {
namespace {

struct StopAtAny {
    double reach;
    bool any = false;
    bool takes(const Vec3&, const PolygonShape&, const Closest& closest) const { return closest.distance <= reach; }
    bool keep(const Block&, std::uint32_t, const PolygonShape&, const Closest&) { return any = true; }
};

struct StopOnSurface {
    static constexpr double reach = 0;
    bool any = false;
    bool takes(const Vec3& point, const PolygonShape& polygon, const Closest& closest) const {
        return ball_meets(point, 0, polygon, closest);
    }
    bool keep(const Block&, std::uint32_t, const PolygonShape&, const Closest&) { return any = true; }
};

}  // namespace

bool on_some_facet(const Node& root, const Vec3& point) {
    StopOnSurface found;
    NearFacets<StopOnSurface> near{point, ~0u, found};
    traverse(root, near);
    return found.any;
}

bool any_facet_near(const Node* root, const Vec3& point, double reach) {
    StopAtAny found{reach};
    NearFacets<StopAtAny> near{point, ~0u, found};
    if (root) traverse(*root, near);
    return found.any;
}

}  // namespace firma
