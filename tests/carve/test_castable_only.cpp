// SPDX-License-Identifier: MIT
// What a report says of faces that are castable only and stay: how many reach into the cutter, against sampling.
#include <gtest/gtest.h>

#include <array>

#include "firma/carve.h"
#include "firma/level.h"
#include "scenes/rng.h"
#include "tests/carve/winding.h"
#include "tests/solid/solid_levels.h"

namespace firma {
namespace {

using test::add_box;
using test::add_polygon;
using test::empty_level;
using test::winding;

Pose at(const Vec3& position, double scale) {
    Pose pose;
    pose.position = position;
    pose.scale = scale;
    return pose;
}

/// A sheet of 2 m at a height, looking up.
void add_sheet(Level& level, double x, double y, double z) {
    add_polygon(level, {{x, y, z}, {x + 2, y, z}, {x + 2, y + 2, z}, {x, y + 2, z}});
}

/// By whose rules all of them stay.
World kept(const Level& level) {
    WorldOptions options;
    options.rules.open_faces = false;
    return make_world(level, options).value();
}

// Finding 13 (F13): it was "nothing (met only air)".
TEST(CastableOnly, WhatABlastMeetsOfThemIsTold) {
    Level level = empty_level();
    add_box(level, {0, 0, 0}, {10, 10, 4}, true);
    add_sheet(level, 2, 2, 2);
    add_sheet(level, 4.5, 2, 2.5);
    add_sheet(level, 2, 6, 0.5);
    const World world = kept(level);
    ASSERT_EQ(world.face_count() - world.solid().face_count(), 3u);
    const Cutter rock = make_crater(CutterShape::kRocky, 5);

    const CarveResult two = carve(world, rock, at({4.25, 3, 2.25}, 1));
    EXPECT_EQ(two.status, CarveStatus::kNothing);
    EXPECT_EQ(two.report.faces_castable_only, 2u);
    EXPECT_EQ(&two.world.data(), &world.data());

    const CarveResult air = carve(world, rock, at({7, 8, 2}, 1));
    EXPECT_EQ(air.status, CarveStatus::kNothing);
    EXPECT_EQ(air.report.faces_castable_only, 0u);

    const CarveResult floor = carve(world, rock, at({3, 7, 0}, 1));
    EXPECT_EQ(floor.status, CarveStatus::kDone);
    EXPECT_EQ(floor.report.faces_castable_only, 1u);
    EXPECT_EQ(floor.world.face_count() - floor.world.solid().face_count(), 3u);

    const CarveResult filled = fill(world, rock, at({3, 7, 0}, 1));
    EXPECT_EQ(filled.status, CarveStatus::kDone);
    EXPECT_EQ(filled.report.faces_castable_only, 1u);

    const CarveResult refused = carve(world, rock, at({3, 7, 9000}, 1));
    EXPECT_EQ(refused.status, CarveStatus::kRefused);
    EXPECT_EQ(refused.report.faces_castable_only, 0u);

    // Wholly inside; around a corner of the box; flush with its top, which is beyond what it holds.
    EXPECT_EQ(carve(world, rock, at({3, 3, 2}, 5)).report.faces_castable_only, 3u);
    const Cutter box = make_crater(CutterShape::kBox, 0);
    EXPECT_EQ(carve(world, box, at({2, 2, 1.5}, 0.75)).report.faces_castable_only, 1u);
    EXPECT_EQ(carve(world, box, at({3, 3, 1.25}, 0.5)).report.faces_castable_only, 0u);
}

TEST(CastableOnly, ASolidByItselfHasNone) {
    Level level = test::box_level({0, 0, 0}, {4, 4, 4}, true);
    add_sheet(level, 1, 1, 0.5);
    const SolidResult cut = subtract(make_solid(level).value(), make_crater(CutterShape::kRocky, 5), at({2, 2, 0}, 1));
    EXPECT_TRUE(cut.done());
    EXPECT_EQ(cut.report.faces_castable_only, 0u);
}

bool any_sample_inside(const std::array<Vec3, 3>& face, const Cutter& cutter, const Pose& pose) {
    constexpr int kSamples = 24;
    for (int u = 0; u <= kSamples; ++u)
        for (int v = 0; u + v <= kSamples; ++v) {
            const Vec3 point =
                face[0] + (face[1] - face[0]) * (double(u) / kSamples) + (face[2] - face[0]) * (double(v) / kSamples);
            if (winding(cutter, pose, point) > 0.5) return true;
        }
    return false;
}

TEST(CastableOnly, AgreesWithSampling) {
    scenes::Rng rng(41);
    std::size_t sampled = 0, counted = 0;
    for (const CutterShape shape : {CutterShape::kRocky, CutterShape::kSpiky, CutterShape::kDrill, CutterShape::kWedge})
        for (const double size : {0.2, 1.0, 4.0}) {
            Level level = empty_level();
            std::vector<std::array<Vec3, 3>> faces(60);
            for (std::array<Vec3, 3>& face : faces) {
                Vec3 middle;
                for (int axis = 0; axis < 3; ++axis) middle[axis] = rng.uniform(-2, 2);
                for (Vec3& corner : face) corner = to_metres(snap(middle + rng.direction() * size).value());
                add_polygon(level, {face.begin(), face.end()});
            }
            const World world = kept(level);
            const Cutter cutter = make_crater(shape, 9);
            const Pose pose = at({}, 1.2);
            std::size_t inside = 0;
            for (const std::array<Vec3, 3>& face : faces) inside += any_sample_inside(face, cutter, pose);
            const CarveResult result = carve(world, cutter, pose);
            ASSERT_EQ(result.status, CarveStatus::kNothing);
            EXPECT_GE(result.report.faces_castable_only, inside);
            sampled += inside;
            counted += result.report.faces_castable_only;

            CarveJob job(world, cutter, pose);
            while (!job.run(0)) {
            }
            EXPECT_EQ(job.result().report.faces_castable_only, result.report.faces_castable_only);
        }
    EXPECT_GT(sampled, 150u);
    EXPECT_LE(counted, sampled + sampled / 20) << "but for those that samples are too coarse for";
}

}  // namespace
}  // namespace firma
