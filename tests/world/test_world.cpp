// SPDX-License-Identifier: MIT
// The World as a value and the questions it answers, on a small closed room.
#include "firma/carve.h"
#include "firma/queries.h"
#include "firma/rooms.h"
#include "firma/solid.h"
#include "firma/world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "firma/level.h"
#include "tests/world/copied_node.h"
#include "world/world_data.h"

namespace firma {
namespace {

/// A box of air, 4 x 4 x 3 m, wound inward, a material a side.
Level box_room() {
    Level level;
    level.name = "box room";
    level.materials = {"floor", "wall", "ceiling"};
    level.groups = {""};
    for (const int k : {0, 1, 2, 3, 4, 5, 6, 7}) {
        const std::int32_t m = std::int32_t(kSurfaceSteps);
        level.vertices.push_back({(k & 1) * 4 * m, (k >> 1 & 1) * 4 * m, (k >> 2) * 3 * m});
    }
    const int quads[6][4] = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}};
    const std::uint32_t materials[6] = {0, 2, 1, 1, 1, 1};
    for (std::uint32_t f = 0; f < 6; ++f) {
        LevelFace face;
        face.first_corner = std::uint32_t(level.corners.size());
        face.corner_count = 4;
        face.source = f + 10;
        face.material = materials[f];
        face.mask = 1u << f;
        level.faces.push_back(face);
        for (const int corner : quads[f]) level.corners.push_back(std::uint32_t(corner));
    }
    level.source_faces = 16;
    return level;
}

World room() {
    return make_world(box_room()).value();
}

TEST(World, IsSoundAndDescribesItself) {
    const World world = room();
    EXPECT_FALSE(check_world(world)) << check_world(world)->what;
    EXPECT_EQ(world.face_count(), 6u);
    EXPECT_EQ(world.room_count(), 1u);
    EXPECT_EQ(world.bounds(), (Box{{0, 0, 0}, {4, 4, 3}}));
    EXPECT_EQ(world.material_name(2), "ceiling");
    EXPECT_EQ(world.material_name(7), "");
    const std::vector<Face> faces = world.faces();
    ASSERT_EQ(faces.size(), 6u);
    EXPECT_EQ(faces[0].normal, (Vec3{0, 0, 1})) << "the floor faces up, into the air";
    for (std::uint32_t edge = 0; edge < 4; ++edge) EXPECT_TRUE(other_face(world, faces[0].ref(), edge).valid());
    EXPECT_FALSE(other_face(world, faces[0].ref(), 4).valid());
    EXPECT_FALSE(other_face(world, {}, 0).valid());
    EXPECT_EQ(world.find_face({3})->source, 13u);
    EXPECT_FALSE(world.find_face({6}));
}

TEST(World, AnEmptyOneAnswersToo) {
    const World world;
    EXPECT_FALSE(check_world(world));
    EXPECT_EQ(cast(world, {{0, 0, 0}, 1}, {1, 0, 0}).status, Status::kMiss);
    EXPECT_TRUE(world.bounds().empty());
    EXPECT_FALSE(closest(world, {0, 0, 0}));
}

TEST(World, AHitSaysWhatItMet) {
    const World world = room();
    const Hit hit = cast(world, {{1, 1, 1.5}, 0.5}, {0, 0, -2}, {.contact_offset = 0.25});
    EXPECT_EQ(hit.status, Status::kHit);
    EXPECT_EQ(hit.fraction, 0.5);
    EXPECT_EQ(hit.safe_fraction, 0.375);
    EXPECT_EQ(hit.face.id, (FaceId{0}));
    EXPECT_EQ(world.material_name(hit.material), "floor");
    const std::optional<FaceInfo> face = world.face_info(hit.face);
    ASSERT_TRUE(face);
    EXPECT_EQ(face->source, 10u);
    EXPECT_EQ(face->room, RoomId{0});
    EXPECT_EQ(room_of(world, hit), RoomId{0});
    EXPECT_EQ(face->ref(), hit.face);
}

