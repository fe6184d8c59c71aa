// SPDX-License-Identifier: MIT
// Seeded closed levels to be carved.
#include "scenes/cut_levels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "scenes/closed_meshes.h"

namespace firma::scenes {
namespace {

std::int64_t metres(double value) {
    return std::llround(value * double(kMetre));
}

Steps in_metres(double x, double y, double z) {
    return {metres(x), metres(y), metres(z)};
}

std::int64_t& part(Steps& s, int axis) {
    return axis == 0 ? s.x : axis == 1 ? s.y : s.z;
}

void add_plain_box(std::vector<GridPolygon>& faces, const Steps& low, const Steps& high, bool room, bool triangles,
                   std::int64_t step, Rng& rng) {
    PanelBox box{low, high};
    box.room = room;
    box.triangles = triangles;
    box.step = step;
    add_panel_box(faces, box, rng);
}

Steps random_size(Rng& rng, double least, double most) {
    const double x = rng.uniform(least, most), y = rng.uniform(least, most), z = rng.uniform(least, most);
    return in_metres(x, y, z);
}

}  // namespace

void add_panel_box(std::vector<GridPolygon>& faces, const PanelBox& box, Rng& rng) {
    using Cell = std::array<int, 3>;
    std::map<Cell, GridPoint> corners;
    const auto corner = [&](const Cell& at) {
        const auto [entry, is_new] = corners.try_emplace(at);
        if (!is_new) return entry->second;
        Steps p;
        int on_sides = 0, side = 0;
        for (int axis = 0; axis < 3; ++axis) {
            Steps low = box.low, high = box.high;
            const std::int64_t a = part(low, axis), b = part(high, axis);
            const int k = at[std::size_t(axis)], n = box.count[axis];
            part(p, axis) = a + (b - a) * k / n;
            if (k == 0 || k == n) {
                ++on_sides;
                side = axis;
            }
        }
        if (box.bump > 0 && on_sides == 1) part(p, side) += metres(rng.uniform(-box.bump, box.bump));
        return entry->second = in_world(p, box.step);
    };
    const auto add_panel = [&](int axis, int side, int i, int k) {
        const std::size_t u = std::size_t((axis + 1) % 3), v = std::size_t((axis + 2) % 3);
        Cell at{};
        at[std::size_t(axis)] = side ? box.count[axis] : 0;
        at[u] = i;
        at[v] = k;
        Cell b = at, c = at, d = at;
        ++b[u], ++c[u], ++c[v], ++d[v];
        GridPoint p[4] = {corner(at), corner(b), corner(c), corner(d)};  // seen from beyond side 1 counter-clockwise
        if ((side == 1) == box.room) std::swap(p[1], p[3]);
        if (!box.triangles) return faces.push_back({p[0], p[1], p[2], p[3]});
        const int turn = int(rng.below(2));
        faces.push_back({p[turn], p[1 + turn], p[2 + turn]});
        faces.push_back({p[turn], p[2 + turn], p[(3 + turn) % 4]});
    };
    for (int axis = 0; axis < 3; ++axis)
        for (int side = 0; side < 2; ++side)
            for (int i = 0; i < box.count[(axis + 1) % 3]; ++i)
                for (int k = 0; k < box.count[(axis + 2) % 3]; ++k) add_panel(axis, side, i, k);
}

CutLevel bumpy_rooms(Rng& rng, int rooms, int panels, const Steps& place, std::int64_t step) {
    constexpr double kRoom = 12, kHeight = 6, kSpacing = 13.5, kHull = 8;
    CutLevel level;
    level.size = kHeight;
    const double width = rooms * kSpacing;
    add_plain_box(level.faces, place + in_metres(-kHull, -kHull, -kHull),
                  place + in_metres(width + kHull, width + kHull, kHeight + kHull), false, true, step, rng);
    for (int a = 0; a < rooms; ++a)
        for (int b = 0; b < rooms; ++b) {
            PanelBox room{place + in_metres(a * kSpacing, b * kSpacing, 0),
                          place + in_metres(a * kSpacing + kRoom, b * kSpacing + kRoom, kHeight)};
            for (int axis = 0; axis < 3; ++axis) room.count[axis] = axis == 2 ? std::max(panels / 2, 1) : panels;
            room.bump = 0.12;
            room.step = step;
            room.room = true;
            add_panel_box(level.faces, room, rng);
        }
    return level;
}

CutLevel room_with_pillars(Rng& rng, const Steps& place, std::int64_t step) {
    CutLevel level;
    level.size = 4;
    const bool triangles = rng.chance(0.5);
    add_plain_box(level.faces, place + in_metres(-6, -6, -2), place + in_metres(6, 6, 2), true, triangles, step, rng);
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) {
            if (rng.chance(0.4)) continue;
            const Steps size = random_size(rng, 0.125, 1.5);
            const Steps low = place + in_metres(-4.5 + 3 * i, -4.5 + 3 * k, -1) + random_steps(rng, kMetre / 4);
            add_plain_box(level.faces, low, low + size, false, triangles, step, rng);
        }
    return level;
}

