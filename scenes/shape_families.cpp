// SPDX-License-Identifier: MIT
// Families that are about the polygons.
#include "scenes/shape_families.h"

#include <cmath>
#include <cstdlib>

#include "scenes/cast_builder.h"

namespace firma::scenes {

void generic_triangles(CastBuilder& b) {
    b.triangles(30, 8 * kMetre, 3 * kMetre, kInput);
    b.wild_casts(2, 12);
}

void generic_ngons(CastBuilder& b) {
    b.ngons(30, 8 * kMetre, 3 * kMetre, kInput, 4 + int(b.rng.below(14)));
    b.wild_casts(2, 12);
}

void surface_grid(CastBuilder& b) {
    b.ngons(15, 8 * kMetre, 3 * kMetre, 1, 4 + int(b.rng.below(14)));
    b.triangles(15, 8 * kMetre, 3 * kMetre, 1);
    b.wild_casts(2, 12);
}

void many_corners(CastBuilder& b) {
    b.ngons(6, 4 * kMetre, 4 * kMetre, kInput, 400);
    b.wild_casts(2, 8);
}

void collinear_corners(CastBuilder& b) {
    const std::int64_t step = kInput * (1 + b.rng.below(2000));
    const int points = 5 + int(b.rng.below(6));
    b.ngons(24, 6 * kMetre, 3 * kMetre, step, points, true);
    b.wild_casts(2, 10);
}

void height_field(CastBuilder& b) {
    constexpr int kSide = 7;
    const std::int64_t cell = kMetre * (1 + b.rng.below(3)), rise = b.rng.chance(0.5) ? kInput : kMetre / 4;
    Steps grid[kSide + 1][kSide + 1];
    for (int i = 0; i <= kSide; ++i)
        for (int j = 0; j <= kSide; ++j)
            grid[i][j] = {(i - kSide / 2) * cell, (j - kSide / 2) * cell,
                          rise * std::int64_t(b.rng.below(std::uint32_t(kMetre / rise)))};
    for (int i = 0; i < kSide; ++i)
        for (int j = 0; j < kSide; ++j) {
            const GridPoint p = in_world(grid[i][j]), q = in_world(grid[i + 1][j]), r = in_world(grid[i + 1][j + 1]),
                            s = in_world(grid[i][j + 1]);
            b.scene.polygons.push_back({p, q, r});
            b.scene.polygons.push_back({p, r, s});
        }
    for (int k = 0; k < kCastsAScene; ++k) {
        const Place at = b.any_place();
        Vec3 way = b.rng.direction();
        way.z = -std::fabs(way.z);
        const double radius = b.rng.chance(0.4) ? 0 : b.magnitude(0.01, 1);
        const double before = b.rng.uniform(0, 10);
        const double after = b.rng.uniform(0, 10);
        b.meet(at.point, {0, 0, 1}, radius, way, before, after);
    }
}

void fans(CastBuilder& b) {
    const int spokes = 3 + int(b.rng.below(62));
    const WholeFrame frame = random_frame(b.rng, 3);
    const std::int64_t size = 2 * kMetre / frame.length;
    double height = b.rng.chance(0.3) ? 0 : b.rng.uniform(-1, 1);
    if (b.rng.chance(0.5)) height *= 1e-3;
    const Steps centre = random_steps(b.rng, 8 * kMetre);
    std::vector<GridPoint> rim;
    for (int k = 0; k < spokes; ++k) {  // around a square, so as not to need a sine
        const double part = double(4 * k) / spokes, in_side = part - std::floor(part);
        const double x[4] = {1, 1 - 2 * in_side, -1, -1 + 2 * in_side},
                     y[4] = {-1 + 2 * in_side, 1, 1 - 2 * in_side, -1};
        const double i = x[int(part)], j = y[int(part)], scale = double(size) * (0.6 + 0.4 * b.rng.uniform());
        rim.push_back(in_world(centre + frame.at(std::llround(i * scale), std::llround(j * scale), 0), kInput));
    }
    const GridPoint hub = in_world(centre + frame.z * std::llround(height * double(size)), kInput);
    for (int k = 0; k < spokes; ++k) {
        const GridPolygon p{hub, rim[std::size_t(k)], rim[std::size_t((k + 1) % spokes)]};
        const Vec3 area = cross(to_metres(p[1]) - to_metres(p[0]), to_metres(p[2]) - to_metres(p[0]));
        if (length(area) > 1e-6) b.scene.polygons.push_back(p);
    }
    const Vec3 up = to_metres(frame.z) * (kSurfaceSteps / double(frame.length));
    for (int k = 0; k < kCastsAScene; ++k) {
        const double which = b.rng.uniform();
        const Vec3 target = which < 0.5   ? to_metres(hub)
                            : which < 0.8 ? b.place(Feature::kEdge).point
                                          : b.any_place().point;
        Vec3 way = b.rng.direction();
        if (dot(way, up) > 0) way = way * -1;
        const double radius = b.rng.chance(0.5) ? 0 : b.magnitude(1e-4, 1);
        const Vec3 away = b.rng.chance(0.5) ? way * -1 : up;
        const double before = b.rng.uniform(0, 10);
        const double after = b.rng.uniform(0, 10);
        b.meet(target, away, radius, way, before, after);
    }
}

void slivers(CastBuilder& b) {
    const std::int64_t step = b.rng.chance(0.5) ? kInput : 1;
    while (b.scene.polygons.size() < 24) {
        const Steps origin = random_steps(b.rng, 4 * kMetre);
        const Steps along = random_steps(b.rng, std::int64_t(b.magnitude(64 * double(step), 50.0 * kMetre)));
        const Steps width = random_steps(b.rng, 1) * step;
        const GridPoint p = in_world(origin, step), q = in_world(origin + along, step);
        const Steps middle{(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2};
        const GridPoint r = in_world((b.rng.chance(0.5) ? middle : steps(p)) + width, step);
        const GridPolygon triangle{p, q, r};
        const Steps u = steps(q) - steps(p), v = steps(r) - steps(p);
        if (!along_one_line(u, v)) b.scene.polygons.push_back(triangle);
    }
    for (int k = 0; k < kCastsAScene; ++k) {
        const Place at = b.any_place();
        const double radius = b.rng.chance(0.3) ? 0 : b.magnitude(1e-6, 1);
        const Vec3 way = b.rng.direction(), away = b.rng.chance(0.3) ? b.perpendicular_to(way) : way * -1;
        const double nudged = b.nudged(radius, 1);
        const double before = b.rng.uniform(0, 4);
        const double after = b.rng.uniform(0, 4);
        b.meet(at.point, away, nudged, way, before, after);
    }
}

void knife_edges(CastBuilder& b) {
    for (int k = 0; k < 8; ++k) {
        const Steps a = random_steps(b.rng, 6 * kMetre), along = random_steps(b.rng, 3 * kMetre),
                    back = random_steps(b.rng, 2 * kMetre);
        const Steps thin = random_steps(b.rng, kInput * (1 + b.rng.below(4)));
        const GridPoint p = in_world(a, kInput), q = in_world(a + along, kInput), r = in_world(a + back, kInput),
                        s = in_world(a + back + thin, kInput);
        const Vec3 n = cross(to_metres(q) - to_metres(p), to_metres(r) - to_metres(p));
        const double volume = dot(n, to_metres(s) - to_metres(p));
        if (volume == 0) continue;
        const GridPolygon sides[4] = {{p, q, r}, {p, s, q}, {q, s, r}, {p, r, s}};  // outward when volume < 0
        for (const GridPolygon& side : sides) b.scene.polygons.push_back(volume < 0 ? side : turned_over(side));
    }
    if (b.scene.polygons.empty()) return generic_triangles(b);
    for (int k = 0; k < kCastsAScene; ++k) {
        const Place at = b.place(b.rng.chance(0.8) ? Feature::kEdge : Feature::kVertex);
        const Vec3 out = b.outward(at);
        const Vec3 way = b.rng.chance(0.5) ? out * -1 + b.rng.direction() * 0.01 : b.rng.direction();
        const double radius = b.rng.chance(0.3) ? 0 : b.magnitude(1e-5, 0.5);
        const Vec3 unit = way * (1 / length(way));
        const Vec3 away = b.rng.chance(0.5) ? out : unit * -1;
        const double before = b.rng.uniform(0, 3);
        const double after = b.rng.uniform(0, 3);
        b.meet(at.point, away, radius, unit, before, after);
    }
}

void thin_boxes(CastBuilder& b) {
    for (int k = 0; k < 6; ++k) {
        const WholeFrame frame = random_frame(b.rng, 2);
        const std::int64_t thick = 1 + b.rng.below(64), i = 1 + b.rng.below(20000), j = 1 + b.rng.below(20000);
        const Steps o = random_steps(b.rng, 8 * kMetre), u = frame.x * i, v = frame.y * j, w = frame.z * thick;
        const auto quad = [&](const Steps& at, const Steps& s, const Steps& t) {
            b.scene.polygons.push_back({in_world(at), in_world(at + s), in_world(at + s + t), in_world(at + t)});
        };
        quad(o + w, u, v);
        quad(o, v, u);
        quad(o + u, v, w);
        quad(o, w, v);
        quad(o + v, w, u);
        quad(o, u, w);
    }
    for (int k = 0; k < kCastsAScene; ++k) {
        const Place at = b.any_place();
        const Vec3 way = b.rng.direction();
        const double radius = b.rng.chance(0.5) ? 0 : b.magnitude(1e-6, 0.1);
        const double before = b.magnitude(0.1, 500);
        const double after = b.magnitude(0.1, 500);
        b.meet(at.point, way * -1, radius, way, before, after);
    }
}

void far_away(CastBuilder& b) {
    const std::int64_t far = (b.rng.chance(0.5) ? 8180 : b.rng.chance(0.5) ? 4000 : 1000) * kMetre;
    const Steps centre{b.rng.chance(0.5) ? far : -far, b.rng.chance(0.5) ? far : -far, b.rng.chance(0.5) ? far : -far};
    b.triangles(15, 6 * kMetre, 3 * kMetre, kInput, centre);
    b.ngons(15, 6 * kMetre, 3 * kMetre, kInput, 10, false, centre);
    b.wild_casts(2, 10);
}

void range_border(CastBuilder& b) {
    constexpr std::int64_t kRim = std::int64_t(8192) * kMetre;
    const Steps centre{b.rng.chance(0.5) ? kRim : -kRim, b.rng.chance(0.5) ? kRim : -kRim,
                       b.rng.chance(0.5) ? kRim : -kRim};
    b.triangles(24, 3 * kMetre, 4 * kMetre, b.rng.chance(0.5) ? kInput : 1, centre);
    b.wild_casts(2, 10);
}

void huge_polygons(CastBuilder& b) {
    b.triangles(12, 2000 * kMetre, 5000 * kMetre, kInput);
    b.triangles(4, 0, 8192 * kMetre, 1);
    b.ngons(8, 1000 * kMetre, 5000 * kMetre, kInput, 10);
    for (int k = 0; k < kCastsAScene; ++k) {
        const double radius = b.rng.chance(0.5) ? 1 : 500;
        const double reach = b.rng.chance(0.5) ? 10 : 6000;
        b.wild(radius, reach);
    }
}

void tiny_polygons(CastBuilder& b) {
    const std::int64_t step = b.rng.chance(0.5) ? kInput : 1;
    const Steps centre = random_steps(b.rng, b.rng.chance(0.5) ? 8000 * kMetre : 8 * kMetre);
    b.triangles(16, 12 * step, 3 * step, step, centre);
    b.ngons(14, 12 * step, 4 * step, step, 8, false, centre);
    const double size = double(step) / kSurfaceSteps;
    for (int k = 0; k < kCastsAScene; ++k) {
        const double radius = size * (b.rng.chance(0.5) ? 10 : 1000);
        const double reach = size * (b.rng.chance(0.5) ? 20 : 1e5);
        b.wild(radius, reach);
    }
}

void mixed_scales(CastBuilder& b) {
    b.triangles(8, 2000 * kMetre, 3000 * kMetre, kInput);
    b.triangles(8, 4 * kMetre, 3 * kMetre, kInput);
    b.triangles(8, kMetre / 100, 4 * kInput, 1);
    for (int k = 0; k < kCastsAScene; ++k) {
        const double size = b.magnitude(1e-4, 1e3);
        const double radius = size * b.magnitude(1e-3, 10);
        const double reach = size * b.magnitude(0.1, 1e3);
        b.wild(radius, reach);
    }
}

void repeated(CastBuilder& b) {
    b.ngons(8, 4 * kMetre, 3 * kMetre, kInput, 7);
    for (int copy = 0; copy < 3; ++copy)
        for (int k = 0; k < 8; ++k) {
            const GridPolygon polygon = b.scene.polygons[std::size_t(k)];
            b.scene.polygons.push_back(b.rng.chance(0.5) ? polygon : turned_over(polygon));
        }
    for (std::size_t k = 0; k < b.scene.polygons.size(); ++k) b.scene.two_sided.push_back(b.rng.chance(0.3));
    b.wild_casts(2, 8);
}

}  // namespace firma::scenes
