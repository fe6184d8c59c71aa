// SPDX-License-Identifier: MIT
// How an entity moves, by its class and keys, as the games that levels are made for have it.
// Source: id Software, Quake III Arena source code, 2005, code/game/g_mover.c; of func_door_rotating, func_wall and
// func_explosive: Quake II source code, 2001, game/g_func.c, g_misc.c.
#include "brush/part_paths.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string_view>

#include "brush/entity_keys.h"

namespace firma {
namespace {

constexpr double kRadians = 3.141592653589793 / 180;
constexpr double kForEver = std::numeric_limits<double>::infinity();
constexpr std::size_t kMostStops = 4096;
/// The engines measure models a unit larger on each side.
constexpr double kSpread = 2;

/// Of degrees, within a turn.
double radians(double degrees) {
    return (degrees - 360 * std::floor(degrees / 360)) * kRadians;
}

struct PathMaker {
    const BrushLevel& level;
    const Entity& entity;
    const PartPlace& place;
    BrushPart& part;
    double unit = level.metres_a_unit;
    std::uint32_t flags = key_flags(entity);

    double number(std::string_view key, double otherwise) const { return key_number(entity, key, otherwise); }
    /// Of a speed that divides: what is not above 0 is the usual one, as in the games.
    double speed(double otherwise) const {
        const double given = number("speed", otherwise);
        return given > 0 ? given : otherwise;
    }
    double wait(double otherwise) const {
        const double seconds = number("wait", otherwise);
        return seconds < 0 ? kForEver : seconds;
    }

    /// `angle`: degrees about z, -1 up, -2 down; or the second number of `angles`.
    double yaw() const {
        const KeyNumbers angles = key_numbers(entity, "angles");
        return angles.count > 1 ? angles.number[1] : number("angle", 0);
    }
    Vec3 way() const {
        const double angle = yaw();
        if (angle == -1) return {0, 0, 1};
        if (angle == -2) return {0, 0, -1};
        const SineCosine turned = sine_cosine(radians(angle));
        // Square to an axis it is exactly so.
        const auto clean = [](double x) { return std::fabs(x) < 1e-12 ? 0 : x; };
        return {clean(turned.cosine), clean(turned.sine), 0};
    }

