// SPDX-License-Identifier: MIT
// A particle against a triangle of lanes, by each kernel: the polygon's answer to the bit, or none; above all where the
// path runs through edges, through corners, along the plane, or begins on it.
#include "world/particle_triangle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <optional>

#include "cast/cast_sphere_polygon.h"
#include "cast/make_hit.h"
#include "geometry/exact_predicates.h"
#include "geometry/whole_path.h"
#include "scenes/rng.h"
#include "solid/face_shape.h"
#include "tests/sample.h"
#include "world/sweep_lanes.h"

namespace firma {
namespace {

/// A triangle alone in its lanes.
struct OneTriangle {
    FaceLanes both[2];
    FaceLanes& lanes = both[0];
    Node root;  ///< leads to them

    /// @param step  of coordinates, a multiple of the surface step
    OneTriangle(scenes::Rng& rng, const GridPoint& origin, double size, double step) {
        const bool flat = rng.chance(0.4);
        const int axis_of_plane = int(rng.below(3));
        std::int32_t steps[3][3];
        std::int32_t most = 0;
        for (int c = 0; c < 3; ++c) {
            double sum = 0;
            for (int axis = 0; axis < 3; ++axis) {
                double at = std::floor(rng.uniform(-size, size) / step) * step;
                if (flat && axis == axis_of_plane) at = step;
                if (flat && c > 0 && rng.chance(0.4)) at = steps[c - 1][axis] / kSurfaceSteps;  // along an axis
                // Floats hold 24 bits, and corners lie in the world.
                at = double(float(at));
                const double whole = double(origin[axis]) / kSurfaceSteps + at;
                if (std::floor(at * kSurfaceSteps) != at * kSurfaceSteps || std::fabs(whole) > kWorldRim) at = 0;
                steps[c][axis] = std::int32_t(at * kSurfaceSteps);
                most = std::max(most, std::abs(steps[c][axis]));
                sum += std::fabs(at);
            }
            lanes.size = std::max(lanes.size, float(sum) * (1 + 0x1p-20f));
        }
        lanes.origin = origin;
        lanes.whole = 1;
        // In lanes of either kind, where they fit both.
        const std::int32_t in_a_step = most < 32768 ? 1 : 64;  // of an input step
        bool fits = most / in_a_step < 32768;
        for (const auto& corner : steps)
            for (const std::int32_t at : corner) fits = fits && at % in_a_step == 0;
        const bool wide = !fits || rng.chance(0.3);
        if (wide) lanes.packed |= FaceLanes::kWide;
        lanes.step = float((wide ? 1 : in_a_step) / kSurfaceSteps);
        make_root();
        for (int c = 0; c < 3; ++c)
            for (int axis = 0; axis < 3; ++axis) {
                const std::int32_t at = steps[c][axis];
                lanes.corner[c][axis][0] = std::int16_t(wide ? at >> 16 : at / in_a_step);
                both[1].corner[c][axis][0] = std::int16_t(std::uint16_t(at));
            }
    }
    OneTriangle(const OneTriangle&) = delete;
    OneTriangle& operator=(const OneTriangle&) = delete;

    Vec3 corner(std::uint32_t k) const {
        Vec3 corners[3];
        lanes.read_corners(0, corners);
        return corners[k];
    }

private:
    void make_root() {
        WideNode& wide = root.wide.emplace_back();
        for (std::uint32_t lane = 0; lane < WideNode::kLanes; ++lane) {
            wide.below[lane] = 0;
            for (int axis = 0; axis < 3; ++axis) {
                const float side = lane == 0 ? float(kWorldRim) : -std::numeric_limits<float>::infinity();
                wide.side[0][axis][lane] = -side;
                wide.side[1][axis][lane] = side;
            }
        }
        wide.lead_to_facets(0, &lanes);
    }
};

/// What a kernel tells of the triangle.
struct Told {
    bool looked = false;
    TriangleCrossing crossing;

