// SPDX-License-Identifier: MIT
// A sweep against eight triangles; compiled once for each kind of processor.
#include <hwy/highway.h>

#include "solid/face_lanes.h"
#include "world/lane_boxes.h"
#include "world/lane_vectors.h"
#include "world/sweep_lanes.h"

#if defined(FIRMA_LANE_TRIANGLES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRMA_LANE_TRIANGLES_H
#undef FIRMA_LANE_TRIANGLES_H
#else
#define FIRMA_LANE_TRIANGLES_H
#endif

HWY_BEFORE_NAMESPACE();
namespace firma::HWY_NAMESPACE {

/// Narrows [in, out] to the times t with b t <= w. Where both are 0, as of a triangle whose corners are one in float or
/// of a middle on a rim, that says nothing: kNothing makes such a time later than any. It stands in for the rounding,
/// too, of numbers so small that products of theirs are 0.
HWY_INLINE void clip(Floats b, Floats w, Floats& in, Floats& out) {
    constexpr float kLevel = 0x1p-120f, kNothing = 0x1p-60f;
    w = hn::Add(w, all(kNothing));
    b = hn::IfThenElse(hn::Lt(hn::Abs(b), all(kLevel)), all(kLevel), b);
    const Floats t = hn::Div(w, b);
    const auto falls = hn::Lt(b, hn::Zero(kFloats));
    in = hn::IfThenElse(falls, hn::Max(in, t), in);
    out = hn::IfThenElse(falls, out, hn::Min(out, t));
}

/// How many axes an extent has, where that is not known when this is compiled.
constexpr int kAnyAxes = -1;
template <int known>
HWY_INLINE int axes_of(const LaneSweep& sweep) {
    return known == kAnyAxes ? sweep.axes : known;
}

/// What the extent's axes add to a reach along n.
template <int known>
HWY_INLINE Floats beside(const LaneSweep& sweep, const Floats* n, Floats reach) {
    const int axes = axes_of<known>(sweep);
    for (int k = 0; k < axes; ++k) {
        const Floats a[3] = {all(sweep.axis[k][0]), all(sweep.axis[k][1]), all(sweep.axis[k][2])};
        reach = add(reach, hn::Mul(hn::Abs(dot(n, a)), all(kMore)));
    }
    return reach;
}

/// Narrows [in, out] to the times at which the extent reaches the triangle's plane.
/// @param p, e     the triangle's corners, and its sides from each to the next
/// @param longest  the square of the longest side
/// @param error    what rounding makes of a length, for each square of a metre of `longest`
/// @return how fast the path rises along the triangle's normal
template <int known>
HWY_INLINE Floats clip_to_plane(const LaneSweep& sweep, const Floats (&p)[3][3], const Floats (&e)[3][3],
                                Floats longest, const Floats (&d)[3], float reach, float error, Floats& in,
                                Floats& out) {
    Floats n[3];
    cross(e[0], e[1], n);
    const Floats g = add(hn::Mul(hn::Mul(hn::Sqrt(dot(n, n)), all(kMore)), all(reach)), hn::Mul(longest, all(error)));
    const Floats height = dot(n, p[0]), rise = dot(n, d), far = beside<known>(sweep, n, g);
    // -height + rise t lies between -far and far.
    clip(rise, hn::Add(far, height), in, out);
    clip(hn::Neg(rise), hn::Sub(far, height), in, out);
    return rise;
}

/// Narrows [in, out] to the times at which the extent comes up to a plane that parts it from the triangle when it is
/// where it is at `in`: at a right angle to the way from there to the rim.
/// @param p, e, squares  the triangle's corners, its sides from each to the next, and the squares of their lengths
/// @param d              the path's direction
/// @param grown          the extent's radius and rounding
template <int known>
HWY_INLINE void clip_beside_rim(const LaneSweep& sweep, const Floats (&p)[3][3], const Floats (&e)[3][3],
                                const Floats (&squares)[3], const Floats (&d)[3], float grown, Floats& in,
                                Floats& out) {
    constexpr float kNone = 0x1p-100f, kFar = 0x1p100f;
    const Floats zero = hn::Zero(kFloats);
    Floats away[3] = {zero, zero, zero}, nearest = all(kFar);
    for (int c = 0; c < 3; ++c) {
        Floats from[3];
        for (int axis = 0; axis < 3; ++axis) from[axis] = hn::Sub(hn::Mul(d[axis], in), p[c][axis]);
        const Floats along = hn::Div(dot(from, e[c]), hn::Max(squares[c], all(kNone)));
        const Floats share = hn::Min(hn::Max(along, zero), all(1));
        for (int axis = 0; axis < 3; ++axis) from[axis] = hn::Sub(from[axis], hn::Mul(e[c][axis], share));
        const Floats square = dot(from, from);
        const auto nearer = hn::Lt(square, nearest);
        nearest = hn::Min(nearest, square);
        for (int axis = 0; axis < 3; ++axis) away[axis] = hn::IfThenElse(nearer, from[axis], away[axis]);
    }
    const Floats most = hn::Max(hn::Max(dot(away, p[0]), dot(away, p[1])), dot(away, p[2]));
    const Floats reach = beside<known>(sweep, away, hn::Mul(hn::Sqrt(nearest), all(grown)));
    clip(dot(away, d), add(reach, most), in, out);
}

/// Corners of lanes, metres from their origin.
#if HWY_TARGET == HWY_WASM  // read at once: the module has to be small
struct Corners {
    alignas(16) float at[3][3][kLanes];  ///< in steps
    Floats step;