TEST(World, AHitEdgeNamesBothFaces) {
    Level level = box_room();
    for (LevelFace& face : level.faces) {  // turned inside out: a solid block in the exterior
        std::reverse(level.corners.begin() + face.first_corner, level.corners.begin() + face.first_corner + 4);
    }
    const World world = make_world(level).value();
    const Hit hit = cast(world, {{-2, 2, 5}, 1}, {4, 0, -4});
    ASSERT_EQ(hit.status, Status::kHit);
    ASSERT_EQ(hit.feature, Feature::kEdge);
    const FaceId other = other_face(world, hit.face, hit.feature_index);
    const auto sides = std::minmax(hit.face.id, other);
    EXPECT_EQ(sides.first, (FaceId{1})) << "the lid";
    EXPECT_EQ(sides.second, (FaceId{4})) << "and the side at x = 0";
    EXPECT_EQ(hit.face.id, (FaceId{1})) << "at a tie the lowest id";
}

TEST(World, SafeFractionKeepsTheSkinWhateverTheSpeed) {
    const World world = room();
    for (const double speed : {2.0, 10.0, 1000.0, 1e6}) {
        const Vec3 path{speed, 0, -speed};
        const Hit hit = cast(world, {{0.5, 2, 2}, 0.25}, path);
        const Vec3 stop = Vec3{0.5, 2, 2} + path * hit.safe_fraction;
        EXPECT_NEAR(stop.z - 0.25, world.tolerance().contact_offset, 1e-9) << speed;
    }
    const Hit close = cast(world, {{1, 1, 0.5005}, 0.5}, {0, 0, -1});
    EXPECT_EQ(close.safe_fraction, 0) << "never negative";
    EXPECT_GT(close.fraction, 0);
}

TEST(World, MasksChooseFaces) {
    const World world = room();
    EXPECT_EQ(cast(world, {{1, 1, 1.5}, 0}, {0, 0, -2}, {.mask = ~1u}).status, Status::kMiss);
    EXPECT_EQ(cast(world, {{1, 1, 1.5}, 0}, {0, 0, -2}, {.mask = 1}).status, Status::kHit);
    EXPECT_EQ(closest(world, {1, 1, 0.5}, INFINITY, {.mask = 2}).face.id, (FaceId{1}));
}

TEST(World, SidesByFaceAndByCast) {
    const World one = room();
    EXPECT_EQ(cast(one, {{1, 1, -1}, 0}, {0, 0, 2}).status, Status::kMiss);
    EXPECT_EQ(cast(one, {{1, 1, -1}, 0}, {0, 0, 2}, {.sides = Sides::kBoth}).status, Status::kHit);
    Level level = box_room();
    level.faces[0].two_sided = true;
    EXPECT_EQ(cast(make_world(level).value(), {{1, 1, -1}, 0}, {0, 0, 2}).status, Status::kHit);
}

TEST(World, AnyAndAll) {
    const World world = room();
    EXPECT_EQ(cast_any(world, {{1, 1, 1}, 0}, {0, 0, -0.5}), Status::kMiss);
    EXPECT_EQ(cast_any(world, {{1, 1, 1}, 0}, {0, 0, -1}), Status::kHit);
    EXPECT_EQ(cast_any(world, {{1, 1, 1}, NAN}, {0, 0, -1}), Status::kInvalid);
    std::vector<Hit> hits(3);
    EXPECT_EQ(cast_all(world, {{1, 1, 1}, 0}, {0, 0, -0.5}, hits), Status::kMiss);
    EXPECT_TRUE(hits.empty());
    EXPECT_EQ(cast_all(world, {{-1, 2, 1}, 0}, {10, 0, 0}, hits, {.sides = Sides::kBoth}), Status::kHit);
    ASSERT_EQ(hits.size(), 2u);
    EXPECT_EQ(hits[0].face.id, (FaceId{4}));
    EXPECT_EQ(hits[1].face.id, (FaceId{5}));
    EXPECT_EQ(hits[1].fraction, 0.5);
    EXPECT_EQ(cast_all(world, {{0, 0, INFINITY}, 0}, {0, 0, -1}, hits), Status::kInvalid);
}

