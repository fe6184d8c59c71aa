// SPDX-License-Identifier: MIT
// The way of a sweep through an index, nearest boxes first; compiled once for each kind of processor.
#include <hwy/highway.h>

#include <bit>
#include <cstddef>
#include <cstdint>

#include "base/assert.h"
#include "index/node.h"
#include "world/lane_boxes.h"
#include "world/lane_planes.h"
#include "world/lane_triangles.h"
#include "world/sweep_lanes.h"

#if defined(FIRMA_LANE_WALK_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRMA_LANE_WALK_H
#undef FIRMA_LANE_WALK_H
#else
#define FIRMA_LANE_WALK_H
#endif

HWY_BEFORE_NAMESPACE();
namespace firma::HWY_NAMESPACE {

/// Rounded up.
HWY_INLINE float to_float(double latest) {
    return float(latest) * (1 + 4 * kRoundoff);
}

HWY_INLINE std::uint32_t first_bit(unsigned bits) {
    return std::uint32_t(__builtin_ctz(bits));
}
HWY_INLINE std::uint32_t last_bit(unsigned bits) {
    return 31 ^ std::uint32_t(__builtin_clz(bits));
}

/// What will be looked at: as many lines of a cache as a node has, and of faces, which have one less, the first one
/// twice. Without a branch: which of both it is cannot be foreseen.
HWY_INLINE void fetch(std::uintptr_t below) {
    constexpr std::uintptr_t kLast = sizeof(WideNode) - 64;
    for (std::uintptr_t at = 0; at < kLast; at += 64) __builtin_prefetch(reinterpret_cast<const void*>(below + at));
    const std::uintptr_t last = kLast & ((below & WideNode::kFacets) - 1);
    __builtin_prefetch(reinterpret_cast<const void*>(below + last));
}

/// Takes the lane of the least time out of those left.
template <class Time>
HWY_INLINE std::uint32_t take_first(unsigned& left, const Time* times) {
    std::uint32_t lane = first_bit(left);
    for (unsigned rest = left & (left - 1); rest; rest &= rest - 1)
        if (const std::uint32_t other = first_bit(rest); times[other] < times[lane]) lane = other;
    left &= ~(1u << lane);
    return lane;
}

/// The lane of the least time; of several the first.
HWY_INLINE std::uint32_t earliest(unsigned lanes, const double* times) {
    const unsigned others = lanes & (lanes - 1);
    if (others == 0) return first_bit(lanes);
    if ((others & (others - 1)) == 0) {
        const std::uint32_t one = first_bit(lanes), other = last_bit(lanes);
        return times[other] < times[one] ? other : one;
    }
#if HWY_TARGET == HWY_WASM
    return take_first(lanes, times);
#else
    const auto of = [&](std::uint32_t part) HWY_ATTR {
        const std::uint8_t bytes[8] = {std::uint8_t(lanes >> part)};
        return hn::IfThenElse(hn::LoadMaskBits(kDoubles, bytes), hn::Load(kDoubles, times + part), hn::Inf(kDoubles));
    };
    Doubles least = of(0);
    for (std::uint32_t part = kDoublesAtOnce; part < kLanes; part += kDoublesAtOnce) least = hn::Min(least, of(part));
    least = hn::MinOfLanes(kDoubles, least);
    unsigned found = 0;
    for (std::uint32_t part = 0; part < kLanes; part += kDoublesAtOnce)
        found |= (~bits_of(greater(hn::Load(kDoubles, times + part), least)) & ((1u << kDoublesAtOnce) - 1)) << part;
    return first_bit(found & lanes);
#endif
}

/// Looks at triangles whose planes a particle crosses, and takes these out of those left; true when that ends the
/// sweep. They are whole, so none is a part of another's facet.
HWY_INLINE bool look_through_planes(const FaceLanes& lanes, LaneQuery& query, const Triangles& found, unsigned& left) {
    Crossings known;
    cross_planes(lanes, query, left & lanes.whole, known);
    unsigned crossed = left & lanes.whole & known.crossed;
    left &= ~(lanes.whole & (known.crossed | known.never));
    unsigned inside = found.clear[0] & found.clear[1] & found.clear[2];
#if HWY_TARGET != HWY_WASM
    // Where the line runs through an edge, it does so at the faces beside it, too: double will not tell.
    if (const unsigned open = crossed & ~inside; open && !query.through_edge) {
        const Passes passes = pass_edges(lanes, query, open, known);
        inside |= passes.inside & open;
        const unsigned outside = passes.outside & open;
        if (query.counts) query.counts->faces += unsigned(__builtin_popcount(outside));  // as where each is asked
        crossed &= ~outside;
    }
#endif
    while (crossed) {
        const std::uint32_t lane = earliest(crossed, known.at);
        if (known.at[lane] > query.latest) break;
        crossed &= ~(1u << lane);
        const unsigned clear =
            (found.clear[0] >> lane & 1) | (found.clear[1] >> lane & 1) << 1 | (found.clear[2] >> lane & 1) << 2;
        query.crossing.t = known.at[lane];
        query.crossing.known = true;
        query.crossing.away = (known.away >> lane & 1) != 0;
        query.crossing.open = inside >> lane & 1 ? 0 : std::uint8_t(7 ^ clear);
#if HWY_TARGET != HWY_WASM
        query.crossing.normal = {known.normal[0][lane], known.normal[1][lane], known.normal[2][lane]};
#endif
        if (query.look(query, lanes, lane)) return true;
        if (query.earliest_only && query.met) break;  // the others come later, or at that time and have higher ids
    }
    query.crossing.known = false;
    return false;
}

/// Looks at facets side by side; true when that ends the sweep.
HWY_INLINE bool look_at(const FaceLanes* lanes, const Way& way, float enter, LaneQuery& query, float& latest) {
    std::uint64_t looked_at = 0;  // facets of the block: one may be in several lanes
    alignas(64) float times[kLanes];
    for (;; lanes += lanes->in_a_row()) {
        if (query.counts) query.counts->boxes += lanes->count();
        const Triangles found = look_at_triangles(*lanes, query, way, enter, latest, times);
        unsigned left = found.met;
        if (left && query.sweep.particle) {
            if (look_through_planes(*lanes, query, found, left)) return true;
            latest = to_float(query.latest);
        }
        while (left) {  // by rising bound
            const std::uint32_t lane = take_first(left, times);
            if (times[lane] > latest) break;
            const std::uint64_t bit = std::uint64_t(1) << lanes->slot(lane);
            if (looked_at & bit) continue;
            looked_at |= bit;
            if (query.look(query, *lanes, lane)) return true;
            latest = to_float(query.latest);
        }
        if (!lanes->more_follow()) return false;
    }
}

/// Times, which are not below 0, in the order of their bits: so a processor need not branch.
HWY_INLINE std::uint32_t order_of(const float& time) {
    return std::bit_cast<std::uint32_t>(time);
}

HWY_INLINE LaneWaiting child_of(const WideNode& node, std::uint32_t lane, const float* times) {
    return {node.below[lane], times[lane]};
}

/// Puts boxes of a node where they wait, the farthest deepest. Without branches that go by their times: these cannot be
/// foreseen.
/// @param met    a bit for each
/// @param count  how many these are
HWY_INLINE void put_in_order(const WideNode& node, unsigned met, unsigned count, const float* times,
                             LaneWaiting* waiting) {
    for (unsigned left = met; left; left &= left - 1) {
        const std::uint32_t lane = first_bit(left);
        const Floats time = all(times[lane]);
        unsigned nearer = 0;
        for (std::uint32_t part = 0; part < kLanes; part += kAtOnce) {
            const Floats other = hn::Load(kFloats, times + part);
            nearer |= bits(hn::Lt(other, time)) << part | ((bits(hn::Le(other, time)) << part) & ((1u << lane) - 1));
        }
        const LaneWaiting child = child_of(node, lane, times);
        fetch(child.below);
        waiting[count - 1 - unsigned(__builtin_popcount(nearer & met))] = child;
    }
}

HWY_INLINE std::uint32_t boxes_in_use(const WideNode& node) {
    std::uint32_t count = 0;
    for (const std::uintptr_t below : node.below) count += below != 0;
    return count;
}

/// A sweep on its way through an index.
class Walk {
public:
    HWY_INLINE Walk(const Node& root, LaneQuery& query)
        : query_(&query),
          now_{reinterpret_cast<std::uintptr_t>(root.wide.data()), 0},
          latest_(to_float(query.latest)),
          way_(query.sweep) {}

