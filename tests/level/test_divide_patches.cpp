// SPDX-License-Identifier: MIT
#include "level/divide_patches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "level/tessellate_patch.h"
#include "scenes/rng.h"

namespace firma {
namespace {

constexpr std::uint64_t kPlenty = 1 << 20;

std::vector<PatchDivision> divide(const std::vector<Patch>& patches, double tolerance) {
    return divide_patches(patches, tolerance, kPlenty).value();
}

// The surface itself, by its definition.
Vec3 surface_point(const Patch& patch, std::uint32_t i, std::uint32_t j, double u, double v) {
    const std::array<double, 3> bu = {(1 - u) * (1 - u), 2 * u * (1 - u), u * u};
    const std::array<double, 3> bv = {(1 - v) * (1 - v), 2 * v * (1 - v), v * v};
    Vec3 sum;
    for (std::uint32_t y = 0; y < 3; ++y) {
        for (std::uint32_t x = 0; x < 3; ++x) sum = sum + (bu[x] * bv[y]) * patch.at(2 * i + x, 2 * j + y);
    }
    return sum;
}

double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
    const double square = dot(b - a, b - a);
    const double t = square > 0 ? std::clamp(dot(p - a, b - a) / square, 0.0, 1.0) : 0;
    return length(p - (a + t * (b - a)));
}

// closest_point() takes corners on the grid only.
double distance_to_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 n = cross(b - a, c - a);
    bool inside = length(n) > 0;
    double nearest = INFINITY;
    for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}}) {
        inside = inside && dot(cross(n, to - from), p - from) >= 0;
        nearest = std::min(nearest, distance_to_segment(p, from, to));
    }
    return inside ? std::fabs(dot(p - a, n)) / length(n) : nearest;
}

// The largest distance of a dense sample of the surface from the triangles around.
double measured_stray(const Patch& patch, const PatchDivision& division) {
    const std::vector<Vec3> points = tessellate_patch(patch, division);
    const std::uint32_t columns = division.columns(), rows = division.rows();
    const auto to_cell = [&](const Vec3& p, std::uint32_t x, std::uint32_t y) {
        const auto at = points.begin() + std::ptrdiff_t(y) * columns + x;
        const Vec3 &a = at[0], &b = at[1], &c = at[columns + 1], &d = at[columns];
        return std::min(distance_to_triangle(p, a, b, c), distance_to_triangle(p, a, c, d));
    };
    double most = 0;
    std::uint32_t first_row = 0;
    for (std::uint32_t j = 0; j < division.along_column.size(); ++j) {
        std::uint32_t first_column = 0;
        for (std::uint32_t i = 0; i < division.along_row.size(); ++i) {
            const std::uint32_t nu = division.along_row[i], nv = division.along_column[j];
            for (std::uint32_t y = 0; y <= 4 * nv; ++y) {
                for (std::uint32_t x = 0; x <= 4 * nu; ++x) {
                    const Vec3 p = surface_point(patch, i, j, x / (4.0 * nu), y / (4.0 * nv));
                    const std::uint32_t cx = first_column + std::min(x / 4, nu - 1);
                    const std::uint32_t cy = first_row + std::min(y / 4, nv - 1);
                    double nearest = INFINITY;
                    for (std::uint32_t by = cy == 0 ? 0 : cy - 1; by <= std::min(cy + 1, rows - 2); ++by) {
                        for (std::uint32_t bx = cx == 0 ? 0 : cx - 1; bx <= std::min(cx + 1, columns - 2); ++bx) {
                            nearest = std::min(nearest, to_cell(p, bx, by));
                        }
                    }
                    most = std::max(most, nearest);
                }
            }
            first_column += nu;
        }
        first_row += division.along_column[j];
    }
    return most;
}

Patch quarter_cylinder(double radius, double height) {
    Patch patch{3, 3, {}};
    for (const double z : {0.0, height / 2, height}) {
        for (const Vec3& p : {Vec3{radius, 0, z}, Vec3{radius, radius, z}, Vec3{0, radius, z}})
            patch.control.push_back(p);
    }
    return patch;
}