TEST(World, OverlapAndClosest) {
    const World world = room();
    std::vector<Overlap> found;
    EXPECT_EQ(overlap(world, {{1, 1, 1}, 0.5}, found), Status::kMiss);
    EXPECT_EQ(overlap(world, {{1, 1, 1}, 1}, found), Status::kInitialOverlap);
    ASSERT_EQ(found.size(), 3u) << "touch counts: floor and two walls";
    EXPECT_EQ(found[0].face.id, (FaceId{0}));
    EXPECT_EQ(overlap(world, {{1, 1, 1}, -1}, found), Status::kInvalid);
    const auto near = closest(world, {2, 2, 2.5});
    ASSERT_TRUE(near);
    EXPECT_EQ(near.face.id, (FaceId{1}));
    EXPECT_EQ(near.distance, 0.5);
    EXPECT_EQ(near.point, (Vec3{2, 2, 3}));
    EXPECT_EQ(closest(world, {2, 2, 1.5}, 1).status, Status::kMiss);
    EXPECT_EQ(closest(world, {2, 2, NAN}).status, Status::kInvalid);
}

TEST(World, RefusesALevelThatNoReaderMakes) {
    Level level = box_room();
    level.vertices[3].z += 64;
    const auto bent = make_world(level);
    ASSERT_FALSE(bent);
    EXPECT_EQ(bent.error().text(), "box room: face 10: it is not convex and planar, with area");
    level = box_room();
    level.corners[5] = 99;
    EXPECT_FALSE(make_world(level));
    level = box_room();
    level.faces[5].corner_count = 5;
    EXPECT_FALSE(make_world(level));
    level.faces.clear();
    level.omissions = {{"faces without area", 3, ""}};
    EXPECT_EQ(make_world(level).error().text(),
              "box room: no face is left that a cast could meet; left out: faces without area: 3");
    EXPECT_EQ(make_solid(level).error().code, ErrorCode::kMalformed);
}

TEST(World, RefusesAContactOffsetThatIsNoLength) {
    WorldOptions options;
    for (const double contact_offset : {-0.001, -4.9e-324, -double(INFINITY), double(INFINITY), double(NAN)}) {
        options.tolerance.contact_offset = contact_offset;
        const auto refused = make_world(box_room(), options);
        ASSERT_FALSE(refused) << contact_offset;
        EXPECT_EQ(refused.error().code, ErrorCode::kInvalid);
        EXPECT_EQ(refused.error().text(), "box room: the contact offset must be a finite number, not below zero");
    }
    for (const double contact_offset : {0.0, -0.0, 0.5}) {
        options.tolerance.contact_offset = contact_offset;
        EXPECT_TRUE(make_world(box_room(), options)) << contact_offset;
    }
}

TEST(World, TheNextVersionSharesAllButItsNumber) {
    const World world = room();
    const World next(next_version(world.data()));
    EXPECT_EQ(next.version(), world.version() + 1);
    EXPECT_EQ(&next.data().cells.room(0), &world.data().cells.room(0));
    EXPECT_EQ(next.face_count(), world.face_count());
    EXPECT_FALSE(check_world(next));
}

