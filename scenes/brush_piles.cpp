// SPDX-License-Identifier: MIT
// Random levels of brushes, made to be hard to join.
#include "scenes/brush_piles.h"

#include <algorithm>
#include <array>
#include <random>

#include "firma/level.h"

namespace firma::scenes {
namespace {

constexpr std::int32_t kInputMetre = 4096;  // input steps

struct Point {
    std::int32_t at[3];
};

GridPoint surface(const Point& p) {
    return {p.at[0] * kSurfacePerInput, p.at[1] * kSurfacePerInput, p.at[2] * kSurfacePerInput};
}

class PileMaker {
public:
    explicit PileMaker(std::uint64_t seed) : random_(seed) {
        level.name = "pile";
        level.entities.resize(1);
        level.entities[0].keys = {{"classname", "worldspawn"}};
        level.materials = {"", "stone", "steel"};
        level.surfaces.materials = {""};
        level.surfaces.groups = {""};
    }

    /// low .. high, both included.
    std::int32_t between(std::int32_t low, std::int32_t high) {
        return low + std::int32_t(random_() % std::uint64_t(high - low + 1));
    }

    void box_on_grid(std::int32_t cells, std::int32_t step) {
        std::int32_t low[3], high[3];
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = between(0, cells - 1);
            high[axis] = between(low[axis] + 1, cells);
            low[axis] *= step;
            high[axis] *= step;
        }
        add_box(level, low, high);
    }

    /// A box that shares some of its bounds with an earlier one, or lies within it.
    void box_by_another(bool inside) {
        if (boxes_.empty()) {
            keep_box({0, 0, 0}, {8 * kInputMetre, 8 * kInputMetre, 8 * kInputMetre});
            return;
        }
        const std::array<std::int32_t, 6> other = boxes_[std::size_t(between(0, std::int32_t(boxes_.size()) - 1))];
        std::int32_t low[3], high[3];
        for (int axis = 0; axis < 3; ++axis) {
            const std::int32_t a = other[std::size_t(axis)], b = other[std::size_t(axis + 3)];
            const std::int32_t how = between(0, inside ? 2 : 4);
            const std::int32_t part = std::max(1, (b - a) / 3);
            low[axis] = how == 0 ? a : how == 3 ? b : how == 4 ? a - part : a + part;
            high[axis] = how == 1 ? b : how == 3 ? b + part : how == 4 ? a : std::max(low[axis] + 1, b - part / 2);
        }
        keep_box({low[0], low[1], low[2]}, {high[0], high[1], high[2]});
    }

    /// @param step  corners lie on multiples of it
    void tetrahedron(std::int32_t cells, std::int32_t step) {
        for (;;) {
            Point p[4];
            for (Point& point : p)
                for (std::int32_t& c : point.at) c = between(0, cells) * step;
            if (add_tetrahedron(p)) return;
        }
    }

    /// Three corners, and the fourth a few steps off their plane.
    void flat_tetrahedron() {
        for (;;) {
            Point p[4];
            for (Point& point : p)
                for (std::int32_t& c : point.at) c = between(0, 8) * kInputMetre;
            for (int axis = 0; axis < 3; ++axis) {
                const std::int64_t sum = std::int64_t(p[0].at[axis]) + p[1].at[axis] + p[2].at[axis];
                p[3].at[axis] = std::int32_t(sum / 3) + between(-3, 3);
            }
            if (add_tetrahedron(p)) return;
        }
    }

    /// A box cut in half along a diagonal.
    void wedge(std::int32_t cells, std::int32_t step) {
        box_on_grid(cells, step);
        Brush& brush = level.brushes.back();
        const BrushSide* sides = &level.sides[brush.first_side];
        const int along = between(0, 2), u = (along + 1) % 3, v = (along + 2) % 3;
        Point low{}, high{};
        for (int axis = 0; axis < 3; ++axis) {
            low.at[axis] = sides[2 * axis].points[0][axis] / kSurfacePerInput;
            high.at[axis] = sides[2 * axis + 1].points[0][axis] / kSurfacePerInput;
        }
        const bool flip = between(0, 1) == 1, other = between(0, 1) == 1;
        Point a = low, b = low, c = low;
        a.at[u] = other ? low.at[u] : high.at[u];
        a.at[v] = low.at[v];
        b.at[u] = other ? high.at[u] : low.at[u];
        b.at[v] = high.at[v];
        c = a;
        c.at[along] = high.at[along];
        BrushSide side = level.sides.back();
        side.points[0] = surface(a);
        side.points[flip ? 1 : 2] = surface(b);
        side.points[flip ? 2 : 1] = surface(c);
        level.sides.push_back(side);
        ++brush.side_count;
    }

