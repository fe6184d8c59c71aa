// SPDX-License-Identifier: MIT
// A particle against the convex sum of polygon and hull: the last facet that it enters, if it leaves none before.
//
// In double at first, with bounds on all errors. Where these leave open whether the sum is met, or would lose digits of
// the time, every sign is decided exactly and the time computed in double-double.
#include "cast/cast_hull_polygon.h"

#include <cmath>

#include "cast/hull_glance.h"
#include "cast/time_range.h"
#include "geometry/exact_predicates.h"
#include "geometry/rounding.h"

namespace firma {
namespace {

/// What double tells.
struct HullGuess {
    enum Kind : std::uint8_t { kMiss, kHit, kBlurred, kOpen };
    Kind kind = kOpen;
    HullContact found;
    double earliest = 0;  ///< of kBlurred, a hit for sure: a lower bound on when
};

HullGuess guess(const HullAgainstPolygon& pair, double latest) {
    const Sweep& sweep = pair.sweep();
    HullGuess answer;
    TimeRange enters{-1, -1}, leaves{2 * sweep.end, 2 * sweep.end};
    double first = -1;
    bool open = false;
    const bool may_meet = pair.each_facet([&](const SumFacet& facet) {
        const Estimate now = pair.outside(facet);
        const Estimate change = pair.change(facet);
        const int last = at_end(now, change, sweep.end).sign();
        if (now.value > now.error && last > 0) return false;
        if (now.value < -now.error && last < 0) return true;
        if (std::fabs(now.value) <= now.error || !(std::fabs(change.value) > 4 * change.error)) return open = true;
        const TimeRange crossed = crossing(now, change);
        if (now.value > 0) {
            if (crossed.low > latest) return false;
            if (last >= 0) open = true;
            const double t = now.value / -change.value;
            if (t > first) {
                first = t;
                answer.found.facet = facet;
            }
            if (crossed.low > enters.low) enters.low = crossed.low;
            if (crossed.high > enters.high) enters.high = crossed.high;
        } else {
            if (crossed.low < leaves.low) leaves.low = crossed.low;
            if (crossed.high < leaves.high) leaves.high = crossed.high;
        }
        return enters.low <= leaves.high;
    });
    if (!may_meet) {
        answer.kind = HullGuess::kMiss;
        return answer;
    }
    const double size = max_abs(sweep.start - pair.polygon().corners[0]) + pair.hull().reach;
    const bool sharp = (enters.high - enters.low) * sweep.direction_length <= kTimeError * size;
    if (open || first < 0 || !(enters.high < leaves.low)) return answer;
    answer.kind = sharp ? HullGuess::kHit : HullGuess::kBlurred;
    answer.earliest = enters.low;
    answer.found.contact = {Status::kHit, Feature::kFace, 0, first < sweep.end ? first : sweep.end};
    return answer;
}

DoubleDouble when_met(const HullAgainstPolygon& pair, const SumFacet& facet) {
    const HullAgainstPolygon::Precise precise = pair.precisely(facet);
    return -precise.outside / precise.change;
}

HullContact met_at(const HullAgainstPolygon& pair, const SumFacet& facet, const DoubleDouble& entry) {
    const double t = rounded(entry), end = pair.sweep().end;
    HullContact met{{}, facet};
    met.contact.t = t < 0 ? 0 : t > end ? end : t;
    met.contact.status = met.contact.t > 0 ? Status::kHit : Status::kInitialOverlap;
    return met;
}

/// The time of a sure hit by the facets that may be entered last.
HullContact sharpened(const HullAgainstPolygon& pair, double earliest) {
    SumFacet last;
    DoubleDouble entry;
    bool any = false;
    pair.each_facet([&](const SumFacet& facet) {
        const Estimate now = pair.outside(facet);
        if (!(now.value > 0) || crossing(now, pair.change(facet)).high < earliest) return true;
        const DoubleDouble t = when_met(pair, facet);
        if (!any || entry < t) {
            entry = t;
            last = facet;
        }
        return any = true;
    });
    return met_at(pair, last, entry);
}

/// Equal depths to rounding in double-double count as equal.
bool as_deep(const DoubleDouble& a, const DoubleDouble& b) {
    const DoubleDouble rest = a - b;
    return std::fabs(rest.high) <= 64 * kDoubleDoubleRoundoff * (std::fabs(a.high) + std::fabs(b.high));
}

/// The hull overlaps the polygon. The shortest way out leads through the nearest facets; the overlap gets deeper when
/// the path leads away from all of them. The polygon's own plane, on the side that the path comes from, comes first: so
/// a hull whose middle lies in it is stopped.
HullContact in_overlap(const HullAgainstPolygon& pair) {
    HullContact nearest;
    DoubleDouble least;
    bool any = false, deeper = false, by_plane = false;
    pair.each_facet([&](const SumFacet& facet) {
        const HullAgainstPolygon::Precise precise = pair.precisely(facet);
        const DoubleDouble depth = -precise.outside / precise.length;
        const bool against = pair.change_exactly(facet) < 0;
        if (any && as_deep(depth, least)) {
            deeper = deeper && against;
            return true;
        }
        if (any && least < depth) return true;
        least = depth;
        any = true;
        deeper = against;
        by_plane = against && facet.kind() == SumFacet::kPlane;
        nearest.facet = facet;
        return true;
    });
    if (!by_plane && nearest.facet.kind() == SumFacet::kPlane) {  // both sides of the plane may be as near
        pair.each_facet([&](const SumFacet& facet) {
            if (facet.kind() != SumFacet::kPlane) return false;
            const HullAgainstPolygon::Precise precise = pair.precisely(facet);
            if (pair.change_exactly(facet) < 0 && as_deep(-precise.outside / precise.length, least)) {
                by_plane = true;
                nearest.facet = facet;
            }
            return true;
        });
    }
    if (deeper || by_plane) nearest.contact.status = Status::kInitialOverlap;
    return nearest;
}

HullContact decide(const HullAgainstPolygon& pair, int facing) {
    const Sweep& sweep = pair.sweep();
    HullContact first;
    DoubleDouble latest_entry;
    bool apart = false, touches = false, deeper = true;
    SumFacet touched;
    const bool may_meet = pair.each_facet([&](const SumFacet& facet) {
        const int now = pair.outside_exactly(facet, 0);
        if (now > 0) {
            if (pair.outside_exactly(facet, sweep.end) > 0) return false;
            const HullAgainstPolygon::Precise precise = pair.precisely(facet);
            const DoubleDouble t = -precise.outside / precise.change;
            if (!apart || latest_entry < t) {
                latest_entry = t;
                first.facet = facet;
            }
            apart = true;
        } else if (now == 0) {
            const bool against = pair.change_exactly(facet) < 0;
            if (against && !touches) touched = facet;
            touches = touches || against;
            deeper = deeper && against;
        }
        return true;
    });
    if (!may_meet) return {};
    if (!apart) {
        if (!deeper) return {};
        if (!touches) return in_overlap(pair);
        return {{Status::kInitialOverlap, Feature::kFace, 0, 0}, touched};
    }
    if (!pair.line_meets(facing)) return {};
    return met_at(pair, first.facet, latest_entry);
}

}  // namespace

HullContact cast_hull_polygon(const Sweep& sweep, const HullShape& hull, const PolygonShape& polygon, Sides sides,
                              double latest, CastCounts* counts) {
    const int facing = exact_facing(sweep.direction, polygon);
    if (facing >= 0 && sides == Sides::kFront) return {};
    const HullAgainstPolygon pair(sweep, hull, polygon);
    const HullGlance seen = glance(pair, facing, latest);
    if (seen.kind == HullGlance::kBeside) return {};
    if (seen.kind == HullGlance::kOnIt) return {{Status::kHit, Feature::kFace, 0, seen.t}, pair.facet(seen.by)};
    if (seen.kind == HullGlance::kBlurred) {
        if (counts) ++counts->precise;
        const SumFacet facet = pair.facet(seen.by);
        return met_at(pair, facet, when_met(pair, facet));
    }
    const HullGuess guessed = guess(pair, latest);
    if (guessed.kind == HullGuess::kMiss) return {};
    if (guessed.kind == HullGuess::kHit) return guessed.found;
    if (counts) ++counts->precise;
    if (guessed.kind == HullGuess::kBlurred) return sharpened(pair, guessed.earliest);
    return decide(pair, facing);
}

bool hull_meets(const HullAgainstPolygon& pair) {
    return pair.each_facet([&](const SumFacet& facet) {
        const int sign = pair.outside(facet).sign();
        return sign < 0 || (sign == 0 && pair.outside_exactly(facet, 0) <= 0);
    });
}

SumFacet nearest_facet(const HullAgainstPolygon& pair) {
    SumFacet nearest;
    double least = 0;
    bool any = false;
    pair.each_facet([&](const SumFacet& facet) {
        const double depth = -pair.outside(facet).value / length(facet.direction);
        if (any && !(depth < least)) return true;
        least = depth;
        nearest = facet;
        return any = true;
    });
    return nearest;
}

}  // namespace firma
