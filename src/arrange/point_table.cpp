// SPDX-License-Identifier: MIT
// All points where planes of a level meet, each once.
#include "arrange/point_table.h"

#include <algorithm>

#include "base/assert.h"

namespace firma {
namespace {

constexpr int kPlaneBits = 21;  // three numbers of planes in one key

}  // namespace

std::uint32_t PointTable::add(PlaneId a, PlaneId b, PlaneId c) {
    PlaneId three[3] = {a & ~1u, b & ~1u, c & ~1u};
    std::sort(three, three + 3);
    FIRMA_ASSERT(three[2] >> 1 < 1u << kPlaneBits, "a level of more planes is refused before");
    const std::uint64_t key =
        std::uint64_t(three[0] >> 1) << 2 * kPlaneBits | std::uint64_t(three[1] >> 1) << kPlaneBits | three[2] >> 1;
    const std::uint32_t known = of_planes_.find(key);
    if (known != FlatMap::kNone) return known;
    const Plane *p = &planes_.plane(three[0]), *q = &planes_.plane(three[1]), *r = &planes_.plane(three[2]);
    if (!meet_in_world(*p, *q, *r)) return kNone;
    Entry entry{ExactPoint(*p, *q, *r), {three[0], three[1], three[2]}};
    const GridPoint near = entry.point.rounded();
    if (on_input_grid(near)) {
        const ExactPoint grid(to_input(near));
        if (exact_side(*p, grid) == 0 && exact_side(*q, grid) == 0 && exact_side(*r, grid) == 0) entry.point = grid;
    }
    const std::uint32_t index = find_or_add(entry);
    of_planes_.at(key) = index;
    return index;
}

std::uint32_t PointTable::add(const InputPoint& grid) {
    return find_or_add({ExactPoint(grid), {kNoPlane, kNoPlane, kNoPlane}});
}

/// Equal points round to the same place; what lies there is compared exactly.
std::uint32_t PointTable::find_or_add(const Entry& entry) {
    for (std::uint64_t key = point_key(entry.point.rounded());; key = next_key(key)) {
        std::uint32_t& known = of_place_.at(key);
        if (known == FlatMap::kNone) {
            known = std::uint32_t(points_.size());
            points_.push_back(entry);
            return known;
        }
        if (same(points_[known], entry)) return known;
    }
}

bool PointTable::same(const Entry& a, const Entry& b) const {
    if (a.point.on_grid() != b.point.on_grid()) return false;
    if (a.point.on_grid()) return a.point.grid() == b.point.grid();
    if (a.point.rounded() != b.point.rounded()) return false;
    for (const PlaneId plane : b.planes)
        if (exact_side(planes_.plane(plane), a.point) != 0) return false;
    return true;
}

int PointTable::side(PlaneId plane, std::uint32_t index) const {
    const Entry& entry = points_[index];
    for (const PlaneId own : entry.planes)
        if (own != kNoPlane && same_plane(own, plane)) return 0;
    return exact_side(planes_.plane(plane), entry.point);
}

}  // namespace firma
