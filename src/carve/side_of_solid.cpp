// SPDX-License-Identifier: MIT
// Whether a point lies in a solid.
#include "carve/side_of_solid.h"

#include <algorithm>
#include <cstdint>

#include "carve/gather.h"
#include "firma/grid.h"
#include "solid/near_facets.h"
#include "solid/solid_data.h"

namespace firma {
namespace {

constexpr double kFirstStep = 0x1p-12, kLastStep = 64;  // metres

/// By facets: 0 near one.
int side_by_facets(const Solid& solid, const Vec3& point) {
    if (any_facet_near(solid.data().faces.root.get(), point, kFacetReach / kSurfaceSteps)) return 0;
    const Where where = locate(solid, point);
    return where == Where::kSolid ? 1 : where == Where::kAir ? -1 : 0;
}

/// Of a ray with the solid's faces, on its way to a place.
/// @param steps  how far that is, input steps
CrossingCount crossings(const Solid& solid, const ExactPoint& from, const ExactRay& ray, double steps) {
    GridBox way;
    way.add(from.rounded());
    const Vec3 to = from.approximate() + ray.direction() * steps;
    for (int axis = 0; axis < 3; ++axis) {
        const double at = std::clamp(to[axis] * kSurfacePerInput, double(INT32_MIN), double(INT32_MAX));
        way.low[axis] = std::min(way.low[axis], std::int32_t(at));
        way.high[axis] = std::max(way.high[axis], std::int32_t(at));
    }
    std::vector<FacetPlace> facets;
    gather_facets(solid.data().faces.root.get(), grown(way, kFacetReach + 2), facets);
    SolidPatch patch;
    patch.add(facets);
    for (std::uint32_t edge = 0; edge < patch.edges.size(); ++edge) patch.settle_planes(edge);
    std::vector<ExactRay::Edge> edges;
    CrossingCount count;
    for (const PatchFace& face : patch.faces) {
        edges.clear();
        append_edges(patch, face, edges);
        if (!count.add(ray.meet(face.plane->plane, edges, steps))) break;
    }
    return count;
}

}  // namespace

void append_edges(const SolidPatch& patch, const PatchFace& face, std::vector<ExactRay::Edge>& edges) {
    for (const PatchUse& use : patch.uses(face)) {
        edges.push_back({&patch.vertices[patch.from(use)].point, &patch.vertices[patch.to(use)].point,
                         &patch.across(use.edge, face).plane});
    }
}

/// From a place along a ray, where facets tell, back to the point.
int side_of_solid(const Solid& solid, const ExactPoint& point) {
    if (const int side = side_by_facets(solid, to_metres(point.rounded())); side != 0) return side;
    for (int way = 0; way < ExactRay::kWays; ++way) {
        const ExactRay ray(point, way);
        for (double step = kFirstStep; step <= kLastStep; step *= 2) {
            const Vec3 place = (point.approximate() * (1 / kInputSteps)) + ray.direction() * step;
            const int side = side_by_facets(solid, place);
            if (side == 0) continue;
            const CrossingCount count = crossings(solid, point, ray, step * kInputSteps);
            if (count.begins_on_one()) return 0;
            if (!count.sure()) break;
            return count.odd() ? -side : side;
        }
    }
    return 0;
}

}  // namespace firma
