// SPDX-License-Identifier: MIT
// A shape that goes straight, seen from a part that turns: there its corners go on arcs.
//
// With axis k and angle w of the turn, a point that is at y(0) in the part's frame and goes by v is at
//     y(t) = T(-w t) (y(0) + t v),   y'(t) = T(-w t) v - w k x y(t),   |y''(t)| <= w^2 |k x (y(0) + t v)| + 2 w |k x v|
// where T(a) turns by a about k. k x (...) is convex in t, so its length is greatest at an end of a piece of time.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "firma/hull.h"
#include "firma/motion.h"
#include "moving/arc.h"

namespace firma {

/// The hull of corners, and all within a radius of it.
struct TurningShape {
    std::array<Vec3, kMaxHullCorners> start;  ///< in the part's frame
    std::size_t count = 0;
    double radius = 0;
    Vec3 velocity;  ///< of all of them at the start, in the part's frame, less the part's own
    Vec3 axis;      ///< of the part's turn, in its frame
    double angle = 0;

    /// @param corners  in the world, at the start
    TurningShape(const RigidMotion& part, std::span<const Vec3> corners, double r, const Vec3& path)
        : count(corners.size()), radius(r) {
        const TurnMatrix rotation = matrix_of(normalised(part.rotation));
        const TurnRate rate(part.turn);
        axis = rotation.back(rate.axis);
        angle = rate.angle;
        velocity = rotation.back(path - part.path);
        for (std::size_t k = 0; k < count; ++k) start[k] = rotation.back(corners[k] - part.position);
    }

    /// No corner's |y''| is above this between two times.
    double bend(double from, double to) const {
        double wide = 0;
        for (std::size_t k = 0; k < count; ++k)
            for (const double t : {from, to}) {
                const double across = length(cross(axis, start[k] + velocity * t));
                wide = across > wide ? across : wide;
            }
        return angle * (angle * wide + 2 * length(cross(axis, velocity))) * (1 + 0x1p-30);
    }
};

/// The same at one time.
struct ShapeAt {
    double time = 0;
    std::array<Vec3, kMaxHullCorners> corner;
    std::size_t count = 0;
    Vec3 velocity;  ///< T(-w t) v
    Vec3 spin;      ///< w k

    ShapeAt(const TurningShape& shape, double t) : time(t), count(shape.count), spin(shape.axis * shape.angle) {
        const SineCosine turned = sine_cosine(shape.angle * t);
        const auto turn_back = [&](const Vec3& v) {
            const Vec3 across = cross(shape.axis, v);
            return v - across * turned.sine + cross(shape.axis, across) * (1 - turned.cosine);
        };
        velocity = turn_back(shape.velocity);
        for (std::size_t k = 0; k < count; ++k) corner[k] = turn_back(shape.start[k] + shape.velocity * t);
    }

    std::span<const Vec3> corners() const { return std::span(corner).first(count); }
    /// y' of a point of the shape that is here at this time.
    Vec3 velocity_of(const Vec3& y) const { return velocity - cross(spin, y); }
};

}  // namespace firma
