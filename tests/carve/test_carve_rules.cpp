// SPDX-License-Identifier: MIT
// What refuses a cut or shrinks it: zones, materials, limits, and cutters that cannot be placed.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "firma/carve.h"
#include "firma/level.h"
#include "firma/queries.h"
#include "firma/solid.h"
#include "tests/carve/cutters.h"
#include "tests/solid/solid_levels.h"
#include "world/world_data.h"

namespace firma {
namespace {

/// A room of 8 m in rock: a cube wound inward, its floor of one material and the rest of another.
World room(const CarveRules& rules = {}) {
    const Level level =
        read_obj(
            "v -4 -4 -4\nv 4 -4 -4\nv 4 4 -4\nv -4 4 -4\nv -4 -4 4\nv 4 -4 4\nv 4 4 4\nv -4 4 4\n"
            "usemtl floor\nf 1 2 3 4\nusemtl wall\nf 8 7 6 5\nf 5 6 2 1\nf 6 7 3 2\nf 7 8 4 3\nf 8 5 1 4\n",
            "room")
            .value();
    return make_world(level, {{}, {}, rules}).value();
}

std::uint32_t material_of(const World& world, const char* name) {
    for (std::uint32_t k = 0; k < 8; ++k)
        if (world.material_name(k) == name) return k;
    return ~0u;
}

CarveRules with_hardness(const World& world, const char* name, double hardness) {
    CarveRules rules;
    rules.hardness.assign(8, 0);
    rules.hardness[material_of(world, name)] = hardness;
    return rules;
}

const Cutter kRock = make_crater(CutterShape::kRocky, 5);

void expect_refused(const World& before, const CarveResult& result, const char* part_of_reason) {
    EXPECT_EQ(result.status, CarveStatus::kRefused);
    EXPECT_NE(result.error.text().find(part_of_reason), std::string::npos) << result.error.text();
    EXPECT_EQ(&result.world.data(), &before.data());
    EXPECT_FALSE(check_world(result.world));
}

TEST(CarveRules, AZoneCutsShortAndRefusesACutThatTakesNothingElse) {
    CarveRules rules;
    rules.zones.push_back({"vault", {{3, -1, -1}, {6, 1, 1}}, 1});
    const World world = room(rules), plain = room();
    expect_refused(world, carve(world, kRock, test::pose_at(4, 0, 0, 0.5)), "zone vault may not be carved");
    expect_refused(world, carve(world, kRock, test::pose_at(3.5, 0, 0, 0.5)), "zone vault may not be carved");
    const CarveResult cut = carve(world, kRock, test::pose_at(4, 0, 0, 2)),
                      whole = carve(plain, kRock, test::pose_at(4, 0, 0, 2));
    ASSERT_TRUE(cut.done());
    EXPECT_EQ(cut.report.cut_short, 1u);
    test::expect_sound_world(cut.world);
    // Of a crater that holds all of the zone's inner end the rock there is left: 4 square metres across.
    EXPECT_EQ(locate(whole.world.solid(), {4.5, 0.9, 0.9}), Where::kAir);
    EXPECT_EQ(locate(cut.world.solid(), {4.5, 0.9, 0.9}), Where::kSolid);
    EXPECT_EQ(locate(cut.world.solid(), {4.5, 1.1, 0.9}), Where::kAir);
    EXPECT_LT(cut.report.volume, whole.report.volume - 4);
    EXPECT_EQ(carve(world, kRock, test::pose_at(-4, 0, 0)).report.cut_short, 0u);
}

TEST(CarveRules, AZoneInsideTheCutterCountsAsWell) {
    CarveRules rules;
    rules.zones.push_back({"pea", {{-4.5, 0, 0}, {-4.25, 0.25, 0.25}}, 1});
    const World world = room(rules), plain = room();
    const CarveResult cut = carve(world, kRock, test::pose_at(-4, 0, 0, 3)),
                      whole = carve(plain, kRock, test::pose_at(-4, 0, 0, 3));
    ASSERT_TRUE(cut.done());
    EXPECT_EQ(cut.report.cut_short, 1u);
    EXPECT_NEAR(whole.report.volume - cut.report.volume, 1.0 / 64, 1e-12);
    test::expect_sound_world(cut.world);
}

TEST(CarveRules, ASoftZoneShrinksTheCutter) {
    CarveRules rules;
    rules.zones.push_back({"clay", {{3, -2, -2}, {9, 2, 2}}, 0.5});
    const World world = room(rules), plain = room();
    const CarveResult shrunk = carve(world, kRock, test::pose_at(4, 0, 0, 2)),
                      small = carve(plain, kRock, test::pose_at(4, 0, 0, 1));
    ASSERT_TRUE(shrunk.done());
    EXPECT_EQ(shrunk.report.scale, 0.5);
    EXPECT_EQ(shrunk.report.volume, small.report.volume);
    EXPECT_EQ(carve(world, kRock, test::pose_at(-4, 0, 0, 2)).report.scale, 1);
}

TEST(CarveRules, AMaterialRefusesOrShrinks) {
    const World plain = room();
    const World hard = with_rules(plain, with_hardness(plain, "floor", 1)).value();
    expect_refused(hard, carve(hard, kRock, test::pose_at(0, 0, -4)), "material floor may not be carved");
    EXPECT_TRUE(carve(hard, kRock, test::pose_at(4, 0, 0)).done());
    const World tough = with_rules(plain, with_hardness(plain, "floor", 0.75)).value();
    const CarveResult shrunk = carve(tough, kRock, test::pose_at(0, 0, -4, 2));
    ASSERT_TRUE(shrunk.done());
    EXPECT_EQ(shrunk.report.scale, 0.25);
    EXPECT_EQ(shrunk.report.volume, carve(plain, kRock, test::pose_at(0, 0, -4, 0.5)).report.volume);
}

TEST(CarveRules, HardnessIsAskedOfWhatIsTakenOnly) {
    const World plain = room();
    const World hard = with_rules(plain, with_hardness(plain, "floor", 1)).value();
    // Its box meets the floor's, it does not.
    EXPECT_TRUE(carve(hard, make_crater(CutterShape::kBox, 0), test::pose_at(4, 0, -2.5)).done());
}

TEST(CarveRules, LimitsRefuse) {
    const auto limited = [](auto set) {
        CarveRules rules;
        set(rules);
        return room(rules);
    };
    World world = limited([](CarveRules& r) { r.max_faces = 10; });
    expect_refused(world, carve(world, kRock, test::pose_at(4, 0, 0)), "more than 10 faces");
    world = limited([](CarveRules& r) { r.max_new_faces = 20; });
    expect_refused(world, carve(world, kRock, test::pose_at(4, 0, 0)), "more than the 20 new faces");
    world = limited([](CarveRules& r) { r.max_candidate_faces = 2; });
    expect_refused(world, carve(world, kRock, test::pose_at(4, 4, 4)),
                   "it meets more than the 2 faces that the world allows");
    world = limited([](CarveRules& r) { r.max_cutter_triangles = 100; });
    expect_refused(world, carve(world, kRock, test::pose_at(4, 0, 0)), "180 triangles; the world allows 100");
    world = limited([](CarveRules& r) { r.max_cutter_size = 2; });
    expect_refused(world, carve(world, kRock, test::pose_at(4, 0, 0, 3)), "the world allows 2 m");
}

TEST(CarveRules, FacesCountOnceHoweverManyFacetsTheyHave) {
    CarveRules rules;
    rules.max_candidate_faces = 1;
    const World whole = room(rules);
    // With a hole in it the floor has several facets.
    const CarveResult first = carve(whole, kRock, test::pose_at(0, 0, -4));
    ASSERT_TRUE(first.done()) << first.error.text();
    const CarveResult second = carve(first.world, make_crater(CutterShape::kBox, 0), test::pose_at(2.5, 2.5, -4));
    ASSERT_TRUE(second.done()) << second.error.text();
    EXPECT_EQ(second.report.candidate_faces, 1u);
    EXPECT_GT(second.report.faces_removed, 1u);
    expect_refused(second.world, carve(second.world, kRock, test::pose_at(0, 0, -4, 1.1)), "more than the 1 faces");
}

TEST(CarveRules, WhatCannotBePlacedIsRefused) {
    const World world = room();
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    expect_refused(world, carve(world, Cutter(), test::pose_at(0, 0, 0)), "empty cutter");
    expect_refused(world, carve(world, kRock, test::pose_at(nan, 0, 0)), "not finite");
    expect_refused(world, carve(world, kRock, test::pose_at(0, 0, 0, infinity)), "finite number above zero");
    expect_refused(world, carve(world, kRock, test::pose_at(0, 0, 0, 0)), "above zero");
    expect_refused(world, carve(world, kRock, test::pose_at(8192, 0, 0)), "outside the world");
    expect_refused(world, carve(world, kRock, test::pose_at(0, 0, 0, 1e-5)), "no area on the grid");
    Pose spun = test::pose_at(0, 0, 0);
    spun.rotation = {0, 0, 0, 0};
    expect_refused(world, carve(world, kRock, spun), "rotation");
}

/// As they may come from a file: nobody judges them.
World with_any_rules(const World& world, const CarveRules& rules) {
    auto data = std::make_shared<WorldData>(world.data());
    data->rules = std::make_shared<const CarveRules>(rules);
    return World(std::move(data));
}

TEST(CarveRules, ZonesThatAreNoBoxesDoNothing) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CarveRules rules;
    rules.zones.push_back({"empty", {}, 1});
    rules.zones.push_back({"nothing", {{nan, nan, nan}, {nan, nan, nan}}, 1});
    rules.zones.push_back({"far", {{9000, 9000, 9000}, {9001, 9001, 9001}}, 1});
    rules.zones.push_back({"unasked", {{-9e9, -9e9, -9e9}, {9e9, 9e9, 9e9}}, nan});
    const World world = with_any_rules(room({}), rules);
    EXPECT_TRUE(carve(world, kRock, test::pose_at(4, 0, 0)).done());
    rules.zones.push_back({"everywhere", {{-9e9, -9e9, -9e9}, {9e9, 9e9, 9e9}}, 1});
    const World closed = with_any_rules(world, rules);
    expect_refused(closed, carve(closed, kRock, test::pose_at(4, 0, 0)), "zone everywhere");
}

TEST(Carve, InTheAirNothingHappens) {
    const World world = room();
    const CarveResult result = carve(world, kRock, test::pose_at(0, 0, 0));
    EXPECT_EQ(result.status, CarveStatus::kNothing);
    EXPECT_EQ(&result.world.data(), &world.data());
    EXPECT_EQ(fill(world, kRock, test::pose_at(100, 0, 0)).status, CarveStatus::kNothing);  // in the rock
}

TEST(Carve, NewFacesSayWhereTheyComeFrom) {
    const World world = room();
    CarveOptions options;
    options.material = "rubble";
    const CarveResult result = carve(world, kRock, test::pose_at(4, 0, 0), options);
    ASSERT_TRUE(result.done());
    EXPECT_EQ(result.world.version(), world.version() + 1);
    std::size_t from_cutter = 0, from_level = 0;
    for (const Face& face : result.world.faces()) {
        EXPECT_TRUE(face.solid);
        if (face.source_edit == 0) {
            ++from_level;
            EXPECT_LT(face.source, 6u);
            continue;
        }
        ++from_cutter;
        EXPECT_EQ(face.source_edit, 1u);
        EXPECT_LT(face.source, 180u);
        EXPECT_EQ(result.world.material_name(face.material), "rubble");
    }
    EXPECT_GT(from_cutter, 40u);
    EXPECT_GT(from_level, 6u);
    EXPECT_EQ(result.world.face_count(), world.face_count() - result.report.faces_removed + result.report.faces_added);
}

TEST(Carve, UntouchedFacesKeepTheirIds) {
    const World world = room();
    const CarveResult result = carve(world, kRock, test::pose_at(0, 0, -4));
    ASSERT_TRUE(result.done());
    for (std::uint32_t id = 0; id < 6; ++id) {
        const auto before = world.find_face({id}), after = result.world.find_face({id});
        ASSERT_TRUE(before);
        EXPECT_EQ(after.has_value(), id != 0) << "the floor alone was cut";
        if (after) {
            EXPECT_EQ(after->corners, before->corners);
        }
    }
}

TEST(Carve, SeveralEditsBecomeOneVersion) {
    const World world = room();
    WorldEdit edit(world);
    EXPECT_TRUE(edit.carve(kRock, test::pose_at(4, 0, 0)).done());
    EXPECT_TRUE(edit.carve(kRock, test::pose_at(-4, 0, 0)).done());
    EXPECT_EQ(edit.carve(kRock, test::pose_at(0, 0, 0)).status, CarveStatus::kNothing);
    EXPECT_TRUE(edit.fill(make_crater(CutterShape::kBox, 0), test::pose_at(0, 0, -4)).done());
    const World after = edit.finish();
    EXPECT_EQ(after.version(), world.version() + 1);
    EXPECT_FALSE(check_world(after));
    World one_by_one = carve(world, kRock, test::pose_at(4, 0, 0)).world;
    one_by_one = carve(one_by_one, kRock, test::pose_at(-4, 0, 0)).world;
    one_by_one = fill(one_by_one, make_crater(CutterShape::kBox, 0), test::pose_at(0, 0, -4)).world;
    EXPECT_EQ(after.face_count(), one_by_one.face_count());
    EXPECT_EQ(world.face_count(), 6u);
    EXPECT_EQ(WorldEdit(world).finish().version(), world.version());
}

TEST(Carve, InSlicesItEndsInTheSameFaces) {
    const World world = room();
    const CarveResult at_once = carve(world, kRock, test::pose_at(4, 1, 1, 1.5));
    CarveJob job(world, kRock, test::pose_at(4, 1, 1, 1.5));
    int slices = 1;
    while (!job.run(0)) ++slices;
    EXPECT_GT(slices, 10);
    const CarveResult sliced = job.result();
    ASSERT_TRUE(sliced.done());
    const std::vector<Face> a = at_once.world.faces(), b = sliced.world.faces();
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k) {
        EXPECT_EQ(a[k].id, b[k].id);
        EXPECT_EQ(a[k].corners, b[k].corners);
    }
    EXPECT_EQ(sliced.report.volume, at_once.report.volume);
}

