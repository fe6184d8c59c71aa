// SPDX-License-Identifier: MIT
// The table of families, and those that are about sizes, distances and everyday shapes.
#include "scenes/cast_families.h"

#include <cmath>
#include <cstdlib>

#include "scenes/cast_builder.h"
#include "scenes/exact_families.h"

namespace firma::scenes {

namespace {

constexpr int kCasts = 48;

void triangles(CastBuilder& b, int count, std::int64_t spread, std::int64_t reach, std::int64_t step,
               const Steps& centre = {}) {
    for (int k = 0; k < count; ++k)
        b.scene.polygons.push_back(random_triangle(b.rng, centre + random_steps(b.rng, spread), reach, step));
}

void ngons(CastBuilder& b, int count, std::int64_t spread, std::int64_t reach, std::int64_t step, int points,
           bool collinear = false, const Steps& centre = {}) {
    for (int k = 0; k < count; ++k)
        b.scene.polygons.push_back(
            random_polygon(b.rng, centre + random_steps(b.rng, spread), reach, step, points, collinear));
}

void wild_casts(CastBuilder& b, double radius_most, double reach) {
    for (int k = 0; k < kCasts; ++k) b.wild(radius_most, reach);
}

void generic_triangles(CastBuilder& b) {
    triangles(b, 30, 8 * kMetre, 3 * kMetre, kInput);
    wild_casts(b, 2, 12);
}

void generic_ngons(CastBuilder& b) {
    ngons(b, 30, 8 * kMetre, 3 * kMetre, kInput, 4 + int(b.rng.below(14)));
    wild_casts(b, 2, 12);
}

void surface_grid(CastBuilder& b) {
    ngons(b, 15, 8 * kMetre, 3 * kMetre, 1, 4 + int(b.rng.below(14)));
    triangles(b, 15, 8 * kMetre, 3 * kMetre, 1);
    wild_casts(b, 2, 12);
}

void many_corners(CastBuilder& b) {
    ngons(b, 6, 4 * kMetre, 4 * kMetre, kInput, 400);
    wild_casts(b, 2, 8);
}

void collinear_corners(CastBuilder& b) {
    ngons(b, 24, 6 * kMetre, 3 * kMetre, kInput * (1 + b.rng.below(2000)), 5 + int(b.rng.below(6)), true);
    wild_casts(b, 2, 10);
}

// A height field; the steps between heights may be coarse, so that many neighbours are coplanar.
void terrain(CastBuilder& b) {
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
    for (int k = 0; k < kCasts; ++k) {
        const Place at = b.any_place();
        Vec3 way = b.rng.direction();
        way.z = -std::fabs(way.z);
        const double radius = b.rng.chance(0.4) ? 0 : b.magnitude(0.01, 1);
        b.meet(at.point, {0, 0, 1}, radius, way, b.rng.uniform(0, 10), b.rng.uniform(0, 10));
    }
}

// A disc of triangles around a hub, nearly flat, a cone or a cup, aimed at where the triangles meet.
void fans(CastBuilder& b) {
    const int spokes = 3 + int(b.rng.below(62));
    const WholeFrame frame = random_frame(b.rng, 3);
    const std::int64_t size = 2 * kMetre / frame.length;
    const double height = b.rng.chance(0.3) ? 0 : b.rng.uniform(-1, 1) * (b.rng.chance(0.5) ? 1 : 1e-3);
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
    for (int k = 0; k < kCasts; ++k) {
        const double which = b.rng.uniform();
        const Vec3 target = which < 0.5   ? to_metres(hub)
                            : which < 0.8 ? b.place(Feature::kEdge).point
                                          : b.any_place().point;
        Vec3 way = b.rng.direction();
        if (dot(way, up) > 0) way = way * -1;
        const double radius = b.rng.chance(0.5) ? 0 : b.magnitude(1e-4, 1);
        b.meet(target, b.rng.chance(0.5) ? way * -1 : up, radius, way, b.rng.uniform(0, 10), b.rng.uniform(0, 10));
    }
}

// One step wide, up to 100 m long.
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
        if (u.y * v.z != u.z * v.y || u.z * v.x != u.x * v.z || u.x * v.y != u.y * v.x)
            b.scene.polygons.push_back(triangle);
    }
    for (int k = 0; k < kCasts; ++k) {
        const Place at = b.any_place();
        const double radius = b.rng.chance(0.3) ? 0 : b.magnitude(1e-6, 1);
        const Vec3 way = b.rng.direction(), away = b.rng.chance(0.3) ? b.perpendicular_to(way) : way * -1;
        b.meet(at.point, away, b.nudged(radius, 1), way, b.rng.uniform(0, 4), b.rng.uniform(0, 4));
    }
}