    void stand() const { part.path.stops = {{place.position, 0, 0, 0}}; }
    void go_between(const Vec3& shut, const Vec3& open, double units_a_second, double wait_open) const {
        const double seconds = length(open - shut) / (units_a_second * unit);
        part.path.stops = {{shut, 0, 0, seconds}, {open, 0, wait_open, seconds}};
        part.when_blocked = WhenBlocked::kReturns;
        part.waits_for_trigger = true;
    }
};

/// Slides by its size along its way less the lip.
std::string slide(const PathMaker& make, double speed, double wait, double lip) {
    const Vec3 way = make.way();
    double along = 0;
    for (int axis = 0; axis < 3; ++axis) along += std::fabs(way[axis]) * (make.place.size[axis] + kSpread * make.unit);
    const double distance = along - make.number("lip", lip) * make.unit;
    const Vec3 shut = make.place.position, open = shut + way * distance;
    make.go_between(shut, open, make.speed(speed), make.wait(wait));
    return "";
}

std::string door(const PathMaker& make) {
    std::string note = slide(make, 400, 2, 8);
    if (make.flags & 1) std::swap(make.part.path.stops[0].position, make.part.path.stops[1].position);  // start open
    if (make.flags & 4) make.part.when_blocked = WhenBlocked::kCrushes;
    return note;
}

std::string button(const PathMaker& make) {
    return slide(make, 40, 1, 4);
}

/// Drawn where it is up, begins where it is down.
std::string lift(const PathMaker& make) {
    const double usual = (make.place.size.z / make.unit + kSpread) - make.number("lip", 8);
    const double height = make.number("height", usual) * make.unit;
    const Vec3 up = make.place.position;
    make.go_between(up - Vec3{0, 0, height}, up, make.speed(200), make.wait(1));
    return "";
}

Vec3 axis_by_flags(const PathMaker& make, std::uint32_t x, std::uint32_t y) {
    if (make.flags & x) return {1, 0, 0};
    if (make.flags & y) return {0, 1, 0};
    return {0, 0, 1};
}

std::string without_origin(const PathMaker& make) {
    return make.place.has_origin ? "" : "it has no origin, and turns about that of the level";
}

std::string rotating_door(const PathMaker& make) {
    make.part.path.axis = axis_by_flags(make, 64, 128);
    const double turned = make.number("distance", 90) * kRadians * (make.flags & 2 ? -1 : 1);
    const double seconds = std::fabs(turned) / (make.speed(100) * kRadians);
    make.part.path.stops = {{make.place.position, 0, 0, seconds}, {make.place.position, turned, make.wait(3), seconds}};
    if (make.flags & 1) std::swap(make.part.path.stops[0].angle, make.part.path.stops[1].angle);
    make.part.when_blocked = make.flags & 4 ? WhenBlocked::kCrushes : WhenBlocked::kReturns;
    make.part.waits_for_trigger = true;
    return without_origin(make);
}

std::string rotating(const PathMaker& make) {
    make.stand();
    make.part.path.axis = axis_by_flags(make, 4, 8);
    make.part.path.spin = make.number("speed", 100) * kRadians;
    return without_origin(make);
}

std::string bobbing(const PathMaker& make) {
    make.stand();
    Vec3 way{0, 0, 1};
    if (make.flags & 1)
        way = {1, 0, 0};
    else if (make.flags & 2)
        way = {0, 1, 0};
    make.part.path.swing = {way * (make.number("height", 32) * make.unit), 0, make.speed(4), make.number("phase", 0)};
    return "";
}

/// As long as it hangs below its origin, in a fall of 800 units.
std::string pendulum(const PathMaker& make) {
    make.stand();
    const double hangs = std::fabs(make.place.lowest) / make.unit, longer = hangs < 8 ? 8 : hangs;
    const double frequency = 1 / (2 * 3.141592653589793) * std::sqrt(800 / (3 * longer));
    const double yaw = radians(make.yaw());
    const SineCosine turned = sine_cosine(yaw);
    make.part.path.axis = {turned.cosine, turned.sine, 0};
    make.part.path.rotation = turn_by(Vec3{0, 0, yaw});
    make.part.path.swing = {{}, make.number("speed", 30) * kRadians, 1 / frequency, make.number("phase", 0)};
    return without_origin(make);
}

const Entity* entity_named(const BrushLevel& level, std::string_view name, std::size_t& index) {
    for (index = 0; index < level.entities.size(); ++index)
        if (!name.empty() && level.entities[index].value("targetname") == name) return &level.entities[index];
    return nullptr;
}

/// From corner to corner by their targets. Where that comes back to the first it goes round.
std::string train(const PathMaker& make) {
    const double usual = make.speed(100);
    std::set<std::size_t> met;
    std::size_t first = 0, index = 0;
    std::vector<PartStop>& stops = make.part.path.stops;
    std::vector<double> speeds;
    const Entity* corner = entity_named(make.level, make.entity.value("target"), index);
    first = index;
    bool round = false;
    while (corner && stops.size() < kMostStops && met.insert(index).second) {
        const std::optional<Vec3> at = entity_origin(make.level, *corner);
        if (!at) break;
        const double seconds = key_number(*corner, "wait", 0);
        stops.push_back({*at, 0, seconds > 0 ? seconds : 0, 0});
        const double own = key_number(*corner, "speed", 0);
        speeds.push_back(own > 0 ? own : usual);
        corner = entity_named(make.level, corner->value("target"), index);
        round = corner && index == first;
    }
    if (stops.empty()) {
        make.stand();
        return "it has no target path_corner with an origin: it stands";
    }
    for (std::size_t k = 0; k < stops.size(); ++k) {
        const Vec3& next = stops[k + 1 < stops.size() ? k + 1 : 0].position;
        stops[k].seconds = length(next - stops[k].position) / (speeds[k] * make.unit);
    }
    make.part.path.repeats = round;
    if (!round) stops.back().wait = kForEver;
    return make.place.has_origin ? "" : "it has no origin, and is carried from corner to corner by that of the level";
}

std::string breakable(const PathMaker& make) {
    make.stand();
    make.part.breaks = true;
    const double usual = make.entity.value("targetname").empty() ? 100 : 0;
    make.part.health = std::max(make.number("health", usual), 0.0);
    make.part.damage = std::max(make.number("dmg", 0), 0.0);
    for (const std::string_view key : {"type", "material"})
        if (make.part.matter.empty()) make.part.matter = make.entity.value(key);
    return "";
}

std::string still(const PathMaker& make) {
    make.stand();
    const double yaw = make.yaw();
    if (yaw > 0) make.part.path.rotation = turn_by(Vec3{0, 0, radians(yaw)});
    return "";
}

struct PathRule {
    std::string_view classname;
    std::string (*put)(const PathMaker& make);
};

constexpr PathRule kPathRules[] = {
    {"func_door", door},           {"func_door_rotating", rotating_door},
    {"func_plat", lift},           {"func_button", button},
    {"func_train", train},         {"func_rotating", rotating},
    {"func_bobbing", bobbing},     {"func_pendulum", pendulum},
    {"func_breakable", breakable}, {"func_explosive", breakable},
    {"func_static", still},        {"func_wall", still},
};

}  // namespace

std::string put_path(const BrushLevel& level, const PartPlace& place, BrushPart& part) {
    const Entity& entity = level.entities[part.entity];
    const PathMaker make{level, entity, place, part};
    for (const PathRule& rule : kPathRules)
        if (entity.value("classname") == rule.classname) return rule.put(make);
    make.stand();
    return "its class is not one that is known to move: it stands";
}

}  // namespace firma