TEST(Carve, ADroppedJobLeavesNoTrace) {
    const World world = room();
    {
        CarveJob job(world, kRock, test::pose_at(4, 0, 0));
        for (int k = 0; k < 8; ++k) job.run(0);
        EXPECT_FALSE(job.finished());
    }
    EXPECT_EQ(world.face_count(), 6u);
    EXPECT_FALSE(check_world(world));
}

TEST(Carve, ABoxOutOfARoomsWallHasItsVolume) {
    const World world = room();
    // 2 x 2 x 2 m, one metre of it in the rock; a flush one takes all of it.
    EXPECT_NEAR(carve(world, make_crater(CutterShape::kBox, 0), test::pose_at(4, 0, 0)).report.volume, 4, 0.01);
    const CarveResult flush = carve(world, make_crater(CutterShape::kBox, 0), test::pose_at(5, 0, 0));
    ASSERT_TRUE(flush.done());
    EXPECT_NEAR(flush.report.volume, 8, 0.02);
    // It opened the wall: there is a way in.
    EXPECT_EQ(cast(flush.world, {{0, 0, 0}, 0.5}, {5, 0, 0}).status, Status::kMiss);
}

// Finding 8 (F8).
TEST(CarveVolume, IsAsExactFarOutAsInTheMiddle) {
    // The same tiny cuts, through an edge of a box that lies in the middle of the world, and one at its rim.
    const auto taken = [](std::int32_t x, CutterShape shape, std::uint64_t seed) {
        const double far = x;
        const World world = make_world(test::box_level({far, far, far}, {far + 4, far + 4, far + 4})).value();
        const Pose pose{{far + 4, far + 2, far + 4}, {0.1, 0.2, 0.3, 0.9}, 0.04};
        const CarveResult one = carve(world, make_crater(shape, seed), pose);
        Pose next = pose;
        next.position.y += 0.03;  // through what the first one left
        const CarveResult two = carve(one.world, make_crater(shape, seed + 1), next);
        EXPECT_TRUE(one.done() && two.done());
        return std::array{one.report.volume, two.report.volume};
    };
    for (const CutterShape shape : {CutterShape::kRocky, CutterShape::kBox, CutterShape::kWedge}) {
        const auto near = taken(-2, shape, 7), far = taken(8180, shape, 7), other = taken(-8190, shape, 7);
        for (std::size_t k = 0; k < near.size(); ++k) {
            EXPECT_GT(near[k], 0);
            EXPECT_EQ(near[k], far[k]);
            EXPECT_EQ(near[k], other[k]);
        }
    }
}

