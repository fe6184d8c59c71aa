// SPDX-License-Identifier: MIT
// Joins triangles: islands by topology, then the one question of geometry that this leaves.
#include "level/join_triangles.h"

#include "geometry/judge_outline.h"
#include "level/divide_polygon.h"
#include "level/find_islands.h"

namespace firma {
namespace {

__extension__ using Wide = __int128;
using Judge = OutlineJudge<std::int64_t, Wide, std::span<const GridPoint>>;

// Whether the corners inside lie on the plane of the outline, which has one.
bool exactly_flat(const Island& island, std::span<const GridPoint> points) {
    std::vector<GridPoint> outline;
    for (const std::uint32_t corner : island.outline) outline.push_back(points[corner]);
    const Judge judge(outline);
    const OutlineForm form = judge.form();
    if (!judge.has_normal() || form == OutlineForm::kNotPlanar) return false;
    for (const std::uint32_t corner : island.inner) {
        Wide off = 0;
        for (int axis = 0; axis < 3; ++axis) {
            off += judge.normal()[std::size_t(axis)] * (std::int64_t(points[corner][axis]) - outline[0][axis]);
        }
        if (off != 0) return false;
    }
    return true;
}

bool has_one_outline(const Island& island, std::span<const GridPoint> points) {
    if (island.outline.empty() || island.outline.size() > kMaxOutlineCorners) return false;
    return island.inner.empty() || exactly_flat(island, points);
}

}  // namespace

std::vector<std::vector<std::uint32_t>> join_triangles(std::span<const std::uint32_t> triangles,
                                                       std::span<const GridPoint> points) {
    std::vector<std::vector<std::uint32_t>> polygons;
    for (Island& island : find_islands(triangles)) {
        if (has_one_outline(island, points)) {
            polygons.push_back(std::move(island.outline));
            continue;
        }
        for (auto corner = island.triangles.begin(); corner != island.triangles.end(); corner += 3) {
            polygons.emplace_back(corner, corner + 3);
        }
    }
    return polygons;
}

}  // namespace firma
