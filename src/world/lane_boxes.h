// SPDX-License-Identifier: MIT
// A sweep against the eight boxes of a node; compiled once for each kind of processor.
#include <hwy/highway.h>

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

/// What follows from a sweep, all coordinates together.
HWY_INLINE void make_ready(LaneSweep& sweep) {
    constexpr float kSteepest = 1e18f;  // stands for a slope that is infinite
#if HWY_TARGET == HWY_WASM
    for (int k = 0; k < 3; ++k) {
        const double from = sweep.start[k], grown = sweep.grown[k];
        const float way = float(sweep.direction[k]), low = float(from - grown), high = float(from + grown);
        const float slope = std::fabs(way) * kSteepest > 1 ? 1 / way : kSteepest;
        sweep.along[k] = way;
        sweep.inverse[k] = slope;
        sweep.early[k] = slope * kLess;
        sweep.late[k] = slope * kMore;
        sweep.turned[k] = slope < 0;
        sweep.ahead[k] = slope < 0 ? low : high;
        sweep.behind[k] = slope < 0 ? high : low;
    }
#else
    const hn::CappedTag<double, 4> doubles;
    const hn::Rebind<float, decltype(doubles)> floats;
    const hn::RebindToUnsigned<decltype(floats)> numbers;
    for (std::size_t k = 0; k < 4; k += hn::Lanes(doubles)) {
        const auto from = hn::LoadU(doubles, sweep.start + k), grown = hn::LoadU(doubles, sweep.grown + k);
        const auto way = hn::DemoteTo(floats, hn::LoadU(doubles, sweep.direction + k));
        const auto steepest = hn::Set(floats, kSteepest), one = hn::Set(floats, 1);
        const auto slope = hn::IfThenElse(hn::Gt(hn::Mul(hn::Abs(way), steepest), one), hn::Div(one, way), steepest);
        const auto down = hn::Lt(slope, hn::Zero(floats));
        const auto low = hn::DemoteTo(floats, hn::Sub(from, grown)), high = hn::DemoteTo(floats, hn::Add(from, grown));
        hn::StoreU(way, floats, sweep.along + k);
        hn::StoreU(slope, floats, sweep.inverse + k);
        hn::StoreU(hn::Mul(slope, hn::Set(floats, kLess)), floats, sweep.early + k);
        hn::StoreU(hn::Mul(slope, hn::Set(floats, kMore)), floats, sweep.late + k);
        hn::StoreU(hn::IfThenElse(down, low, high), floats, sweep.ahead + k);
        hn::StoreU(hn::IfThenElse(down, high, low), floats, sweep.behind + k);
        hn::StoreU(hn::BitCast(numbers, hn::VecFromMask(floats, down)), numbers, sweep.turned + k);
    }
#endif
    sweep.ready = true;
}

/// What every node asks of a sweep, in registers.
struct Way {
    Point early, late;  ///< the inverse of the direction, less and more by what times are lowered and raised
    Point ahead, behind;
    std::uint32_t near[3], far[3];  ///< by axis: which of a node's sides is passed first, and last

    HWY_INLINE explicit Way(const LaneSweep& sweep)
        : early(load_point(sweep.early)),
          late(load_point(sweep.late)),
          ahead(load_point(sweep.ahead)),
          behind(load_point(sweep.behind)) {
        for (int axis = 0; axis < 3; ++axis) {
            near[axis] = sweep.turned[axis] != 0;
            far[axis] = 1 - near[axis];
        }
    }
};

/// Times at which the sphere is in a node's boxes, by `latest`; a bit for each that it is in.
HWY_INLINE unsigned enter(const WideNode& node, const Way& way, float latest, float* times) {
    const Point base = load_point(node.base), scale = load_point(node.scale);
    const auto first = [](Floats corner, Floats size, Floats ahead, Floats slope) HWY_ATTR {
        const Floats unsure = hn::Mul(hn::Abs(hn::Mul(size, slope)), all(0x1p-13f));
        return hn::Sub(hn::Mul(hn::Sub(corner, ahead), slope), unsure);
    };
    const auto last = [](Floats corner, Floats size, Floats behind, Floats slope) HWY_ATTR {
        const Floats unsure = hn::Mul(hn::Abs(hn::Mul(size, slope)), all(0x1p-13f));
        return add(hn::Mul(hn::Sub(corner, behind), slope), unsure);
    };
    const auto one_step = [](Floats, Floats size, Floats, Floats slope) HWY_ATTR { return hn::Mul(size, slope); };
    const Point from = by_coordinate(first, base, scale, way.ahead, way.early);
    const Point to = by_coordinate(last, base, scale, way.behind, way.late);
    const Point early = by_coordinate(one_step, base, scale, way.behind, way.early);
    const Point late = by_coordinate(one_step, base, scale, way.behind, way.late);
    const Floats strides_in[3] = {spread<0>(early), spread<1>(early), spread<2>(early)};
    const Floats strides_out[3] = {spread<0>(late), spread<1>(late), spread<2>(late)};
    const Floats ins[3] = {spread<0>(from), spread<1>(from), spread<2>(from)};
    const Floats outs[3] = {spread<0>(to), spread<1>(to), spread<2>(to)};
    unsigned met = 0;
    for (std::uint32_t part = 0; part < kLanes; part += kAtOnce) {
        const auto passed = [&](int axis, std::uint32_t which, Floats stride, Floats start) HWY_ATTR {
            const auto at = hn::PromoteTo(kInts, hn::LoadU(kBytes, node.side[which][axis] + part));
            return add(hn::Mul(hn::ConvertTo(kFloats, at), stride), start);
        };
        const auto enters = [&](int axis)
                                HWY_ATTR { return passed(axis, way.near[axis], strides_in[axis], ins[axis]); };
        const auto leaves = [&](int axis)
                                HWY_ATTR { return passed(axis, way.far[axis], strides_out[axis], outs[axis]); };
        const Floats in = hn::Max(hn::Max(enters(0), enters(1)), hn::Max(enters(2), hn::Zero(kFloats)));
        const Floats out = hn::Min(hn::Min(leaves(0), leaves(1)), hn::Min(leaves(2), all(latest)));
        hn::Store(in, kFloats, times + part);
        met |= bits(hn::Le(in, out)) << part;
    }
    return met & ((1u << node.count) - 1);
}

}  // namespace firma::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