    /// A box as thin as a step or a few.
    void plate() {
        std::int32_t low[3], high[3];
        const int thin = between(0, 2);
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = between(0, 7) * kInputMetre;
            high[axis] = low[axis] + (axis == thin ? between(1, 3) : between(1, 4) * kInputMetre);
            if (axis == thin) low[axis] += between(-1, 0);
        }
        add_box(level, low, high);
    }

    /// A hull around a grid of rooms, with walls between them; in most walls a doorway, and in that a portal, which
    /// reaches into the walls around it.
    void halls(int rooms_x, int rooms_y) {
        constexpr std::int32_t kWide = 3 * kInputMetre, kWall = kInputMetre / 4, kHigh = 5 * kInputMetre / 2;
        const std::int32_t wide = rooms_x * kWide + kWall, deep = rooms_y * kWide + kWall;
        add({0, 0, -kInputMetre}, {wide, deep, 0});
        add({0, 0, kHigh}, {wide, deep, kHigh + kInputMetre});
        for (int x = 0; x <= rooms_x; ++x)
            for (int y = 0; y < rooms_y; ++y)
                wall(0, x * kWide, y * kWide, kWide + kWall, kWall, kHigh, x > 0 && x < rooms_x);
        for (int y = 0; y <= rooms_y; ++y)
            for (int x = 0; x < rooms_x; ++x)
                wall(1, y * kWide, x * kWide, kWide + kWall, kWall, kHigh, y > 0 && y < rooms_y);
        for (int k = 0; k < rooms_x * rooms_y; ++k)  // something that stands about, or hangs in the air
            if (between(0, 1)) {
                const std::int32_t x = between(2, rooms_x * 12 - 3) * kInputMetre / 4,
                                   y = between(2, rooms_y * 12 - 3) * kInputMetre / 4;
                const std::int32_t z = between(0, 1) * kInputMetre;
                add({x, y, z}, {x + kInputMetre / 2, y + kInputMetre / 4, z + kInputMetre});
            }
    }

    BrushLevel level;

private:
    void keep_box(const std::array<std::int32_t, 3>& low, const std::array<std::int32_t, 3>& high) {
        boxes_.push_back({low[0], low[1], low[2], high[0], high[1], high[2]});
        add(low, high);
    }
    void add(const std::array<std::int32_t, 3>& low, const std::array<std::int32_t, 3>& high,
             BrushKind kind = BrushKind::kSolid) {
        const std::int32_t a[3] = {low[0], low[1], low[2]}, b[3] = {high[0], high[1], high[2]};
        add_box(level, a, b, kind);
    }

    /// @param across  the axis that it stands across: 0 or 1
    void wall(int across, std::int32_t at, std::int32_t from, std::int32_t length, std::int32_t thick,
              std::int32_t high, bool may_open) {
        const auto piece = [&](std::int32_t a, std::int32_t b, std::int32_t low, std::int32_t top, BrushKind kind) {
            const std::int32_t begin = kind == BrushKind::kPortal ? at + thick / 4 : at;
            const std::int32_t end = kind == BrushKind::kPortal ? at + thick / 2 : at + thick;
            if (across == 0)
                add({begin, a, low}, {end, b, top}, kind);
            else
                add({a, begin, low}, {b, end, top}, kind);
        };
        if (!may_open || between(0, 3) == 0) return piece(from, from + length, 0, high, BrushKind::kSolid);
        const std::int32_t door = from + between(2, 6) * kInputMetre / 4, wide = kInputMetre, top = 2 * kInputMetre;
        piece(from, door, 0, high, BrushKind::kSolid);
        piece(door + wide, from + length, 0, high, BrushKind::kSolid);
        piece(door, door + wide, top, high, BrushKind::kSolid);
        piece(door - kInputMetre / 8, door + wide + kInputMetre / 8, -kInputMetre / 8, top + kInputMetre / 8,
              BrushKind::kPortal);
        BrushSide* sides = &level.sides[level.brushes.back().first_side];
        sides[2 * across + between(0, 1)].portal = true;
    }

