// SPDX-License-Identifier: MIT
// Double-double arithmetic against rational numbers.
#include "geometry/double_double.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>

#include "scenes/rng.h"

namespace firma {
namespace {

using Rational = boost::multiprecision::cpp_rational;

Rational exact(const DoubleDouble& a) {
    return Rational(a.high) + Rational(a.low);
}

/// A double of full precision, of any of many sizes.
double random_double(scenes::Rng& rng) {
    const double size = std::ldexp(1.0, int(rng.below(80)) - 40);
    return rng.uniform(-1, 1) * size;
}

DoubleDouble random_double_double(scenes::Rng& rng) {
    const double high = random_double(rng);
    return quick_two_sum(high, high * 0x1p-54 * rng.uniform(-1, 1));
}

/// |got - want| <= bound * |size|
void expect_close(const DoubleDouble& got, const Rational& want, const Rational& size, double bound) {
    const Rational error = abs(Rational(exact(got) - want));
    EXPECT_LE(error, abs(size) * Rational(bound));
}

TEST(DoubleDouble, SumsAndProductsOfTwoDoublesAreExact) {
    scenes::Rng rng(1);
    for (int k = 0; k < 20000; ++k) {
        const double a = random_double(rng), b = random_double(rng);
        ASSERT_EQ(exact(two_sum(a, b)), Rational(a) + Rational(b)) << a << " " << b;
        ASSERT_EQ(exact(two_product(a, b)), Rational(a) * Rational(b)) << a << " " << b;
    }
}

TEST(DoubleDouble, OperationsKeepAHundredBits) {
    scenes::Rng rng(2);
    for (int k = 0; k < 5000; ++k) {
        const DoubleDouble a = random_double_double(rng), b = random_double_double(rng);
        const Rational x = exact(a), y = exact(b);
        expect_close(a + b, x + y, abs(x) + abs(y), 0x1p-103);
        expect_close(a * b, x * y, x * y, 0x1p-100);
        if (y != 0) expect_close(a / b, x / y, x / y, 0x1p-98);
    }
}

TEST(DoubleDouble, SquareRootSquaredIsTheNumber) {
    scenes::Rng rng(3);
    for (int k = 0; k < 5000; ++k) {
        DoubleDouble a = random_double_double(rng);
        if (a.high < 0) a = -a;
        const Rational root = exact(square_root(a));
        EXPECT_LE(abs(Rational(root * root - exact(a))), exact(a) * Rational(0x1p-98));
    }
    EXPECT_EQ(square_root(DoubleDouble(0)).high, 0);
    EXPECT_EQ(square_root(DoubleDouble(-1)).high, 0) << "what rounding left below zero counts as zero";
}

TEST(DoubleDouble, ComparesByBothParts) {
    EXPECT_TRUE(DoubleDouble(1, -0x1p-60) < DoubleDouble(1));
    EXPECT_TRUE(DoubleDouble(1) < DoubleDouble(1, 0x1p-60));
    EXPECT_FALSE(DoubleDouble(1) < DoubleDouble(1));
}

}  // namespace
}  // namespace firma
