// SPDX-License-Identifier: MIT
// Which entities of a level something may hold: parts, what is put down, what hangs.
// Source: sizes and the way down of items and players, id Software, Quake III Arena source code, 2005,
// code/game/g_items.c (FinishSpawningItem), bg_pmove.h.
#include <algorithm>
#include <optional>
#include <string_view>
#include <tuple>
#include <utility>

#include "brush/entity_keys.h"
#include "firma/brush_parts.h"
#include "firma/support.h"

namespace firma {
namespace {

struct HeldClass {
    std::string_view begins;  ///< the class's name
    std::string_view ends;
    SupportKind kind;
    Vec3 low, high;            ///< around its origin, units
    double reach;              ///< units
    std::uint32_t floats = 0;  ///< a bit of `spawnflags`: it is held by nothing
};

constexpr Vec3 kItemLow{-15, -15, -15}, kItemHigh{15, 15, 15};
constexpr Vec3 kPlayerLow{-15, -15, -24}, kPlayerHigh{15, 15, 32};
constexpr double kFall = 4096, kHang = 32;

constexpr HeldClass kHeldClasses[] = {
    {"item_", "", SupportKind::kStands, kItemLow, kItemHigh, kFall, 1},
    {"weapon_", "", SupportKind::kStands, kItemLow, kItemHigh, kFall, 1},
    {"ammo_", "", SupportKind::kStands, kItemLow, kItemHigh, kFall, 1},
    {"holdable_", "", SupportKind::kStands, kItemLow, kItemHigh, kFall, 1},
    {"team_CTF_", "flag", SupportKind::kStands, kItemLow, kItemHigh, kFall, 1},
    {"team_CTF_", "", SupportKind::kStands, kPlayerLow, kPlayerHigh, kFall},
    {"info_player_intermission", "", SupportKind::kTouches, {}, {}, -1},  // a camera
    {"info_player_", "", SupportKind::kStands, kPlayerLow, kPlayerHigh, kFall},
    {"light", "", SupportKind::kHangs, {-4, -4, -4}, {4, 4, 4}, kHang},
    {"misc_model", "", SupportKind::kHangs, {-8, -8, -8}, {8, 8, 8}, kHang},
};

const HeldClass* held_class(std::string_view name) {
    for (const HeldClass& held : kHeldClasses)
        if (name.substr(0, held.begins.size()) == held.begins && name.size() >= held.ends.size() &&
            name.substr(name.size() - held.ends.size()) == held.ends)
            return held.reach < 0 ? nullptr : &held;
    return nullptr;
}

std::optional<SupportedThing> held_entity(const BrushLevel& level, std::uint32_t number) {
    const Entity& entity = level.entities[number];
    const HeldClass* held = held_class(entity.value("classname"));
    if (!held || (key_flags(entity) & held->floats)) return std::nullopt;
    const std::optional<Vec3> origin = entity_origin(level, entity);
    if (!origin || !is_finite(*origin)) return std::nullopt;
    SupportedThing thing;
    thing.entity = number;
    thing.kind = held->kind;
    thing.box = {*origin + held->low * level.metres_a_unit, *origin + held->high * level.metres_a_unit};
    thing.reach = held->reach * level.metres_a_unit;
    return thing;
}

SupportedThing held_part(const BrushPart& part, double metres_a_unit) {
    const Pose pose = part_pose(part.path, 0);
    RigidMotion stands;
    stands.position = pose.position;
    stands.rotation = pose.rotation;
    SupportedThing thing;
    thing.entity = part.entity;
    thing.sides = support_sides(MovingPart(part.world, stands));
    // The engines measure models a unit larger on each side: so far apart is in touch.
    thing.reach = metres_a_unit;
    return thing;
}

}  // namespace

std::vector<SupportedThing> supported_entities(const BrushLevel& level, const BrushParts& parts) {
    std::vector<SupportedThing> things;
    for (const BrushPart& part : parts.parts) {
        SupportedThing thing = held_part(part, level.metres_a_unit);
        if (!thing.sides.empty()) things.push_back(std::move(thing));
    }
    for (std::uint32_t k = 0; k < level.entities.size(); ++k)
        if (std::optional<SupportedThing> thing = held_entity(level, k)) things.push_back(std::move(*thing));
    std::sort(things.begin(), things.end(), [](const SupportedThing& a, const SupportedThing& b) {
        return std::tuple(a.entity, a.kind) < std::tuple(b.entity, b.kind);
    });
    return things;
}

}  // namespace firma