// Closed wedges with a hair's angle at the edge, met from the edge's side and from behind one of the faces.
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
    for (int k = 0; k < kCasts; ++k) {
        const Place at = b.place(b.rng.chance(0.8) ? Feature::kEdge : Feature::kVertex);
        const Vec3 out = b.outward(at);
        const Vec3 way = b.rng.chance(0.5) ? out * -1 + b.rng.direction() * 0.01 : b.rng.direction();
        const double radius = b.rng.chance(0.3) ? 0 : b.magnitude(1e-5, 0.5);
        const Vec3 unit = way * (1 / length(way));
        b.meet(at.point, b.rng.chance(0.5) ? out : unit * -1, radius, unit, b.rng.uniform(0, 3), b.rng.uniform(0, 3));
    }
}

// Boxes a few steps thick, shot through at speed.
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
    for (int k = 0; k < kCasts; ++k) {
        const Place at = b.any_place();
        const Vec3 way = b.rng.direction();
        const double radius = b.rng.chance(0.5) ? 0 : b.magnitude(1e-6, 0.1);
        b.meet(at.point, way * -1, radius, way, b.magnitude(0.1, 500), b.magnitude(0.1, 500));
    }
}

void far_away(CastBuilder& b) {
    const std::int64_t far = (b.rng.chance(0.5) ? 8180 : b.rng.chance(0.5) ? 4000 : 1000) * kMetre;
    const Steps centre{b.rng.chance(0.5) ? far : -far, b.rng.chance(0.5) ? far : -far, b.rng.chance(0.5) ? far : -far};
    triangles(b, 15, 6 * kMetre, 3 * kMetre, kInput, centre);
    ngons(b, 15, 6 * kMetre, 3 * kMetre, kInput, 10, false, centre);
    wild_casts(b, 2, 10);
}

// Corners on the very rim of the range: -2^31 and 2^31 - 1 steps.
void range_border(CastBuilder& b) {
    constexpr std::int64_t kRim = std::int64_t(8192) * kMetre;
    const Steps centre{b.rng.chance(0.5) ? kRim : -kRim, b.rng.chance(0.5) ? kRim : -kRim,
                       b.rng.chance(0.5) ? kRim : -kRim};
    triangles(b, 24, 3 * kMetre, 4 * kMetre, b.rng.chance(0.5) ? kInput : 1, centre);
    wild_casts(b, 2, 10);
}

// Five kilometres and more across, and from rim to rim.
void huge_polygons(CastBuilder& b) {
    triangles(b, 12, 2000 * kMetre, 5000 * kMetre, kInput);
    triangles(b, 4, 0, 8192 * kMetre, 1);
    ngons(b, 8, 1000 * kMetre, 5000 * kMetre, kInput, 10);
    for (int k = 0; k < kCasts; ++k) b.wild(b.rng.chance(0.5) ? 1 : 500, b.rng.chance(0.5) ? 10 : 6000);
}

// A few steps across.
void tiny_polygons(CastBuilder& b) {
    const std::int64_t step = b.rng.chance(0.5) ? kInput : 1;
    const Steps centre = random_steps(b.rng, b.rng.chance(0.5) ? 8000 * kMetre : 8 * kMetre);
    triangles(b, 16, 12 * step, 3 * step, step, centre);
    ngons(b, 14, 12 * step, 4 * step, step, 8, false, centre);
    const double size = double(step) / kSurfaceSteps;
    for (int k = 0; k < kCasts; ++k)
        b.wild(size * (b.rng.chance(0.5) ? 10 : 1000), size * (b.rng.chance(0.5) ? 20 : 1e5));
}

void radii(CastBuilder& b) {
    triangles(b, 20, 6 * kMetre, 3 * kMetre, kInput);
    ngons(b, 10, 6 * kMetre, 3 * kMetre, kInput, 8);
    const double least = b.rng.chance(0.5) ? 1e-6 : b.rng.chance(0.5) ? 1e-3 : 1000;
    for (int k = 0; k < kCasts; ++k) {
        const Place at = b.any_place();
        const double radius = least * b.rng.uniform(0.5, 1.5);
        const Vec3 way = b.rng.direction(), away = b.rng.chance(0.5) ? b.normal(at.polygon) : way * -1;
        b.meet(at.point, away, radius, way, b.rng.uniform(0, 10), b.rng.uniform(0, 10));
    }
}

