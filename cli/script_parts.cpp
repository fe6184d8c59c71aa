// SPDX-License-Identifier: MIT
// What a script sets a game up with.
#include "cli/script_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "cli/failure.h"
#include "firma/level.h"

namespace firma::cli {

namespace {

constexpr double kDegree = 0.017453292519943295;
constexpr double kFar = 8192;     // metres
constexpr double kLong = 1e9;     // seconds
constexpr double kStrong = 1e60;  // newtons, newton seconds: above kUnpierced for "never"

CutterShape shape_of(JsonFields& fields, std::string_view key, CutterShape otherwise) {
    const std::string name = fields.text(key, std::string(cutter_shape_name(otherwise)));
    const std::optional<CutterShape> shape = cutter_shape(name);
    if (!shape) fields.fail(key, "'" + name + "' is none of rocky, spiky, drill, wedge, box");
    return *shape;
}

ShotTerms terms_of(const Json* json, const std::string& place, ShotTerms terms) {
    if (!json) return terms;
    JsonFields fields(*json, place);
    terms.ricochet_below =
        fields.number("ricochet_below_degrees", terms.ricochet_below / kDegree, 0, 90.000001) * kDegree;
    terms.restitution = fields.number("restitution", terms.restitution, 0, 1);
    terms.friction = fields.number("friction", terms.friction, 0, 1e6);
    terms.resistance = fields.number("resistance", terms.resistance, 0, kUnpierced);
    fields.finish();
    return terms;
}

Weapon weapon_of_json(const Json& json, const std::string& place, const GameState& game) {
    JsonFields fields(json, place);
    Weapon weapon;
    weapon.name = fields.text("name", std::nullopt);
    for (const GameShots& known : game.shots)
        if (known.weapon.name == weapon.name) weapon = known.weapon;
    weapon.mass = fields.number("mass", weapon.mass, 1e-9, 1e9);
    weapon.gravity.z = -fields.number("gravity", -weapon.gravity.z, 0, 1000);
    weapon.terms = terms_of(fields.find("terms"), fields.place_of("terms"), weapon.terms);
    weapon.bodies = terms_of(fields.find("bodies"), fields.place_of("bodies"), weapon.bodies);
    weapon.pane_energy = fields.number("pane_energy", weapon.pane_energy, 0, kUnpierced);
    weapon.stop_speed = fields.number("stop_speed", weapon.stop_speed, 0, kFar);
    weapon.fuse = fields.number("fuse", weapon.fuse, 0, 3600);
    weapon.lies = fields.flag("lies", weapon.lies);
    if (const Json* charge = fields.find("charge")) {
        JsonFields its(*charge, fields.place_of("charge"));
        weapon.charge = charge_of(its, weapon.charge.value_or(Charge()));
        its.finish();
    }
    fields.finish();
    return weapon;
}

/// A box as a closed level, its corners on the grid of 1/4096 m.
World world_of_box(const Box& box, const std::string& material, const std::string& place) {
    std::string text = "usemtl " + material + "\n";
    for (int k = 0; k < 8; ++k)
        text += fmt::format("v {} {} {}\n", k & 1 ? box.high.x : box.low.x, k & 2 ? box.high.y : box.low.y,
                            k & 4 ? box.high.z : box.low.z);
    text += "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
    const Result<Level> level = read_obj(text, place);
    if (!level) throw Failure(level.error());
    return take(make_world(level.value()));
}

Box box_of(const Json& json, const std::string& place) {
    if (!json.is_array() || json.size() != 2) throw Failure(place, "is not two corners, [[x, y, z], [x, y, z]]");
    const Box box{vec_of(json[0], place), vec_of(json[1], place)};
    for (int axis = 0; axis < 3; ++axis)
        if (!(box.high[axis] - box.low[axis] >= 1.0 / 1024))
            throw Failure(place, "the second corner is not above the first along each axis");
    return box;
}

double wait_of(JsonFields& fields) {
    const Json* wait = fields.find("wait");
    if (wait && wait->is_string() && wait->get<std::string>() == "forever") return INFINITY;
    return fields.number("wait", 0, 0, kLong);
}

PartStop stop_of(const Json& json, const std::string& place) {
    JsonFields fields(json, place);
    PartStop stop;
    stop.position = fields.vec("position", Vec3{});
    stop.angle = fields.number("degrees", 0, -1e6, 1e6) * kDegree;
    stop.wait = wait_of(fields);
    stop.seconds = fields.number("seconds", 0, 0, kLong);
    fields.finish();
    return stop;
}

WhenBlocked when_blocked_of(JsonFields& fields) {
    const std::string name = fields.text("when_blocked", "crushes");
    if (name == "stops") return WhenBlocked::kStops;
    if (name == "returns") return WhenBlocked::kReturns;
    if (name != "crushes") fields.fail("when_blocked", "'" + name + "' is none of stops, returns, crushes");
    return WhenBlocked::kCrushes;
}

PartPath path_of(JsonFields& fields) {
    PartPath path;
    const Json& stops = fields.list("stops");
    for (std::size_t k = 0; k < stops.size(); ++k)
        path.stops.push_back(stop_of(stops[k], fmt::format("{} {}", fields.place_of("stop"), k)));
    path.repeats = fields.flag("repeats", false);
    path.axis = fields.vec("axis", Vec3{0, 0, 1});
    const double axis = length(path.axis);
    if (!(axis > 1e-6)) fields.fail("axis", "is no direction");
    path.axis *= 1 / axis;
    path.spin = fields.number("spin_degrees", 0, -1e6, 1e6) * kDegree;
    if (const Json* swing = fields.find("swing")) {
        JsonFields its(*swing, fields.place_of("swing"));
        path.swing.reach = its.vec("reach", Vec3{});
        path.swing.angle = its.number("degrees", 0, -1e4, 1e4) * kDegree;
        path.swing.period = its.number("period", std::nullopt, 1e-3, kLong);
        path.swing.phase = its.number("phase", 0, 0, 1);
        its.finish();
    }
    return path;
}

/// Another way to go for a part that is there: of the level, or of a saved game.
void drive_anew(JsonFields& fields, std::size_t index, GameState& game) {
    PartDrive drive = drive_of(fields, part_pose(game.drives[index].path, 0));
    add_part(game, game.parts[index], std::move(drive));  // puts it where it goes, and finds the portals that it closes
    std::swap(game.parts[index], game.parts.back());
    std::swap(game.drives[index], game.drives.back());
    game.parts.pop_back();
    game.drives.pop_back();
}

void add_part_of(const Json& json, const std::string& place, GameState& game) {
    JsonFields fields(json, place);
    const std::string name = fields.text("name", std::nullopt);
    const auto known =
        std::find_if(game.parts.begin(), game.parts.end(), [&](const MovingPart& part) { return part.name == name; });
    if (known != game.parts.end()) {
        if (fields.has("box")) fields.fail("name", "there is a part '" + name + "' already");
        drive_anew(fields, std::size_t(known - game.parts.begin()), game);
        fields.finish();
        return;
    }
    const std::string material = fields.text("material", "steel");
    if (material.find_first_of("\r\n") != std::string::npos) fields.fail("material", "has a line end in it");
    const Box box = box_of(fields.at("box"), fields.place_of("box"));
    MovingPart part(world_of_box(box, material, fields.place_of("box")));
    part.name = name;
    PartDrive drive = drive_of(fields, {});
    fields.finish();
    add_part(game, std::move(part), std::move(drive));
}

void set_debris_rules(JsonFields& fields, DebrisRules& rules) {
    rules.max_bodies = fields.count("max_bodies", rules.max_bodies, 0, 1'000'000);
    rules.max_spheres = fields.count("max_spheres", rules.max_spheres, 0, 100'000'000);
    if (fields.has("max_age")) rules.max_age = fields.number("max_age", std::nullopt, 0, kLong);
    rules.max_asleep = fields.number("max_asleep", rules.max_asleep, 0, kLong);
    rules.to_ground = fields.flag("to_ground", rules.to_ground);
    static_cast<void>(fields.find("max_age"));
}

void set_rules(const Json* json, const std::string& place, GameRules& rules) {
    if (!json) return;
    JsonFields fields(*json, place);
    rules.bodies.gravity.z = -fields.number("gravity", -rules.bodies.gravity.z, 0, 1000);
    set_debris_rules(fields, rules.debris);
    if (!fields.flag("chunks", rules.chunks.has_value())) {
        rules.chunks.reset();
    } else {
        if (!rules.chunks) rules.chunks.emplace();
        rules.chunks->min_volume = fields.number("min_volume", rules.chunks->min_volume, 0, 1e12);
        rules.chunks->density = fields.number("density", rules.chunks->density, 0, 1e12);
    }
    rules.max_blast_speed = fields.number("max_blast_speed", rules.max_blast_speed, 0, 1e6);
    fields.finish();
}

}  // namespace

PartDrive drive_of(JsonFields& fields, const Pose& stands) {
    PartDrive drive;
    drive.path = path_of(fields);
    drive.waits = fields.flag("waits", !drive.path.stops.empty());
    drive.when_blocked = when_blocked_of(fields);
    drive.path.rotation = stands.rotation;
    if (stands.position == Vec3{}) return drive;
    if (drive.path.stops.empty()) drive.path.stops.emplace_back();
    for (PartStop& stop : drive.path.stops) stop.position += stands.position;
    return drive;
}

Charge charge_of(JsonFields& fields, const Charge& otherwise) {
    Charge charge = otherwise;
    charge.crater = fields.number("crater", charge.crater, 0, kFar);
    charge.shape = shape_of(fields, "shape", charge.shape);
    charge.material = fields.text("material", charge.material);
    charge.radius = fields.number("radius", charge.radius, 1e-6, kFar);
    charge.impulse = fields.number("impulse", charge.impulse, 0, kStrong);
    charge.break_radius = fields.number("break_radius", charge.break_radius, 0, kFar);
    charge.max_pieces = std::uint32_t(fields.count("max_pieces", charge.max_pieces, 1, kMaxPieces));
    return charge;
}

std::uint32_t weapon_of(JsonFields& fields, std::string_view key, const GameState& game) {
    const std::string name = fields.text(key, std::nullopt);
    std::string names;
    for (std::size_t k = 0; k < game.shots.size(); ++k) {
        if (game.shots[k].weapon.name == name) return std::uint32_t(k);
        names += (names.empty() ? "" : ", ") + game.shots[k].weapon.name;
    }
    fields.fail(key, "'" + name + "' is no weapon; there are " + names);
}

void set_up_game(JsonFields& script, const std::string& place, GameState& game) {
    game.rules.seed = script.count("seed", game.rules.seed, 0, std::numeric_limits<std::uint64_t>::max());
    set_rules(script.find("rules"), place + ": rules", game.rules);
    const Json& weapons = script.list("weapons");
    for (std::size_t k = 0; k < weapons.size(); ++k) {
        Weapon weapon = weapon_of_json(weapons[k], fmt::format("{}: weapon {}", place, k), game);
        const auto known = std::find_if(game.shots.begin(), game.shots.end(),
                                        [&](const GameShots& shots) { return shots.weapon.name == weapon.name; });
        if (known != game.shots.end())
            known->weapon = std::move(weapon);
        else
            game.shots.push_back({std::move(weapon), {}});
    }
    const Json& parts = script.list("parts");
    for (std::size_t k = 0; k < parts.size(); ++k) add_part_of(parts[k], fmt::format("{}: part {}", place, k), game);
}

}  // namespace firma::cli
