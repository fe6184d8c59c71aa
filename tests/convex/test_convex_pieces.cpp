// SPDX-License-Identifier: MIT
// Convex pieces: exactly the whole, exactly convex, few; and hulls near enough.
#include <gtest/gtest.h>

#include "tests/convex/convex_solids.h"
#include "tests/convex/judge_convex.h"
#include "tests/fracture/rubble.h"
#include "tests/sample.h"

namespace firma {
namespace {

using test::block;
using test::boxes;
using test::ConvexJudgement;

/// As many convex pieces as a solid takes, judged.
std::size_t pieces_of(const Solid& solid, std::size_t max_pieces = 4096) {
    const Result<ConvexPieces> result = convex_pieces(solid, {.max_pieces = max_pieces});
    EXPECT_TRUE(result.ok()) << result.error().text();
    if (!result.ok()) return 0;
    ConvexJudgement judgement;
    test::expect_convex_pieces(solid, result.value(), judgement);
    test::expect_union(solid, result.value());
    return result.value().pieces.size();
}

TEST(ConvexPieces, OfBoxes) {
    EXPECT_EQ(pieces_of(block({0, 0, 0}, {1, 2, 3})), 1u);
    const Solid l = boxes({{{0, 0, 0}, {3, 1, 1}}, {{0, 1, 0}, {1, 3, 1}}});
    EXPECT_EQ(pieces_of(l), 2u);
    const Solid u = boxes({{{0, 0, 0}, {3, 1, 1}}, {{0, 1, 0}, {1, 3, 1}}, {{2, 1, 0}, {3, 3, 1}}});
    EXPECT_EQ(pieces_of(u), 3u);
    const Solid t = boxes({{{-2, 0, 0}, {2, 1, 1}}, {{-0.5, 1, 0}, {0.5, 3, 1}}});
    EXPECT_EQ(pieces_of(t), 2u);
    const Solid plus = boxes({{{-2, -1, 0}, {2, 1, 1}}, {{-1, -2, 0}, {1, 2, 1}}});
    EXPECT_EQ(pieces_of(plus), 3u);
    // A step on a plate: the plate is not divided under it.
    const Solid step = boxes({{{-3, -3, 0}, {3, 3, 1}}, {{-1, -1, 1}, {1, 1, 2}}});
    EXPECT_EQ(pieces_of(step), 2u);
    // Two bodies in one solid.
    EXPECT_EQ(pieces_of(boxes({{{0, 0, 0}, {1, 1, 1}}, {{5, 0, 0}, {6, 1, 1}}})), 2u);
}

TEST(ConvexPieces, NumbersOfAnL) {
    const Solid l = boxes({{{0, 0, 0}, {3, 1, 1}}, {{0, 1, 0}, {1, 3, 1}}});
    const ConvexPieces result = convex_pieces(l, {.density = 1000}).value();
    EXPECT_EQ(result.reflex_edges, 1u);
    EXPECT_EQ(result.cuts, 1u);
    EXPECT_EQ(result.exact, 2u);
    double mass = 0;
    for (const ConvexBody& piece : result.pieces) {
        EXPECT_TRUE(piece.exact);
        EXPECT_EQ(piece.corners.size(), 8u);
        EXPECT_EQ(piece.faces.size(), 6u);
        EXPECT_EQ(piece.loops.size(), 24u);
        EXPECT_EQ(piece.hull_volume, piece.mass.volume);
        mass += piece.mass.mass;
    }
    EXPECT_EQ(mass, 5000);
}

TEST(ConvexPieces, OfRings) {
    // A frame, of square profile: four bars.
    const Solid frame = test::without_box(block({-2, -2, 0}, {2, 2, 1}), {-1, -1, -1}, {1, 1, 2});
    EXPECT_EQ(pieces_of(frame), 4u);
    const Solid ring = test::solid_of_mesh(test::ring_mesh(8, 4));
    EXPECT_EQ(pieces_of(ring), 8u);
    for (const auto& [teeth, bore] : {std::pair{6, 0.0}, {12, 0.0}, {12, 0.5}}) {
        const Solid gear = test::gear(teeth, bore);
        const std::size_t pieces = pieces_of(gear);
        EXPECT_GE(pieces, std::size_t(teeth));
        EXPECT_LE(pieces, std::size_t(4 * teeth)) << teeth << " teeth, bore " << bore;
    }
}

TEST(ConvexPieces, OfHollows) {
    const Solid shell = test::without_box(block({-2, -2, -2}, {2, 2, 2}), {-1, -1, -1}, {1, 1, 1});
    EXPECT_EQ(pieces_of(shell), 6u);
    // A body in the hollow of another.
    const Solid nested = unite(shell, test::box_mesh({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}).cutter().value(), {}).solid;
    EXPECT_EQ(pieces_of(nested), 7u);
    // Two hollows that touch nothing.
    const Solid two = test::without_box(shell, {1.25, -1, -1}, {1.75, 1, 1});
    EXPECT_LE(pieces_of(two), 12u);
}

TEST(ConvexPieces, WhereSolidsTouch) {
    // Along an edge, in the middle of one, at a corner.
    EXPECT_EQ(pieces_of(boxes({{{0, 0, 0}, {1, 1, 1}}, {{1, 1, 0}, {2, 2, 1}}})), 2u);
    EXPECT_EQ(pieces_of(boxes({{{0, 0, 0}, {1, 1, 3}}, {{1, 1, 1}, {2, 2, 2}}})), 2u);
    EXPECT_EQ(pieces_of(boxes({{{0, 0, 0}, {1, 1, 1}}, {{1, 1, 1}, {2, 2, 2}}})), 2u);
    // A chequered block: eight cubes of 27 that touch along edges, and all.
    Solid chequered = block({0, 0, 0}, {3, 3, 3});
    for (int x = 0; x < 3; ++x)
        for (int y = 0; y < 3; ++y)
            for (int z = 0; z < 3; ++z)
                if ((x + y + z) % 2)
                    chequered =
                        test::without_box(chequered, {double(x), double(y), double(z)}, {x + 1.0, y + 1.0, z + 1.0});
    EXPECT_EQ(pieces_of(chequered), 14u);
}

TEST(ConvexPieces, OfNeedles) {
    const double step = 1 / 4096.0;
    EXPECT_EQ(pieces_of(block({0, 0, 0}, {8, step, step})), 1u);
    // A slit as wide as a step, at a slant.
    test::TriangleMesh slit = test::box_mesh({-1, 0, -1}, {1, step, 1});
    for (Vec3& vertex : slit.vertices) vertex.y += 0.37 * vertex.x;
    EXPECT_LE(pieces_of(test::without(block({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}), slit.cutter().value())), 3u);
}

TEST(ConvexPieces, OfRandomRubble) {
    ConvexJudgement judgement;
    std::size_t most = 0, pieces = 0, solids = 0, hollow = 0;
    for (int seed = 0; seed < test::sample(200); ++seed) {
        SCOPED_TRACE(seed);
        const Solid solid = test::random_rubble(std::uint64_t(seed));
        if (solid.face_count() == 0) continue;
        ++solids;
        const Result<ConvexPieces> result = convex_pieces(solid, {.max_pieces = 4096});
        ASSERT_TRUE(result.ok()) << result.error().text();
        test::expect_convex_pieces(solid, result.value(), judgement, std::uint64_t(seed));
        if (seed % 10 == 0) test::expect_union(solid, result.value());
        if (seed % 20 == 0) {
            EXPECT_EQ(test::hash_of(convex_pieces(solid, {.max_pieces = 4096}).value()), test::hash_of(result.value()));
        }
        most = std::max(most, result.value().pieces.size());
        pieces += result.value().pieces.size();
        hollow += result.value().reflex_edges > 0;
    }
    EXPECT_GT(hollow, solids * 3 / 4);
    EXPECT_GT(pieces, solids * 4);
    EXPECT_GT(judgement.inside, std::size_t(test::sample(200) * 10));
    EXPECT_GT(judgement.outside, std::size_t(test::sample(200) * 5));
    RecordProperty("pieces", int(pieces));
    RecordProperty("most", int(most));
    RecordProperty("pairs that no plane of the solid parts", int(judgement.by_cut));
}

void expect_rubble_in_pieces(const test::Rubble& rubble) {
    ConvexJudgement judgement;
    std::size_t done = 0;
    for (const Chunk& chunk : rubble.chunks) {
        const Result<ConvexPieces> result = convex_pieces(chunk.solid, {.max_pieces = 4096});
        ASSERT_TRUE(result.ok()) << result.error().text();
        test::expect_convex_pieces(chunk.solid, result.value(), judgement, done);
        if (done++ % 5 == 0) test::expect_union(chunk.solid, result.value());
    }
    EXPECT_GT(judgement.inside, done * 5);
}

TEST(ConvexPieces, OfRubbleOfTheDepot) {
    const test::Rubble rubble = test::rubble_of(test::depot_world(), std::size_t(test::sample(15)), 0.02);
    ASSERT_GE(rubble.chunks.size(), std::size_t(test::sample(15)));
    expect_rubble_in_pieces(rubble);
}

TEST(ConvexPieces, OfRubbleOfAMap) {
    if (openarena_maps().empty()) GTEST_SKIP() << kNoOpenArena;
    const test::Rubble rubble = test::rubble_of(test::openarena_world("kaos2"), std::size_t(test::sample(15)), 0.02);
    ASSERT_GE(rubble.chunks.size(), std::size_t(test::sample(15)));
    expect_rubble_in_pieces(rubble);
}

/// No point of the hulls far from the pieces: by points all over each hull, against the whole.
void judge_hulls(const Solid& solid, double concavity, std::uint64_t seed, ConvexJudgement& judgement) {
    const Result<ConvexPieces> result = convex_pieces(solid, {.max_pieces = 4096, .max_concavity = concavity});
    ASSERT_TRUE(result.ok()) << result.error().text();
    const World world = make_world(solid).value();
    scenes::Rng rng(seed);
    double volume = 0;
    for (const ConvexBody& piece : result.value().pieces) {
        volume += piece.mass.volume;
        EXPECT_LE(piece.overhang, concavity);
        EXPECT_EQ(piece.exact, piece.overhang == 0);
        EXPECT_GE(piece.hull_volume, piece.mass.volume - 4e-6 * measure_solid(solid).area);
        for (int k = 0; k < 40; ++k) {
            // A random mixture of corners, of few of them the most.
            Vec3 at;
            double sum = 0;
            for (const Vec3& corner : piece.corners) {
                double weight = rng.uniform();
                weight = weight * weight * weight * weight;
                at += corner * weight;
                sum += weight;
            }
            at = at * (1 / sum);
            if (locate(solid, at) != Where::kAir) {
                ++judgement.inside;
                continue;
            }
            ++judgement.outside;
            EXPECT_TRUE(closest(world, at, concavity));
        }
    }
    EXPECT_NEAR(volume, measure_solid(solid).volume, 1e-12 * double(result.value().pieces.size()));
}

TEST(ConvexPieces, HullsNearEnough) {
    ConvexJudgement judgement;
    const Solid l = boxes({{{0, 0, 0}, {3, 1, 1}}, {{0, 1, 0}, {1, 3, 1}}});
    EXPECT_EQ(convex_pieces(l, {.max_concavity = 1.5}).value().pieces.size(), 1u);
    EXPECT_EQ(convex_pieces(l, {.max_concavity = 0.1}).value().pieces.size(), 2u);
    // The middle of its hull's slope is 1 m from either arm.
    EXPECT_EQ(convex_pieces(l, {.max_concavity = 1.05}).value().pieces.size(), 1u);
    EXPECT_EQ(convex_pieces(l, {.max_concavity = 0.95}).value().pieces.size(), 2u);
    for (int seed = 0; seed < test::sample(60); ++seed) {
        SCOPED_TRACE(seed);
        const Solid solid = test::random_rubble(std::uint64_t(seed));
        if (solid.face_count() > 0) judge_hulls(solid, seed % 2 ? 0.05 : 0.02, std::uint64_t(seed), judgement);
    }
    const test::Rubble rubble = test::rubble_of(test::depot_world(), std::size_t(test::sample(10)), 0.02);
    for (const Chunk& chunk : rubble.chunks) {
        const std::size_t exact = convex_pieces(chunk.solid, {.max_pieces = 4096}).value().pieces.size();
        judge_hulls(chunk.solid, 0.03, exact, judgement);
        EXPECT_LE(convex_pieces(chunk.solid, {.max_concavity = 0.03}).value().pieces.size(), exact);
    }
    EXPECT_GT(judgement.inside, 1000u);
    EXPECT_GT(judgement.outside, 50u);
}

TEST(ConvexPieces, WhatCannotBeIsRefused) {
    const auto reason = [](const Solid& solid, const ConvexOptions& options) {
        const Result<ConvexPieces> result = convex_pieces(solid, options);
        return result.ok() ? std::string() : result.error().reason;
    };
    const Solid cube = block({-1, -1, -1}, {1, 1, 1});
    EXPECT_EQ(reason(cube, {}), "");
    EXPECT_EQ(reason(Solid(), {}), "a solid without faces has no pieces");
    EXPECT_EQ(reason(test::turned_out(cube), {}), "rock that reaches to infinity has no pieces");
    EXPECT_EQ(reason(cube, {.max_pieces = 0}), "max_pieces is not within 1 to 16384");
    EXPECT_EQ(reason(cube, {.max_pieces = 16385}), "max_pieces is not within 1 to 16384");
    EXPECT_EQ(reason(cube, {.max_concavity = NAN}), "max_concavity is not finite or negative");
    EXPECT_EQ(reason(cube, {.max_concavity = -1}), "max_concavity is not finite or negative");
    EXPECT_EQ(reason(cube, {.max_concavity = 1e-5}),
              "max_concavity is below a tenth of a millimetre: 0 makes all pieces convex");
    EXPECT_EQ(reason(cube, {.density = INFINITY}), "the density is not finite or negative");
    const Solid frame = test::without_box(block({-2, -2, 0}, {2, 2, 1}), {-1, -1, -1}, {1, 1, 2});
    EXPECT_EQ(reason(frame, {.max_pieces = 4}), "");
    EXPECT_EQ(reason(frame, {.max_pieces = 3}),
              "takes more than max_pieces (3) convex pieces, of 4 reflex edges; max_concavity makes fewer");
    EXPECT_EQ(convex_pieces(frame, {.max_pieces = 3}).error().code, ErrorCode::kTooLarge);
}

}  // namespace
}  // namespace firma
