// SPDX-License-Identifier: MIT
// A sweep against the eight boxes of a node; compiled once for each kind of processor.
#include <hwy/highway.h>

#include <bit>
#include <cmath>

#include "index/wide_node.h"
#include "world/lane_vectors.h"
#include "world/sweep_lanes.h"

#if defined(FIRMA_LANE_BOXES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRMA_LANE_BOXES_H
#undef FIRMA_LANE_BOXES_H
#else
#define FIRMA_LANE_BOXES_H
#endif

HWY_BEFORE_NAMESPACE();
namespace firma::HWY_NAMESPACE {

/// What every node asks of a sweep, in registers. Coordinates one by one: they were stored so just before.
struct Way {
    Floats slope[3];           ///< the inverse of the direction
    Floats early[3], late[3];  ///< the same, less and more by what times are lowered and raised
    Floats ahead[3];           ///< the point by which an axis' first side is passed; what moves has it in front
    Floats behind[3];
    std::uint32_t near[3], far[3];  ///< by axis: where a node has the sides passed first, and last, in floats
    float inverse_longest;          ///< of the direction's longest coordinate

    HWY_INLINE explicit Way(const LaneSweep& sweep) {
        constexpr float kSteepest = 1e18f;  // stands for a slope that is infinite
        float inverses[3];
        for (int axis = 0; axis < 3; ++axis) {
            const double from = sweep.start[axis];
            const float along = float(sweep.path->direction[axis]);
            const float inverse = std::fabs(along) * kSteepest > 1 ? 1 / along : kSteepest;
            // Without branches: which way a path goes cannot be foreseen.
            const double reach = sweep.reach[axis] + LaneSweep::kFartherRounding * std::fabs(from);
            const double grown = std::copysign(reach, double(inverse));
            inverses[axis] = inverse;
            slope[axis] = all(inverse);
            early[axis] = all(inverse * kLess);
            late[axis] = all(inverse * kMore);
            ahead[axis] = all(float(from + grown));
            behind[axis] = all(float(from - grown));
            const std::uint32_t high_first = std::bit_cast<std::uint32_t>(inverse) >> 31;
            near[axis] = (3 * high_first + std::uint32_t(axis)) * kLanes;
            far[axis] = (3 * (1 - high_first) + std::uint32_t(axis)) * kLanes;
        }
        inverse_longest = inverses[sweep.path->axis_k];
    }
};

/// Times at which the sphere is in a node's boxes, by `latest`; a bit for each that it is in.
HWY_INLINE unsigned enter(const WideNode& node, const Way& way, float latest, float* times) {
    unsigned met = 0;
    for (std::uint32_t part = 0; part < kLanes; part += kAtOnce) {
        const auto passed = [&](std::uint32_t at, Floats from, Floats by) HWY_ATTR {
            return hn::Mul(hn::Sub(hn::LoadU(kFloats, &node.side[0][0][0] + at + part), from), by);
        };
        const auto enters = [&](int axis) HWY_ATTR { return passed(way.near[axis], way.ahead[axis], way.early[axis]); };
        const auto leaves = [&](int axis) HWY_ATTR { return passed(way.far[axis], way.behind[axis], way.late[axis]); };
        const Floats in = hn::Max(hn::Max(enters(0), enters(1)), hn::Max(enters(2), hn::Zero(kFloats)));
        const Floats out = hn::Min(hn::Min(leaves(0), leaves(1)), hn::Min(leaves(2), all(latest)));
        hn::Store(in, kFloats, times + part);
        met |= bits(hn::Le(in, out)) << part;
    }
    return met;
}

}  // namespace firma::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