    /// Looks into one node, or at the faces below one lane.
    /// @param waiting  what is to be looked into later, kMostWaiting; the same each time
    /// @return whether there is more
    HWY_INLINE bool step(LaneWaiting* waiting) {
        if (now_.below & WideNode::kFacets) {
            const auto* const lanes = reinterpret_cast<const FaceLanes*>(now_.below - WideNode::kFacets);
            if (look_at(lanes, way_, now_.time, *query_, latest_)) {
                ended = true;
                return false;
            }
        } else if (look_into(*reinterpret_cast<const WideNode*>(now_.below), waiting)) {
            return true;
        }
        do {
            if (count_ == 0) return false;
            now_ = waiting[--count_];
        } while (now_.time > latest_);
        return true;
    }

    bool ended = false;  ///< whether a look ended the sweep

private:
    /// Goes on with the nearest of a node's boxes; false where none is met.
    HWY_INLINE bool look_into(const WideNode& node, LaneWaiting* waiting) {
        if (query_->counts) query_->counts->nodes += boxes_in_use(node);
        alignas(64) float times[kLanes];
        const unsigned met = enter(node, way_, latest_, times);
        if (met == 0) return false;
        const unsigned others = met & (met - 1);
        FIRMA_ASSERT(count_ + kLanes <= kMostWaiting, "an index is deeper than any that is built");
        if ((others & (others - 1)) == 0) {
            // One or two: both cases go the same way.
            const std::uint32_t one = first_bit(met), other = last_bit(met);
            const std::uint32_t swap = 0u - std::uint32_t(order_of(times[other]) < order_of(times[one]));
            const std::uint32_t apart = one ^ other, near = one ^ (apart & swap);
            now_ = child_of(node, near, times);
            fetch(now_.below);
            const LaneWaiting next = child_of(node, near ^ apart, times);
            fetch(next.below);
            waiting[count_] = next;
            count_ += others != 0;
        } else {
            const auto more = unsigned(__builtin_popcount(met));
            put_in_order(node, met, more, times, waiting + count_);
            count_ += more;
            now_ = waiting[--count_];
        }
        return true;
    }

