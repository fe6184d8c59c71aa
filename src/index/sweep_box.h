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
#include "index/box_f.h"

#if defined(__wasm_simd128__)
#include <wasm_simd128.h>
#endif

namespace firma {

/// A sweep's radius, and far more than what rounding can amount to on its way through a world.
inline double grown_radius(const Sweep& sweep) {
    constexpr double kMargin = 0x1p-44;
    const double size = max_abs(sweep.start) + 2 * sweep.end + sweep.radius + kWorldRim;
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
#if defined(__wasm__)  // which has to be small
    [[gnu::noinline]]
#else
    [[gnu::always_inline]]
#endif
    bool enters(const AnyBox& box, double latest, double& nearest) const {
#if defined(__wasm_simd128__)
        // Two at a time, and by pmax and pmin, which are what is written below, but an instruction each: engines turn
        // a selection of one of two doubles into a branch.
        const v128_t low = two_of(box.low), high = two_of(box.high);
        const v128_t low_z = wasm_f64x2_splat(box.low[2]), high_z = wasm_f64x2_splat(box.high[2]);
        const v128_t inverse = wasm_v128_load(&inverse_.x), inverse_z = wasm_f64x2_splat(inverse_.z);
        const v128_t zero = wasm_f64x2_const_splat(0);
        const v128_t backward = wasm_f64x2_lt(inverse, zero), backward_z = wasm_f64x2_lt(inverse_z, zero);
        const auto distance = [](v128_t side, v128_t other, v128_t turned, v128_t start, v128_t slope) {
            return wasm_f64x2_mul(wasm_f64x2_sub(wasm_v128_bitselect(other, side, turned), start), slope);
        };
        const v128_t in = distance(low, high, backward, wasm_v128_load(&near_.x), inverse);
        const v128_t out = distance(high, low, backward, wasm_v128_load(&far_.x), inverse);
        const v128_t in_z = distance(low_z, high_z, backward_z, wasm_f64x2_splat(near_.z), inverse_z);
        const v128_t out_z = distance(high_z, low_z, backward_z, wasm_f64x2_splat(far_.z), inverse_z);
        const v128_t from = wasm_f64x2_pmax(wasm_f64x2_pmax(zero, in_z), in);
        const v128_t to = wasm_f64x2_pmin(wasm_f64x2_pmin(wasm_f64x2_splat(latest), out_z), out);
        nearest = wasm_f64x2_extract_lane(wasm_f64x2_pmax(from, wasm_i64x2_shuffle(from, from, 1, 0)), 0);
        return nearest <= wasm_f64x2_extract_lane(wasm_f64x2_pmin(to, wasm_i64x2_shuffle(to, to, 1, 0)), 0);
#else
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
#endif
    }

private:
#if defined(__wasm_simd128__)
    static v128_t two_of(const float* values) { return wasm_f64x2_promote_low_f32x4(wasm_v128_load64_zero(values)); }
    static v128_t two_of(const double* values) { return wasm_v128_load(values); }
#endif

    Vec3 inverse_, near_, far_;
};

}  // namespace firma
