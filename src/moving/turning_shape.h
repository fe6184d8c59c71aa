// SPDX-License-Identifier: MIT
// A shape that goes straight, seen from a part that turns: there its corners go on arcs.
//
// With axis k and angle w of the turn, a point that is at y(0) in the part's frame and goes by v is at
//     y(t) = T(-w t) (y(0) + t v),   y'(t) = T(-w t) v - w k x y(t),   |y''(t)| <= w^2 |k x (y(0) + t v)| + 2 w |k x v|
// where T(a) turns by a about k. k x (...) is convex in t, so its length is greatest at an end of a piece of time.
#pragma once

#include <cmath>
#include <span>

#include "firma/motion.h"
#include "moving/arc.h"
#include "moving/corner_list.h"

namespace firma {

/// The hull of corners, and all within a radius of it.
struct TurningShape {
    CornerList start;  ///< in the part's frame
    double radius = 0;
    Vec3 velocity;  ///< of all of them at the start, in the part's frame, less the part's own
    Vec3 axis;      ///< of the part's turn, in its frame
    double angle = 0;

    /// @param corners  in the world, at the start
    TurningShape(const RigidMotion& part, std::span<const Vec3> corners, double r, const Vec3& path) : radius(r) {
        const TurnMatrix rotation = matrix_of(normalised(part.rotation));
        const TurnRate rate(part.turn);
        axis = rotation.back(rate.axis);
        angle = rate.angle;
        velocity = rotation.back(path - part.path);
        for (const Vec3& corner : corners) start.add(rotation.back(corner - part.position));
    }

    /// No corner's |y''| is above this between two times.
    double bend(double from, double to) const {
        double wide = 0;
        for (const Vec3& corner : start.all())
            for (const double t : {from, to}) {
                const double across = length(cross(axis, corner + velocity * t));
                wide = across > wide ? across : wide;
            }
        return angle * (angle * wide + 2 * length(cross(axis, velocity))) * (1 + 0x1p-30);
    }
};

/// The same at one time.
struct ShapeAt {
    double time = 0;
    CornerList corner;
    Vec3 velocity;  ///< T(-w t) v
    Vec3 spin;      ///< w k

    ShapeAt(const TurningShape& shape, double t) : time(t), spin(shape.axis * shape.angle) {
        const SineCosine turned = sine_cosine(shape.angle * t);
        const auto turn_back = [&](const Vec3& v) {
            const Vec3 across = cross(shape.axis, v);
            return v - across * turned.sine + cross(shape.axis, across) * (1 - turned.cosine);
        };
        velocity = turn_back(shape.velocity);
        for (const Vec3& start : shape.start.all()) corner.add(turn_back(start + shape.velocity * t));
    }

    std::span<const Vec3> corners() const { return corner.all(); }
    /// y' of a point of the shape that is here at this time.
    Vec3 velocity_of(const Vec3& y) const { return velocity - cross(spin, y); }
};

}  // namespace firma