// From a hundredth of a nanometre to beyond the world.
void extreme_radii(CastBuilder& b) {
    triangles(b, 20, 6 * kMetre, 3 * kMetre, kInput);
    for (int k = 0; k < kCasts; ++k) {
        const Place at = b.any_place();
        const double radius = b.rng.chance(0.3)   ? b.magnitude(1e-11, 1e-6)
                              : b.rng.chance(0.2) ? b.magnitude(1e-320, 1e-20)
                                                  : b.magnitude(1e3, 1e6);
        const Vec3 way = b.rng.direction(), away = b.rng.chance(0.5) ? b.normal(at.polygon) : way * -1;
        b.meet(at.point, away, radius, way, b.rng.uniform(0, 10), b.rng.uniform(0, 10));
    }
}

void long_paths(CastBuilder& b) {
    triangles(b, 20, 6 * kMetre, 3 * kMetre, kInput);
    ngons(b, 10, 6 * kMetre, 3 * kMetre, kInput, 8);
    for (int k = 0; k < kCasts; ++k) {
        const Place at = b.any_place();
        const Vec3 way = b.rng.direction();
        const double radius = b.rng.chance(0.4) ? 0 : b.magnitude(1e-3, 5);
        b.meet(at.point, b.rng.chance(0.5) ? way * -1 : b.rng.direction(), radius, way, b.rng.uniform(0, 1e4),
               b.rng.uniform(0, 1e4));
    }
}

// A micrometre or a nanometre, beginning about there where touch begins.
void short_paths(CastBuilder& b) {
    triangles(b, 20, 6 * kMetre, 3 * kMetre, kInput);
    ngons(b, 10, 6 * kMetre, 3 * kMetre, kInput, 8);
    const double size = b.rng.chance(0.5) ? 1e-6 : b.rng.chance(0.5) ? 1e-9 : 1e-12;
    for (int k = 0; k < kCasts; ++k) {
        const Place at = b.any_place();
        const Vec3 way = b.rng.direction(), away = b.rng.chance(0.5) ? b.normal(at.polygon) : way * -1;
        const double radius = b.rng.chance(0.4) ? 0 : b.magnitude(1e-3, 2);
        b.meet(at.point, away, radius, way, size * b.rng.uniform(-0.3, 1.3), size * b.rng.uniform(0, 1));
    }
}

// None at all, subnormal, or with components of very different sizes; often in touch or overlap at the start.
void odd_paths(CastBuilder& b) {
    triangles(b, 20, 4 * kMetre, 3 * kMetre, kInput);
    ngons(b, 10, 4 * kMetre, 3 * kMetre, kInput, 8);
    const double sizes[] = {
        0.0, -0.0, 4.9406564584124654e-324, -1e-310, 1e-300, 1e-200, -1e-100, 1e-70, -1e-38, 1e-30, 1e-20, 1, -5};
    for (int k = 0; k < kCasts; ++k) {
        const Place at = b.any_place();
        const double radius = b.rng.chance(0.3) ? 0 : b.magnitude(1e-3, 2);
        const Vec3 start = at.point + b.rng.direction() * (radius * b.rng.uniform(0, 1.2));
        const bool all_small = b.rng.chance(0.6);
        Vec3 path;
        for (int axis = 0; axis < 3; ++axis)
            path[axis] = sizes[b.rng.below(all_small ? 11 : 13)] * (b.rng.chance(0.5) ? 1 : b.rng.uniform(-1, 1));
        b.add(start, path, radius);
    }
}

// Far outside the world at the start, at the end, or both.
void from_outside(CastBuilder& b) {
    const Steps centre = random_steps(b.rng, b.rng.chance(0.5) ? 8000 * kMetre : 8 * kMetre);
    triangles(b, 15, 6 * kMetre, 3 * kMetre, kInput, centre);
    triangles(b, 10, 0, 8192 * kMetre, kInput);
    for (int k = 0; k < kCasts; ++k) {
        const Place at = b.any_place();
        const Vec3 way = b.rng.direction();
        const double radius = b.rng.chance(0.4) ? 0 : b.magnitude(1e-3, 1000);
        const double before = b.magnitude(1e4, b.rng.chance(0.7) ? 1e6 : 1e9),
                     after = b.rng.chance(0.5) ? before : b.rng.uniform(0, 100);
        b.meet(at.point, way * -1, radius, way, before, after);
    }
}

