// SPDX-License-Identifier: MIT
// Which side of a polygon a ray met.
#include "cast/side_met.h"

#include <cmath>

namespace firma {
namespace {

bool on_rim(const PolygonShape& polygon, const Vec3& point, double rim) {
    for (std::size_t k = 0; k < polygon.corners.size(); ++k) {
        const Vec3 edge = polygon.corners[polygon.next(k)] - polygon.corners[k];
        if (length(cross(edge, point - polygon.corners[k])) < rim * length(edge)) return true;
    }
    return false;
}

}  // namespace

int side_met(const Sweep& ray, const PolygonShape& polygon, const Contact& contact, double rim) {
    const double facing = dot(ray.direction, polygon.unit_normal()) / ray.direction_length;
    if (contact.feature != Feature::kFace || std::fabs(facing) < kGrazingSine) return 0;
    if (on_rim(polygon, ray.at(contact.t), rim)) return 0;
    return facing < 0 ? 1 : -1;
}

}  // namespace firma