TEST(Carve, ACavityInRockAndAPillarInTheAir) {
    const World world = room();
    const CarveResult cavity = carve(world, kRock, test::pose_at(20, 0, 0));
    ASSERT_TRUE(cavity.done());
    EXPECT_EQ(cavity.report.faces_removed, 0u);
    EXPECT_EQ(cavity.report.faces_added, 180u);
    EXPECT_EQ(locate(cavity.world.solid(), {20, 0, 0}), Where::kAir);
    EXPECT_EQ(locate(world.solid(), {20, 0, 0}), Where::kSolid);
    const CarveResult boulder = fill(world, kRock, test::pose_at(0, 0, 0));
    ASSERT_TRUE(boulder.done());
    EXPECT_EQ(locate(boulder.world.solid(), {0, 0, 0}), Where::kSolid);
    EXPECT_NEAR(boulder.report.volume, -cavity.report.volume, 1e-9);
    // A larger cutter around either takes it away again.
    EXPECT_EQ(carve(boulder.world, kRock, test::pose_at(0, 0, 0, 2)).world.face_count(), world.face_count());
    EXPECT_EQ(fill(cavity.world, kRock, test::pose_at(20, 0, 0, 2)).world.face_count(), world.face_count());
}

TEST(Carve, TheSameCutterInTheSamePlaceTakesNothing) {
    const World world = room();
    for (const CutterShape shape : {CutterShape::kRocky, CutterShape::kSpiky, CutterShape::kBox}) {
        const Cutter cutter = make_crater(shape, 9);
        const CarveResult first = carve(world, cutter, test::pose_at(4, 1, 1));
        ASSERT_TRUE(first.done());
        const CarveResult second = carve(first.world, cutter, test::pose_at(4, 1, 1));
        EXPECT_EQ(second.status, CarveStatus::kNothing) << second.error.text();
        EXPECT_EQ(&second.world.data(), &first.world.data());
    }
}