// Paths up to where numbers end being valid.
void huge_paths(CastBuilder& b) {
    triangles(b, 12, 6 * kMetre, 3 * kMetre, kInput);
    triangles(b, 6, 0, 8192 * kMetre, kInput);
    for (int k = 0; k < kCasts; ++k) {
        const Place at = b.any_place();
        const Vec3 way = b.rng.direction();
        const double radius = b.rng.chance(0.5) ? 0 : b.magnitude(1e-3, 1000);
        const double after = b.rng.chance(0.7) ? b.magnitude(1e6, 1e12) : b.magnitude(1e12, 0x1p198);
        b.meet(at.point, way * -1, radius, way, b.rng.uniform(0, 100), after);
    }
}

// Overlapping at the start and going anywhere.
void overlapping(CastBuilder& b) {
    triangles(b, 12, 2 * kMetre, 2 * kMetre, kInput);
    ngons(b, 12, 2 * kMetre, 2 * kMetre, kInput, 9);
    for (int k = 0; k < kCasts; ++k) {
        const Place at = b.any_place();
        const double radius = b.magnitude(1e-3, 4);
        b.add(at.point + b.rng.direction() * (radius * b.rng.uniform()), b.rng.direction() * b.magnitude(1e-3, 10),
              radius);
    }
}

void receding(CastBuilder& b) {
    ngons(b, 24, 8 * kMetre, 2 * kMetre, kInput, 9);
    for (int k = 0; k < kCasts; ++k) {
        const Place at = b.any_place();
        const double radius = b.rng.chance(0.4) ? 0 : b.magnitude(1e-3, 1);
        const Vec3 n = b.normal(at.polygon), way = b.rng.direction();
        b.meet(at.point, n, b.nudged(radius, 1), dot(way, n) < 0 ? way * -1 : way, b.rng.uniform(-0.1, 0.1),
               b.rng.uniform(0, 5));
    }
}

void backface(CastBuilder& b) {
    ngons(b, 24, 8 * kMetre, 2 * kMetre, kInput, 9);
    for (int k = 0; k < kCasts; ++k) {
        const Place at = b.any_place();
        const double radius = b.rng.chance(0.4) ? 0 : b.magnitude(1e-3, 1);
        const Vec3 n = b.normal(at.polygon), way = b.rng.direction();
        b.meet(at.point, n * -1, radius, dot(way, n) < 0 ? way * -1 : way, b.rng.uniform(0, 5), b.rng.uniform(0, 5));
    }
}

// The sphere cuts the plane beside the polygon, the centre before it or behind; the edge or the corner is what it
// meets.
void straddling(CastBuilder& b) {
    ngons(b, 24, 8 * kMetre, 2 * kMetre, kInput, 9);
    const double side = b.rng.chance(0.5) ? 1 : -1;
    for (int k = 0; k < kCasts; ++k) {
        const Place at = b.place(b.rng.chance(0.6) ? Feature::kEdge : Feature::kVertex);
        const double radius = b.magnitude(1e-2, 2), lean = b.rng.uniform() * (b.rng.chance(0.3) ? 1e-6 : 0.9);
        const Vec3 n = b.normal(at.polygon), out = b.outward(at);
        Vec3 away = out + n * (side * lean);
        away = away * (1 / length(away));
        Vec3 way = away * -1 + b.perpendicular_to(away) * b.rng.uniform(0, 2);
        way = way * (1 / length(way));
        b.meet(at.point, away, radius, way, radius * b.rng.uniform(), b.rng.uniform(0, 3));
    }
}

