// SPDX-License-Identifier: MIT
// Hulls against polygons, judged by the exact oracle: on lattices, where all ties there are come up, and anywhere.
#include <gtest/gtest.h>

#include <string>

#include "cast/cast_hull_polygon.h"
#include "cast/make_hull_hit.h"
#include "scenes/grid_polygons.h"
#include "tests/reference/exact_hull.h"

// As many as suits a quick test; -DFIRMA_HULL_CASTS=100000 for more.
#ifndef FIRMA_HULL_CASTS
#define FIRMA_HULL_CASTS 400
#endif

namespace {

using namespace firma;
using namespace firma::reference;
using scenes::Rng;

/// How scenes are made.
struct HullScenes {
    const char* name;
    bool lattice;     ///< all numbers are small multiples of `step`: touches and parallels are exact
    double step;      ///< metres
    double away;      ///< from the origin, metres
    bool box;         ///< a box, turned unless on a lattice; else a hull of 4 to 10 points
    double flatness;  ///< of the third axis
};

struct HullScene {
    std::vector<Vec3> corners, polygon;
    Vec3 start, path;
    Sides sides = Sides::kFront;
};

Vec3 lattice_point(Rng& rng, int reach, double step) {
    const auto one = [&] { return (double(rng.below(std::uint32_t(2 * reach + 1))) - reach) * step; };
    return {one(), one(), one()};
}

HullScene make_hull_scene(Rng& rng, const HullScenes& kind) {
    HullScene scene;
    const std::int64_t input = std::int64_t(std::llround(kind.step * scenes::kMetre));
    const scenes::Steps middle = scenes::random_steps(rng, std::int64_t(kind.away * scenes::kMetre) / input) * input;
    const scenes::GridPolygon polygon = rng.chance(0.6)
                                            ? scenes::random_triangle(rng, middle, 3 * input, input)
                                            : scenes::random_polygon(rng, middle, 3 * input, input, 8, rng.chance(0.3));
    scene.polygon = scenes::to_metres(polygon);
    const Vec3 here = scene.polygon[rng.below(std::uint32_t(scene.polygon.size()))];
    scene.sides = rng.chance(0.5) ? Sides::kBoth : Sides::kFront;
    if (kind.box) {
        const Vec3 half = kind.lattice
                              ? Vec3{1, 1, 1} * kind.step + lattice_point(rng, 1, kind.step / 2)
                              : Vec3{rng.uniform(0.2, 2), rng.uniform(0.2, 2), rng.uniform(0.2, 2)} * kind.step;
        Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
        if (!kind.lattice) {
            x = rng.direction();
            const Vec3 aside = cross(x, rng.direction());
            y = aside * (1 / length(aside));
            z = cross(x, y);
        }
        for (int k = 0; k < 8; ++k)
            scene.corners.push_back(x * (k & 1 ? half.x : -half.x) + y * (k & 2 ? half.y : -half.y) +
                                    z * ((k & 4 ? half.z : -half.z) * kind.flatness));
    } else {
        const int count = 4 + int(rng.below(7));
        for (int k = 0; k < count; ++k) {
            Vec3 o = kind.lattice ? lattice_point(rng, 2, kind.step) : rng.direction() * (2 * kind.step);
            o.z *= kind.flatness;
            scene.corners.push_back(o);
        }
    }
    if (kind.lattice) {
        scene.start = here + lattice_point(rng, 5, kind.step);
        scene.path = lattice_point(rng, 5, kind.step) * (rng.chance(0.2) ? 2 : 1);
    } else {
        scene.start = here + rng.direction() * rng.uniform(0, 6) * kind.step;
        const Vec3 at = here + rng.direction() * rng.uniform(0, 4) * kind.step;
        scene.path = (at - scene.start) * rng.uniform(0, 3);
        if (rng.chance(0.1)) scene.path[int(rng.below(3))] = 0;
    }
    return scene;
}

std::string described(const HullScene& scene) {
    char line[160];
    std::string text = scene.sides == Sides::kBoth ? "both sides\n" : "front\n";
    const auto add = [&](const char* name, const Vec3& v) {
        std::snprintf(line, sizeof line, "%s %a %a %a\n", name, v.x, v.y, v.z);
        text += line;
    };
    for (const Vec3& v : scene.polygon) add("polygon", v);
    for (const Vec3& v : scene.corners) add("hull", v);
    add("start", scene.start);
    add("path", scene.path);
    return text;
}

struct HullTally {
    int casts = 0, hits = 0, overlaps = 0, misses = 0, precise = 0, excused = 0;
};

void judge_hull(const HullScene& scene, HullTally& tally) {
    const Result<HullShape> hull = shape_of_hull(scene.corners);
    if (!hull.ok()) return;  // flat
    Sweep sweep;
    const PolygonShape polygon = make_shape(scene.polygon);
    HullContact found;
    CastCounts counts;
    if (make_sweep({scene.start, hull.value().reach}, scene.path, sweep) == Status::kHit)
        found = cast_hull_polygon(sweep, hull.value(), polygon, scene.sides, sweep.end, &counts);
    ++tally.casts;
    tally.precise += int(counts.precise);
    const ExactHullCast exact(scene.corners, scene.start, scene.path, scene.polygon);
    const HullExpected expected = exact.expect(scene.sides);
    const double size = 1 + max_abs(scene.start) * 1e-3, tolerance = 1e-9 * size;
    const Status status = found.contact.status;
    if (status != expected.status) {
        // The nearest of facets, in an overlap, is found by rounded depths. Nothing else is forgiven.
        const bool overlap = expected.doubt < 1e-12 && status != Status::kHit && expected.status != Status::kHit;
        const bool at_once =
            status == Status::kInitialOverlap && expected.status == Status::kHit && nearest(expected.at) < 1e-300;
        if (overlap || at_once) {
            ++tally.excused;
            return;
        }
        FAIL() << "status " << int(status) << " for " << int(expected.status) << " at " << nearest(expected.at) << "\n"
               << described(scene);
    }
    tally.hits += status == Status::kHit;
    tally.overlaps += status == Status::kInitialOverlap;
    tally.misses += status == Status::kMiss;
    if (status == Status::kMiss) return;

    const PolygonHit hit = make_hull_hit(sweep, hull.value(), polygon, found);
    const double long_path = length(scene.path);
    if (status == Status::kHit) {
        const double exactly = nearest(expected.at);
        EXPECT_GT(hit.fraction, 0) << described(scene);
        EXPECT_LE(hit.fraction, 1) << described(scene);
        EXPECT_NEAR(hit.fraction * long_path, exactly * long_path, tolerance) << described(scene);
        EXPECT_NEAR(exact.gap_at(hit.fraction), 0, tolerance) << described(scene);
    } else {
        EXPECT_EQ(hit.fraction, 0);
    }
    EXPECT_NEAR(length(hit.normal), 1, 1e-12) << described(scene);
    double best = INFINITY;
    for (const Vec3& normal : expected.normals) best = std::fmin(best, length(hit.normal - normal));
    // Facets that are entered nearly at once may stand for each other: then the hull is in touch along the other, too.
    if (best > 1e-9) {
        ++tally.excused;
        const Vec3 centre = scene.start + scene.path * hit.fraction;
        double lowest = INFINITY, highest = -INFINITY;
        for (const Vec3& o : scene.corners)
            lowest = std::fmin(lowest, dot(hit.normal, (centre - scene.polygon[0]) + o));
        for (const Vec3& v : scene.polygon) highest = std::fmax(highest, dot(hit.normal, v - scene.polygon[0]));
        if (status == Status::kHit)
            EXPECT_NEAR(lowest, highest, tolerance) << described(scene);
        else
            EXPECT_LT(expected.doubt, 1e-12) << described(scene);
    }
    const ClosestPoint on_it = closest_point(hit.point, scene.polygon);
    EXPECT_LT(on_it.distance, tolerance) << described(scene);
    if (hit.feature == Feature::kVertex) {
        EXPECT_LT(length(hit.point - scene.polygon[hit.feature_index]), tolerance) << described(scene);
    }
    if (hit.feature == Feature::kEdge) {
        const Vec3 &a = scene.polygon[hit.feature_index],
                   &b = scene.polygon[(hit.feature_index + 1) % scene.polygon.size()];
        const double along = std::fmin(1, std::fmax(0, dot(hit.point - a, b - a) / dot(b - a, b - a)));
        EXPECT_LT(length(hit.point - (a + (b - a) * along)), tolerance) << described(scene);
    }
    if (status == Status::kHit) {  // the point is of the hull, too: a hull of one point, at rest
        for (const HullShape::Triangle& t : hull.value().triangles) {
            const Vec3 from = hit.point - (hit.centre + hull.value().corners[t.corner[0]]);
            const double noise =
                t.error.x * std::fabs(from.x) + t.error.y * std::fabs(from.y) + t.error.z * std::fabs(from.z);
            EXPECT_LT(dot(from, t.normal), tolerance * length(t.normal) + noise) << described(scene);
        }
    }
}

constexpr HullScenes kHullScenes[] = {
    {"BoxesOnALattice", true, 0.25, 0, true, 1},
    {"HullsOnALattice", true, 0.25, 0, false, 1},
    {"HullsOnALatticeFarAway", true, 0x1p-18, 8000, false, 1},
    {"BoxesAnywhere", false, 1, 10, true, 1},
    {"HullsAnywhere", false, 1, 10, false, 1},
    {"FarAway", false, 1, 8000, true, 1},
    {"Tiny", false, 0x1p-12, 100, false, 1},
    {"Large", false, 500, 4000, true, 1},
    {"FlatBoxes", false, 1, 10, true, 1e-9},
    {"FlatHulls", false, 1, 100, false, 1e-7},
};

class HullCasts : public testing::TestWithParam<HullScenes> {};

TEST_P(HullCasts, AreWhatTheOracleSays) {
    HullTally tally;
    Rng rng(17);
    for (int k = 0; k < FIRMA_HULL_CASTS && !HasFailure(); ++k) judge_hull(make_hull_scene(rng, GetParam()), tally);
    RecordProperty("casts", tally.casts);
    std::printf("%s: %d casts, %d hits, %d overlaps, %d misses, %d decided exactly, %d excused\n", GetParam().name,
                tally.casts, tally.hits, tally.overlaps, tally.misses, tally.precise, tally.excused);
    EXPECT_GT(tally.hits, tally.casts / 50);
    EXPECT_GT(tally.misses, tally.casts / 50);
    EXPECT_GT(tally.overlaps, 0);
    EXPECT_LE(tally.excused, tally.casts / 20);
}

INSTANTIATE_TEST_SUITE_P(Families, HullCasts, testing::ValuesIn(kHullScenes),
                         [](const auto& of) { return std::string(of.param.name); });

TEST(HullShapes, AreClosedAndHoldAllPoints) {
    Rng rng(5);
    for (int k = 0; k < 300; ++k) {
        std::vector<Vec3> points;
        const std::uint32_t count = 4 + rng.below(61);
        for (std::uint32_t i = 0; i < count; ++i)
            points.push_back(k % 3 == 0   ? lattice_point(rng, 2, 1)
                             : k % 3 == 1 ? rng.direction()
                                          : lattice_point(rng, 1, 1));
        const Result<HullShape> made = shape_of_hull(points);
        if (!made.ok()) continue;
        const HullShape& hull = made.value();
        ASSERT_EQ(hull.triangles.size(), 2 * hull.corners.size() - 4);
        ASSERT_EQ(hull.edges.size(), 3 * hull.corners.size() - 6);
        for (const HullShape::Triangle& t : hull.triangles) {
            ASSERT_GT(length(t.normal), 0);
            for (const Vec3& p : points)
                ASSERT_LE(exact_triple_sign(difference_as_sum(p, hull.corners[t.corner[0]]), hull.side(t, 1),
                                            hull.side(t, 2)),
                          0);
        }
        for (const Vec3& p : points) ASSERT_LE(length(p), hull.reach);
    }
}

TEST(HullShapes, SayWhatIsWrong) {
    const std::vector<Vec3> flat{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    EXPECT_EQ(shape_of_hull(flat).error().code, ErrorCode::kInvalid);
    EXPECT_EQ(shape_of_hull({}).error().code, ErrorCode::kInvalid);
    EXPECT_EQ(shape_of_hull(std::vector<Vec3>(65)).error().code, ErrorCode::kTooLarge);
    EXPECT_EQ(shape_of_hull(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, NAN, 0}, {0, 0, 1}}).error().code,
              ErrorCode::kOutOfRange);
}

}  // namespace