CutLevel block_with_cavities(Rng& rng, const Steps& place, std::int64_t step) {
    CutLevel level;
    level.size = 4;
    const bool triangles = rng.chance(0.5);
    add_plain_box(level.faces, place + in_metres(-6, -6, -2), place + in_metres(6, 6, 2), false, triangles, step, rng);
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) {
            if (rng.chance(0.3)) continue;
            const Steps size = random_size(rng, 0.125, 1.75);
            const Steps low = place + in_metres(-4.5 + 3 * i, -4.5 + 3 * k, -1) + random_steps(rng, kMetre / 4);
            add_plain_box(level.faces, low, low + size, true, triangles, step, rng);
        }
    return level;
}

CutLevel thin_wall(Rng& rng, const Steps& place) {
    CutLevel level;
    level.size = 3;
    const bool triangles = rng.chance(0.5);
    const std::int64_t gap =
        kInput * (rng.chance(0.5) ? 1 + std::int64_t(rng.below(4)) : 1 + std::int64_t(rng.below(200)));
    const Steps size = random_size(rng, 2, 4);
    PanelBox left{place, place + size}, right{place, place + size};
    part(right.low, 0) += size.x + gap;
    part(right.high, 0) += size.x + gap;
    for (PanelBox* box : {&left, &right}) {
        box->room = true;
        box->triangles = triangles;
        if (triangles && rng.chance(0.5)) box->count[1] = box->count[2] = 3;
        add_panel_box(level.faces, *box, rng);
    }
    return level;
}

CutLevel large_room(Rng& rng, const Steps& place) {
    CutLevel level;
    level.size = 8;
    const Steps size = random_size(rng, 20, 300);
    const bool triangles = rng.chance(0.5);
    add_plain_box(level.faces, place, place + size, true, triangles, kInput, rng);
    const Steps pillar = place + Steps{size.x / 3, size.y / 3, size.z / 3};  // itself of large faces
    add_plain_box(level.faces, pillar, pillar + Steps{size.x / 4, size.y / 3, size.z / 2}, false, !triangles, kInput,
                  rng);
    return level;
}

CutLevel any_closed_mesh(Rng& rng) {
    const auto kind = MeshKind(rng.below(kMeshKinds - 1));
    static_assert(int(MeshKind::kTurnedBox) == kMeshKinds - 1, "whose corners lie off the input grid");
    ClosedMesh mesh = make_closed_mesh(kind, rng);
    CutLevel level;
    level.faces = std::move(mesh.faces);
    level.size = std::max(mesh.free_radius * 2, mesh.size / 8);
    if (rng.chance(0.5))
        for (GridPolygon& face : level.faces) face = turned_over(face);
    return level;
}

}  // namespace firma::scenes
