// SPDX-License-Identifier: MIT
// A sphere against the inside of a face.
//
// The point of the sphere nearest to the plane leads: with w = start - corner and the unit normal n on the mover's
// side, it meets the plane at t = (w.n - r) / -(d.n), and the face if the foot of the centre then lies inside. A sphere
// whose centre is nearer to the plane than r already (the article's early-out at "distance < 0") cannot meet the inside
// first; its edges and vertices still count.
#pragma once

#include "cast/entry.h"
#include "cast/sweep.h"
#include "cast/vector_of.h"
#include "geometry/polygon_shape.h"
#include "geometry/rounding.h"

namespace firma {

/// The exact normal as double-doubles.
inline VectorOf<DoubleDouble> precise_normal(const PolygonShape& polygon) {
    const ExactNormal n = exact_normal(polygon.corners);
    return {quick_two_sum(n.axis[0][0], n.axis[0][1]), quick_two_sum(n.axis[1][0], n.axis[1][1]),
            quick_two_sum(n.axis[2][0], n.axis[2][1])};
}

/// How the start and the path lie to a face's plane, its normal turned against the path.
struct PlaneView {
    double facing = -1;   ///< -1: seen from its front; 1: from its back
    double height = 0;    ///< of the start over the plane, on the mover's side
    double approach = 0;  ///< how much the height falls per unit of t
    double height_error = 0, approach_error = 0;
};

inline PlaneView view_plane(const Sweep& sweep, const PolygonShape& polygon, int facing) {
    const Vec3 w = sweep.start - polygon.corners[0];
    PlaneView view;
    view.facing = facing > 0 ? 1 : -1;
    const double scale = -view.facing / polygon.normal_length;
    view.height = dot(w, polygon.normal) * scale;
    view.approach = -dot(sweep.direction, polygon.normal) * scale;
    view.height_error = rounding(16) * length(w);
    view.approach_error = rounding(16) * sweep.direction_length;
    return view;
}

/// When a sphere's leading point, or a particle, meets the plane, where double would lose digits.
inline Entry enter_plane_precisely(const Sweep& sweep, double radius, const PolygonShape& polygon, double facing) {
    using Real = DoubleDouble;
    const VectorOf<Real> n = precise_normal(polygon);
    const Real down = dot(exactly<Real>(sweep.direction), n) * Real(facing);
    const Real height = dot(difference<Real>(sweep.start, polygon.corners[0]), n) * Real(-facing);
    const Real reach = Real(radius) * square_root(dot(n, n));
    if (!(0.0 < down)) return {};
    return counted(sweep, (height - reach) / down);
}

/// When the sphere's leading point meets the plane. To be asked when the start is not below it by
/// more than rounding and the path leads down; beyond the end of the path the answer is kNone.
inline Entry enter_plane(const Sweep& sweep, const PolygonShape& polygon, const PlaneView& view) {
    if (view.approach >= sweep.direction_length * kShallowSine) {
        const double t = (view.height - sweep.radius) / view.approach;
        if (!near_end(t, sweep.end)) return t > sweep.end ? Entry{} : Entry{Entry::kFound, t < 0 ? 0 : t};
    }
    return enter_plane_precisely(sweep, sweep.radius, polygon, view.facing);
}

/// Whether the foot of the centre at t lies inside the face. In double: along its rim the edges answer as well as the
/// face.
inline bool foot_inside(const Sweep& sweep, const PolygonShape& polygon, double t) {
    const Vec3 centre = (sweep.start - polygon.corners[0]) + sweep.direction * t;
    for (std::size_t k = 0; k < polygon.corners.size(); ++k) {
        const Vec3 a = polygon.corners[k] - polygon.corners[0],
                   b = polygon.corners[polygon.next(k)] - polygon.corners[0];
        if (dot(cross(b - a, centre - a), polygon.normal) < 0) return false;
    }
    return true;
}

}  // namespace firma