TEST(Carve, VolumeIsThatOfTheCraterHoweverLargeTheWall) {
    const Cutter rock = make_crater(CutterShape::kRocky, 3);
    const World rock_alone = fill(World(), rock, test::pose_at(0, 0, 0, 0.05)).world;
    const double whole = measure_solid(rock_alone).volume;
    for (const double half : {4.0, 400.0, 8000.0}) {
        const World slab = fill(World(), make_crater(CutterShape::kBox, 0), test::pose_at(0, 0, 0, half)).world;
        // What it takes of the wall, and what it adds beside it, make up the rock.
        Pose pose = test::pose_at(half + 0.0103, 0.3, 0.4, 0.05);
        const double taken = carve(slab, rock, pose).report.volume, added = -fill(slab, rock, pose).report.volume;
        EXPECT_GT(taken, whole / 5);
        EXPECT_GT(added, whole / 5);
        EXPECT_NEAR(taken + added, whole, 0.01 * whole) << half;  // snapped elsewhere it is another rock
    }
}

/// Two fans around one rim, the lower one dented inward: its triangles' boxes all meet, and it is no star.
Cutter umbrella(std::uint32_t spokes) {
    std::vector<Vec3> vertices{{0, 0, 1}, {0, 0, 0.5}};
    for (std::uint32_t k = 0; k < spokes; ++k) {
        // Around a square, evenly.
        const double along = 4.0 * k / spokes, part = along - std::floor(along);
        const Vec3 corners[] = {{1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}, {1, 1, 0}};
        const int side = int(along);
        vertices.push_back(corners[side] + (corners[side + 1] - corners[side]) * part);
    }
    std::vector<CutterTriangle> triangles;
    for (std::uint32_t k = 0; k < spokes; ++k) {
        const std::uint32_t a = 2 + k, b = 2 + (k + 1) % spokes;
        triangles.push_back({0, a, b});
        triangles.push_back({1, b, a});
    }
    return make_cutter(vertices, triangles, "umbrella").value();
}

