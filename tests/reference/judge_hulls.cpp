// SPDX-License-Identifier: MIT
// Boxes and hulls against polygons, judged.
#include <cmath>
#include <cstdio>
#include <vector>

#include "cast/cast_hull_polygon.h"
#include "cast/make_hull_hit.h"
#include "scenes/grid_polygons.h"
#include "tests/reference/exact_hull.h"
#include "tests/reference/judge_shapes.h"
#include "tests/reference/surely_apart.h"

namespace firma::reference {
namespace {

using scenes::Rng;

/// How scenes are made.
struct HullKind {
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

Vec3 hull_lattice_point(Rng& rng, int reach, double step) {
    const auto one = [&] { return (double(rng.below(std::uint32_t(2 * reach + 1))) - reach) * step; };
    return {one(), one(), one()};
}

HullScene make_hull_scene(Rng& rng, const HullKind& kind) {
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
                              ? Vec3{1, 1, 1} * kind.step + hull_lattice_point(rng, 1, kind.step / 2)
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
            Vec3 o = kind.lattice ? hull_lattice_point(rng, 2, kind.step) : rng.direction() * (2 * kind.step);
            o.z *= kind.flatness;
            scene.corners.push_back(o);
        }
    }
    if (kind.lattice) {
        scene.start = here + hull_lattice_point(rng, 5, kind.step);
        scene.path = hull_lattice_point(rng, 5, kind.step) * (rng.chance(0.2) ? 2 : 1);
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

/// What is wrong with a touch whose status is right; empty: nothing.
/// @param excused  set where facets that are entered nearly at once stand for each other
std::string wrong_with(const HullScene& scene, const HullShape& hull, const PolygonHit& hit, const ExactHullCast& exact,
                       const HullExpected& expected, bool& excused) {
    const double tolerance = 1e-9 * (1 + max_abs(scene.start) * 1e-3), long_path = length(scene.path);
    const bool moved = hit.status == Status::kHit;
    if (moved) {
        if (!(hit.fraction > 0 && hit.fraction <= 1)) return "a fraction out of range";
        if (!(std::fabs(hit.fraction - nearest(expected.at)) * long_path <= tolerance)) return "another fraction";
        if (!(std::fabs(exact.gap_at(hit.fraction)) <= tolerance)) return "a gap, or an overlap";
    } else if (hit.fraction != 0) {
        return "an overlap not at the start";
    }
    if (!(std::fabs(length(hit.normal) - 1) <= 1e-12)) return "a normal that is not unit";
    double best = INFINITY;
    for (const Vec3& normal : expected.normals) best = std::fmin(best, length(hit.normal - normal));
    if (best > 1e-9) {
        // Facets that are entered nearly at once may stand for each other: then the hull is in touch along that, too.
        excused = true;
        const Vec3 centre = scene.start + scene.path * hit.fraction;
        double lowest = INFINITY, highest = -INFINITY;
        for (const Vec3& o : scene.corners)
            lowest = std::fmin(lowest, dot(hit.normal, (centre - scene.polygon[0]) + o));
        for (const Vec3& v : scene.polygon) highest = std::fmax(highest, dot(hit.normal, v - scene.polygon[0]));
        if (moved ? !(std::fabs(lowest - highest) <= tolerance) : !(expected.doubt < 1e-12)) return "another normal";
    }
    if (!(closest_point(hit.point, scene.polygon).distance <= tolerance)) return "a point off the polygon";
    const std::size_t count = scene.polygon.size(), k = hit.feature_index;
    if (k >= count) return "a feature that is not there";
    const Vec3 &a = scene.polygon[k], &b = scene.polygon[(k + 1) % count];
    if (hit.feature == Feature::kVertex && !(length(hit.point - a) <= tolerance)) return "another vertex";
    if (hit.feature == Feature::kEdge) {
        const double along = std::fmin(1, std::fmax(0, dot(hit.point - a, b - a) / dot(b - a, b - a)));
        if (!(length(hit.point - (a + (b - a) * along)) <= tolerance)) return "another edge";
    }
    if (!moved) return {};
    for (const HullShape::Triangle& t : hull.triangles) {  // the point is of the hull, too
        const Vec3 from = hit.point - (hit.centre + hull.corners[t.corner[0]]);
        const double noise =
            t.error.x * std::fabs(from.x) + t.error.y * std::fabs(from.y) + t.error.z * std::fabs(from.z);
        if (!(dot(from, t.normal) <= tolerance * length(t.normal) + noise)) return "a point off the hull";
    }
    return {};
}

void judge_hull(const HullScene& scene, ShapeTally& tally) {
    const Result<HullShape> hull = shape_of_hull(scene.corners);
    if (!hull.ok()) return;  // flat
    firma::Sweep sweep;
    const PolygonShape polygon = make_shape(scene.polygon);
    HullContact found;
    CastCounts counts;
    if (make_sweep({scene.start, hull.value().reach}, scene.path, sweep) == Status::kHit)
        found = cast_hull_polygon(sweep, hull.value(), polygon, scene.sides, sweep.end, &counts);
    ++tally.casts;
    tally.precise += counts.precise;
    const Status status = found.contact.status;
    tally.hits += status == Status::kHit;
    tally.overlaps += status == Status::kInitialOverlap;
    tally.misses += status == Status::kMiss;
    const double reach = hull.value().reach * (1 + 0x1p-40);
    if (status == Status::kMiss && surely_apart(Hull(scene.polygon), scene.start, scene.path, 1, reach)) return;
    const ExactHullCast exact(scene.corners, scene.start, scene.path, scene.polygon);
    const HullExpected expected = exact.expect(scene.sides);
    if (status != expected.status) {
        // The nearest of facets, in an overlap, is found by rounded depths. Nothing else is forgiven.
        const bool overlap = expected.doubt < 1e-12 && status != Status::kHit && expected.status != Status::kHit;
        const bool at_once =
            status == Status::kInitialOverlap && expected.status == Status::kHit && nearest(expected.at) < 1e-300;
        if (overlap || at_once) {
            ++tally.excused;
            return;
        }
        return tally.fail("status " + std::to_string(int(status)) + " for " + std::to_string(int(expected.status)) +
                          "\n" + described(scene));
    }
    if (status == Status::kMiss) return;
    const PolygonHit hit = make_hull_hit(sweep, hull.value(), polygon, found);
    bool excused = false;
    const std::string fault = wrong_with(scene, hull.value(), hit, exact, expected, excused);
    tally.excused += excused;
    if (!fault.empty()) tally.fail(fault + "\n" + described(scene));
}

template <HullKind kind>
void judge_hull_kind(Rng& rng, ShapeTally& tally) {
    judge_hull(make_hull_scene(rng, kind), tally);
}

constexpr ShapeFamily kHullFamilies[] = {
    {"BoxesOnALattice", judge_hull_kind<HullKind{true, 0.25, 0, true, 1}>},
    {"HullsOnALattice", judge_hull_kind<HullKind{true, 0.25, 0, false, 1}>},
    {"HullsOnALatticeFarAway", judge_hull_kind<HullKind{true, 0x1p-18, 8000, false, 1}>},
    {"BoxesAnywhere", judge_hull_kind<HullKind{false, 1, 10, true, 1}>},
    {"HullsAnywhere", judge_hull_kind<HullKind{false, 1, 10, false, 1}>},
    {"BoxesFarAway", judge_hull_kind<HullKind{false, 1, 8000, true, 1}>},
    {"TinyHulls", judge_hull_kind<HullKind{false, 0x1p-12, 100, false, 1}>},
    {"LargeBoxes", judge_hull_kind<HullKind{false, 500, 4000, true, 1}>},
    {"FlatBoxes", judge_hull_kind<HullKind{false, 1, 10, true, 1e-9}>},
    {"FlatHulls", judge_hull_kind<HullKind{false, 1, 100, false, 1e-7}>},
};

}  // namespace

std::span<const ShapeFamily> hull_families() {
    return kHullFamilies;
}

}  // namespace firma::reference
