// SPDX-License-Identifier: MIT
// Whether a point lies in a solid.
#include "carve/side_of_solid.h"

#include "firma/grid.h"
#include "solid/near_facets.h"
#include "solid/solid_data.h"

namespace firma {

int side_of_solid(const Solid& solid, const Vec3& point) {
    if (any_facet_near(solid.data().faces.root.get(), point, kFacetReach / kSurfaceSteps)) return 0;
    const Where where = locate(solid, point);
    return where == Where::kSolid ? 1 : where == Where::kAir ? -1 : 0;
}

}  // namespace firma
