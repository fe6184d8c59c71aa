// SPDX-License-Identifier: MIT
// What --json makes of numbers and names that JSON has no words for.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <string>

#include "cli/json.h"

namespace firma::cli {
namespace {

std::string number_text(double value) {
    return json_text(value);
}

TEST(Json, WholeNumbersHaveNoPoint) {
    EXPECT_EQ(number_text(4), "4\n");
    EXPECT_EQ(number_text(-4096), "-4096\n");
    EXPECT_EQ(number_text(9007199254740994), "9007199254740994\n");
    EXPECT_EQ(number_text(1e17), "1e+17\n");
}

TEST(Json, NumbersAreReadAsTheSameDouble) {
    EXPECT_EQ(number_text(0.1), "0.1\n");
    for (const double value : {0.1, 1.0 / 3, 1e-300, 5e-324, 1.7976931348623157e308, 123456.789, -0.0}) {
        const double again = std::strtod(number_text(value).c_str(), nullptr);
        EXPECT_EQ(again, value);
        EXPECT_EQ(std::signbit(again), std::signbit(value));
    }
}

TEST(Json, WhatIsNotFiniteIsNull) {
    EXPECT_EQ(number_text(NAN), "null\n");
    EXPECT_EQ(number_text(-INFINITY), "null\n");
}

TEST(Json, BytesThatAreNotUtf8AreReplaced) {
    EXPECT_EQ(json_text("h\xC3\xB6hle \"\n"), "\"h\xC3\xB6hle \\\"\\n\"\n");
    EXPECT_EQ(json_text("\xFFx"), "\"\xEF\xBF\xBDx\"\n");
}

TEST(Json, KeysStayInOrderAndPointsAreArrays) {
    Json json;
    json["z"] = Vec3{1, 2.5, -3};
    json["a"] = nullptr;
    json["empty"] = Json::array();
    EXPECT_EQ(json.dump(), R"({"z":[1.0,2.5,-3.0],"a":null,"empty":[]})");
    EXPECT_EQ(json_text(json), "{\n  \"z\": [\n    1,\n    2.5,\n    -3\n  ],\n  \"a\": null,\n  \"empty\": []\n}\n");
}

}  // namespace
}  // namespace firma::cli
