// SPDX-License-Identifier: MIT
// The way of a sweep through an index, nearest boxes first; compiled once for each kind of processor.
#include <hwy/highway.h>

#include <utility>

#include "base/assert.h"
#include "index/node.h"
#include "world/lane_boxes.h"
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

/// What will be looked at. Without a branch: which of both it is cannot be foreseen.
HWY_INLINE void fetch(const void* child, bool faces) {
    const auto* const from = static_cast<const char*>(child);
    const std::size_t last = faces ? sizeof(FaceLanes) - 1 : sizeof(WideNode) - 1;
    for (std::size_t at = 0; at < sizeof(FaceLanes); at += 64) __builtin_prefetch(from + (at < last ? at : last));
}

/// Looks at facets side by side; true when that ends the sweep.
HWY_INLINE bool look_at(const FaceLanes* first, std::uint32_t count, float enter, LaneQuery& query, float& latest) {
    std::uint64_t looked_at = 0;  // facets of the block: one may be in several lanes
    alignas(64) float times[kLanes];
    for (const FaceLanes* lanes = first; lanes != first + count; lanes += lanes->in_a_row()) {
        query.counts.boxes += lanes->count();
        unsigned met = look_at_triangles(*lanes, query, enter, latest, times);
        while (met) {  // by rising bound
            std::uint32_t lane = first_bit(met);
            for (unsigned rest = met & (met - 1); rest; rest &= rest - 1)
                if (const std::uint32_t other = first_bit(rest); times[other] < times[lane]) lane = other;
            met &= ~(1u << lane);
            if (times[lane] > latest) break;
            const std::uint64_t bit = std::uint64_t(1) << lanes->slot(lane);
            if (looked_at & bit) continue;
            looked_at |= bit;
            if (query.look(query, *lanes, lane)) return true;
            latest = to_float(query.latest);
        }
    }
    return false;
}

bool sweep_lanes(const Node& root, LaneQuery& query) {
    if (!query.sweep.ready) make_ready(query.sweep);
    struct Waiting {
        const void* child;
        std::uint32_t facets;
        float time;
    };
    constexpr std::size_t kMost = (kDeepestTree + 1) * (kLanes - 1) + 1;
    Waiting waiting[kMost];
    std::size_t count = 0;
    Waiting now{root.wide.data(), 0, 0};
    float latest = to_float(query.latest);
    alignas(64) float times[kLanes];
    const Way way(query.sweep);
    for (;;) {
        if (now.facets) {
            const auto* const lanes = static_cast<const FaceLanes*>(now.child);
            if (look_at(lanes, now.facets, now.time, query, latest)) return true;
        } else {
            const WideNode& node = *static_cast<const WideNode*>(now.child);
            query.counts.nodes += node.count;
            unsigned met = enter(node, way, latest, times);
            if (met) {
                std::uint32_t lane = first_bit(met);
                Waiting next{node.child[lane], node.facets[lane], times[lane]};
                fetch(next.child, next.facets > 0);
                const std::size_t base = count;
                // The nearest goes on, the others wait, the farthest deepest.
                for (met &= met - 1; met; met &= met - 1) {
                    lane = first_bit(met);
                    Waiting other{node.child[lane], node.facets[lane], times[lane]};
                    fetch(other.child, other.facets > 0);
                    if (other.time < next.time) std::swap(other, next);
                    FIRMA_ASSERT(count < kMost, "an index is deeper than any that is built");
                    std::size_t k = count++;
                    for (; k > base && waiting[k - 1].time < other.time; --k) waiting[k] = waiting[k - 1];
                    waiting[k] = other;
                }
                now = next;
                continue;
            }
        }
        do {
            if (count == 0) return false;
            now = waiting[--count];
        } while (now.time > latest);
    }
}

}  // namespace firma::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
