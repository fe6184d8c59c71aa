// SPDX-License-Identifier: MIT
// Scripts of games: events.
#include "cli/game_script.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "cli/csv_reader.h"
#include "cli/failure.h"
#include "cli/json_fields.h"
#include "cli/script_parts.h"
#include "firma/recording.h"
#include "firma/rooms.h"

namespace firma::cli {

const char* const kScriptHelp =
    R"(A script is JSON, metres, seconds, kilograms; docs/recordings.md has every key:
  {"events": [
     {"time": 0, "player": {"position": [6, 3, 0.1]}},
     {"time": 0.5, "wish": {"player": 0, "velocity": [4, 0, 0], "jump": true}},
     {"time": 1, "fire": {"weapon": "rocket", "from": [6, 3, 1.6], "to": [14, 2, 3.7], "speed": 40}},
     {"time": 2, "blast": {"position": [14, 12, 3.75], "crater": 2.2}},
     {"time": 2, "carve": {"position": [20, 0, 1], "scale": 1.2, "shape": "drill"}},
     {"time": 2, "fill": {"position": [20, 5, 0], "scale": 0.5, "shape": "box", "material": "concrete"}},
     {"time": 3, "body": {"ball": 0.3, "position": [10, 5, 3], "velocity": [3, 0, 0], "density": 800}},
     {"time": 3, "body": {"box": [0.4, 0.3, 0.3], "position": [10, 6, 3]}},
     {"time": 4, "part": "gate"},
     {"time": 4, "door": {"portal": "hall_door", "open": false}}],
   "parts": [{"name": "gate", "box": [[-1, -0.1, 0], [1, 0.1, 2.2]],
              "stops": [{"position": [8, 9, 0], "seconds": 1}, {"position": [10, 9, 0], "wait": 2, "seconds": 1}]}],
   "weapons": [{"name": "rocket", "charge": {"crater": 1.5}}], "rules": {"max_bodies": 300}, "seed": 1}
Weapons that are there: bullet, rocket, grenade. Parts of the level (func_door and its like) are there by the names
part_0, part_1, ..., nodes of glTF that are parts by their own; `part` sets one off that waits. Of one of these "parts"
says another way to go, without a box: its stops are told from where it stands.
)";

namespace {

constexpr double kDensityOfBodies = 1000;
constexpr double kFastest = 524288;  // metres a second
constexpr double kReachOfRoom = 8192;
constexpr std::size_t kBoxSpheresAlong = 64;

/// What a script's events name.
struct EventReader {
    const GameState& game;
    std::size_t players;  ///< that are there by then