TEST(DividePatches, CylinderGetsChordsAcrossOnly) {
    const Patch patch = quarter_cylinder(4, 10);
    const auto division = divide({patch}, 0.01);
    EXPECT_EQ(division[0].along_column[0], 1u);
    const std::uint32_t n = division[0].along_row[0];
    EXPECT_GT(n, 4u);
    const double stray = measured_stray(patch, division[0]);
    EXPECT_LE(stray, 0.01);
    EXPECT_GT(stray, 0.005);  // nor finer than it has to be
}

TEST(DividePatches, FlatAndStraightIsOneCell) {
    Patch patch{5, 3, {}};
    for (const double y : {0.0, 1.0, 7.0}) {
        for (const double x : {0.0, 3.0, 4.0, 5.0, 9.0}) patch.control.push_back({x, y, 0});
    }
    const auto division = divide({patch}, 0.01);
    EXPECT_EQ(division[0].along_row, (std::vector<std::uint32_t>{1, 1}));
    EXPECT_EQ(division[0].along_column, (std::vector<std::uint32_t>{1}));
    const auto points = tessellate_patch(patch, division[0]);
    ASSERT_EQ(points.size(), 6u);
    EXPECT_EQ(points[1], (Vec3{4, 0, 0}));
    EXPECT_EQ(points[5], (Vec3{9, 7, 0}));
}

TEST(DividePatches, FlatWithARoundRimFollowsTheRim) {
    Patch patch{3, 3, {}};
    for (const double s : {0.0, 0.5, 1.0}) {
        for (const Vec3& p : {Vec3{4, 0, 0}, Vec3{4, 4, 0}, Vec3{0, 4, 0}}) patch.control.push_back(s * p);
    }
    const auto division = divide({patch}, 0.01);
    EXPECT_GT(division[0].along_row[0], 4u);
    EXPECT_EQ(division[0].along_column[0], 1u);
    EXPECT_LE(measured_stray(patch, division[0]), 0.01);
}

TEST(DividePatches, TwistIsDivided) {
    // Straight along rows and columns, and yet no plane: z = x y.
    Patch patch{3, 3, {}};
    for (const double y : {0.0, 1.0, 2.0}) {
        for (const double x : {0.0, 1.0, 2.0}) patch.control.push_back({x, y, x * y});
    }
    const auto division = divide({patch}, 0.01);
    EXPECT_GT(division[0].along_row[0], 1u);
    EXPECT_GT(division[0].along_column[0], 1u);
    EXPECT_LE(measured_stray(patch, division[0]), 0.01);
}

TEST(DividePatches, RandomPatchesStayWithinTolerance) {
    scenes::Rng rng(1);
    for (int round = 0; round < 400; ++round) {
        Patch patch{3, 3, {}};
        const double rough = round % 2 == 0 ? 1 : 0.2;
        for (int y = 0; y < 3; ++y) {
            for (int x = 0; x < 3; ++x) {
                const Vec3 off = {rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
                patch.control.push_back(Vec3{2.0 * x, 2.0 * y, 0} + rough * off);
            }
        }
        const double tolerance = round % 3 == 0 ? 0.1 : 0.01;
        const auto division = divide({patch}, tolerance);
        ASSERT_LE(measured_stray(patch, division[0]), tolerance) << "round " << round;
    }
}

Patch turned_round(const Patch& patch) {
    Patch turned = patch;
    std::reverse(turned.control.begin(), turned.control.end());
    return turned;
}

Patch transposed(const Patch& patch) {
    Patch turned{patch.height, patch.width, {}};
    for (std::uint32_t x = 0; x < patch.width; ++x) {
        for (std::uint32_t y = 0; y < patch.height; ++y) turned.control.push_back(patch.at(x, y));
    }
    return turned;
}

std::vector<Vec3> first_row(const Patch& patch, const PatchDivision& division) {
    auto points = tessellate_patch(patch, division);
    points.resize(division.columns());
    return points;
}

std::vector<Vec3> first_column(const Patch& patch, const PatchDivision& division) {
    const auto points = tessellate_patch(patch, division);
    std::vector<Vec3> column;
    for (std::size_t k = 0; k < points.size(); k += division.columns()) column.push_back(points[k]);
    return column;
}

std::vector<Vec3> last_row(const Patch& patch, const PatchDivision& division) {
    const auto points = tessellate_patch(patch, division);
    return {points.end() - division.columns(), points.end()};
}

// Two patches with the same first row, otherwise as different as can be; one of them also turned and transposed.
TEST(DividePatches, SharedRimsGetTheSamePointsBitForBit) {
    scenes::Rng rng(2);
    for (int round = 0; round < 200; ++round) {
        Patch a{5, 3, {}}, b{5, 5, {}};
        for (int k = 0; k < 15; ++k) a.control.push_back({rng.uniform(-9, 9), rng.uniform(-9, 9), rng.uniform(-9, 9)});
        b.control.assign(a.control.begin(), a.control.begin() + 5);
        for (int k = 0; k < 20; ++k) b.control.push_back({rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)});
        const std::vector<Patch> patches = {a, b, turned_round(b), transposed(b)};
        const auto divisions = divide(patches, 0.05);
        const auto rim = first_row(a, divisions[0]);
        EXPECT_EQ(rim, first_row(b, divisions[1]));
        auto back = last_row(patches[2], divisions[2]);
        std::reverse(back.begin(), back.end());
        EXPECT_EQ(rim, back);
        EXPECT_EQ(rim, first_column(patches[3], divisions[3]));
    }
}

