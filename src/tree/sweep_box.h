// SPDX-License-Identifier: MIT
// A moving sphere against many boxes: the path as a segment, every box grown by the radius, by slabs.
//
// Conservative: boxes are also grown by far more than what rounding, here and in the narrow phase, can amount to. So no
// touch is culled, and the bound on where a box is entered is never later than any touch the narrow phase computes
// inside it; that is why the answer does not depend on the way through the tree. Source: T. Kay, J. Kajiya, Ray Tracing
// Complex Scenes, 1986.
#pragma once

#include <cmath>

#include "cast/sweep.h"
#include "tree/block.h"

namespace firma {

/// A sweep's radius, and far more than what rounding can amount to on its way through a world.
inline double grown_radius(const Sweep& sweep) {
    constexpr double kMargin = 0x1p-44;
    const double size = largest(sweep.start) + 2 * sweep.end + sweep.radius + kWorldRim;
    return sweep.radius + kMargin * size;
}

class SweepBox {
public:
    explicit SweepBox(const Sweep& sweep) {
        constexpr double kSteepest = 0x1p+300;  // stands for a slope that is infinite
        const double grown = grown_radius(sweep);
        for (int axis = 0; axis < 3; ++axis) {
            const double d = sweep.direction[axis];
            inverse_[axis] = std::fabs(d) * kSteepest > 1 ? 1 / d : kSteepest;
            const double ahead = inverse_[axis] < 0 ? -grown : grown;
            near_[axis] = sweep.start[axis] + ahead;
            far_[axis] = sweep.start[axis] - ahead;
        }
    }

    /// @param box     low[3] and high[3], metres
    /// @param latest  in the sweep's parameter
    /// @param nearest set to a lower bound for when the sphere is in the box, when it is by `latest`
    template <class AnyBox>
    bool enters(const AnyBox& box, double latest, double& nearest) const {
        double from = 0, to = latest;
        for (int axis = 0; axis < 3; ++axis) {
            const bool backward = inverse_[axis] < 0;
            const double low = box.low[axis], high = box.high[axis];
            const double in = ((backward ? high : low) - near_[axis]) * inverse_[axis];
            const double out = ((backward ? low : high) - far_[axis]) * inverse_[axis];
            from = in > from ? in : from;
            to = out < to ? out : to;
        }
        nearest = from;
        return from <= to;
    }

private:
    Vec3 inverse_, near_, far_;
};

}  // namespace firma
