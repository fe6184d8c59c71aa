// SPDX-License-Identifier: MIT
// Capsules against polygons, judged.
#include <cmath>
#include <cstdio>
#include <vector>

#include "cast/cast_capsule_polygon.h"
#include "firma/capsule.h"
#include "scenes/grid_polygons.h"
#include "tests/reference/exact_capsule.h"
#include "tests/reference/judge_shapes.h"
#include "tests/reference/surely_apart.h"

namespace firma::reference {
namespace {

using scenes::Rng;

struct CapsuleScene {
    Capsule capsule;
    std::vector<Vec3> polygon;
    Vec3 path;
    Sides sides = Sides::kFront;
};

/// How scenes are made.
struct CapsuleKind {
    bool lattice;     ///< all numbers are small multiples of `step`: touches and parallels are exact
    double step;      ///< metres
    double away;      ///< from the origin, metres
    double thinness;  ///< of the radius
    enum Way { kAny, kToFace, kAlongSide, kNearlyToFace, kThrough } way = kAny;
};

Vec3 on_lattice(Rng& rng, int reach, double step) {
    const auto one = [&] { return (double(rng.below(std::uint32_t(2 * reach + 1))) - reach) * step; };
    return {one(), one(), one()};
}

/// Of whole length, so that a radius may fit it exactly.
constexpr Vec3 kWholeWays[] = {{3, 4, 0},  {0, 3, -4}, {-4, 0, 3}, {1, 2, 2}, {-2, 1, 2},
                               {2, -2, 1}, {1, 0, 0},  {0, 1, 0},  {0, 0, 1}};

CapsuleScene make_capsule_scene(Rng& rng, const CapsuleKind& kind) {
    CapsuleScene scene;
    const std::int64_t input = std::int64_t(std::llround(kind.step * scenes::kMetre));
    const scenes::Steps middle = scenes::random_steps(rng, std::int64_t(kind.away * scenes::kMetre) / input) * input;
    scene.polygon =
        scenes::to_metres(rng.chance(0.6) ? scenes::random_triangle(rng, middle, 3 * input, input)
                                          : scenes::random_polygon(rng, middle, 3 * input, input, 8, rng.chance(0.3)));
    const std::size_t k = rng.below(std::uint32_t(scene.polygon.size()));
    const Vec3 here = scene.polygon[k], side = scene.polygon[(k + 1) % scene.polygon.size()] - here;
    const Vec3 other = scene.polygon[(k + 2) % scene.polygon.size()] - here;
    scene.sides = rng.chance(0.5) ? Sides::kBoth : Sides::kFront;

    Vec3 start, s, to;
    double r = 0;
    if (kind.lattice) {
        start = here + on_lattice(rng, 5, kind.step);
        s = on_lattice(rng, 4, kind.step);
        to = on_lattice(rng, 5, kind.step) * (rng.chance(0.2) ? 2 : 1);
        r = double(1 + rng.below(6)) * kind.step * (rng.chance(0.3) ? 0.5 : 1);
        if (rng.chance(0.3)) {  // r away from a corner or a point of the side, exactly
            const Vec3 way = kWholeWays[rng.below(9)] * kind.step;
            start = here + side * (0.25 * double(rng.below(5))) + way +
                    on_lattice(rng, 2, kind.step) * (rng.chance(0.5) ? 1 : 0);
            r = length(way);
        }
        if (rng.chance(0.4)) to = here + on_lattice(rng, 2, kind.step) - start;
        if (rng.chance(0.2)) to = kWholeWays[rng.below(9)] * (kind.step * (double(rng.below(5)) - 2));
    } else {
        start = here + rng.direction() * rng.uniform(0, 7) * kind.step;
        s = rng.direction() * rng.uniform(0, 4) * kind.step;
        r = rng.uniform(0.05, 1.5) * kind.step;
        const Vec3 at = here + rng.direction() * rng.uniform(0, 4) * kind.step;
        to = (at - start) * rng.uniform(0, 3);
        if (rng.chance(0.1)) to[int(rng.below(3))] = 0;
    }
    const double part = 0.25 * (double(rng.below(9)) - 4), more = 0.25 * (double(rng.below(9)) - 4);
    switch (kind.way) {
        case CapsuleKind::kAny:
            break;
        case CapsuleKind::kToFace:
            s = side * part + other * more;
            if (rng.chance(0.4)) to = side * more + other * part;
            break;
        case CapsuleKind::kAlongSide:
            s = side * (rng.chance(0.2) ? 0x1p-20 : part);
            if (rng.chance(0.4)) to = side * more;
            break;
        case CapsuleKind::kNearlyToFace:
            s = side * part + other * (rng.chance(0.5) ? more : 0) +
                rng.direction() * (kind.step * std::pow(2.0, -double(rng.below(60))));
            if (rng.chance(0.3)) to = s * rng.uniform(-2, 2);
            break;
        case CapsuleKind::kThrough: {
            const Vec3 inside = here + side * (0.25 * double(rng.below(4))) + other * (0.125 * double(rng.below(4)));
            if (s == Vec3{}) s = {kind.step, 0, 0};
            start = inside - s * (0.25 * double(rng.below(5)));
            break;
        }
    }
    scene.capsule = Capsule(start, start + s, r * kind.thinness);
    scene.path = to;
    return scene;
}

std::string described(const CapsuleScene& scene) {
    char line[160];
    std::string text = scene.sides == Sides::kBoth ? "both sides\n" : "front\n";
    const auto add = [&](const char* name, const Vec3& v) {
        std::snprintf(line, sizeof line, "%s %a %a %a\n", name, v.x, v.y, v.z);
        text += line;
    };
    for (const Vec3& v : scene.polygon) add("polygon", v);
    add("from", scene.capsule.from);
    add("to", scene.capsule.to);
    add("path", scene.path);
    std::snprintf(line, sizeof line, "radius %a\n", scene.capsule.radius);
    return text + line;
}

double from_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
    const Vec3 ab = b - a;
    const double square = dot(ab, ab), along = square > 0 ? dot(p - a, ab) / square : 0;
    return length(p - (a + ab * std::fmin(1, std::fmax(0, along))));
}

/// What is wrong with a touch whose status is right; empty: nothing.
std::string wrong_with(const CapsuleScene& scene, const PolygonHit& hit, const ExactCapsuleCast& exact,
                       const CapsuleExpected& expected) {
    const Capsule& capsule = scene.capsule;
    const double size = 1 + max_abs(capsule.from) * 1e-3, tolerance = 1e-9 * size, long_path = length(scene.path);
    if (hit.status == Status::kHit) {
        const double exactly = nearest(Ratio{expected.at.floor_times(Integer(1) << 200), Integer(1) << 200});
        if (!(hit.fraction > 0 && hit.fraction <= 1)) return "a fraction out of range";
        if (!(std::fabs(hit.fraction - exactly) * long_path <= tolerance)) return "another fraction";
        if (!(std::fabs(exact.gap_at(hit.fraction)) <= 1e-3 * tolerance + 0x1p-50 * long_path))
            return "a gap, or an overlap";
    } else if (hit.fraction != 0) {
        return "an overlap not at the start";
    }
    if (!(std::fabs(length(hit.normal) - 1) <= 1e-12)) return "a normal that is not unit";
    const Vec3 travelled = scene.path * hit.fraction;
    const Vec3 middle = capsule.from * 0.5 + capsule.to * 0.5;
    if (!(length(hit.centre - (middle + travelled)) <= tolerance)) return "another centre";
    const double scale = length(capsule.to - capsule.from) + length(hit.point - capsule.from);
    const Vec3 away = exact.away_at(hit.fraction);
    const double distance = expected.segment_meets ? 0 : exact.gap_at(hit.fraction) + capsule.radius;
    if (expected.segment_meets) {
        bool among = expected.ways.empty();
        for (const Vec3& way : expected.ways) among = among || length(way - hit.normal) <= 1e-9;
        if (!among && expected.doubt > 1e-12) return "a normal that is no nearest way out";
    } else if (distance > 1e-5 * size &&
               !(length(hit.normal - away) <= 1e-12 * size / distance + 1e-7 * std::sqrt(1 + scale / distance))) {
        // Distances that are equal to rounding may belong to ways that differ by the root of that.
        return "another normal";
    }
    if (!(closest_point(hit.point, scene.polygon).distance <= tolerance)) return "a point off the polygon";
    if (!(std::fabs(from_segment(hit.point, capsule.from + travelled, capsule.to + travelled) - distance) <= tolerance))
        return "a point that is not the nearest " + std::to_string(distance) + " " + std::to_string(hit.fraction);
    const std::size_t count = scene.polygon.size(), k = hit.feature_index;
    if (k >= count) return "a feature that is not there";
    if (hit.feature == Feature::kVertex && !(length(hit.point - scene.polygon[k]) <= tolerance))
        return "another vertex";
    if (hit.feature == Feature::kEdge && !expected.segment_meets &&
        !(from_segment(hit.point, scene.polygon[k], scene.polygon[(k + 1) % count]) <= tolerance))
        return "another edge";
    return {};
}

bool same_hit(const PolygonHit& a, const PolygonHit& b) {
    return a.status == b.status && a.feature == b.feature && a.feature_index == b.feature_index &&
           a.fraction == b.fraction && a.centre == b.centre && a.point == b.point && a.normal == b.normal &&
           a.face_normal == b.face_normal;
}

void judge_capsule(const CapsuleScene& scene, ShapeTally& tally) {
    const Capsule& capsule = scene.capsule;
    const Sphere around = ball_around(capsule);
    const PolygonShape polygon = make_shape(scene.polygon);
    const CapsuleShape shape = shape_of_capsule(capsule);
    firma::Sweep sweep;
    Contact found;
    CastCounts counts;
    const bool goes = make_sweep(around, scene.path, sweep) == Status::kHit;
    if (goes) found = cast_capsule_polygon(sweep, shape, polygon, scene.sides, sweep.end, &counts);
    ++tally.casts;
    tally.precise += counts.precise;
    const Status status = found.status;
    tally.hits += status == Status::kHit;
    tally.overlaps += status == Status::kInitialOverlap;
    tally.misses += status == Status::kMiss;
    if (shape.is_sphere()) {
        const PolygonHit one = cast_polygon(capsule, scene.path, scene.polygon, scene.sides);
        const Sphere sphere{capsule.from, capsule.radius};
        if (!same_hit(one, cast_polygon(sphere, scene.path, scene.polygon, scene.sides)))
            return tally.fail("not what the sphere says\n" + described(scene));
    }
    if (status == Status::kMiss &&
        surely_apart(Hull(scene.polygon), around.centre, scene.path, 1, around.radius * (1 + 0x1p-40)))
        return;
    const ExactCapsuleCast exact(capsule, scene.path, scene.polygon);
    const CapsuleExpected expected = exact.expect(scene.sides);
    const double size = 1 + max_abs(capsule.from) * 1e-3;
    if (status != expected.status) {
        // Rounding in double-double may take a graze, a touch at the start, or one of two ways out that are as near,
        // for the other. What a segment alone meets on its way is decided exactly.
        const double rounding = 1e-13 * size, gap = exact.gap_at(0);
        const bool at_start = std::fabs(gap) < rounding || std::fabs(gap + capsule.radius) < rounding;
        const bool graze = capsule.radius > 0 && std::fabs(exact.margin()) < rounding;
        const bool neither = gap < 0 && std::fabs(dot(exact.away_at(0), scene.path)) < rounding;  // closer nor away
        const bool forgiven = expected.segment_meets ? expected.doubt < rounding : at_start || graze || neither;
        if (forgiven) {
            ++tally.excused;
            return;
        }
        return tally.fail("status " + std::to_string(int(status)) + " for " + std::to_string(int(expected.status)) +
                          ", margin " + std::to_string(exact.margin()) + "\n" + described(scene));
    }
    if (status == Status::kMiss) return;
    const std::string fault = wrong_with(scene, make_capsule_hit(sweep, shape, polygon, found), exact, expected);
    if (!fault.empty()) tally.fail(fault + "\n" + described(scene));
}

template <CapsuleKind kind>
void judge_kind(Rng& rng, ShapeTally& tally) {
    judge_capsule(make_capsule_scene(rng, kind), tally);
}

template <bool lattice>
void judge_spheres(Rng& rng, ShapeTally& tally) {
    CapsuleScene scene = make_capsule_scene(rng, {lattice, 0.25, 4, rng.chance(0.2) ? 0.0 : 1.0});
    scene.capsule.to = scene.capsule.from;
    judge_capsule(scene, tally);
}

constexpr ShapeFamily kCapsuleFamilies[] = {
    {"Lattice", judge_kind<CapsuleKind{true, 0.25, 0, 1}>},
    {"LatticeFarAway", judge_kind<CapsuleKind{true, 0x1p-10, 8000, 1}>},
    {"Anywhere", judge_kind<CapsuleKind{false, 1, 10, 1}>},
    {"FarAway", judge_kind<CapsuleKind{false, 1, 8000, 1}>},
    {"Small", judge_kind<CapsuleKind{false, 0x1p-8, 100, 1}>},
    {"Large", judge_kind<CapsuleKind{false, 500, 4000, 1}>},
    {"ParallelToThePlane", judge_kind<CapsuleKind{true, 0.25, 4, 1, CapsuleKind::kToFace}>},
    {"ParallelAnywhere", judge_kind<CapsuleKind{false, 0.5, 4, 1, CapsuleKind::kToFace}>},
    {"AlongSides", judge_kind<CapsuleKind{true, 0.25, 4, 1, CapsuleKind::kAlongSide}>},
    {"AlongSidesAnywhere", judge_kind<CapsuleKind{false, 0.5, 4, 1, CapsuleKind::kAlongSide}>},
    {"NearlyParallel", judge_kind<CapsuleKind{false, 0.5, 4, 1, CapsuleKind::kNearlyToFace}>},
    {"NearlyParallelOnALattice", judge_kind<CapsuleKind{true, 0.5, 4, 1, CapsuleKind::kNearlyToFace}>},
    {"ThroughThePolygon", judge_kind<CapsuleKind{true, 0.25, 4, 1, CapsuleKind::kThrough}>},
    {"ThroughAnywhere", judge_kind<CapsuleKind{false, 0.5, 4, 1, CapsuleKind::kThrough}>},
    {"Thin", judge_kind<CapsuleKind{false, 0.5, 4, 1e-7}>},
    {"NearRounding", judge_kind<CapsuleKind{false, 0.5, 4, 1e-14}>},
    {"Segments", judge_kind<CapsuleKind{true, 0.25, 4, 0}>},
    {"SegmentsInThePlane", judge_kind<CapsuleKind{true, 0.25, 4, 0, CapsuleKind::kToFace}>},
    {"SegmentsAnywhere", judge_kind<CapsuleKind{false, 0.5, 4, 0}>},
    {"Spheres", judge_spheres<true>},
    {"SpheresAnywhere", judge_spheres<false>},
};

}  // namespace

std::span<const ShapeFamily> capsule_families() {
    return kCapsuleFamilies;
}

}  // namespace firma::reference
