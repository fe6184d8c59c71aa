// SPDX-License-Identifier: MIT
// Half planes around a line in order of angle.
#include "geometry/around_edge.h"

#include "base/sort.h"

namespace firma {
namespace {

/// 0 at the angle of `zero`, 1 within half a turn from there, 2 opposite, 3 beyond.
std::uint8_t part_of(std::uint32_t plane, std::uint32_t zero, const SpokeAngles& angles) {
    if (plane == zero) return 0;
    const int turn = angles.turn(zero, plane);
    if (turn != 0) return turn > 0 ? 1 : 3;
    return angles.same_half(zero, plane) ? 0 : 2;
}

/// Sign of the turn from one to another, within a part.
int turn_between(const Spoke& a, const Spoke& b, const SpokeAngles& angles) {
    return a.plane == b.plane ? 0 : angles.turn(a.plane, b.plane);
}

}  // namespace

bool sort_spokes(std::span<Spoke> spokes, const SpokeAngles& angles) {
    const std::uint32_t zero = spokes[0].plane;
    for (Spoke& spoke : spokes) spoke.part = part_of(spoke.plane, zero, angles);
    sort_range(spokes, [&](const Spoke& a, const Spoke& b) {
        if (a.part != b.part) return a.part < b.part;
        const int turn = turn_between(a, b, angles);
        return turn != 0 ? turn > 0 : a.owner < b.owner;
    });
    for (std::size_t k = 0; k < spokes.size(); ++k) {
        const Spoke &here = spokes[k], &next = spokes[k + 1 < spokes.size() ? k + 1 : 0];
        if (here.air_after != next.air_before) return false;
        if (&here != &next && here.part == next.part && turn_between(here, next, angles) == 0) return false;
    }
    return true;
}

}  // namespace firma