// Past an edge or a corner at just about the radius: a unit in the last place, up to a thousandth.
void graze(CastBuilder& b, Feature feature) {
    ngons(b, 30, 8 * kMetre, 2 * kMetre, kInput, 8);
    for (int k = 0; k < kCasts; ++k) {
        const Place at = b.place(feature);
        const double radius = b.magnitude(1e-3, 2);
        const Vec3 n = b.normal(at.polygon), e = b.edge(at), out = b.outward(at);
        Vec3 away = out + n * b.rng.uniform(-0.9, 0.9);
        if (feature == Feature::kEdge) away = away - e * dot(away, e);
        away = away * (1 / length(away));
        const Vec3 way = b.perpendicular_to(away);
        const double off = b.rng.chance(0.6) ? 0 : b.magnitude(1e-16, 1e-3) * (b.rng.chance(0.5) ? 1 : -1);
        const double before = b.rng.uniform(0, 5), after = b.rng.uniform(0, 5);
        b.add(at.point + away * b.nudged(radius, 2) - way * before, way * (before + after), radius * (1 + off));
    }
}
void graze_edges(CastBuilder& b) {
    graze(b, Feature::kEdge);
}
void graze_corners(CastBuilder& b) {
    graze(b, Feature::kVertex);
}

// Nearly parallel to the face, down to 1e-12.
void shallow(CastBuilder& b) {
    ngons(b, 24, 8 * kMetre, 4 * kMetre, kInput, 8);
    for (int k = 0; k < kCasts; ++k) {
        const Place at = b.any_place();
        const double radius = b.rng.chance(0.4) ? 0 : b.magnitude(1e-3, 2);
        const Vec3 n = b.normal(at.polygon), flat = b.perpendicular_to(n);
        Vec3 way = flat - n * b.magnitude(1e-12, 0.01);
        way = way * (1 / length(way));
        b.meet(at.point, n, radius, way, b.rng.uniform(0, 6), b.rng.uniform(0, 6));
    }
}

// Contact at, just before and just after the end, along the normal or not.
void end_of_path(CastBuilder& b) {
    ngons(b, 24, 8 * kMetre, 2 * kMetre, kInput, 8);
    for (int k = 0; k < kCasts; ++k) {
        const Place at = b.any_place();
        const double radius = b.rng.chance(0.4) ? 0 : b.magnitude(1e-3, 2);
        const Vec3 way = b.rng.direction(), away = b.rng.chance(0.5) ? b.normal(at.polygon) : way * -1;
        const double before = b.rng.uniform(0.1, 8),
                     miss = b.rng.chance(0.5) ? 0 : b.magnitude(1e-16, 1e-3) * (b.rng.chance(0.5) ? 1 : -1);
        b.meet(at.point, away, radius, way, before, b.nudged(miss, 1));
    }
}

// Starts on a face, an edge or a corner, or as near as double can say.
void starts_on(CastBuilder& b) {
    ngons(b, 24, 4 * kMetre, 2 * kMetre, kInput, 8);
    for (int k = 0; k < kCasts; ++k) {
        const Place at = b.any_place();
        const std::vector<Vec3> v = b.corners(at.polygon);
        const Vec3 exact =
            at.feature == Feature::kVertex ? at.point : (v[at.corner] + v[(at.corner + 1) % v.size()]) * 0.5;
        const Vec3 n = b.normal(at.polygon), way = b.rng.chance(0.3) ? b.perpendicular_to(n) : b.rng.direction();
        b.add(at.feature == Feature::kFace ? at.point : exact, way * b.magnitude(1e-9, 10),
              b.rng.chance(0.5) ? 0 : b.magnitude(1e-3, 2));
    }
}

// Each polygon several times, also turned over, some of them two-sided: ties wherever something is met.
void repeated(CastBuilder& b) {
    ngons(b, 8, 4 * kMetre, 3 * kMetre, kInput, 7);
    for (int copy = 0; copy < 3; ++copy)
        for (int k = 0; k < 8; ++k) {
            const GridPolygon polygon = b.scene.polygons[std::size_t(k)];
            b.scene.polygons.push_back(b.rng.chance(0.5) ? polygon : turned_over(polygon));
        }
    for (std::size_t k = 0; k < b.scene.polygons.size(); ++k) b.scene.two_sided.push_back(b.rng.chance(0.3));
    wild_casts(b, 2, 8);
}

// Starts at the place, with a part of the path along an axis of the polygon, so that everything happens at once.
void mixed_scales(CastBuilder& b) {
    triangles(b, 8, 2000 * kMetre, 3000 * kMetre, kInput);
    triangles(b, 8, 4 * kMetre, 3 * kMetre, kInput);
    triangles(b, 8, kMetre / 100, 4 * kInput, 1);
    for (int k = 0; k < kCasts; ++k) {
        const double size = b.magnitude(1e-4, 1e3);
        b.wild(size * b.magnitude(1e-3, 10), size * b.magnitude(0.1, 1e3));
    }
}