    LaneQuery* query_;
    LaneWaiting now_;
    std::size_t count_ = 0;
    float latest_;
    Way way_;
};

bool sweep_lanes(const Node& root, LaneQuery& query) {
    LaneWaiting waiting[kMostWaiting];
    Walk walk(root, query);
    while (walk.step(waiting)) {
    }
    return walk.ended;
}

#if HWY_TARGET != HWY_WASM  // the module has to be small
/// Room for a sweep.
union Place {
    Place() {}
    Walk walk;
};

void sweep_lanes_together(LaneSource& source) {
    Place places[LaneSource::kPlaces];
    std::uint32_t busy[LaneSource::kPlaces], count = 0;
    const auto begin = [&](std::uint32_t place, bool ended) HWY_ATTR {
        const LaneSource::Next next = source.next(place, ended);
        if (next.index) new (&places[place].walk) Walk(*next.index, *next.query);
        return next.index != nullptr;
    };
    for (std::uint32_t place = 0; place < source.places; ++place)
        if (begin(place, false)) busy[count++] = place;
    while (count > 0)
        for (std::uint32_t k = 0; k < count; ++k) {
            const std::uint32_t place = busy[k];
            Walk& walk = places[place].walk;
            if (!walk.step(source.waiting[place]) && !begin(place, walk.ended)) busy[k--] = busy[--count];
        }
}
#endif

}  // namespace firma::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
