// SPDX-License-Identifier: MIT
// A seeded sample of every family of casts, all ways of asking, judged by the exact oracle: no error at all.
// (A million and more: tests/full/full_casts.cpp.)
#include <gtest/gtest.h>

#include <string>

#include "firma/polygon.h"
#include "tests/every_kernel.h"
#include "tests/reference/judge_scene.h"

namespace {

using namespace firma;
using namespace firma::reference;

class OracleSample : public testing::TestWithParam<std::size_t> {};

TEST_P(OracleSample, EveryAnswerIsRight) {
    const scenes::CastFamily& family = scenes::cast_families()[GetParam()];
    Tally total;
    for (std::uint64_t index = 0; total.casts < 4000; ++index) total.add(judge_family(family, 20, index));
    for (const std::string& failure : total.failures) ADD_FAILURE() << failure;
    EXPECT_EQ(total.errors(), 0u);
    EXPECT_GT(total.touched, 40u) << "the family no longer meets anything";
}

TEST_P(OracleSample, EveryAnswerIsRightByEveryKernel) {
    const scenes::CastFamily& family = scenes::cast_families()[GetParam()];
    test::with_every_kernel([&](const char* kernel) {
        Tally total;
        for (std::uint64_t index = 0; total.casts < 500; ++index) total.add(judge_family(family, 21, index));
        for (const std::string& failure : total.failures) ADD_FAILURE() << kernel << ": " << failure;
        EXPECT_EQ(total.errors(), 0u) << kernel;
    });
}

INSTANTIATE_TEST_SUITE_P(Families, OracleSample, testing::Range(std::size_t(0), scenes::cast_families().size()),
                         [](const auto& of) { return std::string(scenes::cast_families()[of.param].name); });

// Every polygon of every family is one that the contract allows.
TEST(CastFamilies, MakeOnlySoundPolygons) {
    for (const scenes::CastFamily& family : scenes::cast_families())
        for (std::uint64_t index = 0; index < 8; ++index)
            for (const scenes::GridPolygon& polygon : scenes::make_cast_scene(family, 3, index).polygons)
                ASSERT_EQ(check_polygon(scenes::to_metres(polygon)), PolygonFault::kNone) << family.name;
}

TEST(CastFamilies, AreTheSameForTheSameSeed) {
    for (const scenes::CastFamily& family : scenes::cast_families()) {
        const scenes::CastScene a = scenes::make_cast_scene(family, 5, 2), b = scenes::make_cast_scene(family, 5, 2);
        EXPECT_EQ(a.polygons, b.polygons);
        ASSERT_EQ(a.casts.size(), b.casts.size());
        for (std::size_t k = 0; k < a.casts.size(); ++k) EXPECT_EQ(a.casts[k].path, b.casts[k].path);
        EXPECT_NE(a.polygons, scenes::make_cast_scene(family, 5, 3).polygons) << family.name;
    }
}

// overlap() has no tolerance.
TEST(OracleSample, OverlapIsExact) {
    std::uint64_t asked = 0;
    for (const scenes::CastFamily& family : scenes::cast_families()) {
        const scenes::CastScene scene = scenes::make_cast_scene(family, 9, 0);
        std::vector<std::vector<Vec3>> polygons;
        for (const scenes::GridPolygon& polygon : scene.polygons) polygons.push_back(scenes::to_metres(polygon));
        const ExactOracle oracle(polygons);
        for (const scenes::CastQuery& query : scene.casts)
            for (std::uint32_t f = 0; f < polygons.size(); ++f, ++asked)
                ASSERT_EQ(overlap(query.sphere, polygons[f]), oracle.overlaps(query.sphere, f))
                    << family.name << "\n"
                    << describe(oracle, {query.sphere, query.path}, {f});
    }
    RecordProperty("asked", int(asked));
}

}  // namespace
