// SPDX-License-Identifier: MIT
// Numbers and words of SVG, whatever comes in.
#include <gtest/gtest.h>

#include <cmath>

#include "draw/svg_text.h"
#include "draw/utf8.h"

namespace firma::draw {
namespace {

std::string number(double value) {
    return SvgText().number(value).text();
}
std::string words(std::string_view text) {
    return SvgText().words(text).text();
}

TEST(SvgText, NumbersAreRoundedToTenths) {
    EXPECT_EQ(number(0), "0");
    EXPECT_EQ(number(12), "12");
    EXPECT_EQ(number(12.34), "12.3");
    EXPECT_EQ(number(12.35001), "12.4");
    EXPECT_EQ(number(-0.04), "0");
    EXPECT_EQ(number(-0.26), "-0.3");
    EXPECT_EQ(number(-12.96), "-13");
}

TEST(SvgText, NumbersThatAreNone) {
    EXPECT_EQ(number(NAN), "0");
    EXPECT_EQ(number(INFINITY), "0");
    EXPECT_EQ(number(1e300), "0");
}

TEST(SvgText, WordsCannotBecomeMarkup) {
    EXPECT_EQ(words("a<b>&\"c\""), "a&lt;b&gt;&amp;\"c\"");
    EXPECT_EQ(words("tab\tbell\a"), "tab?bell?");
}

TEST(SvgText, OnlyUtf8Passes) {
    EXPECT_EQ(words("h\xC3\xB6hle"), "h\xC3\xB6hle");
    EXPECT_EQ(words("\xE2\x82\xAC \xF0\x9F\x98\x80"), "\xE2\x82\xAC \xF0\x9F\x98\x80");
    EXPECT_EQ(words("\xFFx"), "?x");
    EXPECT_EQ(words("\xC0\x80"), "??");       // overlong
    EXPECT_EQ(words("\xED\xA0\x80"), "???");  // a surrogate
    EXPECT_EQ(words("cut \xE2\x82"), "cut ??");
    EXPECT_EQ(utf8_length(""), 0u);
}

TEST(SvgText, ShortNumbers) {
    EXPECT_EQ(short_number(1.5, 3), "1.5");
    EXPECT_EQ(short_number(2, 2), "2");
    EXPECT_EQ(short_number(-0.0001, 2), "0");
    EXPECT_EQ(short_number(100, 0), "100");
    EXPECT_EQ(short_number(NAN, 2), "?");
    EXPECT_EQ(grouped_number(0), "0");
    EXPECT_EQ(grouped_number(999), "999");
    EXPECT_EQ(grouped_number(1000), "1,000");
    EXPECT_EQ(grouped_number(1234567), "1,234,567");
}

}  // namespace
}  // namespace firma::draw
