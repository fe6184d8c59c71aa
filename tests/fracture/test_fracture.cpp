// SPDX-License-Identifier: MIT
// Solids broken into pieces: the pieces are the whole, exactly, and look as their matter breaks.
#include <gtest/gtest.h>

#include <cstdlib>

#include "firma/fracture.h"
#include "firma/turn.h"
#include "tests/body/simple_bodies.h"
#include "tests/carve/cutters.h"
#include "tests/fracture/judge_pieces.h"
#include "tests/fracture/rubble.h"
#include "tests/sample.h"
#include "tests/solid/solid_levels.h"

namespace firma {
namespace {

Solid block(const Vec3& low, const Vec3& high) {
    return test::brush_world(map_text::box(low, high, "rock")).solid();
}

FracturePattern pattern_named(const char* matter) {
    return fracture_pattern(default_matters().matters[*matter_named(default_matters(), matter)]);
}

Vec3 size_of(const Solid& solid) {
    const Box box = solid.bounds();
    return box.high - box.low;
}

std::uint64_t hash_of(const Fracture& broken) {
    std::uint64_t hash = broken.pieces.size();
    for (const FracturePiece& piece : broken.pieces) hash = hash * 31 + hash_solid(piece.solid);
    return hash;
}

TEST(Fracture, PiecesAreTheWhole) {
    const Solid whole = block({-1, -0.5, -0.25}, {1, 0.5, 0.25});
    for (const char* matter : {"brick", "concrete", "wood", "steel", "glass", "rock"})
        for (const bool hit : {false, true}) {
            FractureOptions options;
            options.max_pieces = 24;
            if (hit) options.impact = Vec3{0.75, 0.1, 0.25};
            const Result<Fracture> broken = fracture(whole, pattern_named(matter), options);
            ASSERT_TRUE(broken.ok()) << broken.error().text();
            EXPECT_GE(broken.value().pieces.size(), 2u) << matter;
            EXPECT_LE(broken.value().pieces.size(), 24u) << matter;
            EXPECT_EQ(broken.value().refused, 0u);
            test::expect_whole(whole, broken.value());
        }
}

TEST(Fracture, APieceTakenTwiceOrLeftOutIsTold) {
    const Solid whole = block({-1, -1, -1}, {1, 1, 1});
    Fracture broken = fracture(whole, {}, {.max_pieces = 8}).value();
    ASSERT_EQ(broken.pieces.size(), 8u);
    double volume = 0;
    for (std::size_t k = 1; k < 8; ++k) volume += broken.pieces[k].mass.volume;
    EXPECT_LT(volume, 7.99);
    const Cutter again = cutter_from_solid(broken.pieces[0].solid).value();
    EXPECT_EQ(subtract(broken.pieces[1].solid, again, {}).status, CarveStatus::kNothing);
    EXPECT_EQ(subtract(whole, again, {}).status, CarveStatus::kDone);
}

TEST(Fracture, RubbleOfTheDepotBreaks) {
    const test::Rubble rubble = test::rubble_of(test::depot_world(), std::size_t(test::sample(20)), 0.02);
    ASSERT_GE(rubble.chunks.size(), std::size_t(test::sample(20)));
    std::size_t pieces = 0, fractures = 0;
    for (const Chunk& chunk : rubble.chunks)
        for (const char* matter : {"brick", "concrete", "wood", "glass", "rock"}) {
            FractureOptions options;
            options.seed = ++fractures;
            options.min_volume = 0.0005;
            options.max_pieces = 16;
            if (fractures % 2 == 0) options.impact = chunk.solid.bounds().high;
            const Result<Fracture> broken = fracture(chunk.solid, pattern_named(matter), options);
            ASSERT_TRUE(broken.ok()) << broken.error().text();
            EXPECT_EQ(broken.value().refused, 0u) << broken.value().refusal.text();
            pieces += broken.value().pieces.size();
            if (fractures % 8 == 0)
                test::expect_whole(chunk.solid, broken.value());
            else
                test::expect_volumes(chunk.solid, broken.value());
        }
    EXPECT_GT(pieces, fractures * 4);
}

TEST(Fracture, RubbleOfMapsBreaks) {
    if (openarena_maps().empty()) GTEST_SKIP() << kNoOpenArena;
    for (const char* map : {"kaos2", "oa_koth1"}) {
        const test::Rubble rubble = test::rubble_of(test::openarena_world(map), std::size_t(test::sample(10)), 0.02);
        std::size_t fractures = 0, pieces = 0;
        for (const Chunk& chunk : rubble.chunks)
            for (const char* matter : {"brick", "concrete", "wood", "glass"}) {
                FractureOptions options;
                options.seed = ++fractures;
                options.max_pieces = 12;
                if (fractures % 2 == 0) options.impact = chunk.solid.bounds().low;
                const Result<Fracture> broken = fracture(chunk.solid, pattern_named(matter), options);
                ASSERT_TRUE(broken.ok()) << broken.error().text();
                pieces += broken.value().pieces.size();
                if (fractures % 16 == 0)
                    test::expect_whole(chunk.solid, broken.value());
                else
                    test::expect_volumes(chunk.solid, broken.value());
            }
        EXPECT_GE(fractures, 4 * std::size_t(test::sample(10))) << map;
        EXPECT_GT(pieces, fractures * 2) << map;
    }
}

TEST(Fracture, BricksLieInRowsHalfABrickOn) {
    // A wall 2 m long, 1 m high, one brick thick, its low corner at the origin.
    const Solid wall = block({0, 0, 0}, {2, 0.125, 1});
    FracturePattern pattern = pattern_named("brick");
    pattern.growth = 0;
    const Fracture broken = fracture(wall, pattern, {.max_pieces = 4096, .min_volume = 0}).value();
    // 16 rows: 8 of 8 bricks, 8 of 7 bricks and two halves.
    EXPECT_EQ(broken.pieces.size(), 8u * 8 + 8 * 9);
    std::size_t halves = 0;
    for (const FracturePiece& piece : broken.pieces) {
        const Box box = piece.solid.bounds();
        const Vec3 size = box.high - box.low;
        EXPECT_EQ(size.z, 0.0625);
        EXPECT_EQ(size.y, 0.125);
        const int row = int(box.low.z / 0.0625);
        EXPECT_EQ(box.low.z, row * 0.0625);
        const double along = box.low.x + (row % 2 ? 0.125 : 0);
        if (size.x == 0.125) {
            ++halves;
            EXPECT_TRUE(row % 2 == 1 && (box.low.x == 0 || box.high.x == 2));
        } else {
            EXPECT_EQ(size.x, 0.25);
            EXPECT_EQ(along * 4, double(int(along * 4)));
        }
    }
    EXPECT_EQ(halves, 16u);
}

TEST(Fracture, ConcreteKeepsItsThickness) {
    const Solid slab = block({0, 0, 0}, {3, 0.25, 2});
    const Fracture broken = fracture(slab, pattern_named("concrete"), {}).value();
    EXPECT_GE(broken.pieces.size(), 8u);
    for (const FracturePiece& piece : broken.pieces) EXPECT_NEAR(size_of(piece.solid).y, 0.25, 1e-5);
}

TEST(Fracture, WoodSplintersAlongItsGrain) {
    for (int grain = 0; grain < 3; ++grain) {
        Vec3 high{0.2, 0.2, 0.2};
        high[grain] = 2;
        high[(grain + 1) % 3] = 0.125;
        const Fracture broken = fracture(block({}, high), pattern_named("wood"), {.min_volume = 0}).value();
        EXPECT_GE(broken.pieces.size(), 8u);
        for (const FracturePiece& piece : broken.pieces) {
            const Vec3 size = size_of(piece.solid);
            EXPECT_GT(size[grain], 2 * size[(grain + 1) % 3]);
            EXPECT_GT(size[grain], 2 * size[(grain + 2) % 3]);
        }
    }
}

TEST(Fracture, GlassBreaksAwayFromTheImpact) {
    const Solid pane = block({0, 0, 0}, {2, 0.015625, 1.5});
    const Vec3 impact{0.5, 0, 0.75};
    const Fracture broken =
        fracture(pane, pattern_named("glass"), {.impact = impact, .max_pieces = 80, .min_volume = 0}).value();
    EXPECT_GE(broken.pieces.size(), 40u);
    std::size_t at_impact = 0;
    double near = 0, far = 0;
    std::size_t near_count = 0, far_count = 0;
    for (const FracturePiece& piece : broken.pieces) {
        EXPECT_NEAR(size_of(piece.solid).y, 0.015625, 1e-5) << "cracks go straight through";
        double least = 1e9;
        const World own = make_world(piece.solid).value();
        least = closest(own, impact, 10).distance;
        at_impact += least < 0.001;
        const bool is_near = length(piece.mass.centre - impact) < 0.3;
        (is_near ? near : far) += piece.mass.volume;
        ++(is_near ? near_count : far_count);
    }
    EXPECT_GE(at_impact, 5u) << "shards that meet where it was hit";
    EXPECT_LT(near / double(near_count) * 2, far / double(far_count)) << "larger away from there";
}

TEST(Fracture, PiecesAreSmallerWhereItWasHit) {
    const Solid whole = block({0, 0, 0}, {4, 1, 1});
    const Fracture broken =
        fracture(whole, pattern_named("rock"), {.impact = Vec3{0, 0.5, 0.5}, .max_pieces = 60}).value();
    double near = 0, far = 0;
    std::size_t near_count = 0, far_count = 0;
    for (const FracturePiece& piece : broken.pieces) {
        const bool is_near = piece.mass.centre.x < 1;
        (is_near ? near : far) += piece.mass.volume;
        ++(is_near ? near_count : far_count);
    }
    EXPECT_LT(near / double(near_count) * 3, far / double(far_count));
}

TEST(Fracture, CracksHaveTheirMaterialAndOtherFacesKeepTheirs) {
    const World world = test::brush_world(map_text::box({-1, -1, -1}, {1, 1, 1}, "rock"));
    const Fracture broken = fracture(world.solid(), {}, {.max_pieces = 6, .material = 77}).value();
    double area = 0;
    for (const FracturePiece& piece : broken.pieces) {
        const World own = make_world(piece.solid).value();
        for (const Face& face : own.faces()) {
            EXPECT_EQ(face.material == 77, face.source_edit != 0);
            if (face.material == 77) continue;
            EXPECT_LT(face.source, 6u);
            Vec3 sum;
            for (std::size_t k = 2; k < face.corners.size(); ++k)
                sum += cross(face.corners[k - 1] - face.corners[0], face.corners[k] - face.corners[0]);
            area += length(sum) / 2;
        }
    }
    EXPECT_NEAR(area, 24, 1e-4) << "the old surface, each part once";
    const std::uint32_t matter = matter_at(world, {});
    EXPECT_EQ(crack_material(world, matter), std::nullopt) << "no cut has left it yet";
    const CarveResult cut = carve(world, make_crater(CutterShape::kRocky, 1), test::pose_at(1, 1, 1, 0.5));
    const std::optional<std::uint32_t> material = crack_material(cut.world, matter);
    ASSERT_TRUE(material);
    EXPECT_EQ(cut.world.material_name(*material), firma::matter(cut.world, matter).inside);
}

TEST(Fracture, TheSameBitsFromTheSameSeed) {
    const Solid whole = block({-1, -0.5, -0.25}, {1, 0.5, 0.25});
    for (const char* matter : {"brick", "concrete", "wood", "glass"}) {
        const FracturePattern pattern = pattern_named(matter);
        const std::uint64_t first = hash_of(fracture(whole, pattern).value());
        EXPECT_EQ(hash_of(fracture(whole, pattern).value()), first);
        const std::uint64_t other = hash_of(fracture(whole, pattern, {.seed = 2}).value());
        EXPECT_EQ(other != first, pattern.crooked > 0) << matter;
    }
}

TEST(Fracture, PiecesBreakAgain) {
    const Solid whole = block({-1, -1, -1}, {1, 1, 1});
    const Fracture first = fracture(whole, {.size = {1, 1, 1}}, {.max_pieces = 5}).value();
    for (const FracturePiece& piece : first.pieces)
        test::expect_whole(piece.solid, fracture(piece.solid, {.size = {0.4, 0.4, 0.4}}, {.max_pieces = 6}).value());
}

TEST(Fracture, HollowsAndSeveralBodies) {
    SolidResult hollow =
        subtract(block({-1, -1, -1}, {1, 1, 1}), make_crater(CutterShape::kRocky, 3), test::pose_at(0, 0, 0, 0.5));
    ASSERT_TRUE(hollow.done());
    test::expect_whole(hollow.solid, fracture(hollow.solid, {}, {.max_pieces = 20}).value());
    const SolidResult two = unite(hollow.solid, make_crater(CutterShape::kSpiky, 1), test::pose_at(5, 0, 0));
    ASSERT_TRUE(two.done());
    const Fracture apart = fracture(two.solid, {.size = {9, 9, 9}}).value();
    EXPECT_EQ(apart.pieces.size(), 2u);
    EXPECT_EQ(apart.cracks, 0u);
    test::expect_whole(two.solid, apart);
}

TEST(Fracture, WhatCannotBeIsRefused) {
    const Solid whole = block({-1, -1, -1}, {1, 1, 1});
    const auto reason = [&](const FracturePattern& pattern, const FractureOptions& options) {
        const Result<Fracture> broken = fracture(whole, pattern, options);
        return broken.ok() ? std::string() : broken.error().reason;
    };
    EXPECT_EQ(reason({}, {}), "");
    EXPECT_EQ(reason({.size = {1, NAN, 1}}, {}), "the pattern's size is not finite or below a millimetre");
    EXPECT_EQ(reason({.size = {1, 0, 1}}, {}), "the pattern's size is not finite or below a millimetre");
    EXPECT_EQ(reason({.growth = -1}, {}), "the pattern's growth is not finite or negative");
    EXPECT_EQ(reason({.crooked = NAN}, {}), "the pattern's crooked is not within 0 to 1");
    EXPECT_EQ(reason({.axes = Quaternion{0, 0, 0, 0}}, {}), "the pattern's axes are zero or not finite");
    EXPECT_EQ(reason({}, {.impact = Vec3{INFINITY, 0, 0}}), "the impact is not finite");
    EXPECT_EQ(reason({}, {.max_pieces = 0}), "max_pieces is not within 1 to 4096");
    EXPECT_EQ(reason({}, {.min_volume = NAN}), "min_volume is not finite or negative");
    EXPECT_EQ(reason({}, {.density = -1}), "the density is not finite or negative");
    EXPECT_EQ(reason({.style = CrackStyle(9)}, {}), "the pattern's style is none");
    EXPECT_EQ(fracture(Solid(), {}).error().reason, "a solid without faces has no pieces");
    const Solid rock = make_world(test::box_level({0, 0, 0}, {4, 4, 4}, true)).value().solid();
    EXPECT_EQ(fracture(rock, {}).error().reason, "rock that reaches to infinity has no pieces");
    const Solid far = block({8000, 0, 0}, {8100, 100, 100});
    EXPECT_EQ(fracture(far, {}).error().code, ErrorCode::kOutOfRange);
    EXPECT_EQ(fracture(whole, {}, {.max_pieces = 1}).value().pieces.size(), 1u);
    // An impact far away: all pieces are as large as they can be.
    EXPECT_TRUE(fracture(whole, pattern_named("glass"), {.impact = Vec3{1e200, 0, 0}}).ok());
}

TEST(Fracture, AxesOfSlabsAndBeams) {
    const auto expect_axis = [](const Vec3& axis, int which) { EXPECT_NEAR(std::fabs(axis[which]), 1, 1e-9); };
    const TurnMatrix slab = matrix_of(fracture_axes(block({0, 0, 0}, {3, 0.25, 2})));
    expect_axis(slab.column(0), 0);
    expect_axis(slab.column(1), 2);
    expect_axis(slab.column(2), 1);
    const TurnMatrix bricks = matrix_of(fracture_axes(block({0, 0, 0}, {3, 0.25, 2}), CrackStyle::kBricks));
    expect_axis(bricks.column(0), 0);
    expect_axis(bricks.column(1), 1);
    EXPECT_NEAR(bricks.column(2).z, 1, 1e-9);
    EXPECT_EQ(fracture_axes(Solid()), (Quaternion{0, 0, 0, 1}));
}

}  // namespace
}  // namespace firma