    Told(const LaneKernel& kernel, const OneTriangle& it, const Sweep& sweep, bool front_only, double latest) {
        const LaneSweep lanes(sweep);
        LaneQuery query(lanes, front_only, latest, this, [](LaneQuery& asked, const FaceLanes&, std::uint32_t) {
            Told& told = *static_cast<Told*>(asked.whose);
            told.looked = true;
            told.crossing = asked.crossing;
            return false;
        });
        EXPECT_FALSE(kernel.sweep(it.root, query));
    }

    bool must_ask() const { return looked && !crossing.known; }
    /// Where no polygon is to be asked.
    Contact contact(const OneTriangle& it, const Sweep& sweep) const {
        if (!looked) return {};
        std::optional<WholePath> whole;
        bool through_edge = false;
        const int facing = crossing.away ? 1 : -1;
        if (crossing.open && !line_passes(sweep, whole, it.lanes, 0, crossing.open, facing, through_edge)) return {};
        return {Status::kHit, Feature::kFace, 0, crossing.t};
    }
};

bool same_bits(const Vec3& a, const Vec3& b) {
    for (int axis = 0; axis < 3; ++axis)
        if (std::bit_cast<std::uint64_t>(a[axis]) != std::bit_cast<std::uint64_t>(b[axis])) return false;
    return true;
}

void expect_same_hit(const PolygonHit& made, const PolygonHit& wanted) {
    EXPECT_EQ(made.status, wanted.status);
    EXPECT_EQ(made.feature, wanted.feature);
    EXPECT_EQ(made.feature_index, wanted.feature_index);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(made.fraction), std::bit_cast<std::uint64_t>(wanted.fraction));
    EXPECT_TRUE(same_bits(made.centre, wanted.centre));
    EXPECT_TRUE(same_bits(made.point, wanted.point));
    EXPECT_TRUE(same_bits(made.normal, wanted.normal));
    EXPECT_TRUE(same_bits(made.face_normal, wanted.face_normal));
}

Vec3 as_floats(const Vec3& v) {
    return {double(float(v.x)), double(float(v.y)), double(float(v.z))};
}

/// Where a path is aimed.
Vec3 target_in(scenes::Rng& rng, const OneTriangle& it) {
    const std::uint32_t k = rng.below(3);
    const Vec3 a = it.corner(k), b = it.corner((k + 1) % 3), c = it.corner((k + 2) % 3);
    const double share = std::ldexp(double(rng.below(64)), -6);
    const double hair = std::ldexp(1.0, -18 - int(rng.below(36)));
    switch (rng.below(5)) {
        case 0:
            return a;
        case 4:  // beside an edge or a corner, down to what double cannot tell
            return a + (b - a) * (rng.chance(0.5) ? share : 0) + rng.direction() * hair;
        case 1:
            return a + (b - a) * share;  // on an edge, maybe exactly
        case 2:
            return a + (b - a) * rng.uniform(0, 1);  // a hair off
        default:
            return a + (b - a) * 0.25 + (c - a) * 0.25;  // within
    }
}

struct Tally {
    int told = 0, asked = 0;
    int inside = 0;       ///< met, by the lanes alone
    int beside = 0;       ///< met near the rim, or on it
    int through_rim = 0;  ///< met where an edge or a corner is, exactly
};

void compare(const OneTriangle& it, const Vec3& start, const Vec3& path, double part_of_path, Tally& tally) {
    Sweep sweep;
    if (make_sweep({start, 0}, path, sweep) != Status::kHit || !LaneSweep(sweep).usable) return;
    const LaneShape shape(it.lanes, 0);
    if (!shape.polygon.has_area()) return;
    for (const LaneKernel& kernel : lane_kernels())
        for (const bool front_only : {false, true}) {
            const Sides sides = front_only ? Sides::kFront : Sides::kBoth;
            const double latest = part_of_path * sweep.end;
            const Told it_told(kernel, it, sweep, front_only, latest);
            if (it_told.must_ask()) {
                ++tally.asked;
                continue;
            }
            ++tally.told;
            const Contact told = it_told.contact(it, sweep);
            const Contact wanted = cast_sweep_polygon(sweep, shape.polygon, sides, latest);
            const bool later = !told.touched() && wanted.touched() && wanted.t > latest;
            if (later) continue;
            ASSERT_EQ(told.status, wanted.status) << kernel.name;
            if (!wanted.touched()) continue;
            ASSERT_LE(told.t, latest) << kernel.name;
            ASSERT_EQ(told.feature, wanted.feature);
            ASSERT_EQ(told.index, wanted.index);
            ASSERT_EQ(std::bit_cast<std::uint64_t>(told.t), std::bit_cast<std::uint64_t>(wanted.t)) << kernel.name;
            bool through_rim = false;
            for (std::uint32_t k = 0; k < 3; ++k)
                through_rim |= exact_edge_side(start, path, it.corner(k), it.corner((k + 1) % 3)) == 0;
            tally.through_rim += through_rim;
            const bool inside = it_told.crossing.open == 0;
            if (inside) {
                ASSERT_FALSE(through_rim) << kernel.name;
            }
            PolygonHit hit;
            make_particle_hit(sweep, it.corner(0), it_told.crossing.normal, it_told.crossing.away, told, hit);
            ++(inside ? tally.inside : tally.beside);
            expect_same_hit(hit, make_hit(sweep, shape.polygon, wanted));
            if (testing::Test::HasFailure()) return;
        }
}

void run(Tally& tally, bool floats, double far, double size, double step, int count, std::uint64_t seed) {
    scenes::Rng rng(seed);
    for (int k = 0; k < count; ++k) {
        const auto steps = [&] {
            return std::int32_t(std::floor(rng.uniform(-far, far))) * std::int32_t(kSurfaceSteps);
        };
        const GridPoint origin{steps(), steps(), steps()};
        const OneTriangle it(rng, origin, size, step);
        for (int ray = 0; ray < 6; ++ray) {
            const Vec3 target = target_in(rng, it);
            Vec3 start = target + rng.direction() * (size * rng.uniform(0.1, 8));
            const double kind = rng.uniform(0, 1);
            if (kind < 0.1) start = target_in(rng, it);  // on the plane, as far as numbers go
            if (kind > 0.9) start[int(rng.below(3))] = target[int(rng.below(3))];
            if (kind > 0.8 && kind < 0.9) {
                const int axis = int(rng.below(3));  // along an axis
                const double away = start[axis];
                start = target;
                start[axis] = away;
            }
            if (floats) start = as_floats(start);
            Vec3 path = (floats ? as_floats(target) : target) - start;
            if (floats) path = as_floats(path);
            path = path * std::ldexp(1.0, int(rng.below(4)) - 1);
            compare(it, start, path, rng.chance(0.7) ? 1 : rng.uniform(0, 1), tally);
            if (testing::Test::HasFailure()) return;
        }
    }
}

TEST(ParticleTriangle, SaysWhatThePolygonSays) {
    if (lane_kernels().empty()) GTEST_SKIP() << "compiled without lanes";
    Tally tally;
    std::uint64_t seed = 1;
    for (const bool floats : {false, true})
        for (const double far : {0.0, 20.0, 8191.0})
            for (const double size : {0.01, 1.0, 30.0})
                for (const double step : {1 / kInputSteps, 1 / kSurfaceSteps, 0.25}) {
                    run(tally, floats, far, size, step, test::sample(1000), ++seed);
                    if (HasFailure()) return;
                }
    EXPECT_GT(tally.told, 2 * tally.asked);
    EXPECT_GT(tally.inside, tally.told / 20);
    EXPECT_GT(tally.beside, tally.told / 20);
    EXPECT_GT(tally.through_rim, tally.told / 20) << "the test must meet the rims it is for";
}

}  // namespace
}  // namespace firma
