// SPDX-License-Identifier: MIT
// Worlds as bytes and back: the same world, the same bytes, the same edits from there on.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "base/hasher.h"
#include "firma/queries.h"
#include "firma/rooms.h"
#include "firma/solid.h"
#include "scenes/divided_building.h"
#include "tests/reference/judge_cut.h"
#include "tests/save/saved_worlds.h"
#include "world/world_data.h"

namespace firma {
namespace {

World unpacked(std::span<const std::byte> bytes) {
    Result<World> read = unpack_world(bytes, "test");
    EXPECT_TRUE(read.ok()) << read.error().text();
    return read ? read.value() : World();
}

/// Packed, unpacked and packed again.
void expect_round_trip(const World& world) {
    const std::vector<std::byte> bytes = pack_world(world);
    const Result<World> read = unpack_world(bytes, "test");
    ASSERT_TRUE(read.ok()) << read.error().text();
    EXPECT_EQ(hash_world(read.value()), hash_world(world));
    EXPECT_EQ(hash_solid(read.value()), hash_solid(world));
    EXPECT_FALSE(check_world(read.value()));
    EXPECT_FALSE(check_solid(read.value()));
    EXPECT_TRUE(pack_world(read.value()) == bytes);
}

TEST(PackWorld, EmptyOnes) {
    expect_round_trip(World());
    World world = room_world();
    Pose pose;
    pose.scale = 100;
    const World rock = carve(room_world(), make_crater(CutterShape::kBox, 1), pose).world;  // no face is left
    expect_round_trip(rock);
    expect_round_trip(world);
}

TEST(PackWorld, LevelsOfEveryFamilyAfterCuts) {
    const Level ours = read_level(FIRMA_ROOT "/levels/first.obj").value();
    for (const scenes::CutFamily& family : scenes::cut_families()) {
        SCOPED_TRACE(family.name);
        const scenes::CutCase it = scenes::make_cut_case(family, 4, 1, ours);
        World world = make_world(it.level).value();
        expect_round_trip(world);
        for (std::size_t k = 0; k < it.cuts.size() && k < 5; ++k) world = reference::make_cut(world, it.cuts[k]).world;
        expect_round_trip(world);
    }
}

/// They are in no hash, and a reader may pass them over.
TEST(PackWorld, HowTexturesLie) {
    const World world = papered_world();
    expect_round_trip(world);
    for (const bool exact : {false, true})
        for (const bool index : {false, true}) {
            const World read = unpacked(pack_world(world, {.exact = exact, .index = index}));
            std::size_t pieces = 0;
            for (const Face& face : world.faces()) {
                const std::optional<TextureProjection> lies = texture_of(world, face.ref());
                EXPECT_TRUE(texture_of(read, face.ref()) == lies);
                EXPECT_EQ(lies.has_value(), face.source != 2);
                pieces += face.source == 1;
            }
            EXPECT_EQ(pieces, 2u);
        }
    std::vector<NewSection> sections;
    const std::vector<std::byte> bytes = pack_world(world);
    const std::vector<Section> known = read_container(bytes, "test").value();
    for (const Section& section : known) {
        const bool of_textures = section.type == kTextureMapsSection || section.type == kTexturedFacesSection ||
                                 section.type == kTextureOutlinesSection;
        if (of_textures) {
            EXPECT_FALSE(section.required());
            continue;
        }
        NewSection copy{section.type, section.flags, {}};
        for (const std::byte byte : section.bytes) copy.content.u8(std::uint8_t(byte));
        sections.push_back(copy);
    }
    const World bare = unpacked(write_container(sections));
    EXPECT_EQ(hash_world(bare), hash_world(world));
    EXPECT_FALSE(texture_of(bare, bare.faces()[0].ref()));
}

/// In no hash, and a reader may pass it over.
TEST(PackWorld, WhatHoldsPieces) {
    World world = with_anchors(room_world(), {.hanging = true,
                                              .materials = {""},
                                              .sources = {7, 3, 7},
                                              .volumes = {{{1, 2, 3}, {4, 5, 6}}, {{-1e9, 0, 0}, {0, 1, 1}}}});
    const CarveResult post =
        fill(world, make_crater(CutterShape::kBox, 1), {.position = {0.1, 0.2, 1.5}, .scale = 0.25});
    ASSERT_TRUE(post.done());
    EXPECT_EQ(post.world.data().anchors->edits, (std::vector<std::uint32_t>{1})) << "it stands free";
    for (const World& saved : {world, post.world}) {
        expect_round_trip(saved);
        const World read = unpacked(pack_world(saved));
        ASSERT_TRUE(read.data().anchors);
        EXPECT_TRUE(*read.data().anchors == *saved.data().anchors);
        EXPECT_EQ(read.data().anchors->sources, (std::vector<std::uint32_t>{3, 7}));
        EXPECT_EQ(read.data().anchors->volumes.size(), 2u);
    }
    EXPECT_FALSE(unpacked(pack_world(room_world())).data().anchors) << "nothing was said";
    const std::vector<std::byte> bytes = pack_world(world);
    const std::vector<Section> sections = read_container(bytes, "test").value();
    for (const Section& section : sections) EXPECT_TRUE(section.type != kAnchorsSection || !section.required());
}

TEST(PackWorld, RoomsPortalsAndDoors) {
    expect_round_trip(two_rooms());
    const World read = unpacked(pack_world(two_rooms()));
    EXPECT_EQ(room_info(read, {0})->name, "hall");
    EXPECT_EQ(portal_info(read, {0})->name, "door");
    EXPECT_FALSE(portal_info(read, {0})->open);
    EXPECT_TRUE(portal_info(read, {1})->polygons == 0);
    const scenes::DividedBuilding building(
        {.rooms_x = 4, .rooms_y = 3, .rooms_z = 2, .outdoors = true, .closed = 0.5, .seed = 7});
    const World world = assemble_world(building.parts()).value();
    expect_round_trip(world);
    const World again = unpacked(pack_world(world));
    scenes::Rng rng(3);
    for (int k = 0; k < 200; ++k) {
        const Vec3 point = building.point_in_air(0, rng);
        EXPECT_EQ(locate(again, point), locate(world, point));
    }
    // Without walls that bound a solid, rays cannot tell rooms: casts that are to locate ask all.
    const World facets = unpacked(pack_world(world, {.exact = false}));
    EXPECT_EQ(facets.room_count(), world.room_count());
    for (int k = 0; k < 200; ++k) {
        const Vec3 point = building.point_in_air(0, rng);
        EXPECT_EQ(locate(facets, point).where, Where::kUnknown);
        const Vec3 path = rng.direction() * 20.0;
        RoomTrail trail;
        const Hit hit = cast(facets, {point, 0}, path, {.room = kLocateRoom, .trail = &trail});
        EXPECT_EQ(hit.face, cast(world, {point, 0}, path).face);
        EXPECT_EQ(trail.count, 0u);
    }
}

/// Two blocks that touch in an edge: exact faces without any cut, and two edges between the same vertices.
TEST(PackWorld, DoubledEdges) {
    std::string text;
    add_box(text, {0, 0, 0}, {2, 2, 2}, false);
    add_box(text, {2, 2, 0}, {4, 4, 2}, false);
    World world = world_of(text);
    ASSERT_EQ(measure_solid(world).faces, 12u);
    std::size_t doubled = 0;
    const std::vector<std::byte> bytes = pack_world(world);
    for (const SectionPlace& place : section_places(bytes))
        for (std::size_t k = 0; place.type == kEdgesSection && k < place.length / kEdgeBytes; ++k)
            doubled += read_u32(bytes.data() + place.first + k * kEdgeBytes + 16) == kDoubledEdge;
    EXPECT_EQ(doubled, 2u);
    expect_round_trip(world);
    World loaded = unpacked(bytes);
    for (World* each : {&world, &loaded}) {
        Pose pose;
        pose.position = {2, 2, 1};
        pose.scale = 0.5;
        *each = carve(*each, make_crater(CutterShape::kRocky, 1), pose).world;
    }
    EXPECT_EQ(world.data().edits(), 1u);
    EXPECT_EQ(hash_world(loaded), hash_world(world));
}

TEST(PackWorld, EditsGoOnToTheSameBits) {
    World world = room_world();
    scenes::Rng rng(1);
    while (world.data().edits() < 100) cut_somewhere(world, rng, 0.2);
    World loaded = unpacked(pack_world(world));
    scenes::Rng again = rng;
    while (world.data().edits() < 200) {
        cut_somewhere(world, rng, 0.2);
        cut_somewhere(loaded, again, 0.2);
        if (world.data().edits() % 20 == 0) {
            ASSERT_EQ(hash_world(world), hash_world(loaded)) << world.data().edits();
        }
    }
    EXPECT_TRUE(pack_world(world) == pack_world(loaded));
}

/// Fixed for every compiler, its options and every machine.
TEST(PackWorld, SameBytesEverywhere) {
    const std::vector<std::byte> bytes = pack_world(cut_room(10, 3));
    Hasher hasher;
    for (const std::byte byte : bytes) hasher.add(std::uint8_t(byte));
    EXPECT_EQ(hasher.value(), 13743024880270267991u) << hasher.value();
}

TEST(PackWorld, ToleranceOptionsAndRules) {
    WorldOptions options;
    options.tolerance.contact_offset = 0.0123;
    options.tree = {Split::kSurfaceArea, 20, 3, 0.25};
    options.rules.zones = {{"vault", {{-1, -2, -3}, {1, 2, 3}}, 0.5}, {"", {{0, 0, 0}, {0, 0, 0}}, 1}};
    options.rules.hardness = {0, 0.25, 1};
    options.rules.max_faces = 12345;
    options.rules.max_candidate_faces = 23456;
    options.rules.max_new_faces = 34567;
    options.rules.max_cutter_triangles = 45678;
    options.rules.max_pairs = std::size_t(1) << 40;
    options.rules.max_corners = 56789;
    options.rules.max_cutter_size = 67.5;
    const World world = room_world(options);
    expect_round_trip(world);
    const World keep = unpacked(pack_world(world));
    const WorldData& read = keep.data();
    EXPECT_EQ(read.tolerance.contact_offset, 0.0123);
    EXPECT_EQ(read.tree_options.split, Split::kSurfaceArea);
    EXPECT_EQ(read.tree_options.max_depth, 20);
    EXPECT_EQ(read.tree_options.faces_per_leaf, 3);
    EXPECT_EQ(read.tree_options.min_node_volume, 0.25);
    const CarveRules& rules = *read.rules;
    ASSERT_EQ(rules.zones.size(), 2u);
    EXPECT_EQ(rules.zones[0].name, "vault");
    EXPECT_EQ(rules.zones[0].box, options.rules.zones[0].box);
    EXPECT_EQ(rules.zones[0].hardness, 0.5);
    EXPECT_EQ(rules.zones[1].box.high.x, 0);
    EXPECT_EQ(rules.hardness, options.rules.hardness);
    EXPECT_EQ(rules.max_faces, 12345u);
    EXPECT_EQ(rules.max_candidate_faces, 23456u);
    EXPECT_EQ(rules.max_new_faces, 34567u);
    EXPECT_EQ(rules.max_cutter_triangles, 45678u);
    EXPECT_EQ(rules.max_pairs, std::size_t(1) << 40);
    EXPECT_EQ(rules.max_corners, 56789u);
    EXPECT_EQ(rules.max_cutter_size, 67.5);
    EXPECT_EQ(keep.material_name(1), "rock");
}

TEST(PackWorld, FacetsAloneAreSmallerAndCannotBeCarved) {
    const World world = cut_room(20, 5);
    const std::vector<std::byte> whole = pack_world(world), facets = pack_world(world, {.exact = false});
    EXPECT_LT(2 * facets.size(), whole.size());
    World read = unpacked(facets);
    EXPECT_EQ(read.face_count(), world.face_count());
    EXPECT_FALSE(check_world(read));
    EXPECT_TRUE(pack_world(read) == pack_world(unpacked(pack_world(read))));
    scenes::Rng rng(6);
    int hits = 0;
    for (int k = 0; k < 500; ++k) {
        Vec3 from, path;
        for (int axis = 0; axis < 3; ++axis) from[axis] = rng.uniform(-3, 3);
        for (int axis = 0; axis < 3; ++axis) path[axis] = rng.uniform(-9, 9);
        const double radius = rng.uniform(0, 0.2);
        const Hit one = cast(world, {from, radius}, path), other = cast(read, {from, radius}, path);
        EXPECT_EQ(one.status, other.status);
        EXPECT_EQ(one.fraction, other.fraction);
        EXPECT_EQ(one.face, other.face);
        EXPECT_EQ(one.normal, other.normal);
        hits += one.touched();
    }
    EXPECT_GT(hits, 300);
    for (const Face& face : read.faces()) EXPECT_FALSE(face.solid);
    Pose pose;
    pose.position = {0, 4, 0};
    EXPECT_EQ(carve(read, make_crater(CutterShape::kRocky, 1), pose).status, CarveStatus::kNothing);
    EXPECT_EQ(fill(read, make_crater(CutterShape::kRocky, 1), pose).status, CarveStatus::kDone);
}

TEST(PackWorld, VersionOneStaysReadable) {
    const Result<World> golden = load_world(FIRMA_ROOT "/tests/data/golden_v1.firma");
    ASSERT_TRUE(golden.ok()) << golden.error().text();
    EXPECT_EQ(hash_world(golden.value()), 3620734030464234831u) << hash_world(golden.value());
    EXPECT_EQ(golden.value().data().edits(), 6u);
    std::ifstream file(FIRMA_ROOT "/tests/data/golden_v1.firma", std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    EXPECT_LT(bytes.size(), 50'000u);
    EXPECT_EQ(version_of_container(std::as_bytes(std::span(bytes))), 1u);
    EXPECT_TRUE(pack_world(golden.value()) == pack_world(unpacked(std::as_bytes(std::span(bytes)))));
    expect_round_trip(golden.value());
}

/// Files had an index then: the rest is what is written now, for ever. Whatever is in the index, the world is the same.
void expect_same_but_for_the_index(const World& world, std::span<const std::byte> all) {
    const std::vector<std::byte> packed = pack_world(world);
    const std::vector<Section> now = read_container(packed, "now").value(), then = read_container(all, "then").value();
    ASSERT_EQ(then.size(), now.size() + 6);
    for (std::size_t k = 0; k < then.size(); ++k) {
        const bool of_index = k >= now.size();
        EXPECT_EQ(section_name(then[k].type)[0] == 'I', of_index) << k;
        EXPECT_EQ(then[k].required(), !of_index && now[k].required()) << k;
        if (!of_index) {
            EXPECT_EQ(then[k].type, now[k].type) << k;
            EXPECT_TRUE(std::ranges::equal(then[k].bytes, now[k].bytes)) << section_name(now[k].type);
            continue;
        }
        const SectionPlace place = section_places(all)[k];
        std::vector<std::byte> damaged(all.begin(), all.end());
        std::fill_n(damaged.begin() + std::ptrdiff_t(place.first), place.length, std::byte(0xFF));
        fix_checksums(damaged);
        EXPECT_TRUE(pack_world(unpacked(damaged)) == packed) << section_name(then[k].type);
    }
}

/// What version 2 wrote when it was new, of the worlds of version 1. Where nothing needs version 3, version 2 is
/// written.
TEST(PackWorld, VersionTwoStaysReadable) {
    for (const std::string name : {"golden", "golden_rooms"}) {
        const std::string folder = FIRMA_ROOT "/tests/data/";
        const Result<World> one = load_world(folder + name + "_v1.firma"),
                            two = load_world(folder + name + "_v2.firma");
        ASSERT_TRUE(one.ok() && two.ok()) << name;
        EXPECT_EQ(hash_world(one.value()), hash_world(two.value()));
        EXPECT_EQ(hash_solid(one.value()), hash_solid(two.value()));
        EXPECT_EQ(hash_regions(one.value()), hash_regions(two.value()));
        EXPECT_TRUE(pack_world(one.value(), {.index = false}) == pack_world(two.value(), {.index = false}));
        std::ifstream file(folder + name + "_v2.firma", std::ios::binary);
        const std::string bytes{std::istreambuf_iterator<char>(file), {}};
        EXPECT_EQ(version_of_container(std::as_bytes(std::span(bytes))), 2u);
        expect_same_but_for_the_index(two.value(), std::as_bytes(std::span(bytes)));
    }
}

/// What version 3 wrote when it was new: meshes, and brushes, of several matters, cut.
TEST(PackWorld, VersionThreeStaysReadable) {
    const struct {
        const char* name;
        std::uint64_t hash;
        const char *inside, *outside;
    } kFiles[] = {{"golden_meshes_v3", 8133417574651600334u, "jelly", "rock"},
                  {"golden_brushes_v3", 1886614306337391u, "brick", "wood"}};
    for (const auto& file : kFiles) {
        const std::string path = FIRMA_ROOT "/tests/data/" + std::string(file.name) + ".firma";
        const Result<World> golden = load_world(path);
        ASSERT_TRUE(golden.ok()) << golden.error().text();
        const World& world = golden.value();
        EXPECT_FALSE(check_world(world));
        EXPECT_EQ(hash_world(world), file.hash) << hash_world(world);
        EXPECT_EQ(matter(world, matter_at(world, {0.5, 0.5, 0.5})).name, file.inside);
        EXPECT_EQ(matter(world, matter_at(world, {5, 0.5, 0.5})).name, file.outside);
        std::ifstream stream(path, std::ios::binary);
        const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
        EXPECT_EQ(version_of_container(std::as_bytes(std::span(bytes))), 3u);
        expect_same_but_for_the_index(world, std::as_bytes(std::span(bytes)));
        expect_round_trip(world);
    }
}

/// Rooms inside and out, doors of both kinds, a cavity, and rooms that craters made one.
World rooms_and_craters() {
    const scenes::DividedBuilding building(
        {.rooms_x = 2, .rooms_y = 1, .rooms_z = 1, .jitter = 0, .outdoors = true, .closed = 0.5, .seed = 3});
    World world = assemble_world(building.parts()).value();
    scenes::Rng rng(12);
    for (int k = 0; k < 5; ++k) {
        Pose pose;
        for (int axis = 0; axis < 3; ++axis) pose.position[axis] = rng.uniform(0, axis == 0 ? 11 : 5);
        pose.scale = k == 4 ? 0.2 : 0.6;
        if (k == 4) pose.position = {5.5, 2.5, 0.5};
        world = carve(world, make_crater(CutterShape::kWedge, rng.next()), pose, {"crater"}).world;
    }
    return *set_portal_open(world, {2}, !portal_info(world, {2})->open);
}

TEST(PackWorld, RoomsAndCratersAreTheSameEverywhere) {
    const World world = rooms_and_craters();
    EXPECT_FALSE(check_world(world));
    EXPECT_EQ(hash_world(world), 3508137524439295431u) << hash_world(world);
    const World again = unpacked(pack_world(world));
    EXPECT_EQ(hash_world(again), hash_world(world));
}

/// What rooms_and_craters() made when version 1 was new. Edits since then take the planes of fewer neighbours for edges
/// that they leave whole, so that it makes other bits today; the file must be readable by every later Firma, to the
/// bit.
TEST(PackWorld, RoomsOfVersionOneStayReadable) {
    const std::string path = FIRMA_ROOT "/tests/data/golden_rooms_v1.firma";
    const Result<World> golden = load_world(path);
    ASSERT_TRUE(golden.ok()) << golden.error().text();
    const World& world = golden.value();
    EXPECT_FALSE(check_world(world));
    EXPECT_EQ(hash_world(world), 6388791359657166093u) << hash_world(world);
    std::ifstream file(path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    EXPECT_EQ(version_of_container(std::as_bytes(std::span(bytes))), 1u);
    expect_round_trip(world);
    std::size_t joined = 0, gone = 0;
    for (std::uint32_t room = 0; room < world.room_count(); ++room)
        joined += room_info(world, {room})->merged_into != RoomId{room};
    for (std::uint32_t portal = 0; portal < portal_count(world); ++portal)
        gone += portal_info(world, {portal})->polygons == 0;
    EXPECT_GT(joined, 0u);
    EXPECT_GT(gone, 0u);
    EXPECT_LT(joined + 4, world.room_count());
}

}  // namespace
}  // namespace firma