    HWY_INLINE explicit Corners(const FaceLanes& lanes) : step(all(lanes.step)) {
        const bool wide = lanes.is_wide();
        const auto* const upper = &lanes.corner[0][0][0];
        const auto* const lower = &(&lanes)[wide].corner[0][0][0];
        for (std::uint32_t k = 0; k < 9 * kLanes; k += kAtOnce) {
            auto steps = hn::PromoteTo(kInts, hn::LoadU(kShorts, upper + k));
            if (wide) {
                const auto low = hn::PromoteTo(kInts, hn::LoadU(kShorts, lower + k));
                steps = hn::Or(hn::ShiftLeft<16>(steps), hn::And(low, hn::Set(kInts, 0xFFFF)));
            }
            hn::Store(hn::ConvertTo(kFloats, steps), kFloats, &at[0][0][0] + k);
        }
    }
    HWY_INLINE Floats steps(int c, int axis, std::uint32_t part) const { return hn::Load(kFloats, at[c][axis] + part); }
    HWY_INLINE Floats operator()(int c, int axis, std::uint32_t part) const {
        return hn::Mul(steps(c, axis, part), step);
    }
};
#else
template <bool wide>
struct Corners {
    const FaceLanes& lanes;
    Floats step;

    HWY_INLINE explicit Corners(const FaceLanes& of) : lanes(of), step(all(of.step)) {}
    HWY_INLINE Floats steps(int c, int axis, std::uint32_t part) const {
        auto whole = hn::PromoteTo(kInts, hn::LoadU(kShorts, lanes.corner[c][axis] + part));
        if constexpr (wide) {
            const auto low = hn::PromoteTo(kInts, hn::LoadU(kShorts, (&lanes)[1].corner[c][axis] + part));
            whole = hn::Or(hn::ShiftLeft<16>(whole), hn::And(low, hn::Set(kInts, 0xFFFF)));
        }
        return hn::ConvertTo(kFloats, whole);
    }
    HWY_INLINE Floats operator()(int c, int axis, std::uint32_t part) const {
        return hn::Mul(steps(c, axis, part), step);
    }
};
#endif

/// What is said of triangles: a bit for each.
struct Triangles {
    unsigned met = 0;        ///< may be met; of those there is a lower bound for when
    unsigned clear[3] = {};  ///< of a particle, by edge: its line surely passes on the inner side
};

/// Bits of the lanes that hold a triangle.
HWY_INLINE unsigned used(const FaceLanes& lanes) {
    return (2u << (lanes.count() - 1)) - 1;
}

/// Lower bounds for when triangles are met, from the time `enter` on, a bit for each that may be by `latest`.
/// @tparam known  how many axes the extent that moves has, or kAnyAxes
template <int known, class Read>
HWY_INLINE unsigned look(const FaceLanes& lanes, const Read& corner, const LaneQuery& query, const Way& way,
                         float enter, float latest, float* times) {
    const LaneSweep& sweep = query.sweep;
    const int axes = axes_of<known>(sweep);
    float o[3], size = lanes.size + sweep.size;
    for (int axis = 0; axis < 3; ++axis) {
        const double from = sweep.start[axis] - double(lanes.origin[axis]) / kSurfaceSteps;
        o[axis] = float(from + double(enter) * sweep.path->direction[axis]);
        size += std::fabs(o[axis]);
    }
    const float unsure = lanes.uneven() + sweep.margin + 8 * kRoundoff * size;
    const float reach = (sweep.radius + unsure) * kMore;
    const float error = (axes ? 64 : 32) * kRoundoff * size;
    unsigned met = used(lanes);
    alignas(64) float ends[kLanes];
    for (int round = 0;; ++round) {
        unsigned found = 0;
        for (std::uint32_t part = 0; part < kLanes; part += kAtOnce) {
            unsigned left = met >> part & ((1u << kAtOnce) - 1);
            if (left == 0) continue;
            Floats p[3][3];  // corners seen from there
            for (int c = 0; c < 3; ++c)
                for (int axis = 0; axis < 3; ++axis) p[c][axis] = hn::Sub(corner(c, axis, part), all(o[axis]));
            Floats in = hn::Zero(kFloats), out = all((latest - enter) * kMore);
            const auto keep = [&]() HWY_ATTR {
                left &= bits(hn::Le(hn::Mul(in, all(kLess)), hn::Mul(out, all(kMore))));
                return left != 0;
            };
            if (round == 0) {
                for (int axis = 0; axis < 3; ++axis) {
                    const Floats aside = all(axes ? (sweep.extent[axis] + unsure) * kMore : reach);
                    const Floats low = hn::Sub(hn::Min(hn::Min(p[0][axis], p[1][axis]), p[2][axis]), aside);
                    const Floats high = hn::Add(hn::Max(hn::Max(p[0][axis], p[1][axis]), p[2][axis]), aside);
                    const Floats one = hn::Mul(low, way.slope[axis]), other = hn::Mul(high, way.slope[axis]);
                    in = hn::Max(in, hn::Min(one, other));  // which is which cannot be foreseen by a branch
                    out = hn::Min(out, hn::Max(one, other));
                }
                if (!keep()) continue;
            }
            Floats e[3][3];
            for (int c = 0; c < 3; ++c)
                for (int axis = 0; axis < 3; ++axis)
                    e[c][axis] = hn::Sub(corner((c + 1) % 3, axis, part), corner(c, axis, part));
            const Floats squares[3] = {dot(e[0], e[0]), dot(e[1], e[1]), dot(e[2], e[2])};
            const Floats d[3] = {all(float(sweep.path->direction[0])), all(float(sweep.path->direction[1])),
                                 all(float(sweep.path->direction[2]))};
            if (round == 0) {
                const Floats longest = hn::Max(hn::Max(squares[0], squares[1]), squares[2]);
                const Floats rise = clip_to_plane<known>(sweep, p, e, longest, d, reach, error, in, out);
                if (query.front_only) {
                    Floats doubt = hn::Mul(longest, all(128 * kRoundoff));
                    if (const float tilted = lanes.uneven() + lanes.shifted(); tilted > 0)
                        doubt = add(doubt, hn::Mul(hn::Sqrt(longest), all(32 * tilted)));
                    const unsigned away = bits(hn::Gt(rise, doubt));
                    left &= ~(away & ~(unsigned(lanes.two_sided) >> part));
                }
                if (!keep()) continue;
            } else {
                in = hn::Load(kFloats, times + part);
                out = hn::Load(kFloats, ends + part);
            }
            clip_beside_rim<known>(sweep, p, e, squares, d, (reach + error) * kMore, in, out);
            keep();
            hn::Store(hn::Mul(in, all(kLess)), kFloats, times + part);
            hn::Store(out, kFloats, ends + part);
            found |= left << part;
        }
        met = found;
        // Of several the nearest should be known better.
        if (round > 0 || (met & (met - 1)) == 0) return met;
    }
}

/// Of a power of two that is neither the smallest nor the largest.
HWY_INLINE float inverse_of_power(float power) {
    return std::bit_cast<float>((std::uint32_t(2 * 127) << 23) - std::bit_cast<std::uint32_t>(power));
}

/// The same for a particle, seen from its start: triangles along its path, as in Sweep's projection; all lengths in
/// steps of the corners. Times count from the start.
template <class Read>
HWY_INLINE Triangles look_along(const FaceLanes& lanes, const Read& corner, const LaneQuery& query, const Way& way,
                                float latest, float* times) {
    const Sweep& sweep = *query.sweep.path;
    const unsigned filled = used(lanes);
    const float steps = inverse_of_power(lanes.step);
    float o[3];
    for (int axis = 0; axis < 3; ++axis)
        o[axis] = float(sweep.start[axis] - lanes.origin[axis] * (1 / kSurfaceSteps)) * steps;
    const float farthest = lanes.size * steps;
    const float size = farthest + (std::fabs(o[0]) + std::fabs(o[1]) + std::fabs(o[2]));
    const float uneven = lanes.uneven() * steps;
    const float reach = (uneven + query.sweep.margin * steps + 8 * kRoundoff * size) * kMore;
    const float extent = 3 * farthest;  // no triangle's is larger
    const float rounding = 64 * kRoundoff * extent;
    const float unsure_area = extent * (8 * reach + rounding);
    const Floats g = all(unsure_area);
    const Floats unsure_depth = all((2 * reach + 1024 * uneven) * lanes.step);
    const int aside[2] = {sweep.axis_u, sweep.axis_v};
    const float shears[2] = {float(sweep.shear_u), float(sweep.shear_v)};
    const Floats shear[2] = {all(shears[0]), all(shears[1])};
    const float deep = o[sweep.axis_k];
    const Floats from[2] = {all(o[aside[0]] - shears[0] * deep), all(o[aside[1]] - shears[1] * deep)};
    Triangles found;
    for (std::uint32_t part = 0; part < kLanes; part += kAtOnce) {
        Floats ahead[3], flat[3][2];  // corners along the path, seen from there
        for (int c = 0; c < 3; ++c) {
            ahead[c] = corner.steps(c, sweep.axis_k, part);
            for (int axis = 0; axis < 2; ++axis)
                flat[c][axis] =
                    hn::Sub(hn::Sub(corner.steps(c, aside[axis], part), hn::Mul(shear[axis], ahead[c])), from[axis]);
        }
        Floats turns[3];  // twice the area with the path, by side
        for (int c = 0; c < 3; ++c) {
            const Floats *a = flat[c], *b = flat[(c + 1) % 3];
            turns[c] = hn::Sub(hn::Mul(a[0], hn::Sub(b[1], a[1])), hn::Mul(a[1], hn::Sub(b[0], a[0])));
        }
        const Floats least = hn::Min(hn::Min(turns[0], turns[1]), turns[2]);
        const Floats most = hn::Max(hn::Max(turns[0], turns[1]), turns[2]);
        unsigned left = bits(hn::Or(hn::Ge(least, hn::Neg(g)), hn::Le(most, g)));
        const Floats area = add(add(turns[0], turns[1]), turns[2]);
        if (query.front_only) {
            const float tilted = reach + (lanes.uneven() + lanes.shifted()) * steps;
            const unsigned away = bits(hn::Gt(area, all(extent * (32 * tilted + rounding))));
            left &= ~(away & ~(unsigned(lanes.two_sided) >> part));
        }
        if ((left << part & filled) == 0) continue;
        const Floats off = hn::Max(hn::Abs(flat[0][0]), hn::Abs(flat[0][1]));
        const auto close = hn::And(hn::Lt(off, all(4 * extent)), hn::Gt(hn::Abs(area), all(32 * unsure_area)));
        for (int c = 0; c < 3; ++c) {
            const Floats inward = hn::Xor(turns[c], hn::And(area, hn::SignBit(kFloats)));
            found.clear[c] |= bits(hn::And(close, hn::Gt(inward, all(16 * unsure_area)))) << part;
        }
        const Floats per_step = all(lanes.step * way.inverse_longest);
        Floats depth[3];  // times
        for (int c = 0; c < 3; ++c) depth[c] = hn::Mul(hn::Sub(ahead[c], all(deep)), per_step);
        const Floats first = hn::Min(hn::Min(depth[0], depth[1]), depth[2]);
        const Floats spread = hn::Sub(hn::Max(hn::Max(depth[0], depth[1]), depth[2]), first);
        const Floats sum =
            add(add(hn::Mul(turns[1], hn::Sub(depth[0], first)), hn::Mul(turns[2], hn::Sub(depth[1], first))),
                hn::Mul(turns[0], hn::Sub(depth[2], first)));
        const Floats share = hn::Div(all(1), hn::Max(hn::Abs(area), g));
        const Floats behind_first = hn::Mul(hn::CopySignToAbs(share, area), sum);
        const Floats unsure = hn::Mul(spread, add(hn::Mul(all(8 * unsure_area), share), all(16 * kRoundoff)));
        const Floats beyond = uneven > 0 ? unsure : hn::Zero(kFloats);
        Floats in = add(first, hn::Max(hn::Sub(behind_first, unsure), hn::Neg(beyond)));
        Floats out = add(first, hn::Min(add(behind_first, unsure), add(spread, beyond)));
        in = hn::Sub(hn::Mul(in, all(kLess)), unsure_depth);
        out = add(hn::Mul(out, all(kMore)), unsure_depth);
        left &= bits(hn::And(hn::Le(in, all(latest)), hn::Ge(out, hn::Zero(kFloats))));
        hn::StoreU(in, kFloats, times + part);
        found.met |= left << part;
    }
    found.met &= filled;
    return found;
}

template <class Read>
HWY_INLINE Triangles look_by_kind(const FaceLanes& lanes, const Read& corner, const LaneQuery& query, const Way& way,
                                  float enter, float latest, float* times) {
    if (query.sweep.particle) return look_along(lanes, corner, query, way, latest, times);
#if HWY_TARGET == HWY_WASM  // the module has to be small
    const unsigned met = look<kAnyAxes>(lanes, corner, query, way, enter, latest, times);
#else
    const unsigned met = query.sweep.axes == 0   ? look<0>(lanes, corner, query, way, enter, latest, times)
                         : query.sweep.axes == 1 ? look<1>(lanes, corner, query, way, enter, latest, times)
                                                 : look<3>(lanes, corner, query, way, enter, latest, times);
#endif
    if (met == 0) return {};
    for (std::uint32_t part = 0; part < kLanes; part += kAtOnce)
        hn::Store(add(hn::Load(kFloats, times + part), all(enter)), kFloats, times + part);
    return {met, {}};
}

/// Times count from the start.
HWY_INLINE Triangles look_at_triangles(const FaceLanes& lanes, const LaneQuery& query, const Way& way, float enter,
                                       float latest, float* times) {
#if HWY_TARGET == HWY_WASM
    return look_by_kind(lanes, Corners(lanes), query, way, enter, latest, times);
#else
    if (lanes.is_wide()) return look_by_kind(lanes, Corners<true>(lanes), query, way, enter, latest, times);
    return look_by_kind(lanes, Corners<false>(lanes), query, way, enter, latest, times);
#endif
}

}  // namespace firma::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
