// SPDX-License-Identifier: MIT
// Chunks of a real blast as Bullet's bodies: they fall on the level's triangles, come to rest, and lie on the level.
#include <gtest/gtest.h>

#include "firma/queries.h"
#include "tests/bullet/bullet_chunks.h"
#include "tests/fracture/rubble.h"

namespace firma {
namespace {

/// Metres: as deep as a corner may lie in the level. Bullet lets bodies sink in, how far nothing promises.
constexpr double kDeepest = 0.05;

void judge_rest(const test::Rubble& rubble, const ConvexOptions& options) {
    test::BulletScene scene(rubble.world);
    std::vector<ConvexPieces> pieces;
    for (const Chunk& chunk : rubble.chunks) {
        const Result<ConvexPieces> made = convex_pieces(chunk.solid, options);
        ASSERT_TRUE(made.ok()) << made.error().text();
        pieces.push_back(made.value());
        scene.add(chunk, pieces.back());
    }
    for (int frame = 0; frame < 20 * 60; ++frame) scene.step();
    std::size_t corners = 0, fallen = 0;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        SCOPED_TRACE(k);
        const test::BulletChunk& chunk = *scene.chunks()[k];
        const double speed = double(chunk.body->getLinearVelocity().length());
        const double spin = double(chunk.body->getAngularVelocity().length());
        EXPECT_TRUE(!chunk.body->isActive() || (speed < 0.1 && spin < 0.5)) << speed << " m/s, " << spin << " rad/s";
        const Vec3 centre = chunk.place(rubble.chunks[k].mass.centre);
        EXPECT_NE(locate(rubble.world.solid(), centre), Where::kSolid);
        fallen += centre.z < rubble.chunks[k].origin.z + rubble.chunks[k].mass.centre.z - 0.1;
        for (const ConvexBody& piece : pieces[k].pieces)
            for (const Vec3& corner : piece.corners) {
                const Vec3 at = chunk.place(corner);
                ++corners;
                if (locate(rubble.world.solid(), at) != Where::kSolid) continue;
                EXPECT_LE(closest(rubble.world, at, 1).distance, kDeepest) << at.x << ' ' << at.y << ' ' << at.z;
            }
    }
    EXPECT_GT(corners, pieces.size() * 8);
    EXPECT_GT(fallen, pieces.size() / 3);
}

TEST(Bullet, ExactPiecesComeToRest) {
    judge_rest(test::rubble_of(test::depot_world(), 6, 0.05), {.max_pieces = 4096});
}

TEST(Bullet, HullsComeToRest) {
    judge_rest(test::rubble_of(test::depot_world(), 12, 0.05), {.max_concavity = 0.03});
}

}  // namespace
}  // namespace firma
