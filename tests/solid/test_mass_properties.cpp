// SPDX-License-Identifier: MIT
// Mass, centre and inertia: of boxes as formulas have them, of craggy solids as sums over tetrahedra with a hundred
// digits have them.
#include "firma/mass.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>

#include "firma/carve.h"
#include "solid/moment_sum.h"
#include "tests/geometry/big_numbers.h"
#include "tests/solid/solid_levels.h"

namespace firma {
namespace {

using Float = boost::multiprecision::cpp_bin_float_100;

struct FloatPoint {
    Float x[3];
};

FloatPoint metres_of(const ExactPoint& point) {
    FloatPoint p;
    if (point.on_grid()) {
        for (int axis = 0; axis < 3; ++axis) p.x[axis] = Float(point.grid()[axis]) / 4096;
    } else {
        const BigPoint q = big_meet(big_plane(*point.plane(0)), big_plane(*point.plane(1)), big_plane(*point.plane(2)));
        for (int axis = 0; axis < 3; ++axis) p.x[axis] = Float(q.x[axis]) / Float(q.w) / 4096;
    }
    return p;
}

/// Volume, centre and inertia about it.
struct ExactMass {
    Float volume, centre[3], inertia[3][3];
};

/// Tetrahedra from the origin to the triangles of a fan around each loop's first corner; their moments by the points of
/// a rule that is exact for squares: (1 - sqrt(1/5)) / 4 of each corner and the rest of one of the four, all alike.
ExactMass exact_mass(const Boundary& boundary, const Float& density) {
    const Float alike = (1 - sqrt(Float(1) / 5)) / 4, rest = 1 - 3 * alike;
    ExactMass mass;
    Float first[3], second[3][3];
    for (const PatchFace& face : boundary.patch.faces) {
        const auto uses = boundary.patch.uses(face);
        const auto corner = [&](std::uint32_t k) {
            return metres_of(boundary.patch.vertices[boundary.patch.from(uses[k])].point);
        };
        std::uint32_t start = 0;
        for (const std::uint32_t end : boundary.patch.ends(face)) {
            const FloatPoint a = corner(start);
            for (std::uint32_t k = start + 1; k + 1 < end; ++k) {
                const FloatPoint b = corner(k), c = corner(k + 1);
                Float det = 0;
                for (int x = 0, y = 1, z = 2; x < 3; y = z, z = x, ++x)
                    det += a.x[x] * (b.x[y] * c.x[z] - b.x[z] * c.x[y]);
                mass.volume += det / 6;
                for (int heavy = 0; heavy < 4; ++heavy) {  // the last is the origin
                    Float p[3];
                    for (int i = 0; i < 3; ++i)
                        p[i] = (heavy == 0 ? rest : alike) * a.x[i] + (heavy == 1 ? rest : alike) * b.x[i] +
                               (heavy == 2 ? rest : alike) * c.x[i];
                    for (int i = 0; i < 3; ++i) {
                        first[i] += det / 24 * p[i];
                        for (int j = 0; j < 3; ++j) second[i][j] += det / 24 * p[i] * p[j];
                    }
                }
            }
            start = end;
        }
    }
    Float spread[3][3];
    for (int i = 0; i < 3; ++i) mass.centre[i] = first[i] / mass.volume;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) spread[i][j] = second[i][j] - mass.volume * mass.centre[i] * mass.centre[j];
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            mass.inertia[i][j] =
                density * ((i == j ? spread[0][0] + spread[1][1] + spread[2][2] : Float(0)) - spread[i][j]);
    return mass;
}

/// Lengths compare with the solid's size, moments with the greatest.
void expect_exact_mass(const World& world) {
    constexpr double kDensity = 2650;
    constexpr double kClose = 1e-12;
    const MassProperties mass = mass_properties(world.solid(), kDensity);
    const ExactMass exact = exact_mass(test::boundary_of(world), kDensity);
    const auto share = [](double value, const Float& of, const Float& size) { return double(abs(value - of) / size); };
    EXPECT_LT(share(mass.volume, exact.volume, exact.volume), kClose);
    EXPECT_LT(share(mass.mass, exact.volume * kDensity, exact.volume * kDensity), kClose);
    const Float size = pow(exact.volume, Float(1) / 3);
    for (int i = 0; i < 3; ++i) {
        // A coordinate far from the origin cannot be told better than a double can hold it.
        EXPECT_LT(share(mass.centre[i], exact.centre[i], size), kClose + std::fabs(mass.centre[i]) * 0x1p-52);
        for (int j = 0; j < 3; ++j)
            EXPECT_LT(share(mass.inertia[std::size_t(i)][j], exact.inertia[i][j], exact.inertia[i][i]), kClose);
    }
    EXPECT_DOUBLE_EQ(mass.volume, measure_solid(world).volume);
}

World carved_once(const World& world, const Cutter& cutter, const Pose& pose) {
    const CarveResult result = carve(world, cutter, pose);
    EXPECT_EQ(result.status, CarveStatus::kDone) << result.error.reason;
    return result.world;
}

TEST(MassProperties, OfABox) {
    const Solid box = make_solid(test::box_level({1, 2, 3}, {5, 5, 5})).value();  // 4 x 3 x 2
    const MassProperties mass = mass_properties(box, 1000);
    EXPECT_EQ(mass.volume, 24);
    EXPECT_EQ(mass.mass, 24000);
    EXPECT_EQ(mass.centre, (Vec3{3, 3.5, 4}));
    EXPECT_EQ(mass.inertia[0], (Vec3{24000.0 / 12 * (9 + 4), 0, 0}));
    EXPECT_EQ(mass.inertia[1], (Vec3{0, 24000.0 / 12 * (16 + 4), 0}));
    EXPECT_EQ(mass.inertia[2], (Vec3{0, 0, 24000.0 / 12 * (16 + 9)}));
}

TEST(MassProperties, OfABoxAnywhere) {
    for (const Vec3& at : {Vec3{0, 0, 0}, Vec3{-8000, 13.25, 7}, Vec3{8188, 8189, -8192}, Vec3{0.000244140625, 5, 0}}) {
        const Solid box = make_solid(test::box_level(at, at + Vec3{2, 1, 3})).value();
        const MassProperties mass = mass_properties(box, 2);
        EXPECT_EQ(mass.volume, 6);
        EXPECT_EQ(mass.centre, (at + Vec3{1, 0.5, 1.5}));
        EXPECT_EQ(mass.inertia[0], (Vec3{10, 0, 0}));
        EXPECT_EQ(mass.inertia[1], (Vec3{0, 13, 0}));
        EXPECT_EQ(mass.inertia[2], (Vec3{0, 0, 5}));
    }
}

/// Turned by an angle of cosine 3/5 about z: its corners stay on the grid.
TEST(MassProperties, OfATurnedBox) {
    const Vec3 along{3, 4, 0}, across{-8, 6, 0}, up{0, 0, 2}, at{100, -50, 20};  // 5 x 10 x 2
    Level level = test::empty_level();
    const auto add = [&](const Vec3& from, const Vec3& u, const Vec3& v) {
        test::add_polygon(level, {from, from + u, from + u + v, from + v});
    };
    add(at, across, along);
    add(at + up, along, across);
    add(at, along, up);
    add(at + across, up, along);
    add(at, up, across);
    add(at + along, across, up);
    const MassProperties mass = mass_properties(make_solid(level).value(), 12);
    EXPECT_EQ(mass.volume, 100);
    EXPECT_EQ(mass.centre, at + (along + across + up) * 0.5);
    // About its own axes, then turned: R diag R'.
    const double a = 100 * (100 + 4), b = 100 * (25 + 4), c = 100 * (25 + 100);
    EXPECT_DOUBLE_EQ(mass.inertia[0].x, 0.36 * a + 0.64 * b);
    EXPECT_DOUBLE_EQ(mass.inertia[1].y, 0.64 * a + 0.36 * b);
    EXPECT_DOUBLE_EQ(mass.inertia[0].y, 0.48 * (a - b));
    EXPECT_EQ(mass.inertia[0].y, mass.inertia[1].x);
    EXPECT_DOUBLE_EQ(mass.inertia[2].z, c);
    EXPECT_EQ(mass.inertia[2].x, 0);
    EXPECT_EQ(mass.inertia[1].z, 0);
}

/// A hollow one weighs what it holds.
TEST(MassProperties, OfAHollowBox) {
    Level level = test::box_level({0, 0, 0}, {4, 4, 4});
    test::add_box(level, {1, 1, 1}, {2, 2, 2}, true);
    const MassProperties mass = mass_properties(make_solid(level).value(), 1);
    EXPECT_EQ(mass.volume, 63);
    EXPECT_DOUBLE_EQ(mass.centre.x, (64 * 2 - 1.5) / 63);
    const auto about = [&](double volume, double side, double at) {
        const double away = at - mass.centre.x;
        return volume * (side * side / 6 + 2 * away * away);
    };
    EXPECT_DOUBLE_EQ(mass.inertia[0].x, about(64, 4, 2) - about(1, 1, 1.5));
}

/// Alone, of arms or of points: the same to the bit.
TEST(MassProperties, TheVolumeIsThatOfTheMoments) {
    World world = make_world(test::box_level({-1, -2, 5}, {3, 2, 9})).value();
    for (int k = 0; k < 6; ++k)
        world = carved_once(
            world, make_crater(CutterShape::kRocky, std::uint64_t(k)),
            {.position = {k - 1.5, 0.5 * k - 1, 9}, .rotation = random_turn(std::uint64_t(k)), .scale = 1.1});
    const Boundary boundary = test::boundary_of(world);
    const SolidPatch& patch = boundary.patch;
    const InputPoint apex{4096, 0, 7 * 4096};
    MomentSum by_points(apex), volume(apex);
    for (const PatchFace& face : patch.faces) {
        const auto corner = [&](std::uint32_t k) -> const ExactPoint& {
            return patch.vertices[patch.from(patch.uses(face)[k])].point;
        };
        by_points.add_face(face.plane->plane, patch.ends(face), corner);
        volume.add_volume(face.plane->plane, patch.ends(face),
                          [&](std::uint32_t k) { return arm_of(corner(k), apex); });
    }
    const Moments all = moments_of(patch, apex);
    const auto same = [](const DoubleDouble& a, const DoubleDouble& b) { return a.high == b.high && a.low == b.low; };
    EXPECT_GT(all.volume.high, 0);
    EXPECT_TRUE(same(all.volume, volume.sums().volume));
    EXPECT_TRUE(same(all.volume, by_points.sums().volume));
    EXPECT_TRUE(same(all.second[0][2], by_points.sums().second[0][2]));
}

TEST(MassProperties, OfNothing) {
    const auto is_zero = [](const MassProperties& mass) {
        return mass.volume == 0 && mass.mass == 0 && mass.centre == Vec3{} && mass.inertia[0] == Vec3{} &&
               mass.inertia[1] == Vec3{} && mass.inertia[2] == Vec3{};
    };
    EXPECT_TRUE(is_zero(mass_properties(Solid(), 1)));
    EXPECT_TRUE(is_zero(mass_properties(make_solid(test::box_level({0, 0, 0}, {6, 6, 6}, true)).value(), 1)));
    const Solid box = make_solid(test::box_level({0, 0, 0}, {1, 1, 1})).value();
    for (const double density : {-1.0, std::numeric_limits<double>::quiet_NaN(), double(INFINITY)})
        EXPECT_TRUE(is_zero(mass_properties(box, density)));
    EXPECT_EQ(mass_properties(box, 0).volume, 1);
}

TEST(MassProperties, OfCraggySolids) {
    for (const Vec3& corner : {Vec3{-3, -3, -3}, Vec3{8100, -8100, 8100}, Vec3{-4000, 0.5, 12}}) {
        World world = make_world(test::box_level(corner, corner + Vec3{6, 6, 6})).value();
        for (std::uint64_t k = 0; k < 6; ++k) {
            Vec3 at = corner + Vec3{3.3, 2.8, 3.1};
            at[int(k % 3)] = corner[int(k % 3)] + (k < 3 ? 5.9 : 0.2);
            const CutterShape shape = k % 2 ? CutterShape::kRocky : CutterShape::kSpiky;
            world = carved_once(world, make_crater(shape, k), {.position = at, .rotation = random_turn(k)});
            expect_exact_mass(world);
        }
    }
}

/// All that is left is craters' faces: nothing lies on the grid.
TEST(MassProperties, OfASliver) {
    World world = make_world(test::box_level({-1, -1, -1}, {1, 1, 1})).value();
    for (std::uint64_t k = 0; k < 2; ++k)
        world = carved_once(world, make_crater(CutterShape::kRocky, 7 + k),
                            {.position = {0.1, 0.05, k ? 1.95 : -1.93}, .rotation = random_turn(k), .scale = 1.9});
    expect_exact_mass(world);
}

}  // namespace
}  // namespace firma