template <void (*kMake)(CastBuilder&)>
void with_builder(Rng& rng, CastScene& scene) {
    CastBuilder builder(rng, scene);
    builder.floats = rng.chance(0.3);
    kMake(builder);
}

template <void (*kMake)(CastBuilder&)>
void in_double(Rng& rng, CastScene& scene) {
    CastBuilder builder(rng, scene);
    kMake(builder);
}

/// Moves everything, kilometres away where there is room; the casts' starts are rounded once more.
void move_scene(Rng& rng, CastScene& scene) {
    Steps by = random_steps(rng, 8000 * kMetre);
    by = {by.x / kInput * kInput, by.y / kInput * kInput, by.z / kInput * kInput};
    if (rng.chance(0.3)) by = {by.x, 0, 0};
    for (const GridPolygon& polygon : scene.polygons)
        for (const GridPoint& p : polygon) {
            const Steps to = steps(p) + by;
            if (!all_in_world({&to, 1})) return;
        }
    for (GridPolygon& polygon : scene.polygons)
        for (GridPoint& p : polygon) p = in_world(steps(p) + by);
    for (CastQuery& cast : scene.casts) cast.sphere.centre = cast.sphere.centre + to_metres(by);
}

}  // namespace

const std::vector<CastFamily>& cast_families() {
    static const std::vector<CastFamily> kFamilies = {
        {"generic_triangles", with_builder<generic_triangles>},
        {"generic_ngons", with_builder<generic_ngons>},
        {"surface_grid", with_builder<surface_grid>},
        {"many_corners", with_builder<many_corners>},
        {"collinear_corners", with_builder<collinear_corners>},
        {"terrain", with_builder<terrain>},
        {"fans", with_builder<fans>},
        {"slivers", with_builder<slivers>},
        {"knife_edges", with_builder<knife_edges>},
        {"thin_boxes", with_builder<thin_boxes>},
        {"far_away", with_builder<far_away>},
        {"range_border", with_builder<range_border>},
        {"huge_polygons", with_builder<huge_polygons>},
        {"tiny_polygons", with_builder<tiny_polygons>},
        {"radii", with_builder<radii>},
        {"extreme_radii", in_double<extreme_radii>},
        {"long_paths", with_builder<long_paths>},
        {"short_paths", with_builder<short_paths>},
        {"odd_paths", in_double<odd_paths>},
        {"from_outside", with_builder<from_outside>},
        {"huge_paths", in_double<huge_paths>},
        {"overlapping", with_builder<overlapping>},
        {"receding", with_builder<receding>},
        {"backface", with_builder<backface>},
        {"straddling", with_builder<straddling>},
        {"graze_edges", with_builder<graze_edges>},
        {"graze_corners", with_builder<graze_corners>},
        {"shallow", with_builder<shallow>},
        {"end_of_path", with_builder<end_of_path>},
        {"starts_on", with_builder<starts_on>},
        {"repeated", with_builder<repeated>},
        {"mixed_scales", with_builder<mixed_scales>},
        {"axis_aligned", in_double<axis_aligned>},
        {"parallel", in_double<parallel>},
        {"coplanar", in_double<coplanar>},
        {"lattice", in_double<lattice>},
        {"lattice_of_steps", in_double<lattice_of_steps>},
        {"exact_touch", in_double<exact_touch>},
        {"exact_graze", in_double<exact_graze>},
        {"exact_end", in_double<exact_end>},
        {"sliding", in_double<sliding>},
        {"shared_flat", in_double<shared_flat>},
        {"shared_folded", in_double<shared_folded>},
        {"exact_fractions", in_double<exact_fractions>},
    };
    return kFamilies;
}

CastScene make_cast_scene(const CastFamily& family, std::uint64_t seed, std::uint64_t index) {
    std::uint64_t mixed = 0xCBF29CE484222325ull;  // FNV-1a of the name, so that families do not share their randomness
    for (const char c : family.name) mixed = (mixed ^ std::uint64_t(std::uint8_t(c))) * 0x100000001B3ull;
    Rng seeds(mixed ^ (seed * 0x9E3779B97F4A7C15ull));
    Rng rng(seeds.next() + index * 0xD1B54A32D192ED03ull);
    rng.next();
    CastScene scene;
    family.make(rng, scene);
    if (rng.chance(0.2)) move_scene(rng, scene);
    return scene;
}

}  // namespace firma::scenes