    GameEvent read(JsonFields& fields);

private:
    decltype(GameEvent::what) only(JsonFields& fields, const char* key);
};

std::uint32_t part_named(const JsonFields& fields, const Json& json, const GameState& game) {
    if (json.is_number_unsigned()) {
        const std::uint64_t index = json.get<std::uint64_t>();
        if (index >= game.parts.size()) fields.fail("part", fmt::format("there is no part {}", index));
        return std::uint32_t(index);
    }
    if (!json.is_string()) fields.fail("part", "is neither a name nor a number");
    const std::string name = json.get<std::string>();
    for (std::size_t k = 0; k < game.parts.size(); ++k)
        if (game.parts[k].name == name) return std::uint32_t(k);
    fields.fail("part", "there is no part '" + name + "'");
}

PortalId portal_named(const JsonFields& fields, const Json& json, const World& world) {
    std::optional<PortalId> portal;
    if (json.is_string()) portal = find_portal(world, json.get<std::string>());
    if (json.is_number_unsigned()) {
        const std::uint64_t index = json.get<std::uint64_t>();
        if (index < portal_count(world)) portal = PortalId{std::uint32_t(index)};
    }
    if (!portal) fields.fail("portal", "there is no portal " + json.dump());
    return *portal;
}

/// Spheres in rows along the axes of a box, of half its thinnest half side; none inside.
SphereSet spheres_of_box(const Vec3& half, const JsonFields& fields) {
    const double radius = std::min({half.x, half.y, half.z}) * 0.5;
    std::size_t counts[3];
    for (int axis = 0; axis < 3; ++axis) {
        const double along = std::ceil((half[axis] - radius) / radius);
        if (along >= double(kBoxSpheresAlong)) fields.fail("box", "is more than 64 times as long as thick");
        counts[axis] = std::max<std::size_t>(std::size_t(along), 1) + 1;
    }
    SphereSet spheres;
    const auto place = [&](int axis, std::size_t k) {
        const double reach = half[axis] - radius;
        return -reach + 2 * reach * double(k) / double(counts[axis] - 1);
    };
    for (std::size_t x = 0; x < counts[0]; ++x)
        for (std::size_t y = 0; y < counts[1]; ++y)
            for (std::size_t z = 0; z < counts[2]; ++z) {
                const bool inside =
                    x > 0 && x + 1 < counts[0] && y > 0 && y + 1 < counts[1] && z > 0 && z + 1 < counts[2];
                if (!inside) spheres.push_back({{place(0, x), place(1, y), place(2, z)}, radius});
            }
    if (spheres.size() > kMaxSpheres) fields.fail("box", "takes more than 4096 spheres: it is too thin");
    return spheres;
}

BodyShape body_shape_of(JsonFields& fields) {
    const double density = fields.number("density", kDensityOfBodies, 1e-6, 1e9);
    const Json* box = fields.find("box");
    if ((box != nullptr) == fields.has("ball")) throw Failure(fields.place(), "has either 'ball' or 'box'");
    if (!box) {
        const double radius = fields.number("ball", std::nullopt, 1e-4, kReachOfRoom);
        const Sphere sphere{{}, radius};
        return take(make_body_shape({&sphere, 1}, mass_of_ball(radius, density)));
    }
    static_cast<void>(fields.find("ball"));
    const Vec3 half = vec_of(*box, fields.place_of("box"));
    for (int axis = 0; axis < 3; ++axis)
        if (!(half[axis] >= 1e-4 && half[axis] <= kReachOfRoom))
            fields.fail("box", "has a half side that is not 0.0001 to 8192 m");
    return take(make_body_shape(spheres_of_box(half, fields), mass_of_box(half, density)));
}

Quaternion rotation_of(JsonFields& fields) {
    const Json* json = fields.find("rotation");
    if (!json) return {0, 0, 0, 1};
    Quaternion turn{};
    if (!json->is_array() || json->size() != 4) fields.fail("rotation", "is not four numbers, [x, y, z, w]");
    for (std::size_t k = 0; k < 4; ++k) {
        if (!(*json)[k].is_number()) fields.fail("rotation", "is not four numbers, [x, y, z, w]");
        turn[k] = (*json)[k].get<double>();
    }
    return turn;
}

GamePlayer player_of(JsonFields& fields) {
    GamePlayer player;
    PlayerSize size;
    size.radius = fields.number("radius", size.radius, 1e-3, kReachOfRoom);
    size.height = fields.number("height", size.height, 1e-3, kReachOfRoom);
    size.crouched_height =
        fields.number("crouched_height", std::min(size.crouched_height, size.height), 1e-3, kReachOfRoom);
    const std::string shape = fields.text("shape", "capsule");
    if (shape != "capsule" && shape != "box") fields.fail("shape", "'" + shape + "' is neither capsule nor box");
    Result<PlayerShape> made = shape == "box" ? make_player_box(size) : make_player_capsule(size);
    if (!made) throw Failure(fields.place(), made.error().reason);
    player.shape = std::move(made).value();
    player.mass = fields.number("mass", player.mass, 1e-3, 1e9);
    player.rules.gravity = fields.number("gravity", player.rules.gravity, 0, 1e4);
    player.rules.step_height = fields.number("step_height", player.rules.step_height, 0, kReachOfRoom);
    player.rules.jump_speed = fields.number("jump_speed", player.rules.jump_speed, 0, 1e4);
    player.player.position = fields.vec("position", std::nullopt);
    player.player.velocity = fields.vec("velocity", Vec3{});
    return player;
}

FireEvent fire_of(JsonFields& fields, const GameState& game) {
    FireEvent event;
    event.weapon = weapon_of(fields, "weapon", game);
    event.position = fields.vec("from", std::nullopt);
    if (fields.has("velocity")) {
        event.velocity = fields.vec("velocity", std::nullopt);
        if (!(max_abs(event.velocity) <= kFastest)) fields.fail("velocity", "is more than 524288 m/s");
        return event;
    }
    const Vec3 way = fields.vec("to", std::nullopt) - event.position;
    const double far = length(way);
    if (!(far > 0)) fields.fail("to", "is where 'from' is");
    event.velocity = way * (fields.number("speed", std::nullopt, 1e-3, kFastest) / far);
    return event;
}

EditEvent edit_of(JsonFields& fields, EditKind kind) {
    const std::string name = fields.text("shape", "rocky");
    const std::optional<CutterShape> shape = cutter_shape(name);
    if (!shape) fields.fail("shape", "'" + name + "' is none of rocky, spiky, drill, wedge, box");
    const std::uint64_t seed = fields.count("seed", 1, 0, std::numeric_limits<std::uint64_t>::max());
    CarveOptions options;
    options.material = fields.text("material", "");
    const Vec3 position = fields.vec("position", std::nullopt);
    EditEvent event;
    event.command = crater_command(1, {*shape, seed}, position, fields.number("scale", 1, 1e-3, kReachOfRoom), options);
    event.command.kind = kind;
    return event;
}

BodyEvent body_of_fields(JsonFields& fields) {
    const BodyShape shape = body_shape_of(fields);
    Pose pose;
    pose.position = fields.vec("position", std::nullopt);
    pose.rotation = rotation_of(fields);
    BodyEvent event{body_at(shape, pose)};
    event.body.velocity = fields.vec("velocity", Vec3{});
    event.body.spin = fields.vec("spin", Vec3{});
    event.body.friction = fields.number("friction", event.body.friction, 0, 1e3);
    event.body.restitution = fields.number("restitution", event.body.restitution, 0, 1);
    event.body.rolling = fields.number("rolling", event.body.rolling, 0, 1e3);
    return event;
}

WishEvent wish_of(JsonFields& fields, std::size_t players) {
    WishEvent event;
    event.player = std::uint32_t(fields.count("player", 0, 0, std::numeric_limits<std::uint32_t>::max()));
    if (event.player >= players) fields.fail("player", fmt::format("there is no player {} by then", event.player));
    event.wish.velocity = fields.vec("velocity", Vec3{});
    event.wish.jump = fields.flag("jump", false);
    event.wish.crouch = fields.flag("crouch", false);
    event.wish.careful = fields.flag("careful", false);
    return event;
}

EditEvent door_of(JsonFields& fields, const World& world) {
    const PortalId portal = portal_named(fields, fields.at("portal"), world);
    if (!fields.has("open")) throw Failure(fields.place(), "'open' is missing");
    return {door_command(1, portal, fields.flag("open", true))};
}

constexpr const char* kEventKinds[] = {"player", "wish", "fire", "blast", "carve", "fill", "body", "part", "door"};

decltype(GameEvent::what) EventReader::only(JsonFields& fields, const char* key) {
    const Json& json = fields.at(key);
    const std::string kind = key;
    if (kind == "part") return PartEvent{part_named(fields, json, game)};
    JsonFields its(json, fields.place_of(key));
    decltype(GameEvent::what) what;
    if (kind == "player") {
        what = PlayerEvent{player_of(its)};
        ++players;
    } else if (kind == "wish") {
        what = wish_of(its, players);
    } else if (kind == "fire") {
        what = fire_of(its, game);
    } else if (kind == "blast") {
        BlastEvent event;
        event.at = its.vec("position", std::nullopt);
        event.charge = charge_of(its, {});
        what = event;
    } else if (kind == "body") {
        what = body_of_fields(its);
    } else if (kind == "door") {
        what = door_of(its, game.world);
    } else {
        what = edit_of(its, kind == "fill" ? EditKind::kFill : EditKind::kCarve);
    }
    its.finish();
    return what;
}

std::string all_kinds() {
    std::string names;
    for (const char* kind : kEventKinds) names += (names.empty() ? "" : ", ") + std::string(kind);
    return names;
}

GameEvent EventReader::read(JsonFields& fields) {
    const char* found = nullptr;
    for (const char* kind : kEventKinds) {
        if (!fields.has(kind)) continue;
        if (found)
            throw Failure(fields.place(), fmt::format("has both '{}' and '{}'; make two events of it", found, kind));
        found = kind;
    }
    if (!found) throw Failure(fields.place(), "has none of " + all_kinds());
    return {0, only(fields, found)};
}

/// The tick that is nearest to a time.
std::uint64_t tick_of(double seconds, const GameState& game) {
    return game.tick + std::uint64_t(std::floor(seconds * game.rate + 0.5));
}

}  // namespace