TEST(World, CheckFindsWhatIsBroken) {
    const World world = room();
    struct Spoilt {
        Node& node;
        Block& block;
        SolidData& solid;
        RoomFaces& room;
    };
    const auto broken = [&](auto&& change) {
        auto data = std::make_shared<WorldData>(world.data());
        auto solid = std::make_shared<SolidData>(world.solid().data());
        EXPECT_TRUE(solid->faces.root->is_leaf());
        Ref<Node> node = test::copied_node(*solid->faces.root);
        Block& block = test::own_block(*node);
        Ref<RoomFaces> room(new RoomFaces);
        room->count = data->faces_of(0).count;
        room->hash = data->faces_of(0).hash;
        Spoilt spoilt{*node, block, *solid, *room};
        change(spoilt);
        solid->faces.root = Ref<const Node>(node.get());
        room->tree = solid->faces.root;
        data->solid = Solid(std::move(solid));
        data->set_room(0, data->cells.record(0), Ref<const RoomFaces>(room.get()));
        const auto fault = check_world(World(std::move(data)));
        return fault ? fault->what : "";
    };
    EXPECT_EQ(broken([](Spoilt&) {}), "");
    EXPECT_EQ(broken([](Spoilt& s) {
                  for (int axis = 0; axis < 3; ++axis) {  // the third corner, in both triangles of the first wall
                      ++s.block.lanes[0].corner[2][axis][0];
                      ++s.block.lanes[0].corner[1][axis][1];
                  }
              }),
              "a face is not planar");
    EXPECT_EQ(broken([](Spoilt& s) { s.block.faces[1].id = s.block.faces[0].id; }), "two faces have one id");
    EXPECT_EQ(broken([](Spoilt& s) { s.block.faces[1].solid = false; }), "a face of the solid does not say so");
    EXPECT_EQ(broken([](Spoilt& s) { s.block.part = 1; }), "a block lies in a room that its faces are not part of");
    EXPECT_EQ(broken([](Spoilt& s) { s.block.faces[1].material = 7; }), "a room's hash is not that of its faces");
    EXPECT_EQ(broken([](Spoilt& s) { --s.node.box.high[0]; }), "an index block's box is not that around what it holds");
    EXPECT_EQ(broken([](Spoilt& s) { ++s.node.box.high[0]; }), "an index block's box is not that around what it holds");
    EXPECT_EQ(broken([](Spoilt& s) {
                  for (int axis = 0; axis < 3; ++axis) s.node.wide[0].side[1][axis][0] = 0;
              }),
              "a face reaches out of its wide node");
    EXPECT_EQ(broken([](Spoilt& s) { s.node.wide.clear(); }), "an index block has no nodes");
    EXPECT_EQ(broken([](Spoilt& s) { s.block.faces[2].first_lane = 9999; }), "a face has corners that are not there");
    EXPECT_EQ(broken([](Spoilt& s) { s.block.faces[0].owner = 3; }), "a face has an owner that is not there");
    EXPECT_EQ(broken([](Spoilt& s) { ++s.node.facets_below; }),
              "an index block's count of faces is not how many there are");
    EXPECT_EQ(broken([](Spoilt& s) { ++s.node.depth; }), "an index block's depth is not how deep it is");
    EXPECT_EQ(broken([](Spoilt& s) { s.solid.faces.count = 7; }), "the count of faces is not how many there are");
    const auto spoil = [](PersistentMap<std::uint64_t>& regions) {
        std::uint32_t first = ~0u;
        std::uint64_t sum = 0;
        regions.for_each([&](std::uint32_t region, std::uint64_t of) {
            if (first == ~0u) first = region, sum = of;
        });
        regions.set(first, sum + 1);
    };
    EXPECT_EQ(broken([&](Spoilt& s) { spoil(s.solid.points); }), "a region's hash of points is not that of its points");
    EXPECT_EQ(broken([&](Spoilt& s) { spoil(s.solid.faces.regions); }),
              "a region's hash of faces is not that of its faces");
    EXPECT_EQ(broken([](Spoilt& s) { s.solid.next_face = 3; }), "a face's id is not below the next one");
}

// Finding 2 (F2).
TEST(World, ARefThatIsNoLongerGoodIsTold) {
    World world = room();
    const Hit hit = cast(world, {{0, 0, 0}, 0}, {20, 0, 0});
    ASSERT_TRUE(hit.touched());
    EXPECT_EQ(world.face(hit.face)->id, hit.face.id);
    EXPECT_FALSE(world.face({}));
    FaceRef other = hit.face;
    other.corner.x += 1;
    EXPECT_FALSE(world.face(other));
    other = hit.face;
    other.id = {hit.face.id.value + 1};
    EXPECT_FALSE(world.face(other));
    EXPECT_FALSE(World().face(hit.face)) << "of another world";
    EXPECT_FALSE(World().face_info(hit.face));
    EXPECT_FALSE(room_of(World(), hit).valid());
    // Edits until the memory of the first version is used again; under the address sanitizer any read of it is seen.
    Pose pose;
    for (int k = 0; k < 40; ++k) {
        pose.position = {hit.point.x, 0.2 * (k % 5), 0.2 * (k % 7)};
        pose.scale = 0.3;
        world = carve(world, make_crater(CutterShape::kRocky, std::uint64_t(k)), pose).world;
    }
    const std::optional<Face> stale = world.face(hit.face);
    EXPECT_TRUE(!stale || stale->id == hit.face.id);
    // A closed door has no face.
    EXPECT_FALSE(world.face(Hit().face));
}

}  // namespace
}  // namespace firma