TEST(CarveRules, ACutterThatTakesTooLongToJudgeIsRefused) {
    const World world = room();
    EXPECT_TRUE(carve(world, umbrella(400), test::pose_at(4, 0, 0, 2)).done());
    CarveRules rules;
    rules.max_pairs = 50'000;
    const World hasty = with_rules(world, rules).value();
    const CarveResult result = carve(hasty, umbrella(400), test::pose_at(4, 0, 0, 2));
    expect_refused(hasty, result, "more than 50000 pairs");
    EXPECT_EQ(result.error.code, ErrorCode::kTooLarge);
    expect_refused(world, carve(world, umbrella(20'000), test::pose_at(4, 0, 0, 2)), "more than 20000000 pairs");
}

TEST(CarveRules, AFaceOfTooManyCornersIsRefused) {
    CarveRules rules;
    rules.max_corners = 50;
    const World world = room(rules);
    expect_refused(world, carve(world, umbrella(400), test::pose_at(4, 0, 0, 2)), "corners; the world allows 50");
}

TEST(CarveRules, AZoneIsKeptByACutterThatIsMoved) {
    CarveRules rules;
    rules.zones.push_back({"beyond", {{5.0003, -9, -9}, {9, 9, 9}}, 1});
    const World world = room(rules);
    // Flush with the room's wall at x = 4 and up to x = 5: it must move, and may not move into the zone.
    const CarveResult result = carve(world, make_crater(CutterShape::kBox, 0), test::pose_at(4.5, 0, -3.5, 0.5));
    if (result.done()) {
        EXPECT_LE(result.world.bounds().high.x, 5.0003);
    } else {
        EXPECT_EQ(result.status, CarveStatus::kRefused);
    }
}

TEST(CarveRules, AZoneBesideATurnedCutterDoesNothing) {
    CarveRules rules;
    rules.zones.push_back({"vault", {{3.6, 3.6, -0.1}, {3.9, 3.9, 0.1}}, 1});
    const World world = room(rules);
    Pose turned = test::pose_at(0, 0, 0, 3);  // an octahedron-like stance: its box holds the vault, it does not
    turned.rotation = {0, 0, 0.3826834323650898, 0.9238795325112867};
    EXPECT_NE(carve(world, make_crater(CutterShape::kBox, 0), turned).status, CarveStatus::kRefused);
    turned.position = {2, 2, 0};
    const CarveResult cut = carve(world, make_crater(CutterShape::kBox, 0), turned);
    EXPECT_TRUE(cut.done());
    EXPECT_EQ(cut.report.cut_short, 1u);
    turned.position = {3.75, 3.75, 0};
    turned.scale = 0.05;
    expect_refused(world, carve(world, make_crater(CutterShape::kBox, 0), turned), "zone vault");
}

/// A world that has seen so many edits.
template <class Change>
World with_counters(const World& world, const Change& change) {
    auto data = std::make_shared<WorldData>(world.data());
    auto solid = std::make_shared<SolidData>(world.solid().data());
    change(*data, *solid);
    data->solid = Solid(std::move(solid));
    return World(std::move(data));
}

TEST(CarveRules, WithoutNumbersForEditsThereAreNone) {
    constexpr std::uint32_t kLast = std::numeric_limits<std::uint32_t>::max();
    const World last = with_counters(room(), [](WorldData&, SolidData& data) { data.edits = kLast; });
    expect_refused(last, carve(last, kRock, test::pose_at(4, 0, 0)), "no numbers left for new edits");
    expect_refused(last, fill(last, kRock, test::pose_at(4, 0, 0)), "no numbers left for new edits");
    const World before = with_counters(room(), [](WorldData&, SolidData& data) { data.edits = kLast - 1; });
    const CarveResult done = carve(before, kRock, test::pose_at(4, 0, 0));
    ASSERT_TRUE(done.done());
    EXPECT_EQ(done.world.data().edits(), kLast);
    EXPECT_FALSE(check_world(done.world));
}

TEST(CarveRules, WithoutNumbersForVersionsThereAreNoEdits) {
    constexpr std::uint64_t kLast = std::numeric_limits<std::uint64_t>::max();
    const World last = with_counters(room(), [](WorldData& data, SolidData&) { data.version = kLast; });
    expect_refused(last, carve(last, kRock, test::pose_at(4, 0, 0)), "no numbers left for new edits");
    WorldEdit none(last);
    EXPECT_FALSE(none.carve(kRock, test::pose_at(4, 0, 0)).done());
    EXPECT_EQ(&none.finish().data(), &last.data());
    const World before = with_counters(room(), [](WorldData& data, SolidData&) { data.version = kLast - 1; });
    WorldEdit one(before);
    EXPECT_TRUE(one.carve(kRock, test::pose_at(4, 0, 0)).done());
    EXPECT_FALSE(one.carve(kRock, test::pose_at(-4, 0, 0)).done()) << "it would be the version after the last";
    EXPECT_EQ(one.finish().version(), kLast);
}

TEST(CarveRules, WithoutIdsForFacesThereAreNoEdits) {
    constexpr std::uint32_t kMost = std::uint32_t(1) << 31;  // the others are of edits with numbers
    const std::uint32_t come = std::uint32_t(carve(room(), kRock, test::pose_at(4, 0, 0)).report.faces_added);
    ASSERT_GT(come, 0u);
    for (const std::uint32_t left : {0u, 1u, come - 1}) {
        const World last = with_counters(room(), [&](WorldData&, SolidData& data) { data.next_face = kMost - left; });
        expect_refused(last, carve(last, kRock, test::pose_at(4, 0, 0)), "no ids left for new faces");
    }
    const World beyond = with_counters(room(), [](WorldData&, SolidData& data) { data.next_face = kMost + 1; });
    expect_refused(beyond, carve(beyond, kRock, test::pose_at(4, 0, 0)), "no ids left for new faces");
    const World enough = with_counters(room(), [&](WorldData&, SolidData& data) { data.next_face = kMost - come; });
    const CarveResult done = carve(enough, kRock, test::pose_at(4, 0, 0));
    ASSERT_TRUE(done.done());
    for (const Face& face : done.world.faces()) EXPECT_TRUE(face.id.valid());
    EXPECT_FALSE(check_world(done.world));
}

TEST(CarveRules, AShrunkCutterIsCutAsASmallOne) {
    const World plain = room();
    const World tough = with_rules(plain, with_hardness(plain, "wall", 0.5)).value();
    const Cutter box = make_crater(CutterShape::kBox, 0);
    for (const double x : {3.0, 4.0, 6.0}) {
        const CarveResult shrunk = carve(tough, box, test::pose_at(x, 2, 0, 2)),
                          small = carve(plain, box, test::pose_at(x, 2, 0, 1));
        EXPECT_EQ(shrunk.status, small.status) << x;
        EXPECT_EQ(shrunk.report.volume, small.report.volume) << x;
    }
}

TEST(Carve, AWorldOfNothingIsAir) {
    const World empty;
    EXPECT_EQ(carve(empty, kRock, test::pose_at(0, 0, 0)).status, CarveStatus::kNothing);
    const CarveResult rock = fill(empty, kRock, test::pose_at(0, 0, 0));
    ASSERT_TRUE(rock.done());
    EXPECT_EQ(rock.world.face_count(), 180u);
    EXPECT_FALSE(check_world(rock.world));
}

TEST(Carve, TheWholeLevelCanGo) {
    const World world = room();
    const CarveResult all = fill(world, make_crater(CutterShape::kBox, 0), test::pose_at(0, 0, 0, 10));
    ASSERT_TRUE(all.done());
    EXPECT_EQ(all.world.face_count(), 0u);
    EXPECT_EQ(locate(all.world.solid(), {0, 0, 0}), Where::kSolid);
    EXPECT_TRUE(carve(all.world, kRock, test::pose_at(0, 0, 0)).done());
}

}  // namespace
}  // namespace firma