GameScript read_game_script(const std::string& path, GameState& game, std::uint64_t ticks) {
    const Json json = parse_json(read_file(path), path);
    JsonFields script(json, path);
    set_up_game(script, path, game);
    const Json& list = script.list("events");
    script.finish();
    // In order of time before they are read, as they name players by when these come in.
    struct Timed {
        std::uint64_t tick;
        std::size_t index;
    };
    std::vector<Timed> order;
    std::vector<JsonFields> fields;
    fields.reserve(list.size());
    for (std::size_t k = 0; k < list.size(); ++k) {
        fields.emplace_back(list[k], fmt::format("{}: event {}", path, k));
        order.push_back({tick_of(fields[k].number("time", std::nullopt, 0, 1e6), game), k});
    }
    std::sort(order.begin(), order.end(),
              [](const Timed& a, const Timed& b) { return a.tick != b.tick ? a.tick < b.tick : a.index < b.index; });
    GameScript made;
    EventReader reader{game, game.players.size()};
    for (const Timed& timed : order) {
        GameEvent event = reader.read(fields[timed.index]);
        fields[timed.index].finish();
        event.tick = timed.tick;
        if (event.tick >= game.tick + ticks)
            ++made.after_end;
        else
            made.events.push_back(std::move(event));
    }
    if (const auto error = judge_events(game, made.events)) throw Failure(path, error->text());
    return made;
}

}  // namespace firma::cli
