// SPDX-License-Identifier: MIT
// Structs that make no sense are refused with a reason, wherever they go in; and handles of nothing are told.
#include <gtest/gtest.h>

#include <cmath>

#include "firma/firma.h"
#include "tests/solid/solid_levels.h"

namespace firma {
namespace {

Level hollow_box() {
    return test::box_level({0, 0, 0}, {8, 8, 4}, true);
}

World hollow_world() {
    return make_world(hollow_box()).value();
}

/// What each of the ways that rules go in says.
void expect_refused(const CarveRules& rules, const std::string& reason) {
    const Result<World> with = with_rules(hollow_world(), rules);
    ASSERT_FALSE(with.ok());
    EXPECT_EQ(with.error().code, ErrorCode::kInvalid);
    EXPECT_EQ(with.error().text(), reason);
    WorldOptions options;
    options.rules = rules;
    Level level = hollow_box();
    level.name = "box.obj";
    const Result<World> of_level = make_world(level, options);
    ASSERT_FALSE(of_level.ok());
    EXPECT_EQ(of_level.error().text(), "box.obj: " + reason);
    const Solid solid = make_solid(level).value();
    EXPECT_EQ(make_world(solid, options).error().text(), reason);
    SolidCutOptions cut;
    cut.rules = &rules;
    const Cutter box = make_crater(CutterShape::kBox, 0);
    const SolidResult result = subtract(solid, box, {{1, 1, 0}}, cut);
    EXPECT_EQ(result.status, CarveStatus::kRefused);
    EXPECT_EQ(result.error.text(), reason);
    EXPECT_EQ(hash_solid(result.solid), hash_solid(solid));
    EXPECT_EQ(unite(solid, box, {{1, 1, 0}}, cut).error.text(), reason);
}

TEST(BadStructs, Rules) {
    const Box box{{0, 0, 0}, {1, 1, 1}};
    for (const double hardness : {-0.1, 1.5, double(NAN), double(INFINITY)}) {
        CarveRules rules;
        rules.zones = {{"", box, 1}, {"vault", box, hardness}};
        expect_refused(rules, "rules, zone 1 'vault': its hardness is not within 0 and 1");
        rules.zones.clear();
        rules.hardness = {0, 1, hardness};
        expect_refused(rules, "rules, material 2: its hardness is not within 0 and 1");
    }
    for (const Box& bad : {Box{}, Box{{0, 0, 0}, {1, -1, 1}}, Box{{0, NAN, 0}, {1, 1, 1}}}) {
        CarveRules rules;
        rules.zones = {{"", bad, 0.5}};
        expect_refused(rules, "rules, zone 0: its box is empty, or not of numbers");
    }
    for (const double size : {0.0, -1.0, double(NAN)}) {
        CarveRules rules;
        rules.max_cutter_size = size;
        expect_refused(rules, "rules: max_cutter_size is not a length above zero");
    }
}

TEST(BadStructs, Tolerance) {
    for (const double offset : {-1e-300, double(NAN), double(INFINITY)}) {
        WorldOptions options;
        options.tolerance.contact_offset = offset;
        const std::string reason = "the contact offset must be a finite number, not below zero";
        EXPECT_EQ(make_world(make_solid(hollow_box()).value(), options).error().text(), reason);
        BrushLevel brushes;
        EXPECT_FALSE(make_world(brushes, options).ok());
        EXPECT_FALSE(make_divided_world(hollow_box(), {}, options).ok());
    }
}

TEST(BadStructs, OptionsOfTreesCountAsTheNearest) {
    const Vec3 start{2, 2, 2};
    const Hit right = cast(hollow_world(), Ray{start, {0, 0, -4}});
    for (const TreeOptions& odd :
         {TreeOptions{Split(77), -5, -5, -1}, TreeOptions{Split::kSurfaceArea, 1 << 30, 1 << 30, NAN}}) {
        WorldOptions options;
        options.tree = odd;
        const World world = make_world(hollow_box(), options).value();
        EXPECT_FALSE(check_world(world));
        EXPECT_EQ(cast(world, Ray{start, {0, 0, -4}}).fraction, right.fraction);
        EXPECT_FALSE(check_world(rebuild_index(hollow_world(), odd)));
    }
}

TEST(BadStructs, ReadOptions) {
    for (const double scale : {-1.0, double(NAN), double(INFINITY)}) {
        const ReadOptions options{scale, 0.01};
        EXPECT_EQ(read_obj("v 0 0 0\n", "a.obj", options).error().code, ErrorCode::kInvalid);
        EXPECT_EQ(read_map("{}", "a.map", options).error().code, ErrorCode::kInvalid);
        EXPECT_EQ(level_from_mesh({}, "mesh", options).error().code, ErrorCode::kInvalid);
    }
    for (const double tolerance : {0.0, -1.0, double(NAN)})
        EXPECT_EQ(read_map("{}", "a.map", {0, tolerance}).error().code, ErrorCode::kInvalid);
}

TEST(BadStructs, CastsAndQueries) {
    const World world = hollow_world();
    std::vector<Hit> hits;
    for (const double bad : {double(NAN), double(INFINITY), 1e300}) {
        EXPECT_EQ(cast(world, Sphere{{bad, 0, 0}, 1}, {1, 0, 0}).status, Status::kInvalid);
        EXPECT_EQ(cast(world, Sphere{{0, 0, 0}, bad}, {1, 0, 0}).status, Status::kInvalid);
        EXPECT_EQ(cast(world, Ray{{0, 0, 0}, {0, bad, 0}}).status, Status::kInvalid);
        EXPECT_EQ(cast_any(world, Ray{{0, 0, 0}, {0, bad, 0}}), Status::kInvalid);
        EXPECT_EQ(cast_all(world, Ray{{0, 0, 0}, {0, bad, 0}}, hits), Status::kInvalid);
        EXPECT_EQ(closest(world, {0, 0, bad}).status, Status::kInvalid);
        EXPECT_EQ(locate(world, {0, 0, bad}).where, Where::kUnknown);
        EXPECT_EQ(locate(world.solid(), {0, 0, bad}), Where::kUnknown);
    }
    CastOptions options;
    options.contact_offset = NAN;
    EXPECT_EQ(cast(world, Ray{{1, 1, 1}, {0, 0, -4}}, options).status, Status::kInvalid);
    options = {};
    options.room = RoomId{77};
    EXPECT_EQ(cast(world, Ray{{1, 1, 1}, {0, 0, -4}}, options).status, Status::kInvalid);
    EXPECT_EQ(closest(world, {1, 1, 1}, -1).status, Status::kMiss);
    EXPECT_EQ(closest(world, {1, 1, 1}, NAN).status, Status::kInvalid);
    EXPECT_EQ(closest(world, {1, 1, 1}, 1, {.room = RoomId{77}}).status, Status::kInvalid);
    EXPECT_TRUE(triangles_of(world, TriangleOptions{.origin = {0, NAN, 0}}).corners.empty());
    EXPECT_TRUE(triangles_of(world, RoomId{77}).corners.empty());
    const auto none = [](const FaceView&) -> bool { throw "there is none"; };
    EXPECT_TRUE(each_face(world, RoomId{77}, none));
    EXPECT_TRUE(each_face(world, Box{{0, 0, 0}, {1, NAN, 1}}, none));
    EXPECT_TRUE(each_face(world, Region{77, 77, 77}, none));
    const World after = carve(world, make_crater(CutterShape::kBox, 0), {{0, 4, 2}}).world;
    EXPECT_FALSE(diff_worlds(world, after, 1).tiles.empty());
    for (const double size : {-1.0, 0.01, double(NAN), double(INFINITY)}) {
        const WorldDiff diff = diff_worlds(world, after, size);
        EXPECT_FALSE(diff.added.empty());
        EXPECT_TRUE(diff.tiles.empty());
        EXPECT_FALSE(diff.too_many_tiles);
    }
    std::vector<Hit> two(2);
    EXPECT_FALSE(cast_batch(world, std::vector<CastInput>(3), two));
    EXPECT_EQ(two[1].status, Status::kInvalid);
}

/// Ids, refs and hits of nothing, of another world, of a door.
TEST(BadStructs, NamesOfNothing) {
    const World world = hollow_world();
    const Hit miss = cast(world, Ray{{2, 2, 2}, {0.1, 0, 0}});
    Hit odd = cast(world, Ray{{2, 2, 2}, {0, 0, -40}});
    ASSERT_TRUE(odd);
    for (const FaceRef& ref : {FaceRef{}, miss.face, FaceRef{{77}, {}}, FaceRef{odd.face.id, {1, 2, 3}}}) {
        EXPECT_FALSE(world.face(ref));
        EXPECT_FALSE(world.face_info(ref));
        EXPECT_FALSE(other_face(world, ref, 0).valid());
    }
    EXPECT_FALSE(world.find_face({}));
    EXPECT_FALSE(world.find_face({77}));
    EXPECT_FALSE(other_face(world, odd.face, 4000000000u).valid());
    EXPECT_FALSE(room_of(world, miss).valid());
    EXPECT_FALSE(room_of(world, Hit{}).valid());
    odd.portal = {3};
    EXPECT_FALSE(room_of(world, odd).valid());
    for (const RoomId none : {RoomId{}, RoomId{1}, kLocateRoom}) {
        EXPECT_FALSE(room_info(world, none));
        EXPECT_TRUE(neighbours(world, none).empty());
        EXPECT_FALSE(find_path(world, none, RoomId{0}));
        EXPECT_FALSE(find_path(world, RoomId{0}, none));
        EXPECT_EQ(hash_room(world, none), 0u);
    }
    for (const PortalId none : {PortalId{}, PortalId{0}}) {
        EXPECT_FALSE(portal_info(world, none));
        EXPECT_TRUE(portal_polygons(world, none).empty());
        EXPECT_FALSE(set_portal_open(world, none, true));
    }
    EXPECT_EQ(world.material_name(4000000000u), "");
}

TEST(BadStructs, CuttersAndPosesOfNothing) {
    const World world = hollow_world();
    const Cutter none;
    EXPECT_FALSE(none.valid());
    EXPECT_TRUE(none.vertices().empty());
    EXPECT_TRUE(none.triangles().empty());
    EXPECT_EQ(none.name(), "");
    EXPECT_EQ(carve(world, none, {}).status, CarveStatus::kRefused);
    EXPECT_FALSE(carve(world, none, {}).error.reason.empty());
    Cutter moved = make_crater(CutterShape::kBox, 0);
    const Cutter taken = std::move(moved);
    EXPECT_EQ(carve(world, moved, {}).status, CarveStatus::kRefused);  // NOLINT(bugprone-use-after-move)
    for (const Pose& pose : {Pose{{NAN, 0, 0}}, Pose{{0, 0, 1e300}}, Pose{{0, 0, 0}, {0, 0, 0, 0}},
                             Pose{{0, 0, 0}, {0, 0, NAN, 1}}, Pose{{0, 0, 0}, {0, 0, 0, 1}, 0},
                             Pose{{0, 0, 0}, {0, 0, 0, 1}, -1}, Pose{{0, 0, 0}, {0, 0, 0, 1}, INFINITY}}) {
        const CarveResult result = carve(world, taken, pose);
        EXPECT_EQ(result.status, CarveStatus::kRefused);
        EXPECT_FALSE(result.error.reason.empty());
        EXPECT_EQ(hash_world(result.world), hash_world(world));
    }
    EXPECT_FALSE(make_crater(CutterShape(99), 0).valid());
    EXPECT_EQ(carve(world, make_crater(CutterShape(99), 0), {}).status, CarveStatus::kRefused);
    EXPECT_EQ(cutter_shape_name(CutterShape(99)), "");
}

TEST(BadStructs, PointersToNothingAreEmptyValues) {
    EXPECT_EQ(World(std::shared_ptr<const WorldData>()).face_count(), 0u);
    EXPECT_EQ(Solid(std::shared_ptr<const SolidData>()).face_count(), 0u);
}

}  // namespace
}  // namespace firma
