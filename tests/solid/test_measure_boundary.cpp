// SPDX-License-Identifier: MIT
// Volumes and areas against rational numbers, and against what is known.
#include "solid/measure_boundary.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>

#include "tests/geometry/big_numbers.h"
#include "tests/solid/solid_levels.h"

namespace firma {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using Float = boost::multiprecision::cpp_bin_float_100;

struct ExactMeasures {
    Rational volume;   // cubic input steps
    Float area;        // square input steps
    Big facet_sixths;  // cubic surface steps
};

struct RationalPoint {
    Rational x[3];
};

RationalPoint rational(const ExactPoint& point) {
    RationalPoint p;
    if (point.on_grid()) {
        for (int axis = 0; axis < 3; ++axis) p.x[axis] = point.grid()[axis];
    } else {
        const BigPoint q = big_meet(big_plane(*point.plane(0)), big_plane(*point.plane(1)), big_plane(*point.plane(2)));
        for (int axis = 0; axis < 3; ++axis) p.x[axis] = Rational(q.x[axis], q.w);
    }
    return p;
}

/// Cones to the origin, area vectors as they are defined: nothing shared with what is tested.
ExactMeasures exact_measures(const Boundary& boundary) {
    ExactMeasures sums;
    for (const PatchFace& face : boundary.patch.faces) {
        Rational twice[3];
        std::uint32_t first = 0;
        const auto uses = boundary.patch.uses(face);
        RationalPoint some;
        for (const std::uint32_t end : boundary.patch.ends(face)) {
            for (std::uint32_t k = first; k < end; ++k) {
                const std::uint32_t next = k + 1 < end ? k + 1 : first;
                const RationalPoint p = rational(boundary.patch.vertices[boundary.patch.from(uses[k])].point);
                const RationalPoint q = rational(boundary.patch.vertices[boundary.patch.from(uses[next])].point);
                for (int x = 0, y = 1, z = 2; x < 3; y = z, z = x, ++x) twice[x] += p.x[y] * q.x[z] - p.x[z] * q.x[y];
                some = p;
            }
            first = end;
        }
        Rational square;
        for (int axis = 0; axis < 3; ++axis) {
            sums.volume += some.x[axis] * twice[axis] / 6;
            square += twice[axis] * twice[axis];
        }
        sums.area += sqrt(Float(square)) / 2;
    }
    for (const FacetPlace& facet : boundary.facets) {
        const auto corner = [&](std::size_t k, Big(&p)[3]) {
            for (int axis = 0; axis < 3; ++axis) p[axis] = facet.block->corner(facet.record(), k)[axis];
        };
        for (std::size_t k = 2; k < facet.record().corner_count; ++k) {
            Big a[3], b[3], c[3];
            corner(0, a);
            corner(k - 1, b);
            corner(k, c);
            sums.facet_sixths += determinant(a, b, c);
        }
    }
    return sums;
}

void expect_exact(const World& world) {
    const Boundary boundary = test::boundary_of(world);
    const BoundaryMeasures found = measure_boundary(boundary);
    const ExactMeasures exact = exact_measures(boundary);
    const Rational volume = Rational(found.volume.high) + Rational(found.volume.low);
    EXPECT_LT(Float(abs(volume - exact.volume) / abs(exact.volume)), Float("1e-27"));
    EXPECT_LT(Float(abs(Float(found.area.high) + Float(found.area.low) - exact.area) / exact.area), Float("1e-27"));
    EXPECT_EQ(big(found.facet_sixths), exact.facet_sixths);
}

World cut(const World& world, const Cutter& cutter, const Pose& pose) {
    const CarveResult result = carve(world, cutter, pose);
    EXPECT_EQ(result.status, CarveStatus::kDone) << result.error.reason;
    return result.world;
}

TEST(MeasureBoundary, NothingMeasuresNothing) {
    const SolidMeasures measures = measure_solid(World());
    EXPECT_EQ(measures.volume, 0);
    EXPECT_EQ(measures.area, 0);
    EXPECT_EQ(measures.facet_volume, 0);
    EXPECT_EQ(measures.faces, 0u);
}

TEST(MeasureBoundary, BoxMinusBox) {
    const World block = make_world(test::box_level({-3, -2, -1}, {3, 2, 1})).value();
    EXPECT_EQ(measure_solid(block).volume, 48);
    EXPECT_EQ(measure_solid(block).facet_volume, 48);
    EXPECT_EQ(measure_solid(block).area, 88);
    EXPECT_EQ(measure_solid(block).faces, 6u);
    // A pit 2 x 2 and half a metre deep.
    const World pit = cut(block, make_crater(CutterShape::kBox, 0), {.position = {0.25, 0, 1.5}});
    EXPECT_EQ(measure_solid(pit).volume, 46);
    EXPECT_EQ(measure_solid(pit).facet_volume, 46);
    EXPECT_EQ(measure_solid(pit).area, 92);
    EXPECT_EQ(measure_solid(pit).faces, 11u) << "the pit has five sides";
}

TEST(MeasureBoundary, RockAllAroundIsMinusItsAir) {
    const World room = make_world(test::box_level({0, 0, 0}, {6, 6, 6}, true)).value();
    EXPECT_EQ(measure_solid(room).volume, -216);
    const World larger = cut(room, make_crater(CutterShape::kBox, 0), {.position = {3, 3, 0.25}});
    EXPECT_EQ(measure_solid(larger).volume, -219) << "0.75 m into the floor";
    EXPECT_EQ(measure_solid(larger).facet_volume, -219);
    EXPECT_EQ(measure_solid(larger).area, 216 + 8 * 0.75);
}

TEST(MeasureBoundary, AsRationalsSay) {
    World world = make_world(test::box_level({-3, -3, -3}, {3, 3, 3})).value();
    expect_exact(world);
    for (std::uint64_t k = 0; k < 6; ++k) {
        const auto axis = int(k % 3);
        Vec3 at{0.3, -0.2, 0.1};
        at[axis] = k < 3 ? 2.9 : -2.8;
        const CutterShape shape = k % 2 ? CutterShape::kRocky : CutterShape::kSpiky;
        world = cut(world, make_crater(shape, k), {.position = at, .rotation = random_turn(k)});
        expect_exact(world);
    }
}

TEST(MeasureBoundary, FarOutAsWell) {
    const Vec3 corner{8100, -8100, 8100};
    World world = make_world(test::box_level(corner, corner + Vec3{2, 2, 2})).value();
    EXPECT_EQ(measure_solid(world).volume, 8);
    world = cut(world, make_crater(CutterShape::kRocky, 1), {.position = corner + Vec3{1, 1, 2}, .scale = 0.5});
    expect_exact(world);
    EXPECT_LT(measure_solid(world).volume, 8 - 0.1);
}

TEST(MeasureBoundary, DoubleDoublesOfLongIntegers) {
    scenes::Rng rng(5);
    for (int k = 0; k < 1000; ++k) {
        Int256 value;
        for (int word = 0; word < 4; ++word) value.word[word] = std::uint64_t(rng.below(~0u)) << 32 | rng.below(~0u);
        const auto shift = rng.below(200);
        for (int word = 3; word >= 0; --word)  // up to 256 bits, or far fewer
            if (int(shift) / 64 > 3 - word) value.word[word] = k % 2 ? ~0ull : 0;
        if (k % 2) value.word[3] |= 1ull << 63;
        const DoubleDouble sum = to_double_double(value);
        const Rational error = Rational(sum.high) + Rational(sum.low) - Rational(big(value));
        EXPECT_LE(abs(error) * Rational(Big(1) << 102), Rational(abs(big(value)))) << k;
    }
}

}  // namespace
}  // namespace firma
