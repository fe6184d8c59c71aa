// SPDX-License-Identifier: MIT
// Families that are about the mover.
#include "scenes/motion_families.h"

#include <cmath>
#include <cstdlib>

#include "scenes/cast_builder.h"

namespace firma::scenes {

namespace {

// Past an edge or a corner at just about the radius: a unit in the last place, up to a thousandth.
void graze(CastBuilder& b, Feature feature) {
    b.ngons(30, 8 * kMetre, 2 * kMetre, kInput, 8);
    for (int k = 0; k < kCastsAScene; ++k) {
        const Place at = b.place(feature);
        const double radius = b.magnitude(1e-3, 2);
        const Vec3 n = b.normal(at.polygon), e = b.edge(at), out = b.outward(at);
        Vec3 away = out + n * b.rng.uniform(-0.9, 0.9);
        if (feature == Feature::kEdge) away = away - e * dot(away, e);
        away = away * (1 / length(away));
        const Vec3 way = b.perpendicular_to(away);
        double off = b.rng.chance(0.6) ? 0 : b.magnitude(1e-16, 1e-3);
        if (b.rng.chance(0.5)) off = -off;
        const double before = b.rng.uniform(0, 5), after = b.rng.uniform(0, 5);
        b.add(at.point + away * b.nudged(radius, 2) - way * before, way * (before + after), radius * (1 + off));
    }
}

}  // namespace

void radii(CastBuilder& b) {
    b.triangles(20, 6 * kMetre, 3 * kMetre, kInput);
    b.ngons(10, 6 * kMetre, 3 * kMetre, kInput, 8);
    const double least = b.rng.chance(0.5) ? 1e-6 : b.rng.chance(0.5) ? 1e-3 : 1000;
    for (int k = 0; k < kCastsAScene; ++k) {
        const Place at = b.any_place();
        const double radius = least * b.rng.uniform(0.5, 1.5);
        const Vec3 way = b.rng.direction(), away = b.rng.chance(0.5) ? b.normal(at.polygon) : way * -1;
        const double before = b.rng.uniform(0, 10);
        const double after = b.rng.uniform(0, 10);
        b.meet(at.point, away, radius, way, before, after);
    }
}

void extreme_radii(CastBuilder& b) {
    b.triangles(20, 6 * kMetre, 3 * kMetre, kInput);
    for (int k = 0; k < kCastsAScene; ++k) {
        const Place at = b.any_place();
        const double radius = b.rng.chance(0.3)   ? b.magnitude(1e-11, 1e-6)
                              : b.rng.chance(0.2) ? b.magnitude(1e-320, 1e-20)
                                                  : b.magnitude(1e3, 1e6);
        const Vec3 way = b.rng.direction(), away = b.rng.chance(0.5) ? b.normal(at.polygon) : way * -1;
        const double before = b.rng.uniform(0, 10);
        const double after = b.rng.uniform(0, 10);
        b.meet(at.point, away, radius, way, before, after);
    }
}

void long_paths(CastBuilder& b) {
    b.triangles(20, 6 * kMetre, 3 * kMetre, kInput);
    b.ngons(10, 6 * kMetre, 3 * kMetre, kInput, 8);
    for (int k = 0; k < kCastsAScene; ++k) {
        const Place at = b.any_place();
        const Vec3 way = b.rng.direction();
        const double radius = b.rng.chance(0.4) ? 0 : b.magnitude(1e-3, 5);
        const Vec3 away = b.rng.chance(0.5) ? way * -1 : b.rng.direction();
        const double before = b.rng.uniform(0, 1e4);
        const double after = b.rng.uniform(0, 1e4);
        b.meet(at.point, away, radius, way, before, after);
    }
}

void short_paths(CastBuilder& b) {
    b.triangles(20, 6 * kMetre, 3 * kMetre, kInput);
    b.ngons(10, 6 * kMetre, 3 * kMetre, kInput, 8);
    const double size = b.rng.chance(0.5) ? 1e-6 : b.rng.chance(0.5) ? 1e-9 : 1e-12;
    for (int k = 0; k < kCastsAScene; ++k) {
        const Place at = b.any_place();
        const Vec3 way = b.rng.direction(), away = b.rng.chance(0.5) ? b.normal(at.polygon) : way * -1;
        const double radius = b.rng.chance(0.4) ? 0 : b.magnitude(1e-3, 2);
        const double before = size * b.rng.uniform(-0.3, 1.3);
        const double after = size * b.rng.uniform(0, 1);
        b.meet(at.point, away, radius, way, before, after);
    }
}

void odd_paths(CastBuilder& b) {
    b.triangles(20, 4 * kMetre, 3 * kMetre, kInput);
    b.ngons(10, 4 * kMetre, 3 * kMetre, kInput, 8);
    const double sizes[] = {
        0.0, -0.0, 4.9406564584124654e-324, -1e-310, 1e-300, 1e-200, -1e-100, 1e-70, -1e-38, 1e-30, 1e-20, 1, -5};
    for (int k = 0; k < kCastsAScene; ++k) {
        const Place at = b.any_place();
        const double radius = b.rng.chance(0.3) ? 0 : b.magnitude(1e-3, 2);
        const Vec3 aside = b.rng.direction();
        const Vec3 start = at.point + aside * (radius * b.rng.uniform(0, 1.2));
        const bool all_small = b.rng.chance(0.6);
        Vec3 path;
        for (int axis = 0; axis < 3; ++axis) {
            path[axis] = sizes[b.rng.below(all_small ? 11 : 13)];
            if (b.rng.chance(0.5)) path[axis] *= b.rng.uniform(-1, 1);
        }
        b.add(start, path, radius);
    }
}

void from_outside(CastBuilder& b) {
    const Steps centre = random_steps(b.rng, b.rng.chance(0.5) ? 8000 * kMetre : 8 * kMetre);
    b.triangles(15, 6 * kMetre, 3 * kMetre, kInput, centre);
    b.triangles(10, 0, 8192 * kMetre, kInput);
    for (int k = 0; k < kCastsAScene; ++k) {
        const Place at = b.any_place();
        const Vec3 way = b.rng.direction();
        const double radius = b.rng.chance(0.4) ? 0 : b.magnitude(1e-3, 1000);
        const double before = b.magnitude(1e4, b.rng.chance(0.7) ? 1e6 : 1e9),
                     after = b.rng.chance(0.5) ? before : b.rng.uniform(0, 100);
        b.meet(at.point, way * -1, radius, way, before, after);
    }
}

void huge_paths(CastBuilder& b) {
    b.triangles(12, 6 * kMetre, 3 * kMetre, kInput);
    b.triangles(6, 0, 8192 * kMetre, kInput);
    for (int k = 0; k < kCastsAScene; ++k) {
        const Place at = b.any_place();
        const Vec3 way = b.rng.direction();
        const double radius = b.rng.chance(0.5) ? 0 : b.magnitude(1e-3, 1000);
        const double after = b.rng.chance(0.7) ? b.magnitude(1e6, 1e12) : b.magnitude(1e12, 0x1p198);
        b.meet(at.point, way * -1, radius, way, b.rng.uniform(0, 100), after);
    }
}

void overlapping(CastBuilder& b) {
    b.triangles(12, 2 * kMetre, 2 * kMetre, kInput);
    b.ngons(12, 2 * kMetre, 2 * kMetre, kInput, 9);
    for (int k = 0; k < kCastsAScene; ++k) {
        const Place at = b.any_place();
        const double radius = b.magnitude(1e-3, 4);
        const Vec3 aside = b.rng.direction();
        const Vec3 start = at.point + aside * (radius * b.rng.uniform());
        const Vec3 way = b.rng.direction();
        b.add(start, way * b.magnitude(1e-3, 10), radius);
    }
}

void receding(CastBuilder& b) {
    b.ngons(24, 8 * kMetre, 2 * kMetre, kInput, 9);
    for (int k = 0; k < kCastsAScene; ++k) {
        const Place at = b.any_place();
        const double radius = b.rng.chance(0.4) ? 0 : b.magnitude(1e-3, 1);
        const Vec3 n = b.normal(at.polygon), way = b.rng.direction();
        const double nudged = b.nudged(radius, 1);
        const double before = b.rng.uniform(-0.1, 0.1);
        const double after = b.rng.uniform(0, 5);
        b.meet(at.point, n, nudged, dot(way, n) < 0 ? way * -1 : way, before, after);
    }
}

void backface(CastBuilder& b) {
    b.ngons(24, 8 * kMetre, 2 * kMetre, kInput, 9);
    for (int k = 0; k < kCastsAScene; ++k) {
        const Place at = b.any_place();
        const double radius = b.rng.chance(0.4) ? 0 : b.magnitude(1e-3, 1);
        const Vec3 n = b.normal(at.polygon), way = b.rng.direction();
        const double before = b.rng.uniform(0, 5);
        const double after = b.rng.uniform(0, 5);
        b.meet(at.point, n * -1, radius, dot(way, n) < 0 ? way * -1 : way, before, after);
    }
}

void straddling(CastBuilder& b) {
    b.ngons(24, 8 * kMetre, 2 * kMetre, kInput, 9);
    const double side = b.rng.chance(0.5) ? 1 : -1;
    for (int k = 0; k < kCastsAScene; ++k) {
        const Place at = b.place(b.rng.chance(0.6) ? Feature::kEdge : Feature::kVertex);
        const double radius = b.magnitude(1e-2, 2), most = b.rng.chance(0.3) ? 1e-6 : 0.9,
                     lean = b.rng.uniform(0, most);
        const Vec3 n = b.normal(at.polygon), out = b.outward(at);
        Vec3 away = out + n * (side * lean);
        away = away * (1 / length(away));
        const Vec3 across = b.perpendicular_to(away);
        Vec3 way = across * b.rng.uniform(0, 2) - away;
        way = way * (1 / length(way));
        const double before = radius * b.rng.uniform();
        const double after = b.rng.uniform(0, 3);
        b.meet(at.point, away, radius, way, before, after);
    }
}

void graze_edges(CastBuilder& b) {
    graze(b, Feature::kEdge);
}

void graze_corners(CastBuilder& b) {
    graze(b, Feature::kVertex);
}

void shallow(CastBuilder& b) {
    b.ngons(24, 8 * kMetre, 4 * kMetre, kInput, 8);
    for (int k = 0; k < kCastsAScene; ++k) {
        const Place at = b.any_place();
        const double radius = b.rng.chance(0.4) ? 0 : b.magnitude(1e-3, 2);
        const Vec3 n = b.normal(at.polygon), flat = b.perpendicular_to(n);
        Vec3 way = flat - n * b.magnitude(1e-12, 0.01);
        way = way * (1 / length(way));
        const double before = b.rng.uniform(0, 6);
        const double after = b.rng.uniform(0, 6);
        b.meet(at.point, n, radius, way, before, after);
    }
}

void end_of_path(CastBuilder& b) {
    b.ngons(24, 8 * kMetre, 2 * kMetre, kInput, 8);
    for (int k = 0; k < kCastsAScene; ++k) {
        const Place at = b.any_place();
        const double radius = b.rng.chance(0.4) ? 0 : b.magnitude(1e-3, 2);
        const Vec3 way = b.rng.direction(), away = b.rng.chance(0.5) ? b.normal(at.polygon) : way * -1;
        const double before = b.rng.uniform(0.1, 8), far = b.rng.chance(0.5) ? 0 : b.magnitude(1e-16, 1e-3),
                     miss = b.rng.chance(0.5) ? far : -far;
        b.meet(at.point, away, radius, way, before, b.nudged(miss, 1));
    }
}

void starts_on(CastBuilder& b) {
    b.ngons(24, 4 * kMetre, 2 * kMetre, kInput, 8);
    for (int k = 0; k < kCastsAScene; ++k) {
        const Place at = b.any_place();
        const std::vector<Vec3> v = b.corners(at.polygon);
        const Vec3 exact =
            at.feature == Feature::kVertex ? at.point : (v[at.corner] + v[(at.corner + 1) % v.size()]) * 0.5;
        const Vec3 n = b.normal(at.polygon), way = b.rng.chance(0.3) ? b.perpendicular_to(n) : b.rng.direction();
        const Vec3 path = way * b.magnitude(1e-9, 10);
        const double radius = b.rng.chance(0.5) ? 0 : b.magnitude(1e-3, 2);
        b.add(at.feature == Feature::kFace ? at.point : exact, path, radius);
    }
}

}  // namespace firma::scenes
