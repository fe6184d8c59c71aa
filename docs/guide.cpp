// SPDX-License-Identifier: MIT
// The program of docs/guide.md: loads a level, walks through it, shoots, carves, undoes, saves.
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "firma/firma.h"

using firma::Hit, firma::Vec3, firma::World;

[[noreturn]] void fail(const std::string& why) {
    std::fprintf(stderr, "%s\n", why.c_str());
    std::exit(1);
}

template <class T>
T must(firma::Result<T> result) {
    if (!result) fail(result.error().text());
    return std::move(result).value();
}

// Where the first entity stands that has this value under this key.
Vec3 place(const firma::BrushLevel& level, const char* key, const char* value) {
    for (const firma::Entity& entity : level.entities)
        if (entity.value(key) == value)
            if (const auto origin = entity_origin(level, entity)) return *origin;
    fail(std::string("no place with ") + key + " " + value);
}

std::string name_of(const World& world, firma::RoomId room) {
    const auto info = room_info(world, room);
    return info ? std::string(info->name) : "no room";
}

// One step of 1/60 s toward a place, at 4 m/s, and down. Returns false once the ball is there.
bool walk(const World& world, firma::Sphere& ball, double& fall, const Vec3& to) {
    const Vec3 way{to.x - ball.centre.x, to.y - ball.centre.y, 0};
    if (length(way) < 0.1) return false;
    fall -= 9.81 / 60;
    Vec3 path = way * (4.0 / 60 / length(way)) + Vec3{0, 0, fall / 60};
    for (int k = 0; k < 4; ++k) {  // along four surfaces at most
        const Hit hit = cast(world, ball, path, {.mask = firma::kStopsWalk});
        ball.centre = ball.centre + path * hit.safe_fraction;
        if (!hit) break;
        if (hit.normal.z > 0.7) fall = 0;  // it stands on something
        path = path * (1 - hit.safe_fraction);
        path = path - hit.normal * dot(path, hit.normal);  // what is left of it, along the surface
    }
    return true;
}

void print_shot(const char* who, const World& world, const Hit& hit) {
    if (!hit) return void(std::printf("%s meets nothing\n", who));
    std::printf("%s meets %s of %s at (%.3f, %.3f, %.3f)\n", who, world.material_name(hit.material).c_str(),
                name_of(world, room_of(world, hit)).c_str(), hit.point.x, hit.point.y, hit.point.z);
}

int main() {
    const firma::BrushLevel level = must(firma::read_brush_level("levels/depot.map"));
    const World world = must(make_world(level));
    std::printf("%zu faces, %zu rooms, %zu portals\n", world.face_count(), world.room_count(), portal_count(world));

    firma::Sphere ball{.centre = place(level, "classname", "info_player_start"), .radius = 0.5};
    firma::RoomId room = locate(world, ball.centre).room;
    std::printf("the player starts in %s at (%.3f, %.3f, %.3f)\n", name_of(world, room).c_str(), ball.centre.x,
                ball.centre.y, ball.centre.z);

    std::vector<Vec3> stops;  // the middle of each portal on the way, then the place itself
    const Vec3 goal = place(level, "name", "office_west");
    const auto portals = find_path(world, room, locate(world, goal).room);
    if (!portals) fail("no way to office_west");
    for (const firma::PortalId portal : *portals) {
        const firma::Box box = portal_info(world, portal)->bounds;
        stops.push_back((box.low + box.high) * 0.5);
    }
    stops.push_back(goal);

    double fall = 0;
    int steps = 0;
    for (const Vec3& stop : stops)
        for (; walk(world, ball, fall, stop); ++steps) {
            const firma::Location here = locate(world, ball.centre);
            if (here.where != firma::Where::kAir || steps == 600) fail("stuck, or in a wall");
            if (here.room == room) continue;
            const firma::PortalId door = find_path(world, room, here.room).value().front();
            std::printf("step %d: through %s into %s\n", steps, std::string(portal_info(world, door)->name).c_str(),
                        name_of(world, here.room).c_str());
            room = here.room;
        }
    std::printf("step %d: there, at (%.3f, %.3f, %.3f)\n", steps, ball.centre.x, ball.centre.y, ball.centre.z);

    const firma::Ray shot{.start = ball.centre + Vec3{0, 0, 0.6}, .path = {20, 0.5, 0}};
    const Hit hit = cast(world, shot, {.mask = firma::kStopsShots});
    print_shot("the shot", world, hit);
    const auto face = world.face_info(hit.face);
    if (!face) fail("the shot met no face");
    std::printf("face %" PRIu32 ", side %" PRIu32 " of the map\n", face->id.value, face->source);

    const firma::Cutter crater = firma::make_crater(firma::CutterShape::kRocky, 7);
    const firma::Pose pose{.position = hit.point, .scale = 0.5};
    const firma::CarveResult blast = carve(world, crater, pose, {.material = "rubble"});
    if (!blast.done()) fail("nothing carved: " + blast.error.text());
    const World& after = blast.world;

    const firma::WorldDiff diff = diff_worlds(world, after);
    std::printf("carved %.3f m3: %zu faces removed, %zu added\n", blast.report.volume, diff.removed.size(),
                diff.added.size());
    for (const firma::RoomId changed : diff.rooms)
        std::printf("draw %s anew: %zu triangles\n", name_of(after, changed).c_str(),
                    triangles_of(after, changed).corners.size());
    for (const firma::PortalId hole : diff.portals_added) {
        const auto rooms = portal_info(after, hole)->rooms;
        std::printf("a hole leads from %s to %s\n", name_of(after, rooms[0]).c_str(), name_of(after, rooms[1]).c_str());
    }

    print_shot("the same shot", after, cast(after, shot, {.mask = firma::kStopsShots}));
    print_shot("without the crater it", world, cast(world, shot, {.mask = firma::kStopsShots}));  // undo

    must(save_world(after, "build/guide.firma"));
    const World loaded = must(firma::load_world("build/guide.firma"));
    std::printf("saved, loaded: hash %016" PRIx64 ", %s\n", hash_world(loaded),
                hash_world(loaded) == hash_world(after) ? "the same" : "another one");
}
