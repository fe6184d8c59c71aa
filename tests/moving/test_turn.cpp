// SPDX-License-Identifier: MIT
// Sine and cosine beside those of long double; turns.
#include <gtest/gtest.h>

#include <cmath>

#include "body/turn_between.h"
#include "firma/turn.h"
#include "scenes/rng.h"

namespace firma {
namespace {

/// An angle as whole quarters of a turn and what is left: the sine of a large angle is not right to the last digits of
/// a long double in every C library.
struct Quarters {
    long long count;
    long double left;
};

Quarters quarters_of(double angle) {
    // Half of pi: so few digits that their product with the count is exact, and those after.
    constexpr long double high = 0x1.921FB54442p+0L, low = 0xD.18469898CC51701Bp-44L;
    const long long count = std::llround(angle / 1.5707963267948966);
    return {count, (angle - (long double)(count)*high) - (long double)(count)*low};
}

long double sine_of(const Quarters& angle) {
    const long double size = angle.count & 1 ? cosl(angle.left) : sinl(angle.left);
    return angle.count & 2 ? -size : size;
}

void expect_sine_cosine(double angle) {
    const SineCosine got = sine_cosine(angle);
    const Quarters quarters = quarters_of(angle);
    EXPECT_NEAR(double((long double)(got.sine) - sine_of(quarters)), 0, 0x1p-52) << angle;
    EXPECT_NEAR(double((long double)(got.cosine) - sine_of({quarters.count + 1, quarters.left})), 0, 0x1p-52) << angle;
}

TEST(Turn, SineAndCosineAreWithinTheirBound) {
    scenes::Rng rng(1);
    for (int k = 0; k < 200000; ++k) expect_sine_cosine(rng.uniform(-7, 7));
    for (int k = 0; k < 50000; ++k) expect_sine_cosine(rng.uniform(-kMaxAngle, kMaxAngle));
    // The doubles nearest to whole numbers of eighths of a turn, where most digits cancel.
    for (int eighths = -100000; eighths < 100000; eighths += 7)
        expect_sine_cosine(double(eighths * 0.785398163397448309615660845819875721L));
    for (int power = -1074; power < 3; ++power) expect_sine_cosine(std::ldexp(1.0, power));
}

TEST(Turn, AnglesTooLargeAreNoNumber) {
    for (const double angle : {kMaxAngle * 1.001, -kMaxAngle * 2, double(INFINITY), double(NAN)}) {
        EXPECT_TRUE(std::isnan(sine_cosine(angle).sine));
        EXPECT_TRUE(std::isnan(sine_cosine(angle).cosine));
        EXPECT_EQ(turn_by({angle, 0, 0}), (Quaternion{0, 0, 0, 1}));
    }
}

TEST(Turn, GoesAboutItsAxisRightHanded) {
    const double quarter = 1.5707963267948966;
    const Vec3 turned = matrix_of(turn_by({0, 0, quarter})) * Vec3{1, 0, 0};
    EXPECT_NEAR(turned.x, 0, 1e-15);
    EXPECT_NEAR(turned.y, 1, 1e-15);
    EXPECT_EQ(turned.z, 0);
}

TEST(Turn, ComposedIsOneAfterTheOther) {
    scenes::Rng rng(2);
    for (int k = 0; k < 1000; ++k) {
        const Quaternion first = random_turn(rng.next()), second = random_turn(rng.next());
        const Vec3 p = rng.direction();
        const Vec3 one = matrix_of(second) * (matrix_of(first) * p), other = matrix_of(compose(second, first)) * p;
        EXPECT_LT(length(one - other), 1e-14);
        EXPECT_LT(length(matrix_of(first).back(matrix_of(first) * p) - p), 1e-14);
        EXPECT_LT(length(matrix_of(turn_back(first)) * (matrix_of(first) * p) - p), 1e-14);
    }
}

TEST(Turn, OfAxesIsTheTurnThatMakesThem) {
    scenes::Rng rng(3);
    for (int k = 0; k < 1000; ++k) {
        const TurnMatrix turn = matrix_of(random_turn(rng.next()));
        const TurnMatrix again = matrix_of(turn_of_axes(turn.column(0), turn.column(1), turn.column(2)));
        for (int row = 0; row < 3; ++row) EXPECT_LT(length(turn.rows[row] - again.rows[row]), 1e-14);
    }
}

TEST(Turn, BetweenTwoIsTheShorterWay) {
    scenes::Rng rng(4);
    for (int k = 0; k < 2000; ++k) {
        const Quaternion from = random_turn(rng.next()), to = random_turn(rng.next());
        const Vec3 way = turn_between(from, to);
        EXPECT_LE(length(way), 3.1415926535897936);
        const TurnMatrix there = matrix_of(compose(turn_by(way), from)), wanted = matrix_of(to);
        for (int row = 0; row < 3; ++row) EXPECT_LT(length(there.rows[row] - wanted.rows[row]), 1e-14);
    }
    const Vec3 small{1e-9, -2e-9, 3e-10};
    EXPECT_LT(length(turn_between({0, 0, 0, 1}, turn_by(small)) - small), 1e-24);
}

TEST(Turn, NothingToNormaliseIsNoTurn) {
    EXPECT_EQ(normalised({0, 0, 0, 0}), (Quaternion{0, 0, 0, 1}));
    EXPECT_EQ(normalised({NAN, 0, 0, 1}), (Quaternion{0, 0, 0, 1}));
    EXPECT_EQ(normalised({0, 0, 3, 4}), (Quaternion{0, 0, 0.6, 0.8}));
}

}  // namespace
}  // namespace firma
