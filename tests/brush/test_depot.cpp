// SPDX-License-Identifier: MIT
// Our demo level, levels/depot.map, as it is joined: its rooms, its portals, a walk through it.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include "firma/brush_world.h"
#include "firma/carve.h"
#include "firma/level.h"
#include "firma/queries.h"
#include "firma/rooms.h"
#include "firma/solid.h"
#include "tests/brush/depot_level.h"

namespace firma {
namespace {

constexpr double kUnit = 1.0 / 32;
constexpr double kPlayerRadius = 0.3, kPlayerHeight = 1.8;

struct Depot {
    BrushLevel level;
    BrushWorldReport report;
    World world;
};

const Depot& depot() {
    static const Depot made = [] {
        Depot depot;
        depot.level = test::depot_level();
        depot.world = make_world(depot.level, {}, &depot.report).value();
        return depot;
    }();
    return made;
}

Vec3 metres(const Vec3& units) {
    return units * kUnit;
}

Vec3 origin_of(const Entity& entity) {
    std::istringstream words{std::string(entity.value("origin"))};
    Vec3 place;
    words >> place.x >> place.y >> place.z;
    return metres(place);
}

std::vector<Vec3> spawn_points() {
    std::vector<Vec3> places;
    for (const Entity& entity : depot().level.entities)
        if (entity.value("classname").starts_with("info_player_")) places.push_back(origin_of(entity));
    return places;
}

TEST(Depot, JoinsWithNothingLeftOut) {
    EXPECT_TRUE(depot().level.notes.empty());
    EXPECT_TRUE(depot().report.notes.empty()) << depot().report.notes[0].reason;
    EXPECT_EQ(depot().report.lost_shells, 0u);
    EXPECT_EQ(depot().level.max_shift, 0);
    const auto fault = check_world(depot().world);
    EXPECT_FALSE(fault) << fault->what;
    const auto solid_fault = check_solid(depot().world);
    EXPECT_FALSE(solid_fault) << solid_fault->what;
}

TEST(Depot, HasNamedRoomsAndPortalsBetweenThem) {
    const World& world = depot().world;
    std::set<std::string> names;
    for (std::uint32_t room = 0; room < world.room_count(); ++room) {
        const RoomInfo info = *room_info(world, {room});
        EXPECT_FALSE(info.name.empty()) << "room " << room;
        EXPECT_EQ(info.exterior, info.name == "exterior");
        EXPECT_EQ(info.portals.empty(), info.exterior) << info.name;
        names.emplace(info.name);
    }
    EXPECT_EQ(names.size(), world.room_count());
    EXPECT_EQ(names.size(), 23u);
    for (std::uint32_t portal = 0; portal < portal_count(world); ++portal) {
        const PortalInfo info = *portal_info(world, {portal});
        EXPECT_NE(info.rooms[0], info.rooms[1]) << info.name;
        EXPECT_GT(info.polygons, 0u) << info.name;
        EXPECT_FALSE(info.name.empty());
    }
    EXPECT_EQ(portal_count(world), 35u);
}

TEST(Depot, EveryRoomIsReachedThroughPortals) {
    const World& world = depot().world;
    const Location start = locate(world, spawn_points().at(0));
    ASSERT_EQ(start.where, Where::kAir);
    EXPECT_EQ(room_info(world, start.room)->name, "hall");
    for (std::uint32_t room = 0; room < world.room_count(); ++room) {
        const RoomInfo info = *room_info(world, {room});
        EXPECT_EQ(find_path(world, start.room, {room}).has_value(), !info.exterior) << info.name;
    }
}

TEST(Depot, ShowsTheMaterialsOfEachPlaceAndNoFiller) {
    std::set<std::string> seen;
    for (const Face& face : depot().world.faces()) seen.insert(depot().world.material_name(face.material));
    for (const std::string& name : seen) EXPECT_TRUE(name.starts_with("depot/") || name == "common/clip") << name;
    EXPECT_GE(seen.size(), 40u);
    for (const char* name : {"depot/sky", "depot/glass", "depot/liquids/water", "depot/rock", "common/clip"})
        EXPECT_TRUE(seen.contains(name)) << name;
}

TEST(Depot, SpawnPointsHaveSpace) {
    const std::vector<Vec3> places = spawn_points();
    EXPECT_GE(places.size(), 10u);
    for (const Vec3& place : places) {
        const Location at = locate(depot().world, place);
        ASSERT_EQ(at.where, Where::kAir) << place.x << " " << place.y << " " << place.z;
        EXPECT_FALSE(room_info(depot().world, at.room)->exterior);
        const NearFace nearest = closest(depot().world, place, 0.4, {.mask = kStopsWalk});
        EXPECT_FALSE(nearest) << place.x << " " << place.y << " " << place.z;
        const Hit below = cast(depot().world, {place, 0.3}, {0, 0, -1.2}, {.mask = kStopsWalk});
        EXPECT_EQ(below.status, Status::kHit) << place.x << " " << place.y << " " << place.z;
    }
}

TEST(Depot, LightsAndAnchorsAreThere) {
    std::map<std::string, int> count;
    for (const Entity& entity : depot().level.entities) ++count[std::string(entity.value("classname"))];
    EXPECT_EQ(count["info_player_start"], 1);
    EXPECT_EQ(count["firma_anchor"], 1);
    EXPECT_GE(count["light"], 23);
    for (const Entity& entity : depot().level.entities) {
        if (entity.value("classname") != "light") continue;
        EXPECT_EQ(locate(depot().world, origin_of(entity)).where, Where::kAir) << "line " << entity.line;
    }
}

/// Where the feet go, in map units. Flights begin a tread before their first step, so that the way runs along the
/// edges.
struct Walk {
    const char* name;
    std::vector<Vec3> feet;
};

const Walk kWalks[] = {
    {"up the stairs, round the gallery, over the bridge, back by the battery room",
     {{600, 224, 0},    {600, 160, 0},   {108, 160, 0},   {108, 128, 0},   {-180, 128, 0},  {-180, 148, 0},
      {-180, 244, 64},  {-180, 304, 64}, {-76, 304, 64},  {-76, 268, 64},  {-76, 172, 128}, {-76, 128, 128},
      {40, 128, 128},   {40, 404, 128},  {216, 404, 128}, {216, 512, 128}, {448, 512, 128}, {448, -140, 128},
      {184, -140, 128}, {184, 32, 128},  {268, 32, 128},  {460, 32, 0},    {500, 32, 0}}},
    {"along the corridor into its rooms",
     {{216, 512, 128},
      {124, 512, 128},
      {124, 580, 128},
      {124, 512, 128},
      {404, 512, 128},
      {404, 590, 128},
      {404, 512, 128},
      {700, 512, 128},
      {700, 590, 128}}},
    {"through the dock down to the yard, through the tunnel to the cellar and up",
     {{500, 160, 0},     {800, 160, 0},     {800, 112, 0},     {900, 112, 0},     {980, 140, 0},     {980, 424, 0},
      {1056, 424, 0},    {1104, 424, -32},  {1150, 424, -32},  {1200, 330, -32},  {1400, 330, -32},  {1400, 20, -32},
      {1370, -450, -32}, {1370, -624, -32}, {1152, -624, -32}, {832, -624, -112}, {512, -624, -160}, {400, -624, -160},
      {400, -540, -160}, {300, -540, -160}, {192, -500, -160}, {192, 100, -160},  {230, 130, -160},  {-180, 128, -160},
      {-180, 148, -160}, {-180, 268, -80},  {-180, 316, -80},  {-76, 316, -80},   {-76, 292, -80},   {-76, 172, 0},
      {-76, 128, 0},     {60, 128, 0}}},
    {"from the boiler room to the fuel store",
     {{230, 130, -160}, {360, 128, -160}, {400, 152, -160}, {470, 152, -160}}},
    {"into the offices and the lockers",
     {{500, 160, 0}, {500, 580, 0}, {640, 580, 0}, {640, 530, 0}, {732, 530, 0}, {732, 380, 0}}},
    {"into the office in the middle", {{400, 300, 0}, {348, 400, 0}, {348, 560, 0}}},
    {"into the western office", {{200, 300, 0}, {200, 400, 0}, {140, 420, 0}, {140, 560, 0}}},
    {"through the workshop and the cistern",
     {{500, 160, 0},
      {108, 160, 0},
      {108, 60, 0},
      {132, 40, 0},
      {132, -110, 0},
      {270, -110, 0},
      {290, -136, 0},
      {400, -136, 0},
      {400, -72, 0},
      {672, -72, 0},
      {672, 160, 0}}},
    {"up to the roofs",
     {{1370, 20, -32},
      {1370, -440, -32},
      {1308, -440, -32},
      {1308, -428, -32},
      {1308, -44, 224},
      {1308, -8, 224},
      {1240, -8, 224},
      {1100, 160, 224},
      {884, 160, 224},
      {884, 188, 224},
      {884, 380, 352},
      {884, 416, 352},
      {830, 416, 352}}},
    {"into the hut", {{1400, 20, -32}, {1500, 300, -32}, {1772, 440, -32}, {1772, 540, -32}}},
};

TEST(Depot, APlayerCanWalkThroughIt) {
    const World& world = depot().world;
    std::set<std::string> entered;
    for (const Walk& walk : kWalks) {
        for (std::size_t k = 0; k + 1 < walk.feet.size(); ++k) {
            const Vec3 from = metres(walk.feet[k]), way = metres(walk.feet[k + 1]) - from;
            for (const double height : {0.55, kPlayerHeight - kPlayerRadius}) {
                std::array<RoomId, 8> passed;
                RoomTrail trail{passed};
                const Hit hit = cast(world, {from + Vec3{0, 0, height}, kPlayerRadius}, way,
                                     {.mask = kStopsWalk, .room = kLocateRoom, .trail = &trail});
                EXPECT_EQ(hit.status, Status::kMiss)
                    << walk.name << ": leg " << k << " at height " << height << " meets "
                    << world.material_name(hit.material) << " at " << hit.point.x / kUnit << " " << hit.point.y / kUnit
                    << " " << hit.point.z / kUnit;
                for (std::uint32_t p = 0; p < std::min<std::size_t>(trail.count, passed.size()); ++p)
                    entered.emplace(room_info(world, passed[p])->name);
            }
            const Hit floor = cast(world, {from + Vec3{0, 0, 0.3}, 0.0}, {0, 0, -0.6}, {.mask = kStopsWalk});
            EXPECT_EQ(floor.status, Status::kHit) << walk.name << ": nothing to stand on at " << k;
        }
    }
    EXPECT_EQ(entered.size(), world.room_count() - 1) << "all but the exterior";
}

using Corner = std::tuple<double, double, double>;

/// The faces that hang together with one through shared corners.
std::vector<const Face*> shell_around(const std::vector<Face>& faces, FaceId first) {
    std::map<Corner, std::vector<const Face*>> at;
    std::vector<const Face*> shell;
    std::set<FaceId> reached{first};
    for (const Face& face : faces) {
        if (!face.solid) continue;
        for (const Vec3& c : face.corners) at[{c.x, c.y, c.z}].push_back(&face);
        if (face.id == first) shell.push_back(&face);
    }
    for (std::size_t k = 0; k < shell.size(); ++k)
        for (const Vec3& c : shell[k]->corners)
            for (const Face* face : at[{c.x, c.y, c.z}])
                if (reached.insert(face->id).second) shell.push_back(face);
    return shell;
}

/// Whether every edge of a shell is there the other way round as well, as often.
bool is_closed(const std::vector<const Face*>& shell) {
    std::map<std::pair<Corner, Corner>, int> edges;
    for (const Face* face : shell) {
        for (std::size_t k = 0; k < face->corners.size(); ++k) {
            const Vec3 a = face->corners[k], b = face->corners[(k + 1) % face->corners.size()];
            const Corner from{a.x, a.y, a.z}, to{b.x, b.y, b.z};
            ++edges[{from, to}];
            --edges[{to, from}];
        }
    }
    return std::all_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.second == 0; });
}