    bool add_tetrahedron(Point (&p)[4]) {
        const auto minus = [](const Point& a, const Point& b) {
            return std::array<__int128_t, 3>{a.at[0] - b.at[0], a.at[1] - b.at[1], a.at[2] - b.at[2]};
        };
        const auto u = minus(p[1], p[0]), v = minus(p[2], p[0]), w = minus(p[3], p[0]);
        const auto volume = u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) +
                            u[2] * (v[0] * w[1] - v[1] * w[0]);
        if (volume == 0) return false;
        if (volume > 0) std::swap(p[1], p[2]);  // so that the first three are counter-clockwise from outside
        constexpr int kCorners[4][3] = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
        Brush brush;
        brush.first_side = std::uint32_t(level.sides.size());
        brush.side_count = 4;
        for (const auto& three : kCorners) {
            BrushSide side;
            for (int k = 0; k < 3; ++k) side.points[k] = surface(p[three[k]]);
            side.material = std::uint32_t(level.brushes.size() % 3);
            side.mask = kStopsSolid;
            level.sides.push_back(side);
        }
        level.brushes.push_back(brush);
        return true;
    }

    std::mt19937_64 random_;
    std::vector<std::array<std::int32_t, 6>> boxes_;
};

}  // namespace

void add_box(BrushLevel& level, const std::int32_t (&low)[3], const std::int32_t (&high)[3], BrushKind kind) {
    Brush brush;
    brush.kind = kind;
    brush.first_side = std::uint32_t(level.sides.size());
    brush.side_count = 6;
    for (int axis = 0; axis < 3; ++axis)
        for (const bool upper : {false, true}) {
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            Point points[3];
            for (Point& point : points) {
                point.at[axis] = upper ? high[axis] : low[axis];
                point.at[u] = low[u];
                point.at[v] = low[v];
            }
            points[1].at[u] = high[u];
            points[2].at[v] = high[v];
            BrushSide side;
            side.points[0] = surface(points[0]);
            side.points[upper ? 1 : 2] = surface(points[1]);
            side.points[upper ? 2 : 1] = surface(points[2]);
            side.material = std::uint32_t(level.brushes.size() % 3);
            side.mask = kind == BrushKind::kPortal ? 0 : kStopsSolid;
            level.sides.push_back(side);
        }
    level.brushes.push_back(brush);
}

BrushLevel brush_pile(BrushPile kind, std::uint64_t seed, int brushes) {
    PileMaker maker(seed * 8 + std::uint64_t(kind));
    if (kind == BrushPile::kHalls) {
        const int wide = std::max(2, brushes / 8);
        maker.halls(wide, 2);
        return std::move(maker.level);
    }
    for (int k = 0; k < brushes; ++k) {
        const std::int32_t choice = maker.between(0, 3);
        switch (kind) {
            case BrushPile::kBoxes:
                maker.box_on_grid(8, kInputMetre);
                break;
            case BrushPile::kNested:
                maker.box_by_another(true);
                break;
            case BrushPile::kInitialOverlap:
                if (choice == 0)
                    maker.wedge(6, kInputMetre);
                else
                    maker.box_by_another(false);
                break;
            case BrushPile::kWedges:
                if (choice < 2)
                    maker.tetrahedron(4, 2 * kInputMetre);
                else
                    maker.wedge(4, 2 * kInputMetre);
                break;
            case BrushPile::kCrystals:
                maker.tetrahedron(8 * kInputMetre, 1);
                break;
            case BrushPile::kSlivers:
                if (choice < 2)
                    maker.plate();
                else
                    maker.flat_tetrahedron();
                break;
            case BrushPile::kHalls:
                break;
        }
    }
    return std::move(maker.level);
}

}  // namespace firma::scenes
