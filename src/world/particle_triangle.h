// SPDX-License-Identifier: MIT
// A particle against a triangle of lanes whose corners are exact, once its plane is known to be crossed: what
// cast_particle_polygon() says, to the bit. Sides of edges that the lanes leave open are asked for exactly.
#pragma once

#include <cstdint>
#include <optional>

#include "cast/cast_particle_polygon.h"
#include "cast/contact.h"
#include "cast/sweep.h"
#include "geometry/closest_point.h"
#include "geometry/whole_path.h"
#include "solid/face_lanes.h"
#include "solid/face_shape.h"

namespace firma {

/// Of a lane that is whole, as WholePath asks for them.
template <bool wide>
struct LaneCorners {
    const FaceLanes& lanes;
    const std::uint32_t lane;
    const GridPoint& origin;
    const int bits;

    LaneCorners(const FaceLanes& of, std::uint32_t at)
        : lanes(of), lane(at), origin(of.origin), bits(wide ? 0 : of.step_bits()) {}
    std::int64_t steps(unsigned k, int axis) const {
        return wide ? lanes.steps(k, axis, lane) : lanes.corner[k][axis][lane];
    }
};

/// line_meets_polygon() of a lane that is whole. Apart, as of few triangles the lanes leave that open.
/// @param whole   of the sweep's path; made at the first such question
/// @param open    the edges of which that is not known, bits as of WholePath::triangle_sides()
/// @param facing  the sign of direction . normal, not 0
/// @param through_edge  set where the line is known to run exactly through all open edges
[[gnu::noinline]] inline bool line_passes(const Sweep& sweep, [[maybe_unused]] std::optional<WholePath>& whole,
                                          const FaceLanes& lanes, std::uint32_t lane, [[maybe_unused]] unsigned open,
                                          int facing, [[maybe_unused]] bool& through_edge) {
#if !defined(__wasm__)  // which has to be small
    if (!whole) whole.emplace(sweep.start, sweep.direction);
    if (whole->known()) {
        const unsigned wrong = facing > 0 ? kSomeNegative : kSomePositive;
        const unsigned signs = lanes.is_wide() ? whole->triangle_sides(LaneCorners<true>(lanes, lane), open)
                                               : whole->triangle_sides(LaneCorners<false>(lanes, lane), open);
        through_edge |= signs == 0;
        return !(signs & wrong);
    }
#endif
    return line_meets_polygon(sweep, LaneShape(lanes, lane).polygon, facing);
}

/// The same as make_hit(), to the bit.
/// @param corner  the triangle's first, metres
/// @param normal  of a TriangleCrossing
/// @param hit     one that says nothing yet
inline void make_particle_hit(const Sweep& sweep, const Vec3& corner, const Vec3& normal, bool away,
                              const Contact& contact, PolygonHit& hit) {
    const double normal_length = length(normal);
    const Vec3 centre = (sweep.start - corner) + sweep.direction * contact.t;
    hit.status = contact.status;
    hit.feature = contact.feature;
    hit.feature_index = contact.index;
    hit.fraction = sweep.fraction(contact.t);
    hit.centre = sweep.at(contact.t);
    // Added to zero as make_shape() does, so that no zero is negative.
    hit.face_normal = (Vec3{} + normal) * (1 / normal_length);
    hit.normal = away ? -hit.face_normal : hit.face_normal;
    hit.point = corner + (centre - hit.face_normal * (dot(centre, normal) / normal_length));
}

}  // namespace firma