TEST(Depot, TheBridgeIsFreeOnceBothItsEndsAreShot) {
    const Vec3 over_it{14, 7, 4.5}, down{0, 0, -1};
    World world = depot().world;
    for (const int cuts : {0, 1, 2}) {
        if (cuts > 0) {
            const CarveResult cut = carve(world, make_crater(CutterShape::kRocky, std::uint64_t(cuts)),
                                          {.position = {14, cuts == 1 ? 0.5 : 13.5, 3.9}, .scale = 2.2});
            ASSERT_EQ(cut.status, CarveStatus::kDone) << cut.error.text();
            world = cut.world;
        }
        const Hit deck = cast(world, {over_it, 0.0}, down);
        ASSERT_EQ(deck.status, Status::kHit);
        const std::vector<Face> faces = world.faces();
        const std::vector<const Face*> shell = shell_around(faces, deck.face.id);
        EXPECT_TRUE(is_closed(shell));
        Box box;
        for (const Face* face : shell)
            for (const Vec3& corner : face->corners) box.add(corner);
        const bool free = box.low.y > 0 && box.high.y < 14 && box.low.z > 2.5 && box.high.z < 5.5;
        EXPECT_EQ(free, cuts == 2) << "after " << cuts << " shots";
    }
}

}  // namespace
}  // namespace firma