TEST(DividePatches, TiesReachAcrossPatches) {
    // Three in a row along x: straight, straight, and one that bends along y; all share columns.
    const auto strip = [](double from, double bow) {
        Patch patch{3, 3, {}};
        for (const double y : {0.0, 1.0, 2.0}) {
            for (const double x : {0.0, 1.0, 2.0}) patch.control.push_back({from + x, y, x == 2 && y == 1 ? bow : 0});
        }
        return patch;
    };
    const auto divisions = divide({strip(0, 0), strip(2, 0), strip(4, 3)}, 0.01);
    EXPECT_GT(divisions[2].along_column[0], 4u);
    EXPECT_EQ(divisions[0].along_column, divisions[2].along_column);
    EXPECT_EQ(divisions[1].along_column, divisions[2].along_column);
    EXPECT_EQ(divisions[0].along_row[0], 1u);
}

TEST(DividePatches, RimsOfOnePointTieNothing) {
    // Two cones that share their tip only.
    const auto cone = [](double radius) {
        Patch patch{3, 3, {}};
        for (int k = 0; k < 3; ++k) patch.control.push_back({0, 0, 5});
        for (const double s : {0.5, 1.0}) {
            for (const Vec3& p : {Vec3{1, 0, 0}, Vec3{1, 1, 0}, Vec3{0, 1, 0}}) {
                patch.control.push_back(s * radius * p + Vec3{0, 0, 5 - 5 * s});
            }
        }
        return patch;
    };
    const auto divisions = divide({cone(0.1), cone(8)}, 0.01);
    EXPECT_LT(divisions[0].along_row[0], divisions[1].along_row[0]);
}

TEST(DividePatches, NoSpanGetsMoreThanTheMost) {
    const Patch patch = quarter_cylinder(8000, 10);
    const auto division = divide({patch}, 1e-6);
    EXPECT_EQ(division[0].along_row[0], kMostChords);
}

TEST(DividePatches, TooManyCellsAreRefused) {
    const Patch patch = quarter_cylinder(4, 10);
    const std::uint64_t cells = divide({patch}, 0.01)[0].cells();
    const std::vector<Patch> two = {patch, patch};
    EXPECT_TRUE(divide_patches(two, 0.01, 2 * cells).has_value());
    EXPECT_FALSE(divide_patches(two, 0.01, 2 * cells - 1).has_value());
}

TEST(DividePatches, PatchOfNoSizeIsAnswered) {
    const Patch patch{3, 3, std::vector<Vec3>(9, Vec3{1, 2, 3})};
    const auto division = divide({patch}, 0.01);
    EXPECT_EQ(tessellate_patch(patch, division[0]), std::vector<Vec3>(4, Vec3{1, 2, 3}));
}

TEST(DividePatches, NoPatchesNoDivisions) {
    EXPECT_TRUE(divide({}, 0.01).empty());
}

}  // namespace
}  // namespace firma
