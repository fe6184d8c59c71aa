// SPDX-License-Identifier: MIT
// Bodies that break: momentum, angular momentum and mass are kept, every piece is where it was.
#include <gtest/gtest.h>

#include <algorithm>

#include "firma/debris.h"
#include "tests/fracture/rubble.h"
#include "tests/reference/judge_bodies.h"
#include "tests/sample.h"

namespace firma {
namespace {

struct Thrown {
    Bodies bodies;
    Debris debris;
};

/// What moves, about a point.
struct Motion {
    double mass = 0;
    Vec3 momentum, angular;
};

void add_motion(Motion& sum, const Body& body, const Vec3& about) {
    const Vec3 momentum = body.velocity * body.shape.mass();
    sum.mass += body.shape.mass();
    sum.momentum += momentum;
    sum.angular += angular_momentum(body) + cross(body.position - about, momentum);
}

void expect_near(const Vec3& a, const Vec3& b, double error) {
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(a[axis], b[axis], error);
}

/// A chunk that moves, tumbles and lies crooked.
BodyId throw_chunk(Thrown& scene, const Chunk& chunk) {
    const BodyId id = add_debris(scene.bodies, scene.debris, chunk).value();
    Body& body = *scene.bodies.find(id);
    body.rotation = random_turn(5);
    body.velocity = {3, -4, 5};
    body.spin = {2, 7, -6};
    return id;
}

TEST(Shatter, AChunkIsABodyInOneCall) {
    const test::Rubble rubble = test::rubble_of(test::depot_world(), 1, 0.1);
    Thrown scene;
    const Chunk& chunk = rubble.chunks[0];
    const BodyId id = add_debris(scene.bodies, scene.debris, chunk, {.max_spheres = 20}).value();
    const Body& body = *scene.bodies.find(id);
    EXPECT_EQ(body.shape.mass(), chunk.mass.mass);
    EXPECT_LE(body.shape.spheres().size(), 20u);
    expect_near(pose_of(body).position, chunk.origin, 1e-12);
    ASSERT_NE(scene.debris.find(scene.bodies, id), nullptr);
    EXPECT_TRUE(same_solid(scene.debris.find(scene.bodies, id)->solid, chunk.solid));
    EXPECT_EQ(scene.debris.find(scene.bodies, id)->matter, main_matter(chunk));
    remove_debris(scene.bodies, scene.debris, id);
    EXPECT_EQ(scene.bodies.find(id), nullptr);
    EXPECT_EQ(scene.debris.find(scene.bodies, id), nullptr);
    // Another body in its slot is no debris.
    const BodyId other = add_body(scene.bodies, test::body_here(test::ball(1), {}));
    EXPECT_EQ(other.slot, id.slot);
    EXPECT_EQ(scene.debris.find(scene.bodies, other), nullptr);
    EXPECT_FALSE(shatter(scene.bodies, scene.debris, other, {}).ok());
    EXPECT_FALSE(shatter(scene.bodies, scene.debris, {}, {}).ok());
}

TEST(Shatter, KeepsMassMomentumAndAngularMomentum) {
    const test::Rubble rubble = test::rubble_of(test::depot_world(), std::size_t(test::sample(10)), 0.02);
    std::size_t broken = 0, dust = 0;
    for (Chunk chunk : rubble.chunks) {
        chunk.mass = mass_properties(chunk.solid, 2000);  // as dense everywhere
        Thrown scene;
        const BodyId id = throw_chunk(scene, chunk);
        const Body whole = *scene.bodies.find(id);
        Motion before, after;
        add_motion(before, whole, whole.position);
        ShatterOptions options;
        options.fracture.min_volume = 0.002;
        options.fracture.impact = whole.position + Vec3{0.3, 0, 0};
        const Result<Shattered> result = shatter(scene.bodies, scene.debris, id, {}, options);
        ASSERT_TRUE(result.ok()) << result.error().text();
        const Shattered& pieces = result.value();
        if (pieces.cracks == 0) continue;
        ++broken;
        dust += pieces.dust;
        EXPECT_EQ(scene.bodies.find(id), nullptr);
        after.mass = pieces.dust_mass;
        after.momentum = pieces.dust_momentum;
        after.angular = pieces.dust_angular_momentum;
        for (const BodyId piece : pieces.pieces) {
            const Body& body = *scene.bodies.find(piece);
            add_motion(after, body, whole.position);
            expect_near(pose_of(body).position, pose_of(whole).position, 1e-12);
            expect_near(body.velocity, whole.velocity + cross(whole.spin, body.position - whole.position), 1e-9);
            EXPECT_EQ(scene.debris.find(scene.bodies, piece)->broken, 1u);
        }
        const double size = whole.shape.reach();
        EXPECT_NEAR(after.mass, before.mass, 1e-13 * before.mass);
        expect_near(after.momentum, before.momentum, 1e-12 * before.mass * 10);
        expect_near(after.angular, before.angular, 1e-12 * before.mass * 10 * size);
    }
    EXPECT_GT(broken, rubble.chunks.size() / 2);
    EXPECT_GT(dust, 0u) << "the test has no dust";
}

TEST(Shatter, PiecesAreOfTheMatterWhereTheyWere) {
    const test::Rubble rubble = test::rubble_of(test::depot_world(), std::size_t(test::sample(15)), 0.02);
    std::size_t mixed = 0;
    for (const Chunk& chunk : rubble.chunks) {
        Thrown scene;
        const BodyId id = throw_chunk(scene, chunk);
        const Body whole = *scene.bodies.find(id);
        Motion before, after;
        add_motion(before, whole, whole.position);
        ShatterOptions options;
        options.world = &rubble.world;
        const Result<Shattered> result = shatter(scene.bodies, scene.debris, id, {}, options);
        ASSERT_TRUE(result.ok()) << result.error().text();
        after.mass = result.value().dust_mass;
        after.momentum = result.value().dust_momentum;
        after.angular = result.value().dust_angular_momentum;
        std::uint32_t lowest = ~0u, highest = 0;
        for (const BodyId piece : result.value().pieces) {
            const Body& body = *scene.bodies.find(piece);
            add_motion(after, body, whole.position);
            const DebrisPiece& part = *scene.debris.find(scene.bodies, piece);
            lowest = std::min(lowest, part.matter);
            highest = std::max(highest, part.matter);
            const bool is_within = locate(part.solid, body.shape.centre()) == Where::kSolid;
            if (result.value().cracks > 0 && is_within) {
                EXPECT_EQ(part.matter, matter_at(rubble.world, chunk.origin + body.shape.centre()));
            }
        }
        mixed += lowest != highest;
        EXPECT_NEAR(after.mass, before.mass, 1e-12 * before.mass);
        expect_near(after.momentum, before.momentum, 1e-11 * before.mass);
        expect_near(after.angular, before.angular, 1e-11 * before.mass * 10);
    }
    EXPECT_GT(mixed, 0u);
}

// A rail at the edge of a deck has its centre of mass beside it, where there was air.
TEST(Shatter, AnAngleIsOfItsOwnMatter) {
    World world = with_anchors(test::depot_world());
    CarveOptions carving;
    carving.chunks = ChunkOptions{};
    std::vector<Chunk> chunks;
    for (const double y : {2.0, 12.0}) {
        const CarveResult cut =
            carve(world, make_crater(CutterShape::kRocky, 3), {.position = {14, y, 3.75}, .scale = 2.2}, carving);
        world = cut.world;
        chunks.insert(chunks.end(), cut.chunks.begin(), cut.chunks.end());
    }
    const auto bridge = std::max_element(chunks.begin(), chunks.end(),
                                         [](const Chunk& a, const Chunk& b) { return a.mass.mass < b.mass.mass; });
    ASSERT_NE(bridge, chunks.end());
    ASSERT_EQ(matter(world, main_matter(*bridge)).name, "steel");
    Thrown scene;
    const BodyId id = add_debris(scene.bodies, scene.debris, *bridge, {.max_spheres = 4}).value();
    ShatterOptions options;
    options.world = &world;
    options.fracture.impact = Vec3{14, 7, 3};
    const Shattered pieces =
        shatter(scene.bodies, scene.debris, id, fracture_pattern(matter(world, main_matter(*bridge))), options).value();
    std::size_t beside = 0;
    for (const BodyId piece : pieces.pieces) {
        const DebrisPiece& part = *scene.debris.find(scene.bodies, piece);
        EXPECT_EQ(part.matter, main_matter(*bridge));
        beside += locate(part.solid, scene.bodies.find(piece)->shape.centre()) != Where::kSolid;
    }
    EXPECT_GT(beside, 0u) << "the test has no angle";
}

TEST(Shatter, WhatIsBuriedIsDust) {
    const test::Rubble rubble = test::rubble_of(test::depot_world(), 1, 0.1);
    const World ground = test::ground();
    Thrown scene;
    const BodyId id = add_debris(scene.bodies, scene.debris, rubble.chunks[0]).value();
    scene.bodies.find(id)->position = {0, 0, 0};
    const double mass = scene.bodies.find(id)->shape.mass();
    ShatterOptions options;
    options.world = &ground;
    const Shattered pieces = shatter(scene.bodies, scene.debris, id, {.size = {0.2, 0.2, 0.2}}, options).value();
    ASSERT_GT(pieces.pieces.size(), 3u);
    for (const BodyId piece : pieces.pieces) EXPECT_GT(scene.bodies.find(piece)->position.z, 0);
    EXPECT_GT(pieces.dust_mass, 0.2 * mass);
    EXPECT_LT(pieces.dust_mass, 0.8 * mass);
}

TEST(Shatter, KeepsThemWhereDensityIsUneven) {
    const test::Rubble rubble = test::rubble_of(test::depot_world(), 1, 0.1);
    Chunk chunk = rubble.chunks[0];
    // As if its one end were heavier.
    chunk.mass.centre += Vec3{0.05, -0.02, 0.03};
    for (int axis = 0; axis < 3; ++axis)
        chunk.mass.inertia[std::size_t(axis)] = chunk.mass.inertia[std::size_t(axis)] * 1.3;
    chunk.mass.mass *= 2;
    Thrown scene;
    const BodyId id = throw_chunk(scene, chunk);
    const Body whole = *scene.bodies.find(id);
    Motion before, after;
    add_motion(before, whole, whole.position);
    const Shattered pieces =
        shatter(scene.bodies, scene.debris, id, {.size = {0.2, 0.2, 0.2}}, {.fracture = {.min_volume = 0}}).value();
    ASSERT_GT(pieces.pieces.size(), 3u);
    after.mass = pieces.dust_mass;
    after.momentum = pieces.dust_momentum;
    after.angular = pieces.dust_angular_momentum;
    for (const BodyId piece : pieces.pieces) add_motion(after, *scene.bodies.find(piece), whole.position);
    EXPECT_NEAR(after.mass, before.mass, 1e-12 * before.mass);
    expect_near(after.momentum, before.momentum, 1e-11 * before.mass);
    expect_near(after.angular, before.angular, 1e-11 * before.mass);
}

TEST(Shatter, WhatIsNotDividedStays) {
    const test::Rubble rubble = test::rubble_of(test::depot_world(), 1, 0.1);
    Thrown scene;
    const BodyId id = throw_chunk(scene, rubble.chunks[0]);
    const std::uint64_t before = hash_bodies(scene.bodies), solids = hash_debris(scene.debris);
    const Shattered none = shatter(scene.bodies, scene.debris, id, {.size = {90, 90, 90}}).value();
    EXPECT_EQ(none.pieces, std::vector<BodyId>{id});
    EXPECT_FALSE(shatter(scene.bodies, scene.debris, id, {.size = {0, 0, 0}}).ok());
    EXPECT_EQ(hash_bodies(scene.bodies), before);
    EXPECT_EQ(hash_debris(scene.debris), solids);
}

/// Pieces where they came loose, two seconds.
void judge_pieces_in(const World& level, std::size_t count) {
    const test::Rubble rubble = test::rubble_of(level, count, 0.02);
    ASSERT_GE(rubble.chunks.size(), count / 2);
    Thrown scene;
    for (const Chunk& chunk : rubble.chunks) {
        const Result<BodyId> id = add_debris(scene.bodies, scene.debris, chunk, {.max_spheres = 12});
        if (!id) continue;
        scene.bodies.find(id.value())->spin = {1, 2, 3};
        const FracturePattern pattern = fracture_pattern(matter(rubble.world, main_matter(chunk)));
        ASSERT_TRUE(shatter(scene.bodies, scene.debris, id.value(), pattern).ok());
    }
    std::size_t there = 0;
    for (const Body& body : scene.bodies.slots) there += body.shape.valid();
    EXPECT_GT(there, rubble.chunks.size() * 2);
    // Cuts of a map may open a way out of the level: what falls out there is not asked.
    reference::BodyDepths depths;
    EXPECT_EQ(depths.fault(rubble.world, scene.bodies), "") << "at the start";
    for (int frame = 0; frame < 120; ++frame) {
        step(scene.bodies, rubble.world, 1.0 / 60);
        const std::string fault = depths.fault(rubble.world, scene.bodies);
        ASSERT_EQ(fault, "") << "frame " << frame;
    }
}

TEST(Shatter, PiecesFallInTheDepot) {
    judge_pieces_in(test::depot_world(), std::size_t(test::sample(15)));
}

TEST(Shatter, PiecesFallInMaps) {
    if (openarena_maps().empty()) GTEST_SKIP() << kNoOpenArena;
    for (const char* map : {"kaos2", "oa_koth1"})
        judge_pieces_in(test::openarena_world(map), std::size_t(test::sample(6)));
}

}  // namespace
}  // namespace firma
