// SPDX-License-Identifier: MIT
// Numbers as the module writes them into messages, beside printf's.
#include <gtest/gtest.h>

#include <bit>
#include <cfloat>
#include <cstdio>
#include <string>

#include "base/random.h"
#include "bindings/wasm/print_number.h"

namespace firma {
namespace {

std::string ours(double value, int digits, bool fixed) {
    char text[kLongestNumber];
    return {text, std::size_t(print_number(value, digits, fixed, text))};
}

std::string printfs(double value, int digits, bool fixed) {
    char text[kLongestNumber + 1];
    return {text, std::size_t(std::snprintf(text, sizeof text, fixed ? "%.*f" : "%.*g", digits, value))};
}

void expect_same(double value) {
    for (const int digits : {15, 16, 17}) EXPECT_EQ(ours(value, digits, false), printfs(value, digits, false));
    EXPECT_EQ(ours(value, 6, true), printfs(value, 6, true));
}

TEST(PrintNumber, AsPrintfDoes) {
    for (const double value : {0.0,
                               -0.0,
                               1.0,
                               -1.0,
                               0.1,
                               0.5,
                               1.5,
                               9.9999995,
                               0.0000005,
                               0.00000049999,
                               2.5e-7,
                               1e-4,
                               9.9999e-5,
                               1e-5,
                               1e15,
                               1e16,
                               1e17,
                               123456789012345678.0,
                               999999999999999.9,
                               0.99999999999999989,
                               1e22,
                               1e23,
                               1e300,
                               DBL_MAX,
                               DBL_MIN,
                               5e-324,
                               2.2250738585072011e-308,
                               4096.0,
                               1.0 / 3,
                               262144.25,
                               -16777217.0,
                               double(INFINITY),
                               -double(INFINITY)})
        expect_same(value);
    EXPECT_EQ(ours(double(NAN), 17, false), "nan");
}

TEST(PrintNumber, AsPrintfDoesAtRandom) {
    Random random(1);
    for (int k = 0; k < 3000; ++k) {
        const double value = std::bit_cast<double>(random.next());
        if (value == value) expect_same(value);
        const double near = double(std::int64_t(random.next() >> 40)) / 64;
        expect_same(near);
    }
}

}  // namespace
}  // namespace firma
