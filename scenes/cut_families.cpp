// SPDX-License-Identifier: MIT
// Levels with cuts to be made in them.
#include "scenes/cut_families.h"

#include <algorithm>
#include <cmath>

namespace firma::scenes {
namespace {

constexpr int kCuts = 24;

/// A point of a random face, and which way its front looks.
struct Spot {
    Vec3 point, normal;
};

Spot spot_on(const Level& level, Rng& rng) {
    const LevelFace& face = level.faces[rng.below(std::uint32_t(level.faces.size()))];
    const auto corner = [&](std::uint32_t k) {
        return firma::to_metres(level.vertices[level.corners[face.first_corner + k]]);
    };
    const std::uint32_t k = 2 + rng.below(face.corner_count - 2);
    const Vec3 a = corner(0), b = corner(k - 1), c = corner(k);
    double u = rng.uniform();
    double v = rng.uniform();
    if (u + v > 1) {
        u = 1 - u;
        v = 1 - v;
    }
    const Vec3 n = cross(b - a, c - a);
    return {a + (b - a) * u + (c - a) * v, length(n) > 0 ? n * (1 / length(n)) : Vec3{0, 0, 1}};
}

Vec3 rounded(const Vec3& p, double step) {
    Vec3 result;
    for (int axis = 0; axis < 3; ++axis) result[axis] = std::round(p[axis] / step) * step;
    return result;
}

Quaternion any_turn(Rng& rng) {
    if (rng.chance(0.2)) return {0, 0, 0, 1};
    return random_turn(rng.next());
}

/// A crater somewhere on the walls, in the rock, the air, or both.
CutOrder crater_at(const Spot& spot, double radius, Rng& rng) {
    CutOrder order;
    order.cutter = rng.chance(0.5) ? make_crater(CutterShape::kRocky, rng.next()) : any_cutter(rng);
    const double in = rng.uniform(-0.9, 0.9);
    order.pose.position = spot.point - spot.normal * (radius * in);
    order.pose.rotation = any_turn(rng);
    order.pose.scale = radius;
    order.kind = rng.chance(0.2) ? CarveKind::kFill : CarveKind::kCarve;
    return order;
}

void set_level(CutCase& it, const CutLevel& made) {
    it.level = level_of(made.faces);
}

void spread_cuts(CutCase& it, double size, Rng& rng, int count = kCuts) {
    for (int k = 0; k < count; ++k) {
        const Spot spot = spot_on(it.level, rng);
        const double radius = size * rng.uniform(0.08, 0.4);
        it.cuts.push_back(crater_at(spot, radius, rng));
    }
}

void corner_cuts(CutCase& it, double size, Rng& rng) {
    const Vec3 corner = firma::to_metres(it.level.vertices[rng.below(std::uint32_t(it.level.vertices.size()))]);
    for (int k = 0; k < kCuts; ++k) {
        const Vec3 way = rng.direction();
        const double radius = size * rng.uniform(0.05, 0.25);
        it.cuts.push_back(crater_at({corner + way * (size * 0.2 * rng.uniform()), way}, radius, rng));
    }
}

/// Boxes and craters with all coordinates multiples of `step`, unturned: vertices on planes, edges that meet.
void snapped_cuts(CutCase& it, double size, double step, Rng& rng) {
    for (int k = 0; k < kCuts; ++k) {
        const Spot spot = spot_on(it.level, rng);
        CutOrder order;
        if (rng.chance(0.5)) {
            Vec3 half;
            for (int axis = 0; axis < 3; ++axis) half[axis] = step * (1 + rng.below(std::uint32_t(size / 4 / step)));
            order.cutter = box_cutter(half);
        } else {
            const double scale = size * rng.uniform(0.1, 0.4);
            order.cutter = snapped_cutter(any_cutter(rng), scale, step);
        }
        if (!order.cutter.valid()) continue;
        const Vec3 way = rng.direction();
        order.pose.position = rounded(spot.point + way * (size / 4 * rng.uniform()), step);
        order.kind = rng.chance(0.3) ? CarveKind::kFill : CarveKind::kCarve;
        it.cuts.push_back(order);
    }
}

void repeated_cuts(CutCase& it, double size, Rng& rng) {
    while (int(it.cuts.size()) < kCuts) {
        const Spot spot = spot_on(it.level, rng);
        const double radius = size * rng.uniform(0.1, 0.3);
        CutOrder order = crater_at(spot, radius, rng);
        for (int k = 0; k < 4; ++k) {
            it.cuts.push_back(order);
            if (rng.chance(0.5)) order.kind = order.kind == CarveKind::kCarve ? CarveKind::kFill : CarveKind::kCarve;
            if (rng.chance(0.4)) order.pose.position.x += rng.chance(0.5) ? 1 / kInputSteps : rng.uniform(-0.1, 0.1);
            if (rng.chance(0.2)) order.pose.scale *= rng.uniform(0.9, 1.2);
        }
    }
}

void huge_cuts(CutCase& it, double size, Rng& rng) {
    Box bounds;
    for (const GridPoint& p : it.level.vertices) bounds.add(firma::to_metres(p));
    const double all = length(bounds.high - bounds.low);
    for (int k = 0; k < 8; ++k) {
        const Spot spot = spot_on(it.level, rng);
        const bool whole = rng.chance(0.2);
        const double radius = whole ? all * rng.uniform(1, 1.5) : size * rng.uniform(0.5, 1.5);
        CutOrder order = crater_at(spot, radius, rng);
        if (whole) order.pose.position = (bounds.low + bounds.high) * 0.5;
        it.cuts.push_back(order);
        if (whole && rng.chance(0.7)) {  // bring something back
            order.kind = order.kind == CarveKind::kCarve ? CarveKind::kFill : CarveKind::kCarve;
            order.pose.scale *= rng.uniform(0.3, 0.9);
            it.cuts.push_back(order);
        }
        spread_cuts(it, size, rng, 1);
    }
}

void tiny_cuts(CutCase& it, Rng& rng) {
    const Spot spot = spot_on(it.level, rng);
    for (int k = 0; k < kCuts; ++k) {
        const int halvings = 3 + int(rng.below(8));
        const double radius = std::ldexp(rng.uniform(0.5, 1), -halvings);
        const Spot near{spot.point + rng.direction() * 0.02, spot.normal};
        it.cuts.push_back(crater_at(rng.chance(0.5) ? near : spot_on(it.level, rng), radius, rng));
    }
}

Steps anywhere(Rng& rng) {
    if (rng.chance(0.7)) return {};
    return random_steps(rng, 7500 * kMetre);
}

/// So that a hull that begins 8 m before this place and ends `size` m after it lies within `margin` of the rim, or on
/// it.
Steps at_rim(Rng& rng, double size, double margin) {
    Steps place;
    for (std::int64_t* part : {&place.x, &place.y, &place.z}) {
        const auto away = std::int64_t(rng.uniform(0, margin) * double(kMetre));
        const int which = int(rng.below(3));
        if (which == 0) *part = -8184 * kMetre + away;
        if (which == 1) *part = 8192 * kMetre - 64 - std::int64_t(size * double(kMetre)) - away;
    }
    return place;
}

void our_level_spread(Rng& rng, const Level& ours, CutCase& it) {
    it.level = ours;
    spread_cuts(it, 4, rng);
}
void our_level_corner(Rng& rng, const Level& ours, CutCase& it) {
    it.level = ours;
    corner_cuts(it, 4, rng);
}
void our_level_snapped(Rng& rng, const Level& ours, CutCase& it) {
    it.level = ours;
    snapped_cuts(it, 4, rng.chance(0.5) ? 0.125 : 0.0625, rng);
}
void rooms_spread(Rng& rng, const Level&, CutCase& it) {
    const int rooms = 1 + int(rng.below(2)), panels = 2 + int(rng.below(6));
    const Steps place = anywhere(rng);
    const CutLevel level = bumpy_rooms(rng, rooms, panels, place);
    set_level(it, level);
    spread_cuts(it, level.size, rng);
}
void rooms_corner(Rng& rng, const Level&, CutCase& it) {
    const int panels = 2 + int(rng.below(8));
    const Steps place = anywhere(rng);
    const CutLevel level = bumpy_rooms(rng, 1, panels, place);
    set_level(it, level);
    corner_cuts(it, level.size, rng);
}
void rooms_snapped(Rng& rng, const Level&, CutCase& it) {
    const bool coarse = rng.chance(0.5);
    const int panels = 2 + int(rng.below(6));
    const CutLevel level = bumpy_rooms(rng, 1, panels, {}, kMetre / (coarse ? 8 : 16));
    set_level(it, level);
    snapped_cuts(it, level.size, coarse ? 0.125 : 0.0625, rng);
}
void flush_boxes(Rng& rng, const Level&, CutCase& it) {
    const CutLevel level =
        rng.chance(0.5) ? room_with_pillars(rng, {}, kMetre / 8) : block_with_cavities(rng, {}, kMetre / 8);
    set_level(it, level);
    snapped_cuts(it, level.size, 0.125, rng);
}
void repeated(Rng& rng, const Level&, CutCase& it) {
    const Steps place = anywhere(rng);
    const CutLevel level = rng.chance(0.5) ? room_with_pillars(rng, place) : bumpy_rooms(rng, 1, 4, place);
    set_level(it, level);
    repeated_cuts(it, level.size, rng);
}
void huge(Rng& rng, const Level&, CutCase& it) {
    const Steps place = anywhere(rng);
    const int which = int(rng.below(3));
    const CutLevel level = which == 0   ? room_with_pillars(rng, place)
                           : which == 1 ? block_with_cavities(rng, place)
                                        : bumpy_rooms(rng, 2, 3, place);
    set_level(it, level);
    huge_cuts(it, level.size, rng);
}
void tiny(Rng& rng, const Level&, CutCase& it) {
    const Steps place = anywhere(rng);
    const CutLevel level = rng.chance(0.5) ? thin_wall(rng, place) : bumpy_rooms(rng, 1, 3, place);
    set_level(it, level);
    tiny_cuts(it, rng);
}
void rim(Rng& rng, const Level&, CutCase& it) {
    const Steps place = at_rim(rng, 22, rng.chance(0.5) ? 0 : 3);
    const CutLevel level = bumpy_rooms(rng, 1, 3, place);
    set_level(it, level);
    spread_cuts(it, level.size, rng);
}
void pillars(Rng& rng, const Level&, CutCase& it) {
    const Steps place = anywhere(rng);
    const CutLevel level = rng.chance(0.5) ? room_with_pillars(rng, place) : block_with_cavities(rng, place);
    set_level(it, level);
    spread_cuts(it, level.size, rng);
}
void thin_walls(Rng& rng, const Level&, CutCase& it) {
    const Steps place = anywhere(rng);
    const CutLevel level = thin_wall(rng, place);
    set_level(it, level);
    spread_cuts(it, level.size, rng);
}
void large_faces(Rng& rng, const Level&, CutCase& it) {
    const Steps place = anywhere(rng);
    const CutLevel level = large_room(rng, place);
    set_level(it, level);
    if (rng.chance(0.5))
        spread_cuts(it, level.size, rng);
    else
        corner_cuts(it, level.size, rng);
}
void closed_meshes(Rng& rng, const Level&, CutCase& it) {
    const CutLevel level = any_closed_mesh(rng);
    set_level(it, level);
    if (rng.chance(0.5))
        spread_cuts(it, level.size, rng);
    else
        huge_cuts(it, level.size, rng);
}
void filling(Rng& rng, const Level&, CutCase& it) {
    const Steps place = anywhere(rng);
    const CutLevel level = rng.chance(0.5) ? room_with_pillars(rng, place) : bumpy_rooms(rng, 1, 4, place);
    set_level(it, level);
    spread_cuts(it, level.size, rng);
    for (CutOrder& order : it.cuts)
        if (rng.chance(0.6)) order.kind = CarveKind::kFill;
}

/// Tetrahedra over a ring of squares: no point sees it whole.
Cutter ring_cutter(int around) {
    std::vector<Vec3> vertices;
    std::vector<CutterTriangle> triangles;
    const auto circle = [](int k, int count) {
        const double at = 4.0 * k / count, share = at - int(at);
        const Vec3 corner[5] = {{1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}, {1, 1, 0}};
        const Vec3 p = corner[int(at)] * (1 - share) + corner[int(at) + 1] * share;
        return p * (1 / length(p));
    };
    for (int i = 0; i < around; ++i)
        for (int k = 0; k < 4; ++k) {
            const Vec3 large = circle(i, around), small = circle(k, 4);
            const double radius = 1 + 0.35 * small.x;
            vertices.push_back({large.x * radius, large.y * radius, 0.35 * small.y});
            const auto at = [&](int a, int b) { return std::uint32_t(a % around * 4 + b % 4); };
            triangles.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
            triangles.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
        }
    return make_cutter(vertices, triangles, "ring").value();
}

/// One cutter and another one scaled and moved, in one mesh; turned over, the second is a cavity of the first.
Cutter both(const Cutter& one, const Cutter& other, double scale, const Vec3& move, bool turned) {
    std::vector<Vec3> vertices(one.vertices().begin(), one.vertices().end());
    std::vector<CutterTriangle> triangles(one.triangles().begin(), one.triangles().end());
    const auto first = std::uint32_t(vertices.size());
    for (const Vec3& v : other.vertices()) vertices.push_back(v * scale + move);
    for (const auto& [a, b, c] : other.triangles())
        triangles.push_back(turned ? CutterTriangle{a + first, c + first, b + first}
                                   : CutterTriangle{a + first, b + first, c + first});
    return make_cutter(vertices, triangles, "two shells").value();
}

}  // namespace

Cutter any_cutter(Rng& rng) {
    const auto shape = CutterShape(rng.below(5));
    const std::uint64_t seed = rng.next();
    const int which = int(rng.below(12));
    const Cutter cutter = make_crater(shape, seed);
    if (which == 0) return ring_cutter(6 + int(rng.below(10)));
    if (which == 1) return both(make_crater(CutterShape::kRocky, seed), make_crater(shape, seed + 1), 0.3, {}, true);
    if (which == 2)
        return both(make_crater(CutterShape::kRocky, seed), make_crater(CutterShape::kBox, 0), 0.5, {1.8, 0.3, 0.2},
                    false);
    return cutter;
}

Cutter snapped_cutter(const Cutter& cutter, double scale, double step) {
    std::vector<Vec3> vertices;
    for (const Vec3& v : cutter.vertices()) vertices.push_back(rounded(v * scale, step));
    Result<Cutter> made = make_cutter(vertices, cutter.triangles(), "snapped");
    return made ? std::move(made).value() : Cutter();
}

Cutter box_cutter(const Vec3& half) {
    const Cutter box = make_crater(CutterShape::kBox, 0);
    std::vector<Vec3> vertices;
    for (const Vec3& v : box.vertices()) vertices.push_back({v.x * half.x, v.y * half.y, v.z * half.z});
    return make_cutter(vertices, box.triangles(), "box").value();
}

const std::vector<CutFamily>& cut_families() {
    static const std::vector<CutFamily> families = {
        {"our_level_spread", our_level_spread},
        {"our_level_corner", our_level_corner},
        {"our_level_snapped", our_level_snapped},
        {"rooms_spread", rooms_spread},
        {"rooms_corner", rooms_corner},
        {"rooms_snapped", rooms_snapped},
        {"flush_boxes", flush_boxes},
        {"repeated", repeated},
        {"huge", huge},
        {"tiny", tiny},
        {"rim", rim},
        {"pillars", pillars},
        {"thin_walls", thin_walls},
        {"large_faces", large_faces},
        {"closed_meshes", closed_meshes},
        {"filling", filling},
    };
    return families;
}

CutCase make_cut_case(const CutFamily& family, std::uint64_t seed, std::uint64_t index, const Level& ours) {
    std::uint64_t name = 0xcbf29ce484222325ull;
    for (const char c : family.name) name = (name ^ std::uint64_t(c)) * 0x100000001b3ull;
    Rng rng(Rng(seed * 0x9E3779B97F4A7C15ull + index).next() ^ name);
    CutCase it;
    family.make(rng, ours, it);
    return it;
}

}  // namespace firma::scenes
