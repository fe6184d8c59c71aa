// SPDX-License-Identifier: MIT
// Integers of 256 bits against integers without end.
#include "geometry/exact_integer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scenes/rng.h"
#include "tests/geometry/big_numbers.h"

namespace firma {
namespace {

/// Up to `bits` bits with sign: often with long runs of zeros and ones, where carries travel.
Int128 random_integer(scenes::Rng& rng, int bits) {
    Unsigned128 value = rng.next();
    value = value << 64 | rng.next();
    const int kept = int(rng.below(std::uint32_t(bits)));  // the sign takes a bit
    value = kept == 0 ? 0 : value >> (128 - kept);
    if (value != 0 && rng.chance(0.3)) {
        const int from = int(rng.below(128));
        value |= ~Unsigned128(0) >> from;
        value &= (Unsigned128(1) << (bits - 1)) - 1;
    }
    if (rng.chance(0.2)) value = value >> 64 << 64;
    return rng.chance(0.5) ? Int128(value) : -Int128(value) - Int128(rng.chance(0.5));
}

/// Up to `bits` bits with sign.
Int256 random_wide(scenes::Rng& rng, int bits) {
    const int half = bits / 2;
    const Int128 a = random_integer(rng, half);
    const Int128 b = random_integer(rng, bits - half);
    const Int128 c = random_integer(rng, half);
    return product(a, b) + Int256(c);
}

TEST(ExactInteger, SumsAndProductsAreExact) {
    scenes::Rng rng(1);
    for (int i = 0; i < 20000; ++i) {
        const Int128 a = random_integer(rng, 128);
        const Int128 b = random_integer(rng, 127);
        const Int256 ab = product(a, b);
        ASSERT_EQ(big(ab), big(a) * big(b));
        const Int128 c = random_integer(rng, 120);
        const Int128 d = random_integer(rng, 128);
        const Int256 cd = product(c, d);
        ASSERT_EQ(big(ab + cd), big(ab) + big(cd));
        ASSERT_EQ(big(ab - cd), big(ab) - big(cd));
        ASSERT_EQ(big(-ab), -big(ab));
        ASSERT_EQ(big(Int256(a)), big(a));
        ASSERT_EQ((ab - cd).sign(), sign_of(big(ab) - big(cd)));
        ASSERT_EQ(ab == cd, big(ab) == big(cd));
        ASSERT_EQ((ab + cd) - cd, ab);
    }
}

TEST(ExactInteger, WideProductsAreExact) {
    scenes::Rng rng(2);
    for (int i = 0; i < 20000; ++i) {
        const Int256 a = random_wide(rng, 190);
        const auto b = std::int64_t(random_integer(rng, 64));
        ASSERT_EQ(big(a * b), big(a) * b);
        const Int256 c = random_wide(rng, 126);
        const Int128 d = random_integer(rng, 128);
        ASSERT_EQ(big(c * d), big(c) * big(d));
        const Int256 e = random_wide(rng, 160);
        const Int128 f = random_integer(rng, 90);
        ASSERT_EQ(big(e * f), big(e) * big(f));
    }
}

TEST(ExactInteger, SignsAtTheEnds) {
    const Int128 lowest = Int128(Unsigned128(1) << 127);
    EXPECT_EQ(Int256().sign(), 0);
    EXPECT_EQ(Int256(Int128(1)).sign(), 1);
    EXPECT_EQ(Int256(Int128(-1)).sign(), -1);
    EXPECT_EQ(Int256(lowest).sign(), -1);
    EXPECT_EQ(big(product(lowest, lowest)), Big(1) << 254);
    EXPECT_EQ(big(product(lowest, ~lowest)), (Big(1) << 127) - (Big(1) << 254));
    EXPECT_EQ(big(Int256(lowest) * lowest), Big(1) << 254);
    EXPECT_EQ(big(Int256(lowest) * std::int64_t(INT64_MIN)), Big(1) << 190);
    EXPECT_EQ(product(3, -3) + Int256(Int128(9)), Int256());
    for (int k = 0; k < 4; ++k) {
        Int256 single;
        single.word[k] = 1;
        EXPECT_EQ(single.sign(), 1);
        EXPECT_EQ((-single).sign(), -1);
    }
}

TEST(ExactInteger, DoublesAreTheNearest) {
    scenes::Rng rng(3);
    for (int i = 0; i < 20000; ++i) {
        const int bits = 4 + int(rng.below(252));
        const Int256 a = random_wide(rng, bits);
        ASSERT_TRUE(is_nearest(a.to_double(), big(a))) << big(a);
    }
    EXPECT_EQ(Int256().to_double(), 0);
    EXPECT_FALSE(std::signbit(Int256().to_double()));
    Int256 lowest;
    lowest.word[3] = std::uint64_t(1) << 63;
    EXPECT_EQ(lowest.to_double(), -0x1p255);
}

// Halves between two doubles, and what lies one unit beside them, at every height.
TEST(ExactInteger, DoublesRoundHalvesToEven) {
    scenes::Rng rng(4);
    for (int shift = 0; shift <= 200; ++shift)
        for (int i = 0; i < 20; ++i) {
            const auto digits = std::int64_t(rng.next() >> 11 | 1ull << 52);
            Int256 half(Int128(2 * digits + 1));
            for (int k = 0; k < shift; ++k) half = half + half;
            const double even = double(digits % 2 == 0 ? digits : digits + 1) * std::ldexp(1.0, shift + 1);
            ASSERT_EQ(half.to_double(), even);
            ASSERT_EQ((-half).to_double(), -even);
            if (shift == 0) continue;
            const Int256 one(Int128(1));
            ASSERT_EQ((half + one).to_double(), double(digits + 1) * std::ldexp(1.0, shift + 1));
            ASSERT_EQ((half - one).to_double(), double(digits) * std::ldexp(1.0, shift + 1));
            ASSERT_EQ((one - half).to_double(), -double(digits) * std::ldexp(1.0, shift + 1));
        }
}

/// Halves to even, by the floor.
Big rounded_quotient(const Big& a, const Big& b) {
    const Big twice = 2 * a + b;  // floor(a / b + 1/2)
    Big quotient = twice / (2 * b);
    if (quotient * 2 * b > twice) --quotient;
    if (quotient * 2 * b == twice && quotient % 2 != 0) --quotient;
    return quotient;
}

TEST(ExactInteger, QuotientsRoundToTheNearest) {
    scenes::Rng rng(5);
    for (int i = 0; i < 10000; ++i) {
        const int bits = 2 + int(rng.below(136));
        Int256 b = random_wide(rng, bits);
        if (b.sign() < 0) b = -b;
        if (b.sign() == 0) continue;
        // A quotient with a rest of nothing, about a half, or anything.
        const int quotient_bits = 1 + int(rng.below(62));
        const auto quotient = std::int64_t(random_integer(rng, quotient_bits));
        Int256 a = b * quotient;
        const std::uint32_t kind = rng.below(3);
        if (kind == 1) {
            a = a + a + b;
            b = b + b;
            a = a + Int256(Int128(rng.below(3)) - 1);
        }
        if (kind == 2) a = a + random_wide(rng, bits);
        const Big expected = rounded_quotient(big(a), big(b));
        if (abs(expected) >= Big(1) << 62) continue;
        ASSERT_EQ(big(Int128(divide_rounded(a, b))), expected) << big(a) << " / " << big(b);
    }
    const Int256 two(Int128(2));
    const std::int64_t halved[11] = {-2, -2, -2, -1, 0, 0, 0, 1, 2, 2, 2};
    for (int a = -5; a <= 5; ++a) EXPECT_EQ(divide_rounded(Int256(Int128(a)), two), halved[a + 5]) << a;
}

TEST(ExactInteger, DivisionLeavesARemainder) {
    scenes::Rng rng(6);
    for (int i = 0; i < 10000; ++i) {
        const Int256 a = random_wide(rng, 1 + int(rng.below(250)));
        const auto b = std::int64_t(random_integer(rng, 1 + int(rng.below(62))));
        if (b <= 0) continue;
        const Quotient found = divide(a, b);
        ASSERT_EQ(big(found.quotient), big(a) / b) << big(a) << " / " << b;
        ASSERT_EQ(Big(found.remainder), big(a) % b) << big(a) << " / " << b;
    }
}

}  // namespace
}  // namespace firma
